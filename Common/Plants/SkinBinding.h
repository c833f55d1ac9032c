// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkinBinding_h
#define LittoralSkinBinding_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace littoral
{

/**
 * The joints that the vertices of a skin follow, in runs: vertices around a branch follow the same joints alike, those
 * of a trunk the same joints with other weights. What a run has in common is kept, and read, once.
 */
class SkinBinding
{
public:
  /// The vertices [Begin, End), which follow the first Count of four joints. 32 bytes: many runs are of four vertices.
  struct Run
  {
    std::uint32_t Begin = 0;
    std::uint32_t End = 0;
    std::uint32_t FirstWeight = 0;
    std::array<int, 4> Joints{};
    std::int16_t Count = 0; ///< up to the last joint with a weight, at least 1
    bool Varies = false;    ///< each vertex has weights of its own
  };

  /// Vertices that a skin can have: all weights are counted by 32 bits.
  static constexpr std::size_t MostVertices = std::size_t{ 1 } << 30;

  SkinBinding() = default;
  /// Binding by arrays of four joints and four weights of at most MostVertices.
  SkinBinding(const int* jointIds, const float* jointWeights, std::size_t vertices);

  /// Throws InvalidInput if a skin cannot have so many vertices.
  static void RequireRoom(std::size_t vertices);

  /// The run of a vertex.
  const Run* RunOf(std::size_t vertex) const;
  /// The index of a run.
  std::size_t IndexOf(const Run* run) const { return static_cast<std::size_t>(run - this->Runs.data()); }
  const Run* RunAt(std::size_t index) const { return this->Runs.data() + index; }
  const Run* EndOfRuns() const { return this->Runs.data() + this->Runs.size(); }

  /// The weights of a vertex of a run, as many as its joints.
  const float* WeightsOf(const Run& run, std::size_t vertex) const
  {
    return this->Weights.data() + run.FirstWeight +
      (run.Varies ? static_cast<std::size_t>(run.Count) * (vertex - run.Begin) : 0);
  }

  std::size_t GetNumberOfVertices() const { return this->Runs.empty() ? 0 : this->Runs.back().End; }

  /// The arrays again, bit by bit but for the sign of zeros behind the last weight.
  void Write(int* jointIds, float* jointWeights) const;

private:
  std::vector<Run> Runs;
  std::vector<float> Weights;

  /// Adds the next vertex, by its four joints and weights.
  void Add(const int* ids, const float* weights);
};

}

#endif
