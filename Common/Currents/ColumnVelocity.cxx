// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/ColumnVelocity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace littoral
{

namespace
{

constexpr double Slack = 1e-9; ///< of a cell's coordinates, for places on its sides
constexpr int NewtonSteps = 20;
constexpr int MostBins = 4096; ///< along an axis
constexpr double LeastWater = 1e-9;

}

/// A place in a cell: the shares of its corners, and their slopes in x and y.
struct ColumnVelocity::CellPlace
{
  FaceCorners Corners{ -1, -1, -1, -1 };
  double Share[4];
  double Slope[4][2];
};

ColumnVelocity::ColumnVelocity(std::shared_ptr<const ColumnSamples> samples, std::vector<std::array<double, 2>> places,
  std::vector<FaceCorners> cells, CoastBehaviour coast)
  : Samples(std::move(samples))
  , Places(std::move(places))
  , Cells(std::move(cells))
  , Coast(coast)
{
  this->FindRange();
  this->FillBins();
}

double ColumnVelocity::BytesOf(std::size_t columns, std::size_t cells)
{
  // places and corners, and a bin a cell with the two cells and more that touch it
  return 16.0 * static_cast<double>(columns) + 40.0 * static_cast<double>(cells);
}

void ColumnVelocity::FindRange()
{
  const int layers = this->Samples->Layers();
  if (layers > 1)
  {
    this->Range = { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0.0, 0.0 };
  }
  for (std::size_t column = 0; column < this->Samples->Columns(); ++column)
  {
    const auto heightOf = [&](int layer) { return this->Samples->Height(column, layer); };
    for (int layer = 0; layer < layers; ++layer)
    {
      this->IsLevel =
        this->IsLevel && (!this->Samples->IsWater(column, layer) || this->Samples->Sample(column, layer).z == 0.0);
    }
    if (layers > 1)
    {
      const double first = heightOf(0), last = heightOf(layers - 1);
      const double firstStep = std::abs(heightOf(1) - first), lastStep = std::abs(last - heightOf(layers - 2));
      const bool isRising = first < last;
      this->Range.Low = std::min({ this->Range.Low, first, last });
      this->Range.High = std::max({ this->Range.High, first, last });
      this->Range.LowStep = std::max(this->Range.LowStep, isRising ? firstStep : lastStep);
      this->Range.HighStep = std::max(this->Range.HighStep, isRising ? lastStep : firstStep);
    }
  }
}

void ColumnVelocity::FillBins()
{
  if (this->Cells.empty())
  {
    this->FirstOfBin.assign(2, 0);
    return;
  }
  std::array<double, 2> high = this->Places[this->Cells[0][0]];
  this->Low = high;
  for (const FaceCorners& cell : this->Cells)
  {
    for (const int corner : cell)
    {
      for (int axis = 0; corner >= 0 && axis < 2; ++axis)
      {
        this->Low[axis] = std::min(this->Low[axis], this->Places[corner][axis]);
        high[axis] = std::max(high[axis], this->Places[corner][axis]);
      }
    }
  }
  // about as many bins as cells, as square as can be
  const double size[2] = { high[0] - this->Low[0], high[1] - this->Low[1] };
  const double side = std::sqrt(std::max(size[0] * size[1], 1e-300) / static_cast<double>(this->Cells.size()));
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Bins[axis] = static_cast<int>(std::clamp(size[axis] / side, 1.0, static_cast<double>(MostBins)));
    this->BinsPerMetre[axis] = size[axis] > 0.0 ? this->Bins[axis] / size[axis] : 0.0;
  }
  const auto binOf = [&](double value, int axis) {
    return static_cast<int>(
      std::clamp((value - this->Low[axis]) * this->BinsPerMetre[axis], 0.0, this->Bins[axis] - 1.0));
  };
  const auto forBins = [&](const FaceCorners& cell, const auto& use) {
    int from[2], to[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      double least = this->Places[cell[0]][axis], most = least;
      for (const int corner : cell)
      {
        least = corner >= 0 ? std::min(least, this->Places[corner][axis]) : least;
        most = corner >= 0 ? std::max(most, this->Places[corner][axis]) : most;
      }
      const double slack = Slack * (most - least);
      from[axis] = binOf(least - slack, axis);
      to[axis] = binOf(most + slack, axis);
    }
    for (int j = from[1]; j <= to[1]; ++j)
    {
      for (int i = from[0]; i <= to[0]; ++i)
      {
        use(static_cast<std::size_t>(j) * this->Bins[0] + i);
      }
    }
  };
  this->FirstOfBin.assign(static_cast<std::size_t>(this->Bins[0]) * this->Bins[1] + 1, 0);
  for (const FaceCorners& cell : this->Cells)
  {
    forBins(cell, [&](std::size_t bin) { ++this->FirstOfBin[bin + 1]; });
  }
  for (std::size_t bin = 1; bin < this->FirstOfBin.size(); ++bin)
  {
    this->FirstOfBin[bin] += this->FirstOfBin[bin - 1];
  }
  this->CellsOfBins.resize(static_cast<std::size_t>(this->FirstOfBin.back()));
  std::vector<int> next(this->FirstOfBin.begin(), this->FirstOfBin.end() - 1);
  for (std::size_t cell = 0; cell < this->Cells.size(); ++cell)
  {
    forBins(this->Cells[cell], [&](std::size_t bin) { this->CellsOfBins[next[bin]++] = static_cast<int>(cell); });
  }
}

