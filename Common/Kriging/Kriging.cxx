// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/Kriging.h"

#include "Kriging/CovarianceTable.h"
#include "Kriging/KrigingSolver.h"
#include "Kriging/PlaceTree.h"
#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace littoral
{

namespace
{

using Matrix = KrigingSolver::Matrix;
using Vector = KrigingSolver::Vector;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Steps of the table of covariances: with all data it stays in the second-level cache, with neighbours its steps are
/// short against the neighbourhoods.
constexpr std::size_t StepsForAll = 4096;
constexpr std::size_t StepsForNeighbors = 65536;

/// Largest residual of an exact datum, in the larger of the field's standard deviation and the largest value.
constexpr double MaximumResidual = 1e-10;

/// Places whose variances are computed together: as many in each call, so that no sum depends on how many are wanted.
constexpr std::size_t PlacesAtOnce = 64;

/// Eigen cuts products by the sizes of the caches, which would make the last digits depend on the machine.
void FixProducts()
{
  static const bool once = [] {
    Eigen::setCpuCacheSizes(32 << 10, 512 << 10, 4 << 20);
    return true;
  }();
  static_cast<void>(once);
}

/// The squared length of a column, summed in its order: Eigen's sums depend on where a column lies in memory.
double SquaredLength(const Matrix& matrix, Eigen::Index column)
{
  const double* values = matrix.data() + column * matrix.rows();
  double sums[4] = {};
  Eigen::Index n = 0;
  for (; n + 4 <= matrix.rows(); n += 4)
  {
    for (int m = 0; m < 4; ++m)
    {
      sums[m] += values[n + m] * values[n + m];
    }
  }
  for (; n < matrix.rows(); ++n)
  {
    sums[0] += values[n] * values[n];
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// Longest distance of two of the places and the corners of the rectangle of targets, at most.
double FarthestDistance(
  const ReducedSpace& reduce, const std::vector<KrigingPlace>& places, const KrigingOptions& options)
{
  ReducedPlace low = reduce(places[0].X, places[0].Y);
  ReducedPlace high = low;
  const auto include = [&](double x, double y) {
    const ReducedPlace place = reduce(x, y);
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], place[axis]);
      high[axis] = std::max(high[axis], place[axis]);
    }
  };
  for (const KrigingPlace& place : places)
  {
    include(place.X, place.Y);
  }
  for (const double x : { options.Low.X, options.High.X })
  {
    include(x, options.Low.Y);
    include(x, options.High.Y);
  }
  return 1.0001 * std::hypot(high[0] - low[0], high[1] - low[1]);
}

}

/// Data, covariances and drift that both neighbourhoods need.
class Kriging::Internals
{
public:
  Internals(const KrigingModel& model, KrigingData data, const KrigingOptions& options, std::size_t steps)
    : Data(std::move(data))
    , Options(options)
    , Nugget(model.Nugget)
    , Reduce(model)
    , Table(model.Field, FarthestDistance(Reduce, Data.Places, options), steps)
  {
    for (const KrigingPlace& place : this->Data.Places)
    {
      this->Reduced.push_back(this->Reduce(place.X, place.Y));
    }
  }
  virtual ~Internals() = default;
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  virtual void Estimate(const KrigingPlace* places, std::size_t count, double* estimates, double* variances) const = 0;
  virtual std::vector<LeaveOneOutEstimate> LeaveOneOut(const ParallelFor& parallel) const = 0;
  virtual std::size_t GetNeighbors() const { return this->Data.Places.size(); }

  double Noise(std::size_t datum) const { return this->Nugget + this->Data.ErrorVariance(datum); }

  KrigingData Data;
  KrigingOptions Options;
  double Nugget;
  ReducedSpace Reduce;
  CovarianceTable Table;
  std::vector<ReducedPlace> Reduced;
};

// -------------------------------------------------------------------------------------------------------------------

