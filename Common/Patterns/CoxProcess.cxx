// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"
#include "Patterns/PoissonCount.h"
#include "Patterns/ProcessDraws.h"
#include "Terrain/TurningBands.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace littoral
{

namespace
{

/// Rows of the field that are made at a time.
constexpr std::size_t RowsAtOnce = 32;

/// Gaussian field of the log-intensity: the same for any window of the plane.
TurningBandsParameters FieldOf(const ProcessScene& scene)
{
  TurningBandsParameters bands;
  bands.Field.Model = CovarianceModel::SimpleExponential;
  bands.Field.Variance = scene.Process.Variance;
  bands.Field.Range = scene.Process.Range;
  bands.NumberOfLines = 128;
  bands.Seed = scene.Options.Seed;
  bands.Purpose = RandomPurpose::ProcessField;
  return bands;
}

/// Draws the points of the squares of some rows.
class CoxRows
{
public:
  CoxRows(
    const ProcessScene& scene, const ProcessLattice& lattice, const CellBlock& block, const TurningBandsField& field)
    : Scene(scene)
    , Lattice(lattice)
    , Block(block)
    , Field(field)
    , Counts(scene.Options.Seed, RandomPurpose::ProcessCells)
    , Places(scene.Options.Seed, RandomPurpose::ProcessPoints)
  {
  }

  void Draw(std::size_t firstRow, std::size_t endRow, ProcessPattern& pattern) const
  {
    std::vector<float> values(this->Block.Columns() * (endRow - firstRow));
    const long long first = this->Block.First[1] + static_cast<long long>(firstRow);
    const long long last = this->Block.First[1] + static_cast<long long>(endRow) - 1;
    this->Field.FillRows(static_cast<int>(first), static_cast<int>(last), 1.0, 0.0, values.data());
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      const long long i = this->Block.First[0] + static_cast<long long>(n % this->Block.Columns());
      const long long j = first + static_cast<long long>(n / this->Block.Columns());
      this->DrawSquare(i, j, static_cast<double>(values[n]), pattern);
    }
  }

private:
  /// Poisson points of the intensity lambda exp(z - s^2 / 2), with the variance s^2 of z.
  void DrawSquare(long long i, long long j, double z, ProcessPattern& pattern) const
  {
    const double side = this->Lattice.GetSide();
    const double mean = this->Scene.Process.Intensity * side * side * std::exp(z - 0.5 * this->Scene.Process.Variance);
    const std::uint64_t square = ProcessLattice::ObjectOf(i, j);
    const long long count = PoissonCount(mean, this->Counts, square, 0);
    for (long long n = 0; n < count; ++n)
    {
      const auto index = static_cast<std::uint64_t>(n);
      const auto u = this->Places.UniformPair(square, index);
      const PlanePosition place = { this->Lattice.EdgeOf(i) + side * u[0], this->Lattice.EdgeOf(j) + side * u[1] };
      KeepPoint(this->Scene, place, { square, index }, pattern);
    }
  }

  const ProcessScene& Scene;
  const ProcessLattice& Lattice;
  const CellBlock& Block;
  const TurningBandsField& Field;
  RandomStream Counts;
  RandomStream Places;
};

}

ProcessPattern DrawCox(const ProcessScene& scene)
{
  const ProcessLattice lattice(FieldSide(scene.Process));
  const CellBlock block = lattice.Covering(scene.Box);
  const double side = lattice.GetSide();
  const PlaneGrid grid{ { 0.5 * side, 0.5 * side }, { side, side } };
  GridWindow window;
  for (int axis = 0; axis < 2; ++axis)
  {
    window.First[axis] = static_cast<int>(block.First[axis]);
    window.Last[axis] = static_cast<int>(block.Last[axis]);
  }
  TurningBandsField field(FieldOf(scene), grid, window);
  scene.Parallel(field.GetNumberOfLines(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line)
    {
      field.TabulateLine(line);
    }
  });
  const CoxRows rows(scene, lattice, block, field);
  std::vector<ProcessPattern> parts((block.Rows() + RowsAtOnce - 1) / RowsAtOnce);
  scene.Parallel(parts.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part)
    {
      rows.Draw(part * RowsAtOnce, std::min(block.Rows(), (part + 1) * RowsAtOnce), parts[part]);
    }
  });
  return Joined(parts, scene.Parallel);
}

}