bool ColumnVelocity::IsWithin(int cell, double x, double y, CellPlace& place) const
{
  const FaceCorners& corners = this->Cells[cell];
  const std::array<double, 2>& a = this->Places[corners[0]];
  const std::array<double, 2>& b = this->Places[corners[1]];
  const std::array<double, 2>& c = this->Places[corners[2]];
  const bool isQuad = corners[3] >= 0;
  const std::array<double, 2>& d = isQuad ? this->Places[corners[3]] : c;
  // p = a + r (b - a) + s (d - a) + r s (a - b + c - d), the last 0 in a triangle
  const double e[2] = { b[0] - a[0], b[1] - a[1] };
  const double f[2] = { d[0] - a[0], d[1] - a[1] };
  const double g[2] = { isQuad ? a[0] - b[0] + c[0] - d[0] : 0.0, isQuad ? a[1] - b[1] + c[1] - d[1] : 0.0 };
  double r = isQuad ? 0.5 : 0.0;
  double s = r;
  double inverse[2][2] = {}; // dr/dx, dr/dy; ds/dx, ds/dy
  for (int step = 0; step < NewtonSteps; ++step)
  {
    const double miss[2] = { x - a[0] - r * e[0] - s * f[0] - r * s * g[0],
      y - a[1] - r * e[1] - s * f[1] - r * s * g[1] };
    const double alongR[2] = { e[0] + s * g[0], e[1] + s * g[1] };
    const double alongS[2] = { f[0] + r * g[0], f[1] + r * g[1] };
    const double determinant = alongR[0] * alongS[1] - alongR[1] * alongS[0];
    if (!(std::abs(determinant) > 0.0))
    {
      return false;
    }
    inverse[0][0] = alongS[1] / determinant;
    inverse[0][1] = -alongS[0] / determinant;
    inverse[1][0] = -alongR[1] / determinant;
    inverse[1][1] = alongR[0] / determinant;
    const double dr = inverse[0][0] * miss[0] + inverse[0][1] * miss[1];
    const double ds = inverse[1][0] * miss[0] + inverse[1][1] * miss[1];
    r += dr;
    s += ds;
    if (!(std::abs(r) < 1e3 && std::abs(s) < 1e3))
    {
      return false;
    }
    if (std::abs(dr) + std::abs(ds) < 1e-13)
    {
      break;
    }
  }
  const double most = isQuad ? std::max(r, s) : r + s;
  if (!(r >= -Slack && s >= -Slack && most <= 1.0 + Slack))
  {
    return false;
  }
  place.Corners = corners;
  // shares of the corners and their slopes by r and s
  const double shares[4] = { isQuad ? (1.0 - r) * (1.0 - s) : 1.0 - r - s, isQuad ? r * (1.0 - s) : r,
    isQuad ? r * s : s, (1.0 - r) * s };
  const double byR[4] = { isQuad ? s - 1.0 : -1.0, isQuad ? 1.0 - s : 1.0, isQuad ? s : 0.0, -s };
  const double byS[4] = { isQuad ? r - 1.0 : -1.0, isQuad ? -r : 0.0, isQuad ? r : 1.0, 1.0 - r };
  for (int n = 0; n < 4; ++n)
  {
    place.Share[n] = shares[n];
    place.Slope[n][0] = byR[n] * inverse[0][0] + byS[n] * inverse[1][0];
    place.Slope[n][1] = byR[n] * inverse[0][1] + byS[n] * inverse[1][1];
  }
  return true;
}

