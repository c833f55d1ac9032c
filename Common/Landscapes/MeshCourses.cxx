// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/MeshCourses.h"

#include "Numerics/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace littoral
{

namespace
{

/// Points that a search for a way between two points of a line takes at most.
constexpr std::size_t MostSearched = 64;

/// The link from one point to another; -1 if they are no neighbours.
CellIndex FindLink(const PointMesh& mesh, CellIndex point, CellIndex neighbour)
{
  for (CellIndex link = mesh.First[point]; link < mesh.First[point + 1]; ++link)
  {
    if (mesh.Neighbour[link] == neighbour)
    {
      return link;
    }
  }
  return -1;
}

/// Adds the points after one on the way of fewest links to another; the other alone if none is near.
void AddWay(const PointMesh& mesh, CellIndex to, std::vector<CellIndex>& points)
{
  std::vector<CellIndex> found{ points.back() };
  std::vector<std::size_t> before{ 0 };
  for (std::size_t next = 0; next < found.size() && found.size() < MostSearched && found.back() != to; ++next)
  {
    for (CellIndex link = mesh.First[found[next]]; link < mesh.First[found[next] + 1] && found.back() != to; ++link)
    {
      if (std::find(found.begin(), found.end(), mesh.Neighbour[link]) == found.end())
      {
        found.push_back(mesh.Neighbour[link]);
        before.push_back(next);
      }
    }
  }
  std::vector<CellIndex> way{ to };
  for (std::size_t at = found.back() == to ? before.back() : 0; at > 0; at = before[at])
  {
    way.push_back(found[at]);
  }
  points.insert(points.end(), way.rbegin(), way.rend());
}

/// Points of a mesh along a line, each linked to the next.
std::vector<CellIndex> PointsAlong(const PointMesh& mesh, const GivenLine& line)
{
  std::vector<CellIndex> points;
  for (const LineCell& piece : CellsAlong(line, mesh.Width, mesh.Height, mesh.Spacing))
  {
    if (points.empty())
    {
      points.push_back(piece.Cell);
    }
    else
    {
      AddWay(mesh, piece.Cell, points);
    }
  }
  return points;
}

/// Links the points of a river from its lower end upstream.
void LeadRiver(const PointMesh& mesh, const std::vector<CellIndex>& points, DisjointSets& roots, MeshCourses& courses)
{
  for (std::size_t n = points.size() - 1; n-- > 0;)
  {
    const CellIndex point = points[n];
    const CellIndex next = points[n + 1];
    const CellIndex link = FindLink(mesh, point, next);
    // a point of a river already, an outlet, or the closing of a circle goes its own way
    if (link >= 0 && courses.Link[point] < 0 && !mesh.IsRim(point) && roots.RootOf(next) != point)
    {
      courses.Link[point] = link;
      roots.Join(point, next);
    }
  }
}

/// Lowest neighbour of a point of a river that is of no river, but for the one that it drains to, and no lower than
/// that.
double LowestBank(
  const PointMesh& mesh, const MeshCourses& courses, const std::vector<double>& heights, CellIndex point)
{
  double lowest = heights[point];
  for (CellIndex link = mesh.First[point]; link < mesh.First[point + 1]; ++link)
  {
    const CellIndex bank = mesh.Neighbour[link];
    lowest = courses.Link[bank] < 0 && link != courses.Link[point] ? std::min(lowest, heights[bank]) : lowest;
  }
  return std::max(lowest, std::min(heights[point], heights[mesh.Neighbour[courses.Link[point]]]));
}

double HighestNeighbour(const PointMesh& mesh, const std::vector<double>& heights, CellIndex point)
{
  double highest = heights[point];
  for (CellIndex link = mesh.First[point]; link < mesh.First[point + 1]; ++link)
  {
    highest = std::max(highest, heights[mesh.Neighbour[link]]);
  }
  return highest;
}

}

MeshCourses CoursesOn(const PointMesh& mesh, const GivenGround& given)
{
  MeshCourses courses;
  if (!given.HasLines())
  {
    return courses;
  }
  courses.Link.assign(mesh.Points.size(), -1);
  courses.IsRidge.assign(mesh.Points.size(), 0);
  for (const GivenLine& ridge : given.Ridges)
  {
    for (const CellIndex point : PointsAlong(mesh, ridge))
    {
      courses.IsRidge[point] = 1;
    }
  }
  DisjointSets roots(mesh.Points.size());
  for (const GivenLine& river : given.Rivers)
  {
    const std::vector<CellIndex> points = PointsAlong(mesh, river);
    LeadRiver(mesh, points, roots, courses);
    for (const CellIndex point : points)
    {
      courses.IsRidge[point] = 0;
    }
  }
  return courses;
}

void CarveCourses(const PointMesh& mesh, const MeshCourses& courses, double leastSlope, std::vector<double>& heights)
{
  const std::vector<double> before = courses.IsEmpty() ? std::vector<double>() : heights;
  for (CellIndex n = 0; n < static_cast<CellIndex>(before.size()); ++n)
  {
    if (courses.Link[n] >= 0)
    {
      heights[n] = LowestBank(mesh, courses, before, n);
    }
    else if (courses.IsRidge[n] && !mesh.IsRim(n))
    {
      heights[n] = HighestNeighbour(mesh, before, n);
    }
  }
  for (CellIndex n = 0; n < static_cast<CellIndex>(before.size()); ++n)
  {
    // z_r' = min(z_r, z - S d), downstream as long as something changes
    for (CellIndex point = n; courses.Link[point] >= 0;)
    {
      const CellIndex next = mesh.Neighbour[courses.Link[point]];
      const double most = heights[point] - leastSlope * mesh.Distance[courses.Link[point]];
      if (mesh.IsRim(next) || heights[next] <= most)
      {
        break;
      }
      heights[next] = most;
      point = next;
    }
  }
}

std::vector<HeldPoint> PointsOnLines(
  const GivenGround& given, int width, int height, const std::array<double, 2>& spacing)
{
  std::vector<HeldPoint> held;
  for (const std::vector<GivenLine>* lines : { &given.Ridges, &given.Rivers })
  {
    for (const GivenLine& line : *lines)
    {
      for (const LineCell& piece : CellsAlong(line, width, height, spacing))
      {
        held.push_back({ piece.Cell, piece.Middle.Place });
      }
    }
  }
  return held;
}

}
