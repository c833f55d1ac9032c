// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/StemShape.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace littoral
{

namespace
{

constexpr double BreastHeightOfTrees = 1.3; // [m]
constexpr double PartOfLowTrees = 0.5;      // of the height of trees lower than 2.6 m
constexpr double StemPart = 0.9;            // of the stem, above which it is not measured
constexpr double TallestTree = 150.0;       // [m]
constexpr double ThickestTree = 20.0;       // [m]

/// Sets of vertices that triangles join; vertices at one place are one.
class Surfaces
{
public:
  Surfaces(const std::vector<Vector3>& points, const std::vector<std::array<int, 3>>& triangles)
    : Parents(points.size())
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
    std::map<std::tuple<double, double, double>, int> first;
    for (std::size_t point = 0; point < points.size(); ++point)
    {
      const Vector3& p = points[point];
      this->Join(static_cast<int>(point), first.emplace(std::tuple(p.x, p.y, p.z), point).first->second);
    }
    for (const std::array<int, 3>& triangle : triangles)
    {
      this->Join(triangle[0], triangle[1]);
      this->Join(triangle[0], triangle[2]);
    }
  }

  /// One of the vertices of the surface, the same for all of them.
  int Of(int point)
  {
    while (this->Parents[point] != point)
    {
      point = this->Parents[point] = this->Parents[this->Parents[point]];
    }
    return point;
  }

private:
  std::vector<int> Parents;

  void Join(int a, int b) { this->Parents[this->Of(a)] = this->Of(b); }
};

/// The length of the cut of a triangle by a level plane.
double CutAt(const std::array<Vector3, 3>& triangle, double height)
{
  std::array<Vector3, 3> ends;
  int count = 0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vector3& a = triangle[corner];
    const Vector3& b = triangle[(corner + 1) % 3];
    if ((a.z < height) != (b.z < height))
    {
      ends[count++] = a + (height - a.z) / (b.z - a.z) * (b - a);
    }
  }
  return count == 2 ? glm::distance(ends[0], ends[1]) : 0.0;
}

}

double BreastHeight(double height)
{
  return std::min(BreastHeightOfTrees, PartOfLowTrees * height);
}

std::string WhyInvalid(const TreeDimensions& tree, const std::string& site)
{
  ParameterCheck check;
  check.Positive("Height" + site, tree.Height, "m", TallestTree);
  check.Positive("DBH" + site, tree.Diameter, "m", ThickestTree);
  return check.Reason();
}

StemShape::StemShape(const std::vector<Vector3>& points, const std::vector<std::array<int, 3>>& triangles, double top)
  : Top(top)
{
  if (points.empty() || triangles.empty())
  {
    return;
  }
  Surfaces surfaces(points, triangles);
  const auto lowest = std::min_element(
    triangles.begin(), triangles.end(), [&](const auto& a, const auto& b) { return points[a[0]].z < points[b[0]].z; });
  const int stem = surfaces.Of((*lowest)[0]);
  for (const std::array<int, 3>& triangle : triangles)
  {
    if (surfaces.Of(triangle[0]) == stem)
    {
      this->Triangles.push_back({ points[triangle[0]], points[triangle[1]], points[triangle[2]] });
      for (const Vector3& corner : this->Triangles.back())
      {
        this->StemTop = std::max(this->StemTop, corner.z);
      }
    }
  }
}

double StemShape::DiameterAt(double height) const
{
  double girth = 0.0;
  for (const std::array<Vector3, 3>& triangle : this->Triangles)
  {
    girth += CutAt(triangle, height);
  }
  return girth / Pi;
}

double StemShape::MeasuredDiameter(double scale) const
{
  return this->DiameterAt(std::min(BreastHeight(scale * this->Top) / scale, StemPart * this->StemTop));
}

double StemShape::ScaleOfDiameter(double diameter) const
{
  // s d(h(s) / s) = D: the left side grows with s
  double low = 1e-4;
  double high = 1e4;
  for (int step = 0; step < 64; ++step)
  {
    const double middle = std::sqrt(low * high);
    (middle * this->MeasuredDiameter(middle) < diameter ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

std::string StemShape::Fit(const TreeDimensions& tree, PlantPlace& place) const
{
  place.WidthScale = 1.0;
  if (tree.Diameter > 0.0 && !(this->IsThere() && this->MeasuredDiameter(1.0) > 0.0))
  {
    return "its prototype has no stem at breast height.";
  }
  place.Scale = tree.Height > 0.0 ? tree.Height / this->Top : this->ScaleOfDiameter(tree.Diameter);
  if (tree.Height > 0.0 && tree.Diameter > 0.0)
  {
    // D = s g d(h / s)
    place.WidthScale = tree.Diameter / (place.Scale * this->MeasuredDiameter(place.Scale));
  }
  return {};
}

}
