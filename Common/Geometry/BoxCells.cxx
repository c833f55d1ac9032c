// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/BoxCells.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace littoral
{

namespace
{

/// Most cells along an axis.
constexpr double MostCells = 32.0;

}

BoxCells::BoxCells(const std::vector<Box>& boxes)
{
  if (boxes.empty())
  {
    return;
  }
  this->Bounds = boxes.front();
  Vector3 mean(0.0);
  for (const Box& box : boxes)
  {
    this->Bounds.Low = glm::min(this->Bounds.Low, box.Low);
    this->Bounds.High = glm::max(this->Bounds.High, box.High);
    mean += (box.High - box.Low) / static_cast<double>(boxes.size());
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = this->Bounds.High[axis] - this->Bounds.Low[axis];
    const bool isWide = size > 0.0 && std::isfinite(size);
    const double wanted = isWide ? std::ceil(2.0 * size / mean[axis]) : 1.0;
    this->Count[axis] = wanted >= 1.0 ? static_cast<int>(std::min(wanted, MostCells)) : 1;
    this->CellsAMetre[axis] = isWide ? this->Count[axis] / size : 0.0;
  }
  const auto forCells = [this](const Box& box, const auto& task) {
    std::array<int, 3> low;
    std::array<int, 3> high;
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = this->CellAlong(axis, box.Low[axis]);
      high[axis] = this->CellAlong(axis, box.High[axis]);
    }
    for (int z = low[2]; z <= high[2]; ++z)
    {
      for (int y = low[1]; y <= high[1]; ++y)
      {
        for (int x = low[0]; x <= high[0]; ++x)
        {
          task((z * this->Count[1] + y) * this->Count[0] + x);
        }
      }
    }
  };
  // Counted first, then filled in the order of the boxes.
  std::vector<int>& first = this->First;
  first.assign(static_cast<std::size_t>(this->Count[0]) * this->Count[1] * this->Count[2] + 1, 0);
  for (const Box& box : boxes)
  {
    forCells(box, [&first](int cell) { ++first[cell + 1]; });
  }
  for (std::size_t cell = 1; cell < first.size(); ++cell)
  {
    first[cell] += first[cell - 1];
  }
  this->Boxes.resize(first.back());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (std::size_t box = 0; box < boxes.size(); ++box)
  {
    forCells(boxes[box], [&](int cell) { this->Boxes[next[cell]++] = static_cast<int>(box); });
  }
}

int BoxCells::CellAlong(int axis, double position) const
{
  // Rounding keeps order, so that a place within a box is in one of the box's cells.
  const double cell = (position - this->Bounds.Low[axis]) * this->CellsAMetre[axis];
  return static_cast<int>(cell > 0.0 ? std::min(cell, this->Count[axis] - 1.0) : 0.0);
}

BoxCells::List BoxCells::Near(const Vector3& place) const
{
  int cell = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    if (!(place[axis] >= this->Bounds.Low[axis] && place[axis] <= this->Bounds.High[axis]))
    {
      return {};
    }
    cell = cell * this->Count[axis] + this->CellAlong(axis, place[axis]);
  }
  if (this->First.empty())
  {
    return {};
  }
  return { this->Boxes.data() + this->First[cell], this->Boxes.data() + this->First[cell + 1] };
}

}
