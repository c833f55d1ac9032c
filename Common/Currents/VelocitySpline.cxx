// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/VelocitySpline.h"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <functional>

namespace littoral
{

namespace
{

/// Lines that are solved at once.
constexpr std::size_t LinesAtOnce = 64;

/// Memory of a solver for a node [bytes].
constexpr double BytesOfSolver = 500.0;

}

bool SplineAxis::IsMonotone(const std::vector<double>& nodes)
{
  const auto none = [&](
                      auto compare) { return std::adjacent_find(nodes.begin(), nodes.end(), compare) == nodes.end(); };
  return !nodes.empty() && (none(std::greater_equal<double>()) || none(std::less_equal<double>()));
}

SplineAxis::SplineAxis(const std::vector<double>& nodes)
  : Sign(nodes.front() > nodes.back() ? -1.0 : 1.0)
  , Count(static_cast<int>(nodes.size()))
  , Degree(std::min(MaximumWeights - 1, this->Count - 1))
{
  for (const double node : nodes)
  {
    this->Nodes.push_back(this->Sign * node);
  }
  // As many knots at either end as there are weights; in between one a node, but for the second and the last but one.
  this->Knots.assign(static_cast<std::size_t>(this->Degree) + 1, this->Nodes.front());
  for (int n = 2; this->Degree == 3 && n < this->Count - 2; ++n)
  {
    this->Knots.push_back(this->Nodes[n]);
  }
  this->Knots.insert(this->Knots.end(), static_cast<std::size_t>(this->Degree) + 1, this->Nodes.back());
}

bool SplineAxis::At(double position, Weights& weights) const
{
  weights = {};
  if (this->Count == 1)
  {
    return true;
  }
  const double x = this->Sign * position;
  if (!(x >= this->Nodes.front() && x <= this->Nodes.back()))
  {
    return false;
  }
  const auto begin = this->Knots.begin() + this->Degree + 1;
  const auto span = std::upper_bound(begin, this->Knots.begin() + this->Count, x) - 1;
  weights.First = static_cast<int>(span - this->Knots.begin()) - this->Degree;
  // de Boor's recurrence: B of degree d from those of degree d - 1.
  for (int degree = 1; degree <= this->Degree; ++degree)
  {
    double carried = 0.0;
    for (int n = 0; n < degree; ++n)
    {
      const double right = span[n + 1];
      const double left = span[n + 1 - degree];
      const double part = weights.Values[n] / (right - left);
      weights.Values[n] = carried + (right - x) * part;
      carried = (x - left) * part;
    }
    weights.Values[degree] = carried;
  }
  return true;
}

void SplineAxis::Solve(std::vector<double>& values, std::size_t columns) const
{
  if (this->Degree < 2)
  {
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int node = 0; node < this->Count; ++node)
  {
    Weights weights;
    // Row of the collocation matrix: B_n at the node
    this->At(this->Sign * this->Nodes[node], weights);
    for (int n = 0; n <= this->Degree; ++n)
    {
      if (weights.Values[n] != 0.0)
      {
        entries.emplace_back(node, weights.First + n, weights.Values[n]);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(this->Count, this->Count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  Eigen::Map<Eigen::MatrixXd> lines(values.data(), this->Count, static_cast<Eigen::Index>(columns));
  lines = Eigen::MatrixXd(solver.solve(lines));
}

namespace
{

/// Samples to coefficients, three numbers each, along one axis after the other.
template <typename Real>
std::vector<Real> CoefficientsOf(
  const std::array<SplineAxis, 3>& axes, const std::function<Vector3(std::size_t)>& sample, const ParallelFor& parallel)
{
  const std::size_t count = static_cast<std::size_t>(axes[0].Size()) * static_cast<std::size_t>(axes[1].Size()) *
    static_cast<std::size_t>(axes[2].Size());
  std::vector<Real> numbers(3 * count);
  parallel(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
    {
      const Vector3 value = sample(n);
      std::transform(&value[0], &value[0] + 3, &numbers[3 * n], [](double x) { return static_cast<Real>(x); });
    }
  });
  std::size_t stride = 1;
  for (const SplineAxis& axis : axes)
  {
    const std::size_t size = static_cast<std::size_t>(axis.Size());
    const std::size_t lines = count / size;
    const std::size_t batches = (lines + LinesAtOnce - 1) / LinesAtOnce;
    parallel(axis.NumberOfWeights() > 2 ? batches : 0, [&](std::size_t begin, std::size_t end) {
      std::vector<double> values;
      for (std::size_t batch = begin; batch < end; ++batch)
      {
        const std::size_t first = batch * LinesAtOnce;
        const std::size_t many = std::min(LinesAtOnce, lines - first);
        // Each number of the batch, in the samples and among the lines that are solved.
        const auto forEach = [&](const auto& copy) {
          for (std::size_t line = 0; line < many; ++line)
          {
            const std::size_t corner = ((first + line) / stride) * stride * size + (first + line) % stride;
            for (std::size_t n = 0; n < size; ++n)
            {
              for (std::size_t component = 0; component < 3; ++component)
              {
                copy(numbers[3 * (corner + n * stride) + component], values[(3 * line + component) * size + n]);
              }
            }
          }
        };
        values.resize(3 * many * size);
        forEach([](Real number, double& value) { value = number; });
        axis.Solve(values, 3 * many);
        forEach([](Real& number, double value) { number = static_cast<Real>(value); });
      }
    });
    stride *= size;
  }
  return numbers;
}

/// Rows of coefficients along the first axis, as many numbers as `Width`, summed by the weights of the other two.
template <int Width, typename Real>
void SumRows(
  const Real* coefficients, const std::array<SplineAxis, 3>& axes, const SplineAxis::Weights weights[3], double* sum)
{
  const std::size_t width = static_cast<std::size_t>(axes[0].Size());
  const std::size_t height = static_cast<std::size_t>(axes[1].Size());
  for (int k = 0; k < axes[2].NumberOfWeights(); ++k)
  {
    for (int j = 0; j < axes[1].NumberOfWeights(); ++j)
    {
      const std::size_t layer = static_cast<std::size_t>(weights[2].First) + static_cast<std::size_t>(k);
      const std::size_t row = layer * height + static_cast<std::size_t>(weights[1].First + j);
      const Real* values = coefficients + 3 * (row * width + static_cast<std::size_t>(weights[0].First));
      const double weight = weights[2].Values[k] * weights[1].Values[j];
      for (int n = 0; n < Width; ++n)
      {
        sum[n] += weight * values[n];
      }
    }
  }
}

/// The sum of coefficients by their weights.
template <typename Real>
Vector3 Sum(const Real* coefficients, const std::array<SplineAxis, 3>& axes, const SplineAxis::Weights weights[3])
{
  double row[3 * SplineAxis::MaximumWeights] = {};
  switch (axes[0].NumberOfWeights())
  {
    case 1:
      SumRows<3>(coefficients, axes, weights, row);
      break;
    case 2:
      SumRows<6>(coefficients, axes, weights, row);
      break;
    case 3:
      SumRows<9>(coefficients, axes, weights, row);
      break;
    default:
      SumRows<12>(coefficients, axes, weights, row);
  }
  Vector3 sum(0.0);
  for (int i = 0; i < axes[0].NumberOfWeights(); ++i)
  {
    sum += weights[0].Values[i] * Vector3(row[3 * i], row[3 * i + 1], row[3 * i + 2]);
  }
  return sum;
}

}

VelocitySpline::VelocitySpline(const std::array<SplineAxis, 3>& axes, const std::function<Vector3(std::size_t)>& sample,
  bool isSingle, const ParallelFor& parallel)
  : Axes(axes)
{
  if (isSingle)
  {
    this->Single = CoefficientsOf<float>(axes, sample, parallel);
  }
  else
  {
    this->Double = CoefficientsOf<double>(axes, sample, parallel);
  }
}

double VelocitySpline::BytesOf(const std::array<std::size_t, 3>& samples, bool isSingle, int threads)
{
  const double count =
    static_cast<double>(samples[0]) * static_cast<double>(samples[1]) * static_cast<double>(samples[2]);
  const auto longest = static_cast<double>(*std::max_element(samples.begin(), samples.end()));
  // Lines that are solved at a time: their numbers, the solution and a copy of it; and the solver of each batch
  const double lines = count / longest;
  const double atOnce = static_cast<double>(LinesAtOnce);
  const double ofLines = 9.0 * sizeof(double) * longest * std::min(lines, threads * atOnce);
  const double ofSolvers = BytesOfSolver * longest * std::min(std::ceil(lines / atOnce), static_cast<double>(threads));
  return 3.0 * (isSingle ? sizeof(float) : sizeof(double)) * count + ofLines + ofSolvers;
}

Vector3 VelocitySpline::At(const Vector3& position) const
{
  SplineAxis::Weights weights[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!this->Axes[axis].At(position[axis], weights[axis]))
    {
      return Vector3(0.0);
    }
  }
  // v(x) = sum over i, j, k of B_i(x) B_j(y) B_k(z) c_ijk
  return this->Single.empty() ? Sum(this->Double.data(), this->Axes, weights)
                              : Sum(this->Single.data(), this->Axes, weights);
}

}
