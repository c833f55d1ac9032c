// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/WaterMask.h"

#include "Currents/LinearVelocity.h"

#include <utility>

namespace littoral
{

namespace
{

/// A sample acts on a spline by 0.27 a sample: after these the rest is below 1e-9 of it.
constexpr int ContinuedSamples = 16;

std::size_t NumberOf(const SampledVelocity& samples)
{
  return samples.Nodes(0).size() * samples.Nodes(1).size() * samples.Nodes(2).size();
}

}

std::array<double, 2> WaterMask::BytesOf(const SampledVelocity& samples)
{
  const std::size_t count = NumberOf(samples);
  std::size_t land = 0;
  for (std::size_t id = 0; id < count; ++id)
  {
    land += samples.IsWater(id) ? 0 : 1;
  }
  // A sample's velocity and mark, and its mark in a round; numbers of land are in three lists that grow by doubling.
  const double all = land > 0 ? static_cast<double>(count) : 0.0;
  return { (1.0 + sizeof(Vector3)) * all, all + 4.0 * sizeof(std::size_t) * static_cast<double>(land) };
}

WaterMask::WaterMask(const SampledVelocity& samples)
  : Nodes{ samples.Nodes(0), samples.Nodes(1), samples.Nodes(2) }
{
  const std::size_t count = NumberOf(samples);
  for (std::size_t id = 0; id < count; ++id)
  {
    if (!samples.IsWater(id))
    {
      this->Water.resize(count, 1);
      this->Water[id] = 0;
    }
  }
}

double WaterMask::ShareAt(const Vector3& position) const
{
  if (this->IsOpen())
  {
    return 1.0;
  }
  std::array<AxisPlace, 3> at;
  std::array<int, 3> samples{};
  for (int axis = 0; axis < 3; ++axis)
  {
    samples[axis] = static_cast<int>(this->Nodes[axis].size());
    if (!FindPlace(this->Nodes[axis], position[axis], at[axis]))
    {
      return 0.0;
    }
  }
  const auto isWater = [this](long long id) { return Vector3(this->Water[static_cast<std::size_t>(id)]); };
  return Trilinear(isWater, samples, at).x;
}

std::vector<Vector3> WaterMask::Continued(const SampledVelocity& samples) const
{
  const std::size_t columns = this->Nodes[0].size();
  const std::size_t rows = this->Nodes[1].size();
  std::vector<Vector3> values(this->Water.size());
  std::vector<std::size_t> land;
  for (std::size_t id = 0; id < values.size(); ++id)
  {
    values[id] = this->Water[id] ? samples.Sample(id) : Vector3(0.0);
    if (!this->Water[id])
    {
      land.push_back(id);
    }
  }
  std::vector<unsigned char> known = this->Water;
  for (int round = 0; round < ContinuedSamples && !land.empty(); ++round)
  {
    std::vector<std::size_t> rest;
    std::vector<std::size_t> found;
    for (const std::size_t id : land)
    {
      const std::size_t i = id % columns;
      const std::size_t j = id / columns % rows;
      Vector3 sum(0.0);
      int number = 0;
      const auto add = [&](bool isInside, std::size_t other) {
        if (isInside && known[other])
        {
          sum += values[other];
          ++number;
        }
      };
      add(i > 0, id - 1);
      add(i + 1 < columns, id + 1);
      add(j > 0, id - columns);
      add(j + 1 < rows, id + columns);
      (number > 0 ? found : rest).push_back(id);
      values[id] = number > 0 ? sum / static_cast<double>(number) : values[id];
    }
    for (const std::size_t id : found)
    {
      known[id] = 1; // for the next round: whatever the order in this one
    }
    land = std::move(rest);
  }
  return values;
}

}
