// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/FacesToNodes.h"

#include "Numerics/Vector3.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace littoral
{

namespace
{

using Matrix3 = glm::dmat3;

constexpr int Rings = 2; ///< of neighbours that are taken at most
constexpr double LeastDeterminant = 1e-6; ///< of the normal equations of means, beside which they have no solution

using Place = std::array<double, 2>;

Place CenterOf(const FaceCorners& face, const std::vector<Place>& nodes)
{
  Place sum{ 0.0, 0.0 };
  int count = 0;
  for (const int node : face)
  {
    if (node >= 0)
    {
      sum[0] += nodes[node][0];
      sum[1] += nodes[node][1];
      ++count;
    }
  }
  return { sum[0] / count, sum[1] / count };
}

/// Weights of values at places for that of the plane of least squares at an origin; false if they are too few.
bool FitWeights(const Place& origin, const std::vector<Place>& places, std::vector<double>& weights)
{
  double size = 0.0;
  for (const Place& place : places)
  {
    size += std::hypot(place[0] - origin[0], place[1] - origin[1]) / static_cast<double>(places.size());
  }
  // normal equations of the rows (1, dx, dy), lengths in units of the mean distance
  Matrix3 sums(0.0);
  const auto rowOf = [&](const Place& place) {
    return Vector3(1.0, (place[0] - origin[0]) / size, (place[1] - origin[1]) / size);
  };
  for (const Place& place : places)
  {
    const Vector3 row = rowOf(place);
    sums += glm::outerProduct(row, row) / static_cast<double>(places.size());
  }
  if (places.size() < 3 || !(glm::determinant(sums) > LeastDeterminant))
  {
    return false;
  }
  // the first row of the inverse gives the value at the origin
  const Vector3 first = glm::inverse(sums)[0];
  double all = 0.0;
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    weights[n] = glm::dot(first, rowOf(places[n])) / static_cast<double>(places.size());
    all += std::abs(weights[n]);
  }
  return all <= FacesToNodes::LargestWeight;
}

}

FacesToNodes::FacesToNodes(const std::vector<Place>& nodes, const std::vector<FaceCorners>& faces)
{
  std::vector<std::vector<int>> around(nodes.size());
  std::vector<Place> centers(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    centers[f] = CenterOf(faces[f], nodes);
    for (const int node : faces[f])
    {
      if (node >= 0)
      {
        around[node].push_back(static_cast<int>(f));
      }
    }
  }
  std::vector<Place> places;
  std::vector<double> weights;
  this->Begin.push_back(0);
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    std::vector<int> own = around[n];
    for (int ring = 0; ring <= Rings; ++ring)
    {
      places.clear();
      for (const int face : own)
      {
        places.push_back(centers[face]);
      }
      weights.assign(own.size(), own.empty() ? 0.0 : 1.0 / static_cast<double>(own.size()));
      if (own.empty() || FitWeights(nodes[n], places, weights))
      {
        break;
      }
      weights.assign(own.size(), 1.0 / static_cast<double>(own.size()));
      std::vector<int> wider;
      for (const int face : own)
      {
        for (const int node : faces[face])
        {
          const std::vector<int> none;
          const std::vector<int>& more = node >= 0 ? around[node] : none;
          wider.insert(wider.end(), more.begin(), more.end());
        }
      }
      std::sort(wider.begin(), wider.end());
      wider.erase(std::unique(wider.begin(), wider.end()), wider.end());
      if (ring < Rings)
      {
        own = wider;
      }
    }
    this->Faces.insert(this->Faces.end(), own.begin(), own.end());
    this->Weights.insert(this->Weights.end(), weights.begin(), weights.end());
    this->Begin.push_back(static_cast<int>(this->Faces.size()));
  }
}

double FacesToNodes::At(int node, const double* values) const
{
  const int begin = this->Begin[node];
  const int end = this->Begin[node + 1];
  double sum = begin < end ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  for (int n = begin; n < end; ++n)
  {
    sum += this->Weights[n] * values[this->Faces[n]];
  }
  return sum;
}

Vector3 FacesToNodes::At(int node, const Vector3* values) const
{
  const int begin = this->Begin[node];
  const int end = this->Begin[node + 1];
  Vector3 sum(begin < end ? 0.0 : std::numeric_limits<double>::quiet_NaN());
  for (int n = begin; n < end; ++n)
  {
    sum += this->Weights[n] * values[this->Faces[n]];
  }
  return sum;
}

}
