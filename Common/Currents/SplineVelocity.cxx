// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/SplineVelocity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace littoral
{

namespace
{

/// Whether no sample has a vertical velocity.
bool AreLevel(const SampledVelocity& samples)
{
  const std::size_t count = samples.Nodes(0).size() * samples.Nodes(1).size() * samples.Nodes(2).size();
  std::size_t id = 0;
  while (id < count && samples.Sample(id).z == 0.0)
  {
    ++id;
  }
  return id == count;
}

/// The samples that splines go through: with land they continue those of the water.
std::function<Vector3(std::size_t)> SamplesOf(const SampledVelocity& samples, const WaterMask& mask)
{
  if (mask.IsOpen())
  {
    return [&samples](std::size_t id) { return samples.Sample(id); };
  }
  return [values = mask.Continued(samples)](std::size_t id) { return values[id]; };
}

}

SplineVelocity::SplineVelocity(std::shared_ptr<const SampledVelocity> samples, const ParallelFor& parallel)
  : Samples(std::move(samples))
  , Mask(*this->Samples)
  , Spline(
      { SplineAxis(this->Samples->Nodes(0)), SplineAxis(this->Samples->Nodes(1)), SplineAxis(this->Samples->Nodes(2)) },
      SamplesOf(*this->Samples, this->Mask), this->Samples->IsSingle(), parallel)
  , IsLevelAnywhere(AreLevel(*this->Samples))
{
}

double SplineVelocity::BytesOf(const SampledVelocity& samples, int threads)
{
  const auto [kept, besides] = WaterMask::BytesOf(samples);
  const double ofSpline = VelocitySpline::BytesOf(
    { samples.Nodes(0).size(), samples.Nodes(1).size(), samples.Nodes(2).size() }, samples.IsSingle(), threads);
  return kept + std::max(besides, ofSpline);
}

bool SplineVelocity::CanBe(const SampledVelocity& samples)
{
  return SplineAxis::IsMonotone(samples.Nodes(0)) && SplineAxis::IsMonotone(samples.Nodes(1)) &&
    SplineAxis::IsMonotone(samples.Nodes(2));
}

bool SplineVelocity::IsLevelAt(double height) const
{
  // Between two level layers of samples splines need not be level, unless all layers are.
  if (this->IsLevelAnywhere)
  {
    return true;
  }
  const double position = this->Samples->PositionOf({ 0.0, 0.0, height }).z;
  const std::vector<double> nodes = this->Samples->Nodes(2);
  const bool isNode = nodes.size() == 1 || std::any_of(nodes.begin(), nodes.end(), [position](double node) {
    return std::abs(position - node) <= 1e-9 * (1.0 + std::abs(node));
  });
  return isNode && this->Samples->IsLevelAt(height);
}

Vector3 SplineVelocity::Velocity(const Vector3& position) const
{
  const Vector3 along = this->Samples->PositionOf(position);
  return this->Mask.ShareAt(along) * this->Spline.At(along);
}

}