class Kriging::AllData : public Kriging::Internals
{
public:
  AllData(const KrigingModel& model, KrigingData data, const KrigingOptions& options, const ParallelFor& parallel)
    : Internals(model, std::move(data), options, StepsForAll)
    , Functions(options.Type, Data.Places, nullptr, Data.Places.size())
  {
    const auto count = static_cast<Eigen::Index>(this->Data.Places.size());
    this->DriftMatrix.resize(count, static_cast<Eigen::Index>(this->Functions.GetCount()));
    for (Eigen::Index n = 0; n < count; ++n)
    {
      const DriftFunctions::Values functions = this->Functions.At(this->Data.Places[n]);
      for (Eigen::Index m = 0; m < this->DriftMatrix.cols(); ++m)
      {
        this->DriftMatrix(n, m) = functions[m];
      }
    }
    Matrix covariances(count, count);
    // K(i, j) = C(x_i - x_j), i >= j, plus noise where i = j
    parallel(this->Data.Places.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t j = begin; j < end; ++j)
      {
        for (std::size_t i = j; i < this->Reduced.size(); ++i)
        {
          covariances(i, j) = this->Table.Between(this->Reduced[i], this->Reduced[j]);
        }
        covariances(j, j) += this->Noise(j);
      }
    });
    if (!this->Solver.Factor(covariances, this->DriftMatrix))
    {
      throw KrigingFailure("The kriging system cannot be solved: " + this->Solver.Reason() + ".");
    }
    this->Solve();
  }

  void Estimate(const KrigingPlace* places, std::size_t count, double* estimates, double* variances) const override
  {
    constexpr std::size_t some = CovarianceTable::PlacesAtOnce;
    std::size_t n = 0;
    for (; n + some <= count; n += some)
    {
      this->EstimateSome(places + n, estimates + n);
    }
    for (; n < count; ++n)
    {
      estimates[n] = this->EstimateAt(places[n]);
    }
    for (std::size_t first = 0; variances && first < count; first += PlacesAtOnce)
    {
      this->VariancesAt(places + first, std::min(PlacesAtOnce, count - first), variances + first);
    }
  }

  std::vector<LeaveOneOutEstimate> LeaveOneOut(const ParallelFor& parallel) const override
  {
    // P = K^-1 - K^-1 F G^-1 F' K^-1; a datum less its estimate from the others is (P z)_i / P_ii, of variance 1 / P_ii
    const Eigen::Index count = this->DriftMatrix.rows();
    const Matrix& lowerDrifts = this->Solver.LowerDrifts();
    Vector diagonal(count);
    const std::size_t blocks = (static_cast<std::size_t>(count) + PlacesAtOnce - 1) / PlacesAtOnce;
    parallel(blocks, [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin; block < end; ++block)
      {
        const auto first = static_cast<Eigen::Index>(block * PlacesAtOnce);
        const auto width = static_cast<Eigen::Index>(PlacesAtOnce);
        // Columns of L^-1: L x = e, and of A' L^-1 = F' K^-1
        Matrix columns = Matrix::Zero(count, width);
        for (Eigen::Index n = first; n < std::min(first + width, count); ++n)
        {
          columns(n, n - first) = 1.0;
        }
        columns = this->Solver.Lower(columns);
        const Matrix drift =
          lowerDrifts.cols() > 0 ? this->Solver.DriftRoot(lowerDrifts.transpose() * columns) : Matrix::Zero(1, width);
        for (Eigen::Index n = first; n < std::min(first + width, count); ++n)
        {
          diagonal(n) = SquaredLength(columns, n - first) - SquaredLength(drift, n - first);
        }
      }
    });
    std::vector<LeaveOneOutEstimate> left(count);
    for (Eigen::Index n = 0; n < count; ++n)
    {
      // Without this datum the drift is not determined.
      const bool has = diagonal(n) * (this->Table.GetVariance() + this->Noise(n)) > 1e-9;
      const double value = this->Data.Values[n];
      left[n] = has ? LeaveOneOutEstimate{ value - this->Weights(n) / diagonal(n), 1.0 / diagonal(n) }
                    : LeaveOneOutEstimate{ NaN, NaN };
    }
    return left;
  }

