// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVolumeGather_h
#define LittoralVolumeGather_h

#include "VolumeInput.h"
#include "WriterRanks.h"

namespace littoral
{

/**
 * Tells rank 0 what the ranks hold, which then has Samples, Extent, the first Reason of all, and Volumes whose blocks
 * of other ranks are loaded box by box, while those ranks serve. Each rank must call this. On one rank: nothing to do.
 */
void GatherShapes(const WriterRanks& ranks, VolumeInput& input);

/// As long as rank 0 has one, blocks of others can be loaded. Each rank must make one, and those others Serve().
class VolumeServing
{
public:
  explicit VolumeServing(const WriterRanks& ranks)
    : Ranks(ranks)
  {
  }
  ~VolumeServing();
  VolumeServing(const VolumeServing&) = delete;
  VolumeServing& operator=(const VolumeServing&) = delete;

  /// Hands over what rank 0 asks for, until that lets go.
  void Serve(const VolumeInput& input) const;

private:
  WriterRanks Ranks;
};

}

#endif
