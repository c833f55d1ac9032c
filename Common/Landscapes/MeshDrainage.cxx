// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Landscapes/MeshDrainage.h"

#include "Drainage/FlowRouting.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <queue>
#include <utility>

namespace littoral
{

namespace
{

constexpr CellIndex Unreached = -2;

/// Link of steepest descent; -1 where no neighbour is lower.
CellIndex SteepestLink(const PointMesh& mesh, const std::vector<double>& heights, CellIndex point)
{
  CellIndex steepest = -1;
  double most = 0.0;
  for (CellIndex link = mesh.First[point]; link < mesh.First[point + 1]; ++link)
  {
    const double slope = (heights[point] - heights[mesh.Neighbour[link]]) / mesh.Distance[link];
    if (slope > most)
    {
      most = slope;
      steepest = link;
    }
  }
  return steepest;
}

/// Links of steepest descent, and whether all points but the rim's have one.
bool FindLinks(
  const PointMesh& mesh, const std::vector<double>& heights, const ParallelFor& parallel, std::vector<CellIndex>& links)
{
  std::atomic<bool> isDrained{ true };
  parallel(links.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const auto point = static_cast<CellIndex>(n);
      links[n] = mesh.IsRim(point) ? -1 : SteepestLink(mesh, heights, point);
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
std::vector<CellIndex> FloodMesh(const PointMesh& mesh, std::vector<double>& heights)
{
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

}

MeshDrainage DrainMesh(const PointMesh& mesh, const std::vector<double>& heights, const ParallelFor& parallel)
{
  MeshDrainage drainage;
  drainage.Link.resize(heights.size());
  if (!FindLinks(mesh, heights, parallel, drainage.Link))
  {
    std::vector<double> filled = heights;
    const std::vector<CellIndex> back = FloodMesh(mesh, filled);
    FindLinks(mesh, filled, parallel, drainage.Link);
    for (std::size_t n = 0; n < back.size(); ++n)
    {
      drainage.Link[n] = drainage.Link[n] < 0 ? back[n] : drainage.Link[n];
    }
  }
  std::vector<CellIndex> receivers(heights.size());
  for (CellIndex n = 0; n < mesh.Count(); ++n)
  {
    receivers[n] = drainage.Link[n] < 0 ? n : mesh.Neighbour[drainage.Link[n]];
  }
  drainage.Order = StackOrder(receivers);
  drainage.Area = mesh.Area;
  for (std::size_t k = drainage.Order.size(); k-- > 0;)
  {
    // A_r += A, from the divides downstream
    const CellIndex point = drainage.Order[k];
    drainage.Area[receivers[point]] += receivers[point] == point ? 0.0 : drainage.Area[point];
  }
  return drainage;
}

}
