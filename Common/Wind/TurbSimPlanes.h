// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTurbSimPlanes_h
#define LittoralTurbSimPlanes_h

#include "Wind/InflowPlanes.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace littoral
{

/// Numbers as integers of 16 bits: value = (stored - Offset) / Slope.
struct Quantiser
{
  float Slope = 1.0f;
  float Offset = 0.0f;

  /// Quantiser of a range: no value in it differs from its stored one by more than (high - low) / 65535, nor more than
  /// 1.3e-7 of the largest magnitude.
  static Quantiser Of(double low, double high);

  std::int16_t Stored(float value) const;
  float Value(std::int16_t stored) const;
};

/**
 * Planes of TurbSim's full-field files, `.bts`: little-endian; a header of 70 bytes (int16 id, 7 or 8 for a periodic
 * wind; int32 points up, across, of the tower, times; float32 spacing up, across, in time, speed, heights of hub and
 * lowest points, slope and offset of each component; int32 length of the description) and the description; then for
 * each time the points of the grid and those of the tower, three int16 each.
 */
class TurbSimPlanes : public InflowPlanes
{
public:
  /// Planes to write. The grid must be valid.
  TurbSimPlanes(const InflowGrid& grid, const InflowRange& range);

  /// Planes to read, by the first bytes of a file and its size [bytes]. Throws InvalidInput.
  TurbSimPlanes(std::string_view bytes, double size);

  /// Bytes that the second constructor needs of a larger file.
  static constexpr std::size_t BytesToRead = 4096;

  std::string Header() const override;
  std::size_t BytesOfHeader() const override { return this->HeaderSize; }
  std::size_t BytesOfPlane() const override;
  void Decode(const char* const* bytes, float* velocities) const override;
  void Encode(const float* velocities, char* const* bytes) const override;

private:
  std::array<Quantiser, 3> Quantisers;
  std::size_t HeaderSize;
};

}

#endif
