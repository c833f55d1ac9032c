// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBladedPlanes_h
#define LittoralBladedPlanes_h

#include "Wind/InflowPlanes.h"

#include <array>
#include <string>
#include <string_view>

namespace littoral
{

/// Contents of the summary (`.sum`) beside a full-field file.
struct BladedSummary
{
  bool IsClockwise = true;                          ///< whether points across run from left to right
  double HubHeight = 0.0;                           ///< [m]
  double Speed = 0.0;                               ///< [m/s]
  std::array<double, 3> Intensity{ 0.0, 0.0, 0.0 }; ///< of turbulence, by which integers are scaled [%]
  double HeightOffset = 0.0;                        ///< of the hub above the middle of the grid [m]
  bool IsPeriodic = false;
};

/// Reads a summary: lines with CLOCKWISE, HUB HEIGHT, UBAR, three with intensities after it, HEIGHT OFFSET, PERIODIC.
/// Throws InvalidInput.
BladedSummary ReadBladedSummary(const std::string& text);

/**
 * Planes of full-field files in Bladed's form, `.wnd`, as TurbSim writes them: little-endian; a header (int16 -99, 4;
 * int32 3; float32 latitude, roughness, height of the middle, intensities [%], spacing up, across, along; int32 half
 * the number of times; float32 speed, 3 unused; int32 unused, seed, points up, across, 6 unused), then for each time
 * the points of the grid, three int16 each, in 1e-5 of speed times intensity; along the wind less the speed.
 */
class BladedPlanes : public InflowPlanes
{
public:
  /// Planes to write: the grid must be valid. Throws InvalidInput where the format cannot hold it, or values so far
  /// from the mean compared with their deviations.
  BladedPlanes(const InflowGrid& grid, const InflowRange& range);

  /// Planes to read, by the first bytes of a file, its size [bytes] and its summary. Throws InvalidInput, also where
  /// the two contradict each other.
  BladedPlanes(std::string_view bytes, double size, const BladedSummary& summary);

  /// Bytes that the second constructor needs of a larger file.
  static constexpr std::size_t BytesToRead = 104;

  std::string Header() const override;
  /// The summary that goes with the planes.
  std::string Summary() const;
  std::size_t BytesOfHeader() const override { return BytesToRead; }
  std::size_t BytesOfPlane() const override;
  void Decode(const char* const* bytes, float* velocities) const override;
  void Encode(const float* velocities, char* const* bytes) const override;

private:
  double Middle() const;
  double ScaleOf(int component) const;
  /// Calls use(value, place, component) for the values of a plane and their places in the file.
  template <typename Use>
  void ForValues(const Use& use) const;

  bool IsClockwise = true;
  std::array<double, 3> Intensity{ 0.0, 0.0, 0.0 }; ///< [%]
};

}

#endif
