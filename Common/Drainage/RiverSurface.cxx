// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/RiverSurface.h"

#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace littoral
{

namespace
{

constexpr std::size_t None = std::numeric_limits<std::size_t>::max();

/// Neighbours of each node; None where there is none.
struct Links
{
  std::vector<std::size_t> Down;
  std::vector<std::size_t> Up; ///< that of the larger area
};

Links LinksOf(const RiverNetwork& network)
{
  Links links{ std::vector<std::size_t>(network.Places.size(), None),
    std::vector<std::size_t>(network.Places.size(), None) };
  for (const std::vector<std::size_t>& course : network.Courses)
  {
    for (std::size_t k = 0; k + 1 < course.size(); ++k)
    {
      links.Down[course[k]] = course[k + 1];
      std::size_t& up = links.Up[course[k + 1]];
      up = up == None || network.Areas[course[k]] > network.Areas[up] ? course[k] : up;
    }
  }
  return links;
}

/// Node of a course; before its first and after its last one they go on straight.
Vector3 PlaceAt(const RiverNetwork& network, const std::vector<std::size_t>& course, long long k)
{
  const auto last = static_cast<long long>(course.size()) - 1;
  const auto at = [&](long long node) { return network.Places[course[static_cast<std::size_t>(node)]]; };
  return k < 0 ? 2.0 * at(0) - at(1) : k > last ? 2.0 * at(last) - at(last - 1) : at(k);
}

/// Area along a course; of its last node the one before, since there it may have reached another river.
double AreaAt(const RiverNetwork& network, const std::vector<std::size_t>& course, std::size_t k)
{
  return network.Areas[course[std::min(k, course.size() - 2)]];
}

RiverSection SectionAt(
  const RiverNetwork& network, const std::vector<std::size_t>& course, const RiverShape& shape, std::size_t k, double t)
{
  std::array<Vector3, 4> p;
  for (int n = 0; n < 4; ++n)
  {
    p[n] = PlaceAt(network, course, static_cast<long long>(k) + n - 1);
  }
  // c(t) = p1 + t (p2 - p0)/2 + t^2 (2 p0 - 5 p1 + 4 p2 - p3)/2 + t^3 (-p0 + 3 p1 - 3 p2 + p3)/2
  const Vector3 a = 0.5 * (p[2] - p[0]);
  const Vector3 b = 0.5 * (2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3]);
  const Vector3 c = 0.5 * (3.0 * (p[1] - p[2]) + p[3] - p[0]);
  const Vector3 middle = p[1] + t * (a + t * (b + t * c));
  const Vector3 along = Normalised(a + t * (2.0 * b + 3.0 * t * c));
  const double level = std::hypot(along.x, along.y);
  const Vector3 left = level > 0.0 ? Vector3(-along.y, along.x, 0.0) / level : Vector3(0.0, 1.0, 0.0);
  RiverSection section;
  section.Area = (1.0 - t) * AreaAt(network, course, k) + t * AreaAt(network, course, k + 1);
  section.Width = RiverWidth(shape, section.Area);
  // A straight fall from node to node, which goes up nowhere
  const double height = (1.0 - t) * p[1].z + t * p[2].z;
  for (int side = 0; side < 2; ++side)
  {
    section.Banks[side] = middle + (side == 0 ? 0.5 : -0.5) * section.Width * left;
    section.Banks[side].z = height;
  }
  const double run = std::hypot(p[2].x - p[1].x, p[2].y - p[1].y);
  const double slope = run > 0.0 ? (p[2].z - p[1].z) / run : 0.0;
  section.Normal = Normalised(Vector3(slope * -left.y, slope * left.x, 1.0));
  return section;
}

}

//----------------------------------------------------------------------------
std::string WhyInvalid(const RiverShape& shape)
{
  ParameterCheck check;
  check.Range("WidthOfUnitArea", shape.WidthOfUnitArea, 0.001, 1e4, "m");
  check.Range("WidthExponent", shape.WidthExponent, 0.0, 1.0);
  check.Range("Smoothing", shape.Smoothing, 0, 1000);
  check.Range("Subdivision", shape.Subdivision, 1, 100);
  return check.Reason();
}

//----------------------------------------------------------------------------
double RiverWidth(const RiverShape& shape, double area)
{
  return shape.WidthOfUnitArea * std::pow(1e-6 * area, shape.WidthExponent);
}

//----------------------------------------------------------------------------
void SmoothCourses(RiverNetwork& network, int times)
{
  const Links links = LinksOf(network);
  std::vector<Vector3> next = network.Places;
  for (int time = 0; time < times; ++time)
  {
    for (std::size_t node = 0; node < next.size(); ++node)
    {
      if (links.Up[node] != None && links.Down[node] != None)
      {
        next[node] =
          0.25 * network.Places[links.Up[node]] + 0.5 * network.Places[node] + 0.25 * network.Places[links.Down[node]];
      }
    }
    std::swap(next, network.Places);
  }
}

//----------------------------------------------------------------------------
void LetFlow(RiverNetwork& network)
{
  // Rivers upward from their ends, those of large areas first: what is downstream of a node comes before it.
  const Links links = LinksOf(network);
  std::vector<std::size_t> order(network.Places.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return network.Areas[a] > network.Areas[b]; });
  for (const std::size_t node : order)
  {
    if (links.Down[node] != None)
    {
      network.Places[node].z = std::max(network.Places[node].z, network.Places[links.Down[node]].z);
    }
  }
}

//----------------------------------------------------------------------------
std::vector<std::vector<RiverSection>> RiverSections(const RiverNetwork& network, const RiverShape& shape)
{
  std::vector<std::vector<RiverSection>> rivers;
  rivers.reserve(network.Courses.size());
  for (const std::vector<std::size_t>& course : network.Courses)
  {
    std::vector<RiverSection> sections;
    sections.reserve((course.size() - 1) * shape.Subdivision + 1);
    for (std::size_t k = 0; k + 1 < course.size(); ++k)
    {
      for (int part = 0; part < shape.Subdivision; ++part)
      {
        sections.push_back(SectionAt(network, course, shape, k, static_cast<double>(part) / shape.Subdivision));
      }
    }
    sections.push_back(SectionAt(network, course, shape, course.size() - 2, 1.0));
    rivers.push_back(std::move(sections));
  }
  return rivers;
}

}
