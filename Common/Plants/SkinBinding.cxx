// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/SkinBinding.h"

#include "Numerics/InvalidInput.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace littoral
{

namespace
{

/// Joints up to the last one with a weight.
int JointsOf(const float* weights)
{
  int count = 4;
  while (count > 1 && weights[count - 1] == 0.0f)
  {
    --count;
  }
  return count;
}

template <typename Number>
bool IsSame(const Number* a, const Number* b, int count)
{
  return std::memcmp(a, b, static_cast<std::size_t>(count) * sizeof(Number)) == 0;
}

}

SkinBinding::SkinBinding(const int* jointIds, const float* jointWeights, std::size_t vertices)
{
  RequireRoom(vertices);
  for (std::size_t vertex = 0; vertex < vertices; ++vertex)
  {
    this->Add(jointIds + 4 * vertex, jointWeights + 4 * vertex);
  }
  this->Runs.shrink_to_fit();
  this->Weights.shrink_to_fit();
}

void SkinBinding::RequireRoom(std::size_t vertices)
{
  Require(vertices <= MostVertices ? "" : "a skin has more than " + std::to_string(MostVertices) + " vertices.");
}

void SkinBinding::Add(const int* ids, const float* weights)
{
  const int count = JointsOf(weights);
  const auto vertex = static_cast<std::uint32_t>(this->GetNumberOfVertices());
  if (vertex > 0)
  {
    Run& run = this->Runs.back();
    if (run.Count == count && IsSame(ids, run.Joints.data(), 4))
    {
      const bool isSame = IsSame(weights, this->Weights.data() + this->Weights.size() - count, count);
      const bool isFirst = run.End == run.Begin + 1;
      if (run.Varies || isFirst || isSame)
      {
        run.Varies = run.Varies || !isSame;
        run.End = vertex + 1;
        if (run.Varies)
        {
          this->Weights.insert(this->Weights.end(), weights, weights + count);
        }
        return;
      }
    }
  }
  this->Runs.push_back({ vertex, vertex + 1, static_cast<std::uint32_t>(this->Weights.size()),
    { ids[0], ids[1], ids[2], ids[3] }, static_cast<std::int16_t>(count), false });
  this->Weights.insert(this->Weights.end(), weights, weights + count);
}

const SkinBinding::Run* SkinBinding::RunOf(std::size_t vertex) const
{
  const auto run = std::upper_bound(
    this->Runs.begin(), this->Runs.end(), vertex, [](std::size_t own, const Run& one) { return own < one.End; });
  return this->Runs.data() + (run - this->Runs.begin());
}

void SkinBinding::Write(int* jointIds, float* jointWeights) const
{
  for (const Run& run : this->Runs)
  {
    for (std::size_t vertex = run.Begin; vertex < run.End; ++vertex)
    {
      std::copy(run.Joints.begin(), run.Joints.end(), jointIds + 4 * vertex);
      std::fill_n(jointWeights + 4 * vertex, 4, 0.0f);
      std::copy_n(this->WeightsOf(run, vertex), run.Count, jointWeights + 4 * vertex);
    }
  }
}

}
