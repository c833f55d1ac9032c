// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/SeaSpectrum.h"

#include "Numerics/Constants.h"
#include "Numerics/MissingCodes.h"
#include "Numerics/ParameterCheck.h"
#include "Sea/Dispersion.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace littoral
{

namespace
{

/// alpha and beta of Pierson and Moskowitz.
constexpr double Alpha = 8.1e-3;
constexpr double Beta = 0.74;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Frequency from which panels go up [peaks of the form]; 5/4 of its power -4 is 600.
constexpr double LowestPanel = 0.213643;
/// Agreement of panels with their halves; rounding of e^-600 leaves 1e-13.
constexpr double PanelAgreement = 1e-12;
/// Part of the energy that may lie above the range of a form.
constexpr double EnergyAboveRange = 0.01;
/// Frequency from which the higher peak of a young sea is below 1e-25 of the density [peaks of the form].
constexpr double EndOfYoungPeak = 2.0;
/// Relative depth w2 h / g from which on depth takes nothing.
constexpr double DeepRelativeDepth = 20.0;
/// Below it wave numbers are beyond all measure [m].
constexpr double ShallowestDepth = 1e-6;

/// Height over depth at which waves break: of one wave (McCowan 1894), and the significant height of a surf zone, whose
/// root mean square is 0.42 (Thornton and Guza 1982).
constexpr double BreakingHeight = 0.78;
constexpr double BreakingSignificantHeight = 0.59;

/// Lambda of the narrowest sea of Ochi and Hubble.
constexpr double LargestShape = 20.0;
/// Frequencies of a bin over each other up to which a rule of 20 points is better than the difference of closed forms.
constexpr double NarrowBin = 1.1;

/// Significant wave height that no table exceeds; the highest that was measured is about 20 m [m].
constexpr double HighestMeasuredSea = 30.0;

/// Part of a wave's energy that finite depth leaves, after Kitaigorodskii.
double DepthFactor(double frequency, double depth)
{
  const double x = WaveNumber(frequency, depth) * depth;
  if (!(x < 20.0))
  {
    return 1.0;
  }
  // tanh^2 kh / (1 + 2 kh / sinh 2 kh)
  const double t = std::tanh(x);
  return x > 0.0 ? t * t / (1.0 + 2.0 * x / std::sinh(2.0 * x)) : 0.0;
}

std::string WhyInvalidTable(const SpectrumParameters& parameters)
{
  const std::vector<double>& hertz = parameters.Frequencies;
  const std::vector<double>& density = parameters.Densities;
  if (hertz.size() < 2 || hertz.size() != density.size())
  {
    return "the table of the spectrum needs two rows or more of Frequency and Density.";
  }
  for (std::size_t row = 0; row < hertz.size(); ++row)
  {
    if (!std::isfinite(hertz[row]) || hertz[row] < 0.0 || (row > 0 && hertz[row] <= hertz[row - 1]))
    {
      return "Frequency in row " + std::to_string(row) + " of the spectrum must be above that in the row before.";
    }
    if (!std::isfinite(density[row]) || density[row] < 0.0)
    {
      return "Density in row " + std::to_string(row) + " of the spectrum is negative or no number.";
    }
  }
  // Buoys of NDBC write 999.00 where nothing was measured.
  const std::set<double> codes = MissingCodes(density, Infinity);
  const auto code = std::find_if(density.begin(), density.end(), [&](double value) { return codes.count(value) > 0; });
  if (code != density.end())
  {
    return "leave out row " + std::to_string(code - density.begin()) + " of the spectrum: Density " + TextOf(*code) +
      " is a code for a missing value.";
  }
  double energy = 0.0; // of the surface elevation, m0 [m2]
  for (std::size_t row = 1; row < hertz.size(); ++row)
  {
    energy += 0.5 * (density[row] + density[row - 1]) * (hertz[row] - hertz[row - 1]);
  }
  if (const double height = 4.0 * std::sqrt(energy); height > HighestMeasuredSea)
  {
    std::ostringstream words;
    words << "Density of the spectrum makes a significant wave height of " << height << " m; it must be in m2/Hz.";
    return words.str();
  }
  const auto highest = std::max_element(density.begin(), density.end());
  return *highest > 0.0 && hertz[highest - density.begin()] > 0.0
    ? ""
    : "Density of the spectrum has no peak above frequency 0.";
}

}

std::string WhyInvalid(const SpectrumParameters& parameters)
{
  const bool isTable = parameters.Kind == SpectrumKind::Table;
  const bool hasPeakEnhancement = parameters.Kind == SpectrumKind::Jonswap || parameters.Kind == SpectrumKind::Tma;
  ParameterCheck check;
  check.Choice("Spectrum", static_cast<int>(parameters.Kind), 6);
  const bool isDepth = std::isinf(parameters.Depth) || IsSensible(parameters.Depth);
  check.Require(isDepth && parameters.Depth >= ShallowestDepth, "WaterDepth", parameters.Depth, "m",
    "0 (deep) or at least " + TextOf(ShallowestDepth) + " m");
  if (isTable && check.IsGood())
  {
    return WhyInvalidTable(parameters);
  }
  if (parameters.FromWind)
  {
    check.Range("WindSpeed", parameters.WindSpeed, 0.1, 200.0, "m/s");
  }
  else
  {
    check.Positive("SignificantWaveHeight", parameters.SignificantHeight, "m");
    check.Range("PeakPeriod", parameters.PeakPeriod, 0.01, 10000.0, "s");
  }
  if (parameters.Kind == SpectrumKind::OchiHubble)
  {
    check.Positive("SwellHeight", parameters.SwellHeight, "m");
    check.Range("SwellPeriod", parameters.SwellPeriod, 0.01, 10000.0, "s");
    check.Range("SwellShape", parameters.SwellShape, 1.0, LargestShape);
    check.Range("WindSeaShape", parameters.Shape, 1.0, LargestShape);
  }
  if (hasPeakEnhancement)
  {
    check.Range("PeakEnhancement", parameters.PeakEnhancement, 1.0, 20.0);
  }
  return check.Reason();
}

std::string WhyBroken(const SeaSpectrum& spectrum, double depth)
{
  const double height = (spectrum.IsRegular() ? std::sqrt(8.0) : 4.0) * std::sqrt(spectrum.TotalEnergy());
  const double highest = (spectrum.IsRegular() ? BreakingHeight : BreakingSignificantHeight) * depth;
  return height <= (1.0 + 1e-9) * highest ? ""
                                          : "WaterDepth of " + TextOf(depth) + " m holds waves of at most " +
      TextOf(highest) + " m: those of " + TextOf(height) + " m break.";
}

SeaSpectrum::SeaSpectrum(const SpectrumParameters& parameters)
  : Given(parameters)
{
  if (parameters.Kind == SpectrumKind::Table)
  {
    this->ReadTable();
    return;
  }
  const double g = Gravity;
  if (parameters.FromWind)
  {
    // On water of a finite depth the sea of a wind is that of TMA.
    const bool isOld = parameters.Kind == SpectrumKind::PiersonMoskowitz;
    if (std::isfinite(parameters.Depth) && (isOld || parameters.Kind == SpectrumKind::Jonswap))
    {
      this->Given.Kind = SpectrumKind::Tma;
      this->Given.PeakEnhancement = isOld ? 1.0 : parameters.PeakEnhancement;
    }
    const double u = parameters.WindSpeed;
    // Pierson and Moskowitz: wp = (4/5 beta)^(1/4) g/U, Hs = 4 m0^(1/2), m0 = alpha U^4 / (4 beta g^2)
    this->FormPeak = std::pow(0.8 * Beta, 0.25) * g / u;
    this->Given.PeakPeriod = TwoPi / this->FormPeak;
    this->Given.SignificantHeight = 4.0 * u * u / g * std::sqrt(0.25 * Alpha / Beta);
  }
  parameters.Kind == SpectrumKind::OchiHubble ? this->AddHumps() : this->FitToHeightAndPeriod();
}

double SeaSpectrum::Hump::Density(double w) const
{
  // x^lambda e^-x / Gamma(lambda)
  const double ratio = this->Peak / w;
  const double x = (this->Shape + 0.25) * ratio * ratio * ratio * ratio;
  return 4.0 * this->Variance / w * std::exp(this->Shape * std::log(x) - x - std::lgamma(this->Shape));
}

double SeaSpectrum::Hump::Energy(double low, double high) const
{
  if (high < NarrowBin * low)
  {
    return boost::math::quadrature::gauss<double, 20>::integrate(
      [this](double w) { return this->Density(w); }, low, high);
  }
  // m0 P(lambda, x) lies above a frequency
  const auto above = [this](double w) {
    const double ratio = this->Peak / w;
    const double x = (this->Shape + 0.25) * ratio * ratio * ratio * ratio;
    return !(w > 0.0) || x > 600.0 ? 1.0 : boost::math::gamma_p(this->Shape, x);
  };
  return this->Variance * (above(low) - above(high));
}

/// The swell and the wind sea of Ochi and Hubble.
void SeaSpectrum::AddHumps()
{
  const auto hump = [](double height, double period, double shape) {
    return Hump{ height * height / 16.0, TwoPi / period, shape };
  };
  this->Humps = { hump(this->Given.SwellHeight, this->Given.SwellPeriod, this->Given.SwellShape),
    hump(this->Given.SignificantHeight, this->Given.PeakPeriod, this->Given.Shape) };
  this->Total = this->Humps[0].Variance + this->Humps[1].Variance;
  double most = 0.0;
  for (const Hump& one : this->Humps)
  {
    // The other sea shifts a peak a little
    const auto negative = [this](double w) { return -this->Density(w); };
    const auto found = boost::math::tools::brent_find_minima(negative, 0.9 * one.Peak, 1.1 * one.Peak, 40);
    if (-found.second > most)
    {
      most = -found.second;
      this->Peak = found.first;
    }
  }
}

double SeaSpectrum::SwellPart(double w) const
{
  const double all = this->Humps.empty() ? 0.0 : this->Density(w);
  return all > 0.0 ? this->Humps[0].Density(w) / all : 0.0;
}

void SeaSpectrum::FitToHeightAndPeriod()
{
  const double wanted = TwoPi / this->Given.PeakPeriod;
  const double variance = this->Given.SignificantHeight * this->Given.SignificantHeight / 16.0;
  this->FormPeak = wanted;
  this->Peak = wanted;
  // m0 = A / (4 B), B = 5/4 wp^4
  this->Scale = 5.0 * variance * std::pow(wanted, 4.0);
  if (this->Given.Kind == SpectrumKind::PiersonMoskowitz || this->IsRegular())
  {
    this->Total = this->IsRegular() ? 2.0 * variance : variance; // (H/2)^2 / 2
    return;
  }
  if (this->Given.Kind == SpectrumKind::Tma && this->Given.FromWind)
  {
    // The wind gives the deep sea; depth then takes what it takes, and what would break.
    this->Given.Kind = SpectrumKind::Jonswap;
    this->MakePanels();
    this->Scale *= variance / this->Energy(0.0, Infinity);
    this->Given.Kind = SpectrumKind::Tma;
    this->MakePanels();
    this->Peak = this->FindPeak();
    const double most = std::pow(BreakingSignificantHeight * this->Given.Depth, 2.0) / 16.0;
    this->Scale *= std::min(1.0, most / this->Energy(0.0, Infinity));
    this->Total = this->Energy(0.0, Infinity);
    return;
  }
  // Depth shifts the peak a little: shift the form until the peak lies where it is wanted.
  for (int step = 0; this->Given.Kind == SpectrumKind::Tma && step < 60; ++step)
  {
    const double ratio = wanted / this->FindPeak();
    this->FormPeak *= ratio;
    if (std::abs(ratio - 1.0) < 1e-9)
    {
      break;
    }
  }
  this->MakePanels();
  this->Scale *= variance / this->Energy(0.0, Infinity);
  this->Total = variance;
}

double SeaSpectrum::FindPeak() const
{
  // The factor of depth grows by less than w^5, and S beyond the form's peak falls from there on.
  const auto negative = [this](double w) { return -this->Shape(w); };
  const double p = this->FormPeak;
  return boost::math::tools::brent_find_minima(negative, p, 2.0 * p, 40).first;
}

double SeaSpectrum::Shape(double w) const
{
  if (this->Given.Kind == SpectrumKind::Table)
  {
    return this->TableValue(w);
  }
  // w^-5 exp(-5/4 (wp/w)^4)
  const double square = this->FormPeak / w * (this->FormPeak / w);
  const double form = std::exp(-1.25 * square * square) / (w * w * w * w * w);
  if (!(form > 0.0) || this->Given.Kind == SpectrumKind::PiersonMoskowitz)
  {
    return form > 0.0 ? form : 0.0;
  }
  // gamma^exp(-((w/wp - 1)/sigma)^2 / 2)
  const double sigma = w > this->FormPeak ? 0.09 : 0.07;
  const double off = (w / this->FormPeak - 1.0) / sigma;
  const double young = form * std::pow(this->Given.PeakEnhancement, std::exp(-0.5 * off * off));
  return this->Given.Kind == SpectrumKind::Tma ? young * DepthFactor(w, this->Given.Depth) : young;
}

double SeaSpectrum::TableValue(double w) const
{
  if (w < this->Nodes.front() || w > this->Nodes.back())
  {
    return 0.0;
  }
  const std::size_t next = std::min<std::size_t>(
    std::upper_bound(this->Nodes.begin(), this->Nodes.end(), w) - this->Nodes.begin(), this->Nodes.size() - 1);
  const double part = (w - this->Nodes[next - 1]) / (this->Nodes[next] - this->Nodes[next - 1]);
  return this->Values[next - 1] + part * (this->Values[next] - this->Values[next - 1]);
}

double SeaSpectrum::Density(double w) const
{
  if (!this->Humps.empty())
  {
    return w > 0.0 ? this->Humps[0].Density(w) + this->Humps[1].Density(w) : 0.0;
  }
  return w > 0.0 && !this->IsRegular() ? this->Scale * this->Shape(w) : 0.0;
}

double SeaSpectrum::Energy(double low, double high) const
{
  low = std::max(low, 0.0);
  if (!(high > low))
  {
    return 0.0;
  }
  if (this->IsRegular())
  {
    return low <= this->Peak && this->Peak < high ? this->Total : 0.0;
  }
  if (!this->Humps.empty())
  {
    return this->Humps[0].Energy(low, high) + this->Humps[1].Energy(low, high);
  }
  if (this->Given.Kind == SpectrumKind::PiersonMoskowitz)
  {
    return this->FormEnergy(low, high);
  }
  const auto shape = [this](double w) { return this->Shape(w); };
  const double below = this->Scale * this->Panels.Integral(shape, low, high);
  // Above the panels the form alone is left, of a table nothing.
  const double top = this->Given.Kind == SpectrumKind::Table ? Infinity : this->HighestPanel();
  return high > top ? below + this->FormEnergy(std::max(low, top), high) : below;
}

double SeaSpectrum::FormEnergy(double low, double high) const
{
  // A / (5 wp^4) (e^-b - e^-a) with a = 5/4 (wp/low)^4 and b likewise, as e^-b (1 - e^-(a - b)), whose a - b is a
  // product.
  const double p = this->FormPeak;
  const double r = p / low;
  const double q = p / high;
  const double b = 1.25 * q * q * q * q;
  const double gap = std::isfinite(high) && low > 0.0 ? r * q * ((high - low) / p) : r;
  const double drop = 1.25 * gap * (r + q) * (r * r + q * q);
  return -this->Scale / (5.0 * p * p * p * p) * std::exp(-b) * std::expm1(-drop);
}

double SeaSpectrum::HighestPanel() const
{
  const double young = EndOfYoungPeak * this->FormPeak;
  return this->Given.Kind == SpectrumKind::Tma && std::isfinite(this->Given.Depth)
    ? std::max(young, std::sqrt(DeepRelativeDepth * Gravity / this->Given.Depth))
    : young;
}

void SeaSpectrum::MakePanels()
{
  const double p = this->FormPeak;
  const double top = this->HighestPanel();
  std::vector<double> cuts = { LowestPanel * p, p };
  while (cuts.back() < top)
  {
    cuts.push_back(std::min(2.0 * cuts.back(), top));
  }
  this->Panels = CompositeQuadrature([this](double w) { return this->Shape(w); }, cuts, PanelAgreement);
}

std::array<double, 2> SeaSpectrum::Range() const
{
  if (this->Given.Kind != SpectrumKind::Table)
  {
    double highest = 4.0 * this->Peak;
    while (this->Energy(highest, Infinity) > EnergyAboveRange * this->Total)
    {
      highest += 0.5 * this->Peak;
    }
    double lowest = 0.5 * this->Peak;
    for (const Hump& one : this->Humps)
    {
      lowest = std::min(lowest, 0.5 * one.Peak);
    }
    return { lowest, highest };
  }
  const auto positive = [](double value) { return value > 0.0; };
  const auto first = std::find_if(this->Values.begin(), this->Values.end(), positive) - this->Values.begin();
  const auto after = std::find_if(this->Values.rbegin(), this->Values.rend(), positive) - this->Values.rbegin();
  return { this->Nodes[std::max<std::ptrdiff_t>(first - 1, 0)],
    *(this->Nodes.rbegin() + std::max<std::ptrdiff_t>(after - 1, 0)) };
}

void SeaSpectrum::ReadTable()
{
  for (std::size_t row = 0; row < this->Given.Frequencies.size(); ++row)
  {
    this->Nodes.push_back(TwoPi * this->Given.Frequencies[row]);
    this->Values.push_back(this->Given.Densities[row] / TwoPi);
  }
  this->Panels = CompositeQuadrature([this](double w) { return this->TableValue(w); }, this->Nodes, PanelAgreement);
  this->Total = this->Energy(0.0, Infinity);
  this->Peak = this->Nodes[std::max_element(this->Values.begin(), this->Values.end()) - this->Values.begin()];
}

}
