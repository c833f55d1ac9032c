// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/WalledVelocity.h"

#include <algorithm>
#include <utility>

namespace littoral
{

WalledVelocity::WalledVelocity(std::shared_ptr<const VelocityGrid> grid, const WaterLayer& layer)
  : Grid(std::move(grid))
  , Layer(layer)
  , Range(this->Grid->Heights())
{
  this->ReachesBed = layer.HasBed() && this->Range.Low - layer.Bed <= this->Range.LowStep;
  this->ReachesSurface = layer.HasSurface() && layer.Surface - this->Range.High <= this->Range.HighStep;
  const auto crosses = [&](double wall) {
    return wall >= this->Range.Low && wall <= this->Range.High && !this->Grid->IsLevelAt(wall);
  };
  this->CrossesBed = layer.HasBed() && crosses(layer.Bed);
  this->CrossesSurface = layer.HasSurface() && crosses(layer.Surface);
}

Vector3 WalledVelocity::Velocity(const Vector3& position) const
{
  Vector3 at = position;
  double share = 1.0; // of the vertical velocity, between the end of the grid and a wall
  if (this->ReachesSurface && position.z > this->Range.High)
  {
    at.z = this->Range.High;
    share = std::max(0.0, (this->Layer.Surface - position.z) / (this->Layer.Surface - this->Range.High));
  }
  else if (this->ReachesBed && position.z < this->Range.Low)
  {
    at.z = this->Range.Low;
    share = std::max(0.0, (position.z - this->Layer.Bed) / (this->Range.Low - this->Layer.Bed));
  }
  Vector3 flow = this->Grid->Velocity(at);
  flow.z = share * flow.z - this->WallVelocity(position);
  return flow;
}

/// The vertical velocities at the walls, interpolated at a position.
double WalledVelocity::WallVelocity(const Vector3& position) const
{
  if (!this->CrossesBed && !this->CrossesSurface)
  {
    return 0.0;
  }
  if ((position.z < this->Range.Low && !this->ReachesBed) || (position.z > this->Range.High && !this->ReachesSurface))
  {
    return 0.0; // the grid has no flow there
  }
  const auto at = [&](bool crosses, double wall) {
    return crosses ? this->Grid->Velocity({ position.x, position.y, wall }).z : 0.0;
  };
  const double bed = at(this->CrossesBed, this->Layer.Bed);
  const double surface = at(this->CrossesSurface, this->Layer.Surface);
  if (!this->ReachesBed || !this->ReachesSurface)
  {
    return bed + surface; // of which one is 0
  }
  const double part = std::clamp((position.z - this->Layer.Bed) / this->Layer.Depth(), 0.0, 1.0);
  return (1.0 - part) * bed + part * surface;
}

}
