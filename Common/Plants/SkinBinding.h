// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSkinBinding_h
#define LittoralSkinBinding_h

#include <array>
#include <cstddef>
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
  /// The vertices [Begin, End), which follow the first Count of four joints.
  struct Run
  {
    std::size_t Begin = 0;
    std::size_t End = 0;
    std::size_t FirstWeight = 0;
    std::array<int, 4> Joints{};
    int Count = 0;       ///< up to the last joint with a weight, at least 1
    bool Varies = false; ///< each vertex has weights of its own
  };

  SkinBinding() = default;
  /// Binding by arrays of four joints and four weights a vertex.
  SkinBinding(const int* jointIds, const float* jointWeights, std::size_t vertices);

  /// The run of a vertex.
  const Run* RunOf(std::size_t vertex) const;
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

  void Add(const int* ids, const float* weights);
};

}

#endif
