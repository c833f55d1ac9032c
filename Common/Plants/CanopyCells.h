// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCanopyCells_h
#define LittoralCanopyCells_h

#include "Numerics/Vector3.h"
#include "Numerics/WorkShare.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace littoral
{

/// Box of equal cells that foliage is counted in.
struct CanopyGrid
{
  Vector3 Origin{ 0.0, 0.0, 0.0 };  ///< lowest corner [m]
  Vector3 Spacing{ 1.0, 1.0, 1.0 }; ///< sides of a cell [m]
  std::array<int, 3> Count{ 1, 1, 1 };

  std::size_t NumberOfCells() const { return static_cast<std::size_t>(Count[0]) * Count[1] * Count[2]; }
  double CellVolume() const { return Spacing.x * Spacing.y * Spacing.z; }
  double FootArea() const { return Spacing.x * Count[0] * Spacing.y * Count[1]; }
  /// The index of a cell; x runs first.
  std::size_t IndexOf(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * Count[1] + static_cast<std::size_t>(j)) * Count[0] + i;
  }
};

/// Sums of amounts [m2, kg] that are added by any threads and processes in any order, and come out with the same bits:
/// they are kept as whole numbers of 2^-34. A sum is at most 5e8.
class OrderFreeSums
{
public:
  static constexpr double Largest = 5e8;

  explicit OrderFreeSums(std::size_t count)
    : Units(count)
  {
  }

  void Add(std::size_t index, double amount)
  {
    const auto units = static_cast<std::int64_t>(amount * PerUnit + (amount < 0.0 ? -0.5 : 0.5));
    this->Units[index].fetch_add(units, std::memory_order_relaxed);
  }
  double At(std::size_t index) const
  {
    return static_cast<double>(this->Units[index].load(std::memory_order_relaxed)) / PerUnit;
  }
  std::size_t Size() const { return this->Units.size(); }

  /// Sums over all processes, each of which then has them.
  void AddUp(const WorkShare& share);

private:
  static constexpr double PerUnit = 17179869184.0; // 2^34
  static constexpr std::int64_t LargestInDouble = std::int64_t{ 1 } << 53;
  std::vector<std::atomic<std::int64_t>> Units;
};

/// A flat convex polygon while it is cut.
struct CutPolygon
{
  static constexpr int MostCorners = 16;
  std::array<Vector3, MostCorners> Corners;
  int Size = 0;

  double Area() const;
  /// Mean place of its area.
  Vector3 Center() const;
};

/// A triangle as a polygon to be cut.
CutPolygon TriangleOf(const Vector3& a, const Vector3& b, const Vector3& c);

/// Takes the part of a polygon in a cell; Outside is the index of all that lies beyond the grid.
using TakePart = std::function<void(std::size_t cell, const CutPolygon& part)>;
inline constexpr std::size_t OutsideCells = static_cast<std::size_t>(-1);

/// Cuts a polygon at the faces of the cells. The areas of its parts add up to its own.
void CutToCells(const CanopyGrid& grid, const CutPolygon& polygon, const TakePart& take);

}

#endif
