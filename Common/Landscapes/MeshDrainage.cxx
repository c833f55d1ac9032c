// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/MeshDrainage.h"

#include "Drainage/FlowRouting.h"
#include "Numerics/PolledMemory.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace littoral
{

namespace
{

constexpr CellIndex Unreached = -2;

/// Link of steepest descent, to no point of a ridge; -1 where no other neighbour is lower.
CellIndex SteepestLink(
  const PointMesh& mesh, const std::vector<double>& heights, const MeshCourses& courses, CellIndex point)
{
  CellIndex steepest = -1;
  double most = 0.0;
  for (CellIndex link = mesh.First[point]; link < mesh.First[point + 1]; ++link)
  {
    const double slope = (heights[point] - heights[mesh.Neighbour[link]]) / mesh.Distance[link];
    if (slope > most && (courses.IsEmpty() || !courses.IsRidge[mesh.Neighbour[link]]))
    {
      most = slope;
      steepest = link;
    }
  }
  return steepest;
}

/// Link along a given river, or of steepest descent; -1 where neither leads downhill.
CellIndex FallingLink(
  const PointMesh& mesh, const std::vector<double>& heights, const MeshCourses& courses, CellIndex point)
{
  const CellIndex course = courses.IsEmpty() ? -1 : courses.Link[point];
  if (course < 0)
  {
    return SteepestLink(mesh, heights, courses, point);
  }
  return heights[mesh.Neighbour[course]] < heights[point] ? course : -1;
}

/// Links downhill, and whether all points but the rim's have one.
bool FindLinks(const PointMesh& mesh, const std::vector<double>& heights, const MeshCourses& courses,
  const ParallelFor& parallel, std::vector<CellIndex>& links)
{
  std::atomic<bool> isDrained{ true };
  parallel(links.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const auto point = static_cast<CellIndex>(n);
      links[n] = mesh.IsRim(point) ? -1 : FallingLink(mesh, heights, courses, point);
      if (links[n] < 0 && !mesh.IsRim(point))
      {
        isDrained = false;
      }
    }
  });
  return isDrained;
}

/// The link from one point to another that is its neighbour.
CellIndex LinkTo(const PointMesh& mesh, CellIndex point, CellIndex neighbour)
{
  CellIndex link = mesh.First[point];
  while (mesh.Neighbour[link] != neighbour)
  {
    ++link;
  }
  return link;
}

/// Fills depressions, w = max(z, w of the point before), and returns the links towards the point before.
std::vector<CellIndex> FloodMesh(const PointMesh& mesh, std::vector<double>& heights, const Poll& poll)
{
  SteppedPoll steps(poll);
  using Front = std::pair<double, CellIndex>;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> open;
  std::vector<CellIndex> back(heights.size(), Unreached);
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    if (mesh.IsRim(n))
    {
      back[n] = -1;
      open.push({ heights[n], n });
    }
  }
  while (!open.empty())
  {
    steps.Step();
    const auto [level, point] = open.top();
    open.pop();
    for (CellIndex link = mesh.First[point]; link < mesh.First[point + 1]; ++link)
    {
      const CellIndex next = mesh.Neighbour[link];
      if (back[next] == Unreached)
      {
        back[next] = LinkTo(mesh, next, point);
        heights[next] = std::max(heights[next], level);
        open.push({ heights[next], next });
      }
    }
  }
  return back;
}

/// Way by which a flood comes to a point.
struct FloodWay
{
  double Level;
  CellIndex Point;
  CellIndex From;

  bool operator>(const FloodWay& other) const
  {
    return std::tie(this->Level, this->Point, this->From) > std::tie(other.Level, other.Point, other.From);
  }
};
using FloodFront = std::priority_queue<FloodWay, std::vector<FloodWay>, std::greater<>>;

/// As FloodMesh(), but up given rivers from their lower ends alone, and over ridges or into the sides of rivers only
/// once nothing else is left.
std::vector<CellIndex> FloodCourses(
  const PointMesh& mesh, const MeshCourses& courses, std::vector<double>& heights, const Poll& poll)
{
  SteppedPoll steps(poll);
  FloodFront open;
  FloodFront closed;
  std::vector<CellIndex> back(heights.size(), Unreached);
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    if (mesh.IsRim(n))
    {
      back[n] = -1;
      open.push({ heights[n], n, n });
    }
  }
  while (!open.empty() || !closed.empty())
  {
    steps.Step();
    FloodFront& front = open.empty() ? closed : open;
    const FloodWay way = front.top();
    front.pop();
    const CellIndex point = way.Point;
    const bool isOutlet = way.From == point;
    if (!isOutlet && back[point] != Unreached)
    {
      continue;
    }
    back[point] = isOutlet ? -1 : LinkTo(mesh, point, way.From);
    heights[point] = std::max(heights[point], way.Level);
    for (CellIndex link = mesh.First[point]; link < mesh.First[point + 1]; ++link)
    {
      const CellIndex next = mesh.Neighbour[link];
      if (back[next] == Unreached)
      {
        const CellIndex course = courses.Link[next];
        const bool isClosed = courses.IsRidge[point] || (course >= 0 && mesh.Neighbour[course] != point);
        (isClosed ? closed : open).push({ std::max(heights[next], heights[point]), next, point });
      }
    }
  }
  return back;
}

}

MeshDrainage DrainMesh(const PointMesh& mesh, const std::vector<double>& heights, const ParallelFor& parallel,
  const MeshCourses& courses, const Poll& poll)
{
  MeshDrainage drainage;
  Lengthen(drainage.Link, heights.size(), poll);
  if (!FindLinks(mesh, heights, courses, parallel, drainage.Link))
  {
    std::vector<double> filled = CopyOf(heights, poll);
    const std::vector<CellIndex> back =
      courses.IsEmpty() ? FloodMesh(mesh, filled, poll) : FloodCourses(mesh, courses, filled, poll);
    FindLinks(mesh, filled, courses, parallel, drainage.Link);
    for (std::size_t n = 0; n < back.size(); ++n)
    {
      drainage.Link[n] = drainage.Link[n] < 0 ? back[n] : drainage.Link[n];
    }
  }
  std::vector<CellIndex> receivers;
  Lengthen(receivers, heights.size(), poll);
  ForPolled(receivers.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      receivers[n] = drainage.Link[n] < 0 ? static_cast<CellIndex>(n) : mesh.Neighbour[drainage.Link[n]];
    }
  });
  drainage.Order = StackOrder(receivers, poll);
  drainage.Area = CopyOf(mesh.Area, poll);
  ForPolled(drainage.Order.size(), poll, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
    {
      // A_r += A, from the divides downstream
      const CellIndex point = drainage.Order[drainage.Order.size() - 1 - k];
      drainage.Area[receivers[point]] += receivers[point] == point ? 0.0 : drainage.Area[point];
    }
  });
  return drainage;
}

}