private:
  void Solve()
  {
    const Vector values = Eigen::Map<const Vector>(this->Data.Values.data(), this->DriftMatrix.rows());
    this->Solver.Dual(values, this->DriftMatrix, this->Weights, this->Factors);
    // Iterative refinement: the residuals, once more through the factor.
    Vector b;
    Vector c;
    this->Solver.Dual(this->Residuals(values), this->DriftMatrix, b, c);
    this->Weights += b;
    this->Factors += c;
    const double scale = std::max(std::sqrt(this->Table.GetVariance()), values.lpNorm<Eigen::Infinity>());
    const double worst = this->Residuals(values).lpNorm<Eigen::Infinity>();
    if (!(worst <= MaximumResidual * scale))
    {
      throw KrigingFailure(
        "The kriging system is singular to working precision: its solution misses the data by up to " +
        TextOf(worst / scale) +
        " of their scale; give a nugget or measurement errors, leave out data that are close together, or take a "
        "rougher model.");
    }
  }

  double EstimateAt(const KrigingPlace& place) const
  {
    // z*(x) = sum b_i C(x - x_i) + sum c_m f_m(x)
    const ReducedPlace here = this->Reduce(place.X, place.Y);
    double sum = 0.0;
    for (std::size_t n = 0; n < this->Reduced.size(); ++n)
    {
      sum += this->Weights(n) * this->Table.Between(here, this->Reduced[n]);
    }
    return this->WithDrift(sum, place);
  }

  /// The same at some places side by side, to the bit.
  void EstimateSome(const KrigingPlace* places, double* estimates) const
  {
    std::array<ReducedPlace, CovarianceTable::PlacesAtOnce> here;
    std::array<double, CovarianceTable::PlacesAtOnce> sums{};
    for (std::size_t n = 0; n < here.size(); ++n)
    {
      here[n] = this->Reduce(places[n].X, places[n].Y);
    }
    this->Table.AddWeighted(here, this->Reduced, this->Weights.data(), sums);
    for (std::size_t n = 0; n < here.size(); ++n)
    {
      estimates[n] = this->WithDrift(sums[n], places[n]);
    }
  }

  double WithDrift(double sum, const KrigingPlace& place) const
  {
    const DriftFunctions::Values functions = this->Functions.At(place);
    for (Eigen::Index m = 0; m < this->Factors.size(); ++m)
    {
      sum += this->Factors(m) * functions[m];
    }
    return sum;
  }

  void VariancesAt(const KrigingPlace* places, std::size_t count, double* variances) const
  {
    const Eigen::Index data = this->DriftMatrix.rows();
    Matrix t = Matrix::Zero(data, PlacesAtOnce);
    for (std::size_t n = 0; n < count; ++n)
    {
      const ReducedPlace here = this->Reduce(places[n].X, places[n].Y);
      for (Eigen::Index i = 0; i < data; ++i)
      {
        t(i, n) = this->Table.Between(here, this->Reduced[i]);
      }
    }
    t = this->Solver.Lower(t);
    Matrix drift = Matrix::Zero(std::max<Eigen::Index>(1, this->DriftMatrix.cols()), PlacesAtOnce);
    if (this->DriftMatrix.cols() > 0)
    {
      // d = f - A' t
      for (std::size_t n = 0; n < count; ++n)
      {
        const DriftFunctions::Values functions = this->Functions.At(places[n]);
        for (Eigen::Index m = 0; m < drift.rows(); ++m)
        {
          drift(m, n) = functions[m];
        }
      }
      drift -= this->Solver.LowerDrifts().transpose() * t;
      drift = this->Solver.DriftRoot(drift);
    }
    for (std::size_t n = 0; n < count; ++n)
    {
      const double variance = this->Table.GetVariance() - SquaredLength(t, n) + SquaredLength(drift, n);
      variances[n] = std::max(0.0, variance);
    }
  }

  /// Residuals of the dual system, z - (K b + F c).
  Vector Residuals(const Vector& values) const
  {
    Vector residuals = values;
    for (Eigen::Index n = 0; n < residuals.size(); ++n)
    {
      residuals(n) -= this->EstimateAt(this->Data.Places[n]) + this->Noise(n) * this->Weights(n);
    }
    return residuals;
  }

  DriftFunctions Functions;
  Matrix DriftMatrix;
  KrigingSolver Solver;
  Vector Weights;
  Vector Factors;
};

// -------------------------------------------------------------------------------------------------------------------

class Kriging::Neighborhoods : public Kriging::Internals
{
public:
  Neighborhoods(const KrigingModel& model, KrigingData data, const KrigingOptions& options)
    : Internals(model, std::move(data), options, StepsForNeighbors)
    , Tree(Reduced)
  {
    if (options.Neighbors < NumberOfDriftFunctions(options.Type))
    {
      throw KrigingFailure("A neighbourhood of " + std::to_string(options.Neighbors) +
        " data is too small for a drift of " + std::to_string(NumberOfDriftFunctions(options.Type)) + " functions.");
    }
  }

  std::size_t GetNeighbors() const override { return this->Options.Neighbors; }

  void Estimate(const KrigingPlace* places, std::size_t count, double* estimates, double* variances) const override
  {
    Local local;
    for (std::size_t n = 0; n < count; ++n)
    {
      this->Tree.Nearest(this->Reduce(places[n].X, places[n].Y), this->Options.Neighbors, local.Neighbors);
      const LeaveOneOutEstimate found = this->EstimateFrom(places[n], local);
      estimates[n] = found.Estimate;
      if (variances)
      {
        variances[n] = found.Variance;
      }
    }
  }

