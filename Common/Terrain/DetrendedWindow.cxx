// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Terrain/DetrendedWindow.h"

#include "Numerics/Constants.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace littoral
{

namespace
{

/// Cells along a side at most.
constexpr int MostCells = 10;
/// Separations within two near cells are sampled in so many steps a cell, or at the values themselves.
constexpr int MostSteps = 3;
/// Directions over half a turn that stand for all.
constexpr int DirectionsForAll = 12;

/// The part of each of count even pixels that lies in each of so many even cells of the same side.
Eigen::MatrixXd Overlaps(int cells, int count)
{
  Eigen::MatrixXd overlaps(cells, count);
  for (int i = 0; i < count; ++i)
  {
    for (int c = 0; c < cells; ++c)
    {
      const double low = std::max(static_cast<double>(c) / cells, static_cast<double>(i) / count);
      const double high = std::min((c + 1.0) / cells, (i + 1.0) / count);
      overlaps(c, i) = std::max(0.0, high - low) * count;
    }
  }
  return overlaps;
}

/// Number of values in each of so many even cells; a value on the border of cells counts in part.
Eigen::MatrixXd CountInCells(const GridSamples& samples, int cellsX, int cellsY)
{
  Eigen::MatrixXd there(samples.Width, samples.Height);
  for (int j = 0; j < samples.Height; ++j)
  {
    for (int i = 0; i < samples.Width; ++i)
    {
      there(i, j) = std::isnan(samples.At(i, j)) ? 0.0 : 1.0;
    }
  }
  return Overlaps(cellsX, samples.Width) * there * Overlaps(cellsY, samples.Height).transpose();
}

/// The trend's functions f = 1, x, y at the cells' middles, in units of the window's size.
Eigen::MatrixXd TrendFunctions(Trend trend, int cellsX, int cellsY)
{
  const int cells = cellsX * cellsY;
  Eigen::MatrixXd functions(cells, trend == Trend::Plane ? 3 : 1);
  functions.col(0).setOnes();
  for (int c = 0; c < cells && trend == Trend::Plane; ++c)
  {
    const int column = c % cellsX;
    const int row = c / cellsX;
    functions(c, 1) = (column + 0.5) / cellsX - 0.5;
    functions(c, 2) = (row + 0.5) / cellsY - 0.5;
  }
  return functions;
}

/// Least squares of the trend: functions by their weights, and the eigensystem of N = sum of values f f^T.
class NormalEquations
{
public:
  NormalEquations(const Eigen::VectorXd& values, const Eigen::MatrixXd& functions)
    : Weighted(values.asDiagonal() * functions)
    , Normal(functions.transpose() * this->Weighted)
  {
    const Eigen::VectorXd& scales = this->Normal.eigenvalues();
    // A direction along which all values stand at one place has no slope.
    this->Inverse =
      (scales.array() > 1e-9 * scales.maxCoeff()).select(scales.array().inverse(), Eigen::ArrayXd::Zero(scales.size()));
  }

  /// Functions that are orthonormal over the values, times the values.
  Eigen::MatrixXd Basis() const
  {
    return this->Weighted * this->Normal.eigenvectors() * this->Inverse.cwiseSqrt().asDiagonal();
  }

  /// Weights of the cells' means in the coefficients of the functions.
  Eigen::MatrixXd Solution() const
  {
    return this->Weighted * this->Normal.eigenvectors() * this->Inverse.asDiagonal() *
      this->Normal.eigenvectors().transpose();
  }

private:
  Eigen::MatrixXd Weighted;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> Normal;
  Eigen::VectorXd Inverse; ///< of the eigenvalues
};

}

DetrendedWindow::DetrendedWindow(const GridSamples& samples, Trend trend)
  : CellsX(std::min(MostCells, samples.Width))
  , CellsY(std::min(MostCells, samples.Height))
  , CellWidth(samples.Width * samples.Spacing[0] / CellsX)
  , CellHeight(samples.Height * samples.Spacing[1] / CellsY)
{
  const Eigen::MatrixXd counts = CountInCells(samples, this->CellsX, this->CellsY);
  const int cells = this->CellsX * this->CellsY;
  const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(counts.data(), cells);
  this->Values.assign(counts.data(), counts.data() + cells);
  this->Count = values.sum();

  const NormalEquations equations(values, TrendFunctions(trend, this->CellsX, this->CellsY));
  const Eigen::MatrixXd basis = equations.Basis();
  for (int n = 0; n < basis.cols(); ++n)
  {
    this->Basis.emplace_back(basis.col(n).data(), basis.col(n).data() + cells);
  }
  if (trend == Trend::Plane)
  {
    const Eigen::MatrixXd solution = equations.Solution();
    for (int c = 0; c < cells; ++c)
    {
      this->Slope.push_back(
        { solution(c, 1) / (this->CellsX * this->CellWidth), solution(c, 2) / (this->CellsY * this->CellHeight) });
    }
  }
  this->AddNodes(samples);

  // P / n, summed over the pairs of cells of each lag.
  const int lags = this->NumberOfLags();
  this->Loss.resize(lags);
  this->PairWeights.resize(lags);
  const Eigen::MatrixXd projection = basis * basis.transpose() / this->Count;
  for (int a = 0; a < cells; ++a)
  {
    for (int b = 0; b < cells; ++b)
    {
      this->Loss[this->LagIndex(a, b)] += projection(a, b);
      this->PairWeights[this->LagIndex(a, b)] += values[a] * values[b] / (this->Count * this->Count);
    }
  }
}

/// Separations of two cells: a triangle of weights about that of their middles; far apart the middles will do.
void DetrendedWindow::AddNodes(const GridSamples& samples)
{
  const int stepsX = std::clamp((samples.Width + this->CellsX / 2) / this->CellsX, 1, MostSteps);
  const int stepsY = std::clamp((samples.Height + this->CellsY / 2) / this->CellsY, 1, MostSteps);
  for (int lag = 0; lag < this->NumberOfLags(); ++lag)
  {
    const int i = lag % (2 * this->CellsX - 1) - (this->CellsX - 1);
    const int j = lag / (2 * this->CellsX - 1);
    const bool near = std::abs(i) <= 1 && j <= 1;
    const int nx = near ? stepsX : 1;
    const int ny = near ? stepsY : 1;
    for (int b = 1 - ny; b < ny; ++b)
    {
      for (int a = 1 - nx; a < nx; ++a)
      {
        const double weight = static_cast<double>(nx - std::abs(a)) * (ny - std::abs(b)) / (nx * nx * ny * ny);
        this->Nodes.push_back({ lag, (i + static_cast<double>(a) / nx) * this->CellWidth,
          (j + static_cast<double>(b) / ny) * this->CellHeight, weight });
      }
    }
  }
}

/// Index of the separation of two cells, or of the opposite one, which has the same covariance.
int DetrendedWindow::LagIndex(int cellA, int cellB) const
{
  int i = cellB % this->CellsX - cellA % this->CellsX;
  int j = cellB / this->CellsX - cellA / this->CellsX;
  if (j < 0)
  {
    i = -i;
    j = -j;
  }
  return j * (2 * this->CellsX - 1) + i + this->CellsX - 1;
}

std::vector<std::array<double, 2>> DetrendedWindow::Separations() const
{
  std::vector<std::array<double, 2>> separations;
  for (const Node& node : this->Nodes)
  {
    separations.push_back({ node.X, node.Y });
  }
  return separations;
}

std::vector<double> DetrendedWindow::CellMeans(const std::vector<double>& atSeparations) const
{
  std::vector<double> means(this->Loss.size());
  for (std::size_t n = 0; n < this->Nodes.size(); ++n)
  {
    means[this->Nodes[n].Lag] += this->Nodes[n].Weight * atSeparations[n];
  }
  return means;
}

std::vector<double> DetrendedWindow::CellCovariances(const CovarianceFunction& covariance) const
{
  std::vector<double> values;
  for (const Node& node : this->Nodes)
  {
    values.push_back(covariance(node.X, node.Y));
  }
  return this->CellMeans(values);
}

double DetrendedWindow::LostVariance(const std::vector<double>& cellCovariances) const
{
  return std::inner_product(this->Loss.begin(), this->Loss.end(), cellCovariances.begin(), 0.0);
}

/// Imbalance of the pairs at a separation: in each cell, the part of them that ends there less the part that starts
/// there.
std::vector<double> DetrendedWindow::PairImbalance(double x, double y) const
{
  // A pair starts anywhere in its cell, and so ends in up to four.
  std::vector<double> imbalance(this->Values.size());
  double pairs = 0.0;
  const int shiftX = static_cast<int>(std::floor(x / this->CellWidth));
  const int shiftY = static_cast<int>(std::floor(y / this->CellHeight));
  const double partX = x / this->CellWidth - shiftX;
  const double partY = y / this->CellHeight - shiftY;
  for (int n = 0; n < 4; ++n)
  {
    const int stepX = shiftX + n % 2;
    const int stepY = shiftY + n / 2;
    const double part = (n % 2 ? partX : 1.0 - partX) * (n / 2 ? partY : 1.0 - partY);
    for (int j = std::max(0, -stepY); j < std::min(this->CellsY, this->CellsY - stepY); ++j)
    {
      for (int i = std::max(0, -stepX); i < std::min(this->CellsX, this->CellsX - stepX); ++i)
      {
        const int start = j * this->CellsX + i;
        const int end = start + stepY * this->CellsX + stepX;
        const double count = part * this->Values[start] * this->Values[end];
        imbalance[end] += count;
        imbalance[start] -= count;
        pairs += count;
      }
    }
  }
  for (double& value : imbalance)
  {
    value = pairs > 0.0 ? value / pairs : 0.0;
  }
  return imbalance;
}

/// Adds to each lag of cells from a cell on a multiple of the values of the cells there. In a row of cells lags are
/// neighbours, in opposite order below the cell.
void DetrendedWindow::AddPairs(
  int cell, double factor, const std::vector<double>& values, std::vector<double>& lags) const
{
  for (int row = 0; row < this->CellsY; ++row)
  {
    const int first = row * this->CellsX;
    const int step = row < cell / this->CellsX ? -1 : 1;
    double* lag = &lags[this->LagIndex(cell, first)];
    for (int i = 0; i < this->CellsX; ++i)
    {
      lag[step * i] += factor * values[first + i];
    }
  }
}

std::vector<std::vector<double>> DetrendedWindow::SemivarianceChange(
  const std::vector<LagBin>& bins, int directions) const
{
  // With the slope s = sum of w z, half the mean square of z(p + h) - z(p) - h.s is the field's semivariance plus the
  // sum over cells a, b of [h.w(a) / 2 - imbalance(a)] h.w(b) C(a, b).
  std::vector<std::vector<double>> change(bins.size(), std::vector<double>(this->Loss.size()));
  const int cells = static_cast<int>(this->Slope.size());
  const int count = directions == 1 ? DirectionsForAll : 1;
  std::vector<double> along(cells);
  for (std::size_t n = 0; n < bins.size(); ++n)
  {
    for (int direction = 0; direction < count; ++direction)
    {
      const double angle =
        directions == 1 ? Pi * (direction + 0.5) / count : std::atan2(bins[n].Separation[1], bins[n].Separation[0]);
      const double x = bins[n].Lag * std::cos(angle);
      const double y = bins[n].Lag * std::sin(angle);
      const std::vector<double> imbalance = this->PairImbalance(x, y);
      std::transform(this->Slope.begin(), this->Slope.end(), along.begin(),
        [=](const std::array<double, 2>& w) { return x * w[0] + y * w[1]; });
      for (int a = 0; a < cells; ++a)
      {
        this->AddPairs(a, (0.5 * along[a] - imbalance[a]) / count, along, change[n]);
      }
    }
  }
  return change;
}

double DetrendedWindow::VarianceDeviation(const CovarianceFunction& covariance) const
{
  // tr(R C R C) = tr(C C) - 2 tr(P C C) + tr(P C P C), with P = sum of b b^T over the trend's functions b.
  const std::vector<double> means = this->CellCovariances(covariance);
  const std::vector<double> squares = this->CellCovariances([&](double x, double y) {
    const double value = covariance(x, y);
    return value * value;
  });
  const int cells = static_cast<int>(this->Values.size());
  Eigen::MatrixXd matrix(cells, cells);
  for (int a = 0; a < cells; ++a)
  {
    for (int b = 0; b < cells; ++b)
    {
      matrix(a, b) = means[this->LagIndex(a, b)];
    }
  }
  Eigen::MatrixXd basis(cells, this->Basis.size());
  for (std::size_t n = 0; n < this->Basis.size(); ++n)
  {
    basis.col(n) = Eigen::Map<const Eigen::VectorXd>(this->Basis[n].data(), cells);
  }
  const Eigen::MatrixXd seen = matrix * basis;
  const double n2 = this->Count * this->Count;
  const double ofValues = std::inner_product(squares.begin(), squares.end(), this->PairWeights.begin(), 0.0);
  const double ofTrend =
    (Eigen::Map<const Eigen::VectorXd>(this->Values.data(), cells).asDiagonal() * seen.cwiseAbs2()).sum() / n2;
  const double ofBoth = (basis.transpose() * seen).squaredNorm() / n2;
  return std::sqrt(std::max(0.0, 2.0 * (ofValues - 2.0 * ofTrend + ofBoth)));
}

}
