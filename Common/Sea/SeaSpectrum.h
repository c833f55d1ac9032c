// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaSpectrum_h
#define LittoralSeaSpectrum_h

#include "Numerics/CompositeQuadrature.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace littoral
{

enum class SpectrumKind
{
  PiersonMoskowitz = 0, ///< a fully developed sea
  Jonswap = 1,          ///< a young sea with a higher peak
  Tma = 2,              ///< the same with the factor of depth, also where height and period are given
  Table = 3,            ///< measured
  Regular = 4,          ///< one wave
  OchiHubble = 5,       ///< a swell and a wind sea, each with a shape of its own
};

/// Spectrum of the energy of a sea over frequencies, by few numbers or by a table.
struct SpectrumParameters
{
  SpectrumKind Kind = SpectrumKind::PiersonMoskowitz;
  bool FromWind = true;                                   ///< else from height and period
  double WindSpeed = 10.0;                                ///< 19.5 m above the sea [m/s], positive
  double SignificantHeight = 2.0;                         ///< of one wave from trough to crest [m], positive
  double PeakPeriod = 7.0;                                ///< [s], positive
  double PeakEnhancement = 3.3;                           ///< gamma of JONSWAP and TMA, 1 to 20
  double Shape = 1.5;                                     ///< lambda of Ochi and Hubble's wind sea, 1 to 20
  double SwellHeight = 1.0;                               ///< significant height of the swell [m], positive
  double SwellPeriod = 13.0;                              ///< its peak period [s]
  double SwellShape = 4.0;                                ///< its lambda, 1 to 20
  double Depth = std::numeric_limits<double>::infinity(); ///< of the water [m], for TMA and for seas of a wind
  std::vector<double> Frequencies;                        ///< of the table [Hz], increasing, not negative
  std::vector<double> Densities;                          ///< of the table [m2/Hz], not negative
};

/// Why this is no spectrum, in words for a user; empty when it is one.
std::string WhyInvalid(const SpectrumParameters& parameters);

class SeaSpectrum;

/// Why water of a depth [m] cannot hold the waves of a spectrum: they would break. Empty if it can.
std::string WhyBroken(const SeaSpectrum& spectrum, double depth);

/**
 * The density S [m2 s/rad] of the elevation's variance over angular frequency, and its integrals.
 *
 * Pierson-Moskowitz: S = A w^-5 exp(-B/w^4), from the wind by A = alpha g2, B = beta (g/U)^4, or from height and period
 * by A = 5/16 Hs2 wp^4, B = 5/4 wp^4. JONSWAP: the same times gamma^exp(-((w/wp - 1)/sigma)^2/2), scaled to the height;
 * from a wind, to the height and the period of Pierson and Moskowitz. TMA: times tanh2(kh)/(1 + 2kh/sinh 2kh), which
 * takes energy from the waves; height and period, where they are given, are those of the sea with this factor. On water
 * of a finite depth all seas of a wind have it, a fully developed one with gamma 1, and their significant height is at
 * most 0.59 depths, that of a surf zone.
 *
 * Ochi and Hubble (1976): the sum of a swell and a wind sea, whose height and period are those given or of the wind,
 * each with S = 4 m0 x^lambda e^-x / (Gamma(lambda) w), x = (lambda + 1/4) (wp/w)^4, that of Pierson and Moskowitz for
 * lambda 1; a depth takes nothing from it.
 *
 * Regular: all energy, H2/8 of a wave H high, at one frequency, where the density is infinite; Density is 0 elsewhere.
 */
class SeaSpectrum
{
public:
  /// The parameters must be valid.
  explicit SeaSpectrum(const SpectrumParameters& parameters);

  /// Whether all energy is in one wave.
  bool IsRegular() const { return this->Given.Kind == SpectrumKind::Regular; }

  /// Whether it was measured.
  bool IsTable() const { return this->Given.Kind == SpectrumKind::Table; }

  bool HasSwell() const { return !this->Humps.empty(); }

  /// Frequency of the maximum of the wind sea beside a swell, else that of S [rad/s].
  double WindSeaPeak() const { return this->HasSwell() ? this->Humps[1].Peak : this->Peak; }

  /// Part of the density that is swell, 0 to 1; 0 unless the spectrum has one.
  double SwellPart(double frequency) const;

  /// S at an angular frequency [m2 s/rad].
  double Density(double frequency) const;

  /**
   * The integral of S between two angular frequencies [m2]: the closed form of Pierson and Moskowitz, else by panels,
   * to 1e-12 of itself. Below 0.21 peaks of its form a spectrum counts as nothing; its density there is below e^-600.
   */
  double Energy(double low, double high) const;

  /// The integral of S over all frequencies, the variance of the elevation [m2].
  double TotalEnergy() const { return this->Total; }

  /// Frequency of the maximum of S [rad/s].
  double PeakFrequency() const { return this->Peak; }

  /// Lowest and highest angular frequency that matter [rad/s]: 0.5 peaks, and 4 or half peaks more until at most 1 % of
  /// the energy lies above; of a table, where it is not 0.
  std::array<double, 2> Range() const;

private:
  /// One of the seas of Ochi and Hubble.
  struct Hump
  {
    double Variance; ///< [m2]
    double Peak;     ///< [rad/s]
    double Shape;

    double Density(double frequency) const;
    double Energy(double low, double high) const;
  };

  void FitToHeightAndPeriod();
  void AddHumps();
  void ReadTable();
  void MakePanels();
  double HighestPanel() const;
  double Shape(double frequency) const;
  double TableValue(double frequency) const;
  double FormEnergy(double low, double high) const;
  double FindPeak() const;

  SpectrumParameters Given;
  double Scale = 1.0;    ///< A; of a table 1
  double FormPeak = 1.0; ///< peak of the Pierson-Moskowitz form [rad/s]
  double Peak = 1.0;
  double Total = 0.0;
  std::vector<Hump> Humps;    ///< the swell, the wind sea
  std::vector<double> Nodes;  ///< of the table [rad/s]
  std::vector<double> Values; ///< at the nodes [m2 s/rad]
  CompositeQuadrature Panels; ///< of the shape, without the scale
};

}

#endif