  std::vector<LeaveOneOutEstimate> LeaveOneOut(const ParallelFor& parallel) const override
  {
    std::vector<LeaveOneOutEstimate> left(this->Data.Places.size());
    parallel(left.size(), [&](std::size_t begin, std::size_t end) {
      Local local;
      for (std::size_t n = begin; n < end; ++n)
      {
        this->Tree.Nearest(this->Reduced[n], this->Options.Neighbors + 1, local.Neighbors);
        // Itself; where others are at its place, it may not be among the nearest.
        auto& neighbors = local.Neighbors;
        const auto own = std::find(neighbors.begin(), neighbors.end(), n);
        neighbors.erase(own == neighbors.end() ? neighbors.end() - 1 : own);
        left[n] = this->EstimateFrom(this->Data.Places[n], local);
        left[n].Variance += this->Noise(n);
      }
    });
    return left;
  }

private:
  /// Work space of the system of a neighbourhood.
  struct Local
  {
    std::vector<std::size_t> Neighbors;
    Matrix Covariances;
    Matrix Drifts;
    Vector Right;
    Vector Values;
    KrigingSolver Solver;
  };

  LeaveOneOutEstimate EstimateFrom(const KrigingPlace& place, Local& local) const
  {
    const ReducedPlace here = this->Reduce(place.X, place.Y);
    const auto count = static_cast<Eigen::Index>(local.Neighbors.size());
    const DriftFunctions functions(this->Options.Type, this->Data.Places, local.Neighbors.data(), count);
    const auto drifts = static_cast<Eigen::Index>(functions.GetCount());
    local.Covariances.resize(count, count);
    local.Drifts.resize(count, drifts);
    local.Right.resize(count);
    local.Values.resize(count);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const std::size_t datum = local.Neighbors[j];
      for (Eigen::Index i = j + 1; i < count; ++i)
      {
        local.Covariances(i, j) = this->Table.Between(this->Reduced[local.Neighbors[i]], this->Reduced[datum]);
      }
      local.Covariances(j, j) = this->Table.GetVariance() + this->Noise(datum);
      local.Right(j) = this->Table.Between(here, this->Reduced[datum]);
      local.Values(j) = this->Data.Values[datum];
      const DriftFunctions::Values at = functions.At(this->Data.Places[datum]);
      for (Eigen::Index m = 0; m < drifts; ++m)
      {
        local.Drifts(j, m) = at[m];
      }
    }
    if (!local.Solver.Factor(local.Covariances, local.Drifts))
    {
      throw KrigingFailure("The kriging system of a neighbourhood of " + std::to_string(count) +
        " data cannot be solved: " + local.Solver.Reason() + ".");
    }
    const Vector t = local.Solver.Lower(local.Right);
    const Vector u = local.Solver.Lower(local.Values);
    LeaveOneOutEstimate found{ t.dot(u), this->Table.GetVariance() - t.squaredNorm() };
    if (drifts > 0)
    {
      const DriftFunctions::Values at = functions.At(place);
      const Vector d = Eigen::Map<const Vector>(at.data(), drifts) - local.Solver.LowerDrifts().transpose() * t;
      const Vector own = local.Solver.DriftRoot(d);
      const Vector other = local.Solver.DriftRoot(local.Solver.LowerDrifts().transpose() * u);
      found.Estimate += own.dot(other);
      found.Variance += own.squaredNorm();
    }
    found.Variance = std::max(0.0, found.Variance);
    return found;
  }

  PlaceTree Tree;
};

// -------------------------------------------------------------------------------------------------------------------

Kriging::Kriging(
  const KrigingModel& model, KrigingData data, const KrigingOptions& options, const ParallelFor& parallel)
{
  FixProducts();
  const std::size_t count = data.Places.size();
  const std::size_t functions = NumberOfDriftFunctions(options.Type);
  if (count < functions)
  {
    throw KrigingFailure("The drift has " + std::to_string(functions) + " functions, and there " +
      (count == 1 ? "is only 1 datum" : "are only " + std::to_string(count) + " data") +
      "; take a drift of fewer functions.");
  }
  if (options.Neighbors == 0 || options.Neighbors >= count)
  {
    this->Self = std::make_unique<AllData>(model, std::move(data), options, parallel);
  }
  else
  {
    this->Self = std::make_unique<Neighborhoods>(model, std::move(data), options);
  }
}

Kriging::~Kriging() = default;

void Kriging::Estimate(const KrigingPlace* places, std::size_t count, double* estimates, double* variances) const
{
  this->Self->Estimate(places, count, estimates, variances);
}

std::vector<LeaveOneOutEstimate> Kriging::LeaveOneOut(const ParallelFor& parallel) const
{
  return this->Self->LeaveOneOut(parallel);
}

std::size_t Kriging::GetNeighbors() const
{
  return this->Self->GetNeighbors();
}

double Kriging::MemoryFor(std::size_t data, std::size_t neighbors)
{
  const auto count = static_cast<double>(data);
  const bool all = neighbors == 0 || neighbors >= data;
  // All: the matrix, its factor, and the columns of blocks in work. Neighbourhoods: places, values and the tree.
  return all ? sizeof(double) * count * (2.0 * count + 1024.0) : 160.0 * count;
}

}
