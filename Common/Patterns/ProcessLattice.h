// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralProcessLattice_h
#define LittoralProcessLattice_h

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace littoral
{

/// A rectangle of the plane [m], of which the lower and left edges belong to it.
struct PatternArea
{
  std::array<double, 2> Origin{ 0.0, 0.0 };
  std::array<double, 2> Size{ 1.0, 1.0 };

  double Measure() const { return this->Size[0] * this->Size[1]; }

  bool Contains(double x, double y) const
  {
    return x >= this->Origin[0] && y >= this->Origin[1] && x < this->Origin[0] + this->Size[0] &&
      y < this->Origin[1] + this->Size[1];
  }

  PatternArea Grown(double margin) const
  {
    return { { this->Origin[0] - margin, this->Origin[1] - margin },
      { this->Size[0] + 2.0 * margin, this->Size[1] + 2.0 * margin } };
  }
};

/// Cells of a lattice of the whole plane: First <= (i, j) <= Last.
struct CellBlock
{
  std::array<long long, 2> First{ 0, 0 };
  std::array<long long, 2> Last{ -1, -1 };

  std::size_t Columns() const { return static_cast<std::size_t>(this->Last[0] - this->First[0] + 1); }
  std::size_t Rows() const { return static_cast<std::size_t>(this->Last[1] - this->First[1] + 1); }
};

/// The plane cut into squares, the same wherever one looks: what a process draws in a square depends on nothing but the
/// seed and the square, so that all areas show parts of one pattern.
class ProcessLattice
{
public:
  explicit ProcessLattice(double side)
    : Side(side)
  {
  }

  double GetSide() const { return this->Side; }

  /// The squares that meet an area.
  CellBlock Covering(const PatternArea& area) const
  {
    CellBlock block;
    for (int axis = 0; axis < 2; ++axis)
    {
      block.First[axis] = this->IndexOf(area.Origin[axis]);
      block.Last[axis] = this->IndexOf(area.Origin[axis] + area.Size[axis]);
    }
    return block;
  }

  long long IndexOf(double place) const { return static_cast<long long>(std::floor(place / this->Side)); }

  /// Lower edge [m].
  double EdgeOf(long long index) const { return static_cast<double>(index) * this->Side; }

  /// The object of random numbers that a square is.
  static std::uint64_t ObjectOf(long long i, long long j)
  {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32 | static_cast<std::uint32_t>(j);
  }

  /// Squares beyond this index have no object of their own.
  static constexpr double MaximumIndex = 2e9;

private:
  double Side;
};

}

#endif
