// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A wind that several processes make: planes by frequency, lines by column.
#include "Wind/WindField.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace littoral
{

namespace
{

/// Most memory of the planes that a process makes before they are exchanged [bytes].
constexpr std::size_t BytesAtOnce = std::size_t{ 8 } << 20;

}

std::size_t WindField::BlocksAtOnce() const
{
  const auto [first, last] = this->FrequenciesOf(0);
  const std::size_t bytes = 2 * sizeof(float) * this->Grid.NumberOfLines() * static_cast<std::size_t>(last - first + 1);
  return std::max<std::size_t>(1, BytesAtOnce / bytes);
}

/// Makes the next own blocks, from the own one `first` on, and takes the own columns of these and of the others'.
void WindField::ShareBlocks(
  std::size_t first, SharedPlanes& planes, const WorkShare& share, const ParallelFor& parallel)
{
  const std::size_t lines = this->Grid.NumberOfLines();
  const std::size_t blocks = this->NumberOfBlocks();
  const std::size_t end = first + this->BlocksAtOnce();
  planes.Made.resize(std::min(end, share.OwnOf(blocks)) - std::min(first, share.OwnOf(blocks)));
  for (std::size_t n = 0; n < planes.Made.size(); ++n)
  {
    const auto [low, high] = this->FrequenciesOf(share.RowOf(first + n));
    planes.Made[n].resize(2 * lines * static_cast<std::size_t>(high - low + 1));
  }
  parallel(planes.Made.size(), [&](std::size_t begin, std::size_t last) {
    for (std::size_t n = begin; n < last; ++n)
    {
      const std::size_t block = share.RowOf(first + n);
      this->MakePlanesAt(block, [&, low = this->FrequenciesOf(block)[0]](int frequency) {
        float* re = &planes.Made[n][2 * lines * static_cast<std::size_t>(frequency - low)];
        return Plane{ re, re + lines };
      });
    }
  });
  if (this->Synthesis.NormalizeVariance)
  {
    this->SharePower(first, planes, share);
  }
  this->Deal(planes, share);
  const std::size_t kept = this->NumberOfKept();
  for (std::size_t process = 0; kept > 0 && process < share.Ranks; ++process)
  {
    const WorkShare other{ process, share.Ranks, {}, {}, {} };
    const float* next = planes.Received[process].data();
    for (std::size_t own = first; own < std::min(end, other.OwnOf(blocks)); ++own)
    {
      const auto [low, high] = this->FrequenciesOf(other.RowOf(own));
      for (int frequency = low; frequency <= high; ++frequency)
      {
        const bool isOwn = process == share.Rank; // and not sent
        const float* re = isOwn ? &planes.Made[own - first][2 * lines * static_cast<std::size_t>(frequency - low) +
                                    static_cast<std::size_t>(this->Columns.First) * this->Grid.Count[2]]
                                : next;
        const Plane plane = this->KeptPlane(frequency);
        std::copy_n(re, kept, plane.Re);
        std::copy_n(re + (isOwn ? lines : kept), kept, plane.Im);
        next += isOwn ? 0 : 2 * kept;
      }
    }
  }
}

/// Sends each other process its columns of the planes that were made, and gets the own ones of those of the others.
void WindField::Deal(SharedPlanes& planes, const WorkShare& share) const
{
  const auto lines = static_cast<std::ptrdiff_t>(this->Grid.NumberOfLines());
  planes.Sent.resize(share.Ranks);
  for (std::size_t process = 0; process < share.Ranks; ++process)
  {
    if (process == share.Rank)
    {
      continue;
    }
    const WindColumns& columns = planes.Columns[process];
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(columns.First) * this->Grid.Count[2];
    const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(columns.Count()) * this->Grid.Count[2];
    std::vector<float>& sent = planes.Sent[process];
    sent.clear();
    for (const std::vector<float>& block : planes.Made)
    {
      for (auto plane = block.begin(); plane != block.end(); plane += lines)
      {
        sent.insert(sent.end(), plane + from, plane + from + count);
      }
    }
  }
  share.Deal(planes.Sent, planes.Received);
}

/// Adds the power of own blocks from the own one `first` on and of the others' beside them, in the order of their
/// frequencies: sums go from process to process.
void WindField::SharePower(std::size_t first, const SharedPlanes& planes, const WorkShare& share)
{
  const std::size_t lines = this->Grid.NumberOfLines();
  const std::size_t last = std::min((first + this->BlocksAtOnce()) * share.Ranks, this->NumberOfBlocks());
  for (std::size_t block = first * share.Ranks; block < last; ++block)
  {
    const std::size_t owner = block % share.Ranks;
    if (owner == share.Rank)
    {
      const std::vector<float>& made = planes.Made[block / share.Ranks - first];
      for (std::size_t at = 0; at < made.size(); at += 2 * lines)
      {
        this->AddPower(&made[at], &made[at + lines]);
      }
    }
    NumberRows sums(share.Ranks);
    sums[share.Rank] = this->LayerPower;
    share.Complete(sums);
    this->LayerPower = sums[owner];
  }
}

std::vector<float> WindField::MakeShared(const WorkShare& share, const ParallelFor& parallel)
{
  NumberRows bounds(share.Ranks);
  bounds[share.Rank] = { static_cast<double>(this->Columns.First), static_cast<double>(this->Columns.End) };
  share.Complete(bounds);
  SharedPlanes planes;
  for (const std::vector<double>& bound : bounds)
  {
    planes.Columns.push_back({ static_cast<int>(bound[0]), static_cast<int>(bound[1]) });
  }
  std::vector<float> velocities(this->NumberOfKept() * this->Grid.Count[0] * WindComponents);
  for (int component = 0; component < WindComponents; ++component)
  {
    this->BeginComponent(component);
    const WorkShare most{ 0, share.Ranks, {}, {}, {} }; // the first process has the most blocks
    for (std::size_t first = 0; first < most.OwnOf(this->NumberOfBlocks()); first += this->BlocksAtOnce())
    {
      this->ShareBlocks(first, planes, share, parallel);
    }
    this->TakeError();
    if (this->Synthesis.NormalizeVariance)
    {
      this->TakeLayerFactors();
    }
    this->MakeAllLines(velocities.data(), parallel);
  }
  NumberRows errors(share.Ranks);
  errors[share.Rank] = { this->CoherenceError };
  share.Complete(errors);
  for (const std::vector<double>& error : errors)
  {
    this->CoherenceError = std::max(this->CoherenceError, error[0]);
  }
  return velocities;
}

}
