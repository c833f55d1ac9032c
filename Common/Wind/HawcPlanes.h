// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralHawcPlanes_h
#define LittoralHawcPlanes_h

#include "Wind/InflowPlanes.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// The plane that lies first in the files of HAWC2: programs disagree.
enum class HawcOrder
{
  EarliestFirst = 0, ///< as OpenFAST reads and TurbSim writes
  LatestFirst = 1
};

/// Contents of the text file beside the three binaries.
struct HawcText
{
  InflowGrid Grid;
  std::array<std::string, 3> Names; ///< of the files of the components (along, across, up)
  HawcOrder Order = HawcOrder::EarliestFirst;
  bool SaysOrder = false;
};

/// The text: a block `wind` of HAWC2's input file with a block `mann`; what HAWC2 does not ask for as comments.
std::string WriteHawcText(const HawcText& text);

/// Reads such a block: names and sizes of the box, wsp, center_pos0; of others' blocks the order is not told. Throws
/// InvalidInput.
HawcText ReadHawcText(const std::string& bytes);

/**
 * Planes of HAWC2's turbulence boxes: a file of float32 for each component, little-endian, without a header; height
 * fastest, upwards; then across, from left to right; then plane by plane. Along the wind they hold the velocity less
 * the mean wind speed.
 */
class HawcPlanes : public InflowPlanes
{
public:
  /// The grid must be valid. Throws InvalidInput if it has points of a tower, which the files cannot hold.
  HawcPlanes(const InflowGrid& grid, HawcOrder order);

  int NumberOfFiles() const override { return 3; }
  std::size_t BytesOfPlane() const override;
  int TimeAt(int place) const override;
  void Decode(const char* const* bytes, float* velocities) const override;
  void Encode(const float* velocities, char* const* bytes) const override;

private:
  /// Calls use(point, place) for the points of a plane and their places in a file.
  template <typename Use>
  void ForPoints(const Use& use) const;

  HawcOrder Order;
};

}

#endif