bool ColumnVelocity::FindCell(double x, double y, CellPlace& place) const
{
  int bin[2];
  const double at[2] = { (x - this->Low[0]) * this->BinsPerMetre[0], (y - this->Low[1]) * this->BinsPerMetre[1] };
  for (int axis = 0; axis < 2; ++axis)
  {
    if (!(at[axis] >= -Slack * this->Bins[axis] && at[axis] <= (1.0 + Slack) * this->Bins[axis]))
    {
      return false;
    }
    bin[axis] = std::clamp(static_cast<int>(at[axis]), 0, this->Bins[axis] - 1);
  }
  const std::size_t number = static_cast<std::size_t>(bin[1]) * this->Bins[0] + bin[0];
  for (int n = this->FirstOfBin[number]; n < this->FirstOfBin[number + 1]; ++n)
  {
    if (this->IsWithin(this->CellsOfBins[n], x, y, place))
    {
      return true;
    }
  }
  return false;
}

Vector3 ColumnVelocity::Layer(const CellPlace& place, int layer) const
{
  Vector3 sum(0.0);
  double water = 0.0;
  double slope[2] = { 0.0, 0.0 };
  bool isCoast = false;
  for (int n = 0; n < 4; ++n)
  {
    const int corner = place.Corners[n];
    if (corner < 0)
    {
      continue;
    }
    if (!this->Samples->IsWater(corner, layer))
    {
      isCoast = true;
      continue;
    }
    sum += place.Share[n] * this->Samples->Sample(corner, layer);
    water += place.Share[n];
    slope[0] += place.Slope[n][0];
    slope[1] += place.Slope[n][1];
  }
  if (!isCoast || this->Coast == CoastBehaviour::Stop || water < LeastWater)
  {
    return sum;
  }
  // the mean of the water's corners less, towards the land, its part along the slope of the share of water
  Vector3 velocity = sum / water;
  const double steep = std::hypot(slope[0], slope[1]);
  const Vector3 offshore = steep > 0.0 ? Vector3(slope[0] / steep, slope[1] / steep, 0.0) : Vector3(0.0);
  velocity -= (1.0 - water) * std::min(0.0, glm::dot(velocity, offshore)) * offshore;
  velocity.z *= water;
  return velocity;
}

bool ColumnVelocity::IsLevelAt(double) const
{
  return this->IsLevel;
}

Vector3 ColumnVelocity::Velocity(const Vector3& position) const
{
  CellPlace place;
  if (!this->FindCell(position.x, position.y, place))
  {
    return Vector3(0.0);
  }
  const int layers = this->Samples->Layers();
  if (layers == 1)
  {
    return this->Layer(place, 0);
  }
  const auto heightOf = [&](int layer) {
    double height = 0.0;
    for (int n = 0; n < 4; ++n)
    {
      height += place.Corners[n] >= 0 ? place.Share[n] * this->Samples->Height(place.Corners[n], layer) : 0.0;
    }
    return height;
  };
  // the layer below the position, by halves; as if heights rose
  const double sign = heightOf(0) < heightOf(layers - 1) ? 1.0 : -1.0;
  int below = 0;
  int above = layers - 1;
  while (above - below > 1)
  {
    const int middle = (below + above) / 2;
    (sign * heightOf(middle) <= sign * position.z ? below : above) = middle;
  }
  const double low = sign * heightOf(below);
  const double step = sign * heightOf(above) - low;
  const double share = step > 0.0 ? (sign * position.z - low) / step : 0.0;
  if (!(share >= -1.0 && share <= 2.0))
  {
    return Vector3(0.0);
  }
  const double within = std::clamp(share, 0.0, 1.0);
  const Vector3 lower = within < 1.0 ? this->Layer(place, below) : Vector3(0.0);
  const Vector3 upper = within > 0.0 ? this->Layer(place, above) : Vector3(0.0);
  return (1.0 - within) * lower + within * upper;
}

}
