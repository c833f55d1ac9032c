// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Light/LaterLight.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace littoral
{

namespace
{

using Color = LaterLight::ColorLanes;

// Table of what is sent: altitude, angle of the line from the zenith, height of the sun, azimuth from the sun.
constexpr int Altitudes = 16;
constexpr int Views = 32;
constexpr int LowSuns = 25;  // a degree apart
constexpr int HighSuns = 11; // each higher by a factor
constexpr int Suns = LowSuns + HighSuns;
constexpr int Azimuths = 16;
constexpr int Block = Suns * Azimuths; // of an altitude and a view
constexpr double HighestLowSun = 5.0;  // [degrees]
constexpr float Least = 1e-18F;        // light that is none

// Directions around a place, and the harmonics of the light from there.
constexpr int UpRings = 14;
constexpr int DownRings = 6;
constexpr int Rings = UpRings + DownRings;
constexpr int RingPlaces = 14; // on one side of the sun
constexpr int Degrees = 14;
constexpr int Waves = Degrees + 1; // around the zenith
constexpr int Harmonics = (Degrees + 1) * (Degrees + 2) / 2;

constexpr int FirstParts = 28; // of a line, for light that was scattered once
constexpr int LaterParts = 14;

/// Order from which on orders have the ratio of those that follow: later in turbid air, and over light ground.
int LastOrder(const AirParameters& parameters)
{
  return static_cast<int>(3.5 + 0.5 * parameters.Turbidity + parameters.GroundAlbedo);
}

/// A color in single precision; what is next to nothing is nothing, since numbers below 1e-38 are slow.
Color ColorOf(const Vector3& c)
{
  const Color color{ static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 0.0F };
  return color > Least ? color : Color{};
}

Vector3 VectorOf(const Color& c)
{
  return { c[0], c[1], c[2] };
}

Color AtLeast(const Color& color, float least)
{
  return color > least ? color : Color{} + least;
}

/// Part of the way between two neighbours of a table.
struct Place
{
  int Lower;
  float Part;

  Place(float place, int count)
    : Lower(std::min(static_cast<int>(place), count - 2))
    , Part(place - static_cast<float>(this->Lower))
  {
  }
  Color Between(const Color& lower, const Color& upper) const
  {
    return (1.0F - this->Part) * lower + this->Part * upper;
  }
};

// Altitudes are dense at the ground, views even in the angle, azimuths in the sine of half of them.

double AltitudeOf(int row)
{
  const double t = row / (Altitudes - 1.0);
  return AirHeight * t * t * t * t;
}

Place AltitudePlace(double altitude)
{
  return { static_cast<float>(std::sqrt(std::sqrt(std::clamp(altitude / AirHeight, 0.0, 1.0))) * (Altitudes - 1)),
    Altitudes };
}

double CosViewOf(int view)
{
  return std::cos(Pi * view / (Views - 1.0));
}

Place ViewPlace(double cosView)
{
  return { static_cast<float>(std::acos(std::clamp(cosView, -1.0, 1.0)) / Pi * (Views - 1)), Views };
}

double AzimuthOf(int place)
{
  return 2.0 * std::asin(place / (Azimuths - 1.0));
}

Place AzimuthPlace(float cosAzimuth)
{
  return { std::sqrt(std::clamp(0.5F - 0.5F * cosAzimuth, 0.0F, 1.0F)) * (Azimuths - 1), Azimuths };
}

double ElevationOfSun(int sun)
{
  return sun < LowSuns ? HighestLowSun - (LowSuns - 1 - sun)
                       : HighestLowSun * std::pow(90.0 / HighestLowSun, (sun - LowSuns + 1.0) / HighSuns);
}

/// Places among the heights of the sun by the sine of its elevation.
class SunScale
{
public:
  SunScale()
  {
    for (int n = 0; n <= Count; ++n)
    {
      const double sine = std::min(1.0, this->First + (1.0 - this->First) * n / Count);
      const double elevation = std::asin(sine) / Degree;
      const double high = HighSuns * std::log(elevation / HighestLowSun) / std::log(90.0 / HighestLowSun);
      const double above = elevation <= HighestLowSun ? elevation - HighestLowSun : high;
      this->Places[n] = static_cast<float>(std::clamp(LowSuns - 1 + above, 0.0, Suns - 1.0));
    }
  }

  Place At(float sine) const
  {
    const float x = (sine - static_cast<float>(this->First)) * static_cast<float>(Count / (1.0 - this->First));
    const float at = std::clamp(x, 0.0F, static_cast<float>(Count));
    const int i = std::min(static_cast<int>(at), Count - 1);
    return { this->Places[i] + (at - static_cast<float>(i)) * (this->Places[i + 1] - this->Places[i]), Suns };
  }

private:
  static constexpr int Count = 4096;
  double First = std::sin(ElevationOfSun(0) * Degree);
  std::array<float, Count + 1> Places{};
};

const SunScale& TheSunScale()
{
  static const SunScale scale;
  return scale;
}

/// Linear in the azimuth; in the height of the sun the geometric mean of linear and harmonic, of which one is too much
/// and one too little where light falls off exponentially.
inline Color InBlock(const Color* block, const Place& sun, const Place& azimuth)
{
  const Color* at = block + sun.Lower * Azimuths + azimuth.Lower;
  const Color low = azimuth.Between(at[0], at[1]);
  const Color high = azimuth.Between(at[Azimuths], at[Azimuths + 1]);
  Color mean = low * high * (sun.Between(low, high) / sun.Between(high, low));
  for (int c = 0; c < 4; ++c)
  {
    mean[c] = std::sqrt(mean[c]);
  }
  return mean;
}

/// Points and weights of the rule of Gauss and Legendre on an interval.
template <int Count>
void AddRule(double low, double high, std::vector<double>& points, std::vector<double>& weights)
{
  for (int n = 0; n < Count; ++n)
  {
    double x = std::cos(Pi * (n + 0.75) / (Count + 0.5));
    double slope = 1.0;
    for (int newton = 0; newton < 6; ++newton)
    {
      double before = 1.0;
      double p = x;
      for (int l = 2; l <= Count; ++l)
      {
        before = std::exchange(p, ((2.0 * l - 1.0) * x * p - (l - 1.0) * before) / l);
      }
      slope = Count * (x * p - before) / (x * x - 1.0);
      x -= p / slope;
    }
    points.push_back(low + 0.5 * (high - low) * (1.0 - x));
    weights.push_back((high - low) / ((1.0 - x * x) * slope * slope));
  }
}

using HarmonicValues = std::array<float, Harmonics>;

/// Associated Legendre functions sqrt((l - m)! / (l + m)!) P_lm(z), for m = 0 all l, then for m = 1 and so on.
HarmonicValues HarmonicsAt(double z)
{
  HarmonicValues values{};
  double diagonal = 1.0;
  int at = 0;
  for (int m = 0; m < Waves; ++m)
  {
    double before = 0.0;
    double p = diagonal;
    for (int l = m; l <= Degrees; ++l)
    {
      values[at++] = static_cast<float>(p);
      // sqrt((l + 1)2 - m2) P_l+1 = (2 l + 1) z P_l - sqrt(l2 - m2) P_l-1
      const double next =
        ((2.0 * l + 1.0) * z * p - std::sqrt(1.0 * l * l - m * m) * before) / std::sqrt((l + 1.0) * (l + 1.0) - m * m);
      before = std::exchange(p, next);
    }
    diagonal *= std::sqrt(std::max(0.0, 1.0 - z * z) * (2.0 * m + 1.0) / (2.0 * m + 2.0));
  }
  return values;
}

/// Light around a place under a sun, and the light that air makes of it.
class Sphere
{
public:
  using Parts = std::array<Color, Harmonics>;

  Sphere()
  {
    for (int m = 0; m < Waves; ++m)
    {
      for (int k = 0; k < RingPlaces; ++k)
      {
        this->RingWaves[k][m] = static_cast<float>(std::cos(m * Pi * (k + 0.5) / RingPlaces) / RingPlaces);
      }
      for (int k = 0; k < Azimuths; ++k)
      {
        this->TableWaves[m][k] = static_cast<float>((m == 0 ? 1.0 : 2.0) * std::cos(m * AzimuthOf(k)));
      }
    }
    for (int view = 0; view < Views; ++view)
    {
      this->TableHarmonics[view] = HarmonicsAt(CosViewOf(view));
    }
  }

  /// Adds a ring's light of a weight: part_lm = mean of L P_lm(z) cos(m azimuth).
  void Add(const Color* ring, float weight, const HarmonicValues& harmonics, Parts& parts) const
  {
    std::array<Color, Waves> waves{};
    for (int k = 0; k < RingPlaces; ++k)
    {
      for (int m = 0; m < Waves; ++m)
      {
        waves[m] += this->RingWaves[k][m] * ring[k];
      }
    }
    for (int m = 0, at = 0; m < Waves; ++m)
    {
      const Color wave = weight * waves[m];
      for (int l = m; l <= Degrees; ++l, ++at)
      {
        parts[at] += harmonics[at] * wave;
      }
    }
  }

  /// Writes the sum of (2 - [m = 0]) part_lm P_lm(z) cos(m azimuth) for all views and azimuths of a sun.
  void Write(const Parts& parts, Color* sun) const
  {
    for (int view = 0; view < Views; ++view)
    {
      std::array<Color, Azimuths> values{};
      for (int m = 0, at = 0; m < Waves; ++m)
      {
        Color wave{};
        for (int l = m; l <= Degrees; ++l, ++at)
        {
          wave += this->TableHarmonics[view][at] * parts[at];
        }
        for (int k = 0; k < Azimuths; ++k)
        {
          values[k] += this->TableWaves[m][k] * wave;
        }
      }
      for (int k = 0; k < Azimuths; ++k)
      {
        sun[static_cast<std::size_t>(view) * Block + k] = AtLeast(values[k], Least);
      }
    }
  }

private:
  std::array<std::array<float, Waves>, RingPlaces> RingWaves;
  std::array<std::array<float, Azimuths>, Waves> TableWaves;
  std::array<HarmonicValues, Views> TableHarmonics;
};

/// Light of the sun that comes to an altitude, by the root of its cosine above that at which it sets.
class SunRow
{
public:
  SunRow(const AirLayers& air, double altitude)
    : Lowest(static_cast<float>(AirLayers::CosSunset(altitude)))
    , PerRange((Count - 1.0F) * (Count - 1.0F) / (1.0F - this->Lowest))
  {
    for (int n = 0; n < Count; ++n)
    {
      const double t = n / (Count - 1.0);
      this->Values[n] = ColorOf(air.SunAt(altitude, this->Lowest + (1.0 - this->Lowest) * t * t));
    }
  }

  Color At(float cosSun) const
  {
    const Place place(std::sqrt(std::max(0.0F, (cosSun - this->Lowest) * this->PerRange)), Count);
    return place.Between(this->Values[place.Lower], this->Values[place.Lower + 1]);
  }

private:
  static constexpr int Count = 160;
  float Lowest;
  float PerRange;
  std::array<Color, Count> Values;
};

/// Light of an order at all places.
struct Order
{
  std::vector<Color> Sent = std::vector<Color>(static_cast<std::size_t>(Altitudes) * Views * Block);
  std::vector<Color> Means = std::vector<Color>(static_cast<std::size_t>(Altitudes) * Suns);
  std::vector<Color> Ground = std::vector<Color>(Suns);
};

/// Maker of an order out of the one before.
class OrderMaker
{
public:
  OrderMaker(const AirLayers& air, double groundAlbedo)
    : Air(air)
    , Reflected(static_cast<float>(groundAlbedo / Pi))
  {
    for (int sun = 0; sun < Suns; ++sun)
    {
      const double elevation = ElevationOfSun(sun) * Degree;
      this->SinSun[sun] = static_cast<float>(std::sin(elevation));
      for (int k = 0; k < RingPlaces; ++k)
      {
        const double around = Pi * (k + 0.5) / RingPlaces;
        this->Across[sun][k] = static_cast<float>(std::cos(elevation) * std::cos(around));
      }
    }
  }

  /// Order 0: the sun itself, on the ground.
  Order OfSun() const
  {
    Order order;
    for (int sun = 0; sun < Suns; ++sun)
    {
      const double sine = std::max(0.0F, this->SinSun[sun]);
      order.Ground[sun] = ColorOf(sine * this->Air.SunAt(0.0, sine));
    }
    return order;
  }

  /// Makes what an altitude sends of light that was scattered so often.
  void MakeRow(int row, int number, const Order& before, Order& order) const
  {
    const double altitude = AltitudeOf(row);
    const double horizon = AirLayers::CosHorizon(altitude);
    std::vector<double> views;
    std::vector<double> weights;
    AddRule<DownRings>(-1.0, horizon, views, weights);
    AddRule<UpRings>(horizon, 1.0, views, weights);
    std::vector<Sphere::Parts> parts(Suns);
    std::vector<Color> light(static_cast<std::size_t>(Suns) * RingPlaces);
    for (int ring = 0; ring < Rings; ++ring)
    {
      const double view = views[ring];
      const SightLine line = this->Air.Line(std::max(altitude, 1e-4), view, number == 1 ? FirstParts : LaterParts);
      number == 1 ? this->SeeFirst(line, view, light) : this->SeeLater(line, view, before, light);
      this->SeeGround(line, before, light);
      const HarmonicValues harmonics = HarmonicsAt(view);
      for (int sun = 0; sun < Suns; ++sun)
      {
        this->Around.Add(&light[static_cast<std::size_t>(sun) * RingPlaces], static_cast<float>(0.5 * weights[ring]),
          harmonics, parts[sun]);
      }
    }
    const std::array<Color, Harmonics> factors = this->PhaseFactors(altitude);
    for (int sun = 0; sun < Suns; ++sun)
    {
      order.Means[static_cast<std::size_t>(row) * Suns + sun] = parts[sun][0];
      for (int n = 0; n < Harmonics; ++n)
      {
        parts[sun][n] *= factors[n];
      }
      this->Around.Write(parts[sun],
        &order.Sent[static_cast<std::size_t>(row) * Views * Block + static_cast<std::size_t>(sun) * Azimuths]);
    }
  }

  /// Makes the light on level ground.
  void MakeGround(int number, const Order& before, Order& order) const
  {
    std::vector<double> views;
    std::vector<double> weights;
    AddRule<UpRings>(0.0, 1.0, views, weights);
    std::vector<Color> light(static_cast<std::size_t>(Suns) * RingPlaces);
    for (int ring = 0; ring < UpRings; ++ring)
    {
      const SightLine line = this->Air.Line(0.0, views[ring], number == 1 ? FirstParts : LaterParts);
      number == 1 ? this->SeeFirst(line, views[ring], light) : this->SeeLater(line, views[ring], before, light);
      // E = integral of L z
      for (std::size_t n = 0; n < light.size(); ++n)
      {
        order.Ground[n / RingPlaces] += static_cast<float>(TwoPi * weights[ring] * views[ring] / RingPlaces) * light[n];
      }
    }
  }

private:
  /// Factors (2 l + 1) of the phase functions: g^l of Henyey and Greenstein, 1, 0, 1/10 of Rayleigh.
  std::array<Color, Harmonics> PhaseFactors(double altitude) const
  {
    const AirLayers::Coefficients c = this->Air.At(altitude);
    const Vector3 molecules = c.Molecules / (c.Molecules + c.Aerosols);
    std::array<Color, Harmonics> factors;
    for (int m = 0, at = 0; m < Waves; ++m)
    {
      for (int l = m; l <= Degrees; ++l, ++at)
      {
        const double rayleigh = l == 0 ? 1.0 : l == 2 ? 0.1 : 0.0;
        factors[at] =
          ColorOf((2.0 * l + 1.0) * (rayleigh * molecules + std::pow(AerosolAsymmetry, l) * (1.0 - molecules)));
      }
    }
    return factors;
  }

  /// Calls for the suns and the azimuths of a ring: number of the light, sine of the sun's elevation, the part of the
  /// sun across it in the direction of the azimuth.
  template <typename Task>
  void ForRing(const Task& task) const
  {
    for (int sun = 0; sun < Suns; ++sun)
    {
      for (int k = 0; k < RingPlaces; ++k)
      {
        task(static_cast<std::size_t>(sun) * RingPlaces + k, this->SinSun[sun], this->Across[sun][k]);
      }
    }
  }

  /// Light of the sun that is scattered once.
  void SeeFirst(const SightLine& line, double cosView, std::vector<Color>& light) const
  {
    struct Part
    {
      float CosTurn, SinTurn;
      Color Molecules, Aerosols;
      SunRow Sun;
    };
    std::vector<Part> parts;
    for (const SightPart& part : line.Parts)
    {
      parts.push_back({ static_cast<float>(part.CosTurn), static_cast<float>(part.SinTurn), ColorOf(part.Molecules),
        ColorOf(part.Aerosols), SunRow(this->Air, part.Altitude) });
    }
    const double sinView = std::sqrt(std::max(0.0, 1.0 - cosView * cosView));
    this->ForRing([&](std::size_t n, float sine, float across) {
      Color molecules{};
      Color aerosols{};
      for (const Part& part : parts)
      {
        const Color sun = part.Sun.At(part.CosTurn * sine + part.SinTurn * across);
        molecules += sun * part.Molecules;
        aerosols += sun * part.Aerosols;
      }
      const double cosine = cosView * sine + sinView * across;
      light[n] =
        static_cast<float>(MoleculePhase(cosine)) * molecules + static_cast<float>(AerosolPhase(cosine)) * aerosols;
    });
  }

  /// Light that is sent by the air of the order before.
  void SeeLater(const SightLine& line, double cosView, const Order& before, std::vector<Color>& light) const
  {
    struct Part
    {
      float CosTurn, SinTurn, CosView, PerSinView;
      Color Weight;
    };
    std::vector<Part> parts;
    std::vector<Color> blocks(line.Parts.size() * Block);
    for (const SightPart& part : line.Parts)
    {
      Color* block = &blocks[parts.size() * Block];
      const Place row = AltitudePlace(part.Altitude);
      const Place view = ViewPlace(part.CosView);
      const Color* a = &before.Sent[(static_cast<std::size_t>(row.Lower) * Views + view.Lower) * Block];
      const Color* b = a + static_cast<std::size_t>(Views) * Block;
      for (int n = 0; n < Block; ++n)
      {
        block[n] = row.Between(view.Between(a[n], a[n + Block]), view.Between(b[n], b[n + Block]));
      }
      const double sine = std::sqrt(std::max(1e-12, 1.0 - part.CosView * part.CosView));
      parts.push_back({ static_cast<float>(part.CosTurn), static_cast<float>(part.SinTurn),
        static_cast<float>(part.CosView), static_cast<float>(1.0 / sine), ColorOf(part.Molecules + part.Aerosols) });
    }
    const SunScale& scale = TheSunScale();
    const float up = static_cast<float>(cosView);
    const float side = std::sqrt(std::max(0.0F, 1.0F - up * up));
    this->ForRing([&](std::size_t n, float sine, float across) {
      const float cosine = up * sine + side * across;
      Color sum{};
      const Color* block = blocks.data();
      for (const Part& part : parts)
      {
        const float cosSun = part.CosTurn * sine + part.SinTurn * across;
        const float sinSun = std::sqrt(std::max(1e-6F, 1.0F - cosSun * cosSun));
        const float cosAzimuth = (cosine - part.CosView * cosSun) * part.PerSinView / sinSun;
        sum += part.Weight * InBlock(block, scale.At(cosSun), AzimuthPlace(cosAzimuth));
        block += Block;
      }
      light[n] = sum;
    });
  }

  /// Adds the ground at the end of a line, lit by the order before: L = albedo E / pi.
  void SeeGround(const SightLine& line, const Order& before, std::vector<Color>& light) const
  {
    if (!line.MeetsGround)
    {
      return;
    }
    const Color through = this->Reflected * ColorOf(line.Through);
    this->ForRing([&](std::size_t n, float sine, float across) {
      const Place sun =
        TheSunScale().At(static_cast<float>(line.CosTurn) * sine + static_cast<float>(line.SinTurn) * across);
      light[n] += through * sun.Between(before.Ground[sun.Lower], before.Ground[sun.Lower + 1]);
    });
  }

  const AirLayers& Air;
  float Reflected; ///< luminance of the ground by the light on it
  Sphere Around;
  std::array<float, Suns> SinSun;
  std::array<std::array<float, RingPlaces>, Suns> Across;
};

/// Adds an order to a sum; all that follow the last one by the ratio r of the last two: 1 / (1 - r).
void AddOrder(
  const Order& before, const Order& order, bool isLast, std::vector<Color>& sent, std::vector<Color>& ground)
{
  for (std::size_t node = 0; node < order.Means.size(); ++node)
  {
    Color factor = Color{} + 1.0F;
    if (isLast)
    {
      const Color ratio = order.Means[node] / AtLeast(before.Means[node], Least);
      factor = 1.0F / (1.0F - (ratio < 0.9F ? ratio : Color{} + 0.9F));
    }
    const std::size_t row = node / Suns;
    const std::size_t sun = node % Suns;
    for (int view = 0; view < Views; ++view)
    {
      const std::size_t first = (row * Views + view) * Block + sun * Azimuths;
      for (std::size_t n = first; n < first + Azimuths; ++n)
      {
        sent[n] += factor * order.Sent[n];
      }
    }
    if (row == 0)
    {
      ground[sun] += factor * order.Ground[sun];
    }
  }
}

}

LaterLight::LaterLight(const AirLayers& air, const AirParameters& parameters, const ParallelFor& parallel)
{
  const OrderMaker maker(air, parameters.GroundAlbedo);
  const int last = LastOrder(parameters);
  Order before = maker.OfSun();
  this->SentTable.resize(before.Sent.size());
  this->GroundTable.resize(before.Ground.size());
  for (int number = 1; number <= last; ++number)
  {
    Order order;
    parallel(Altitudes + 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
      {
        row < Altitudes ? maker.MakeRow(static_cast<int>(row), number, before, order)
                        : maker.MakeGround(number, before, order);
      }
    });
    AddOrder(before, order, number == last, this->SentTable, this->GroundTable);
    before = std::move(order);
  }
}

Vector3 LaterLight::Sent(double altitude, double cosView, double cosSun, double cosBetween) const
{
  const Place row = AltitudePlace(altitude);
  const Place view = ViewPlace(cosView);
  const Place sun = TheSunScale().At(static_cast<float>(cosSun));
  const double sines = std::sqrt(std::max(1e-12, (1.0 - cosView * cosView) * (1.0 - cosSun * cosSun)));
  const Place azimuth = AzimuthPlace(static_cast<float>((cosBetween - cosView * cosSun) / sines));
  const Color* a = &this->SentTable[(static_cast<std::size_t>(row.Lower) * Views + view.Lower) * Block];
  const Color* b = a + static_cast<std::size_t>(Views) * Block;
  return VectorOf(row.Between(view.Between(InBlock(a, sun, azimuth), InBlock(a + Block, sun, azimuth)),
    view.Between(InBlock(b, sun, azimuth), InBlock(b + Block, sun, azimuth))));
}

Vector3 LaterLight::OnGround(double cosSun) const
{
  const Place sun = TheSunScale().At(static_cast<float>(cosSun));
  return VectorOf(sun.Between(this->GroundTable[sun.Lower], this->GroundTable[sun.Lower + 1]));
}

}
