// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralKrigingSolver_h
#define LittoralKrigingSolver_h

#include "Kriging/DriftFunctions.h"

#include <Eigen/Cholesky>
#include <Eigen/Dense>

#include <cmath>
#include <cstddef>

namespace littoral
{

/**
 * Kriging system of some data, K l + F m = k and F' l = f (Chiles and Delfiner 2012, section 3.4), with the covariance
 * matrix K of the data, noise included, the drift functions F at the data and f at the target, the covariances k of the
 * data with the target, kriging weights l and Lagrange multipliers m. By the Cholesky factor K = L L', with t = L^-1 k,
 * A = L^-1 F, u = L^-1 z, G = A' A and d = f - A' t:
 *
 *   estimate  t'u + d' G^-1 A' u,   variance  C(0) - t't + d' G^-1 d.
 */
class KrigingSolver
{
public:
  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  /// Minimum pivot: the variance of a datum given those before it, as a part of its variance.
  static constexpr double MinimumPivot = 1e-13;
  /// Minimum pivot of a drift function over the data.
  static constexpr double MinimumDriftPivot = 1e-10;

  /// Factors K, of which the lower half is given and changed, and F; false with a reason in words if one is singular.
  bool Factor(Eigen::Ref<Matrix> covariances, const Matrix& drifts)
  {
    const Vector diagonal = covariances.diagonal();
    this->Cholesky.compute(covariances);
    if (this->Cholesky.info() != Eigen::Success || !this->IsWellApart(diagonal))
    {
      this->Why = "the covariance matrix of the data is singular to working precision: some data are so close that "
                  "the others tell all about them; give a nugget or measurement errors, leave data out, or take "
                  "a rougher model";
      return false;
    }
    // A = L^-1 F, G = A' A = R' R by QR; the diagonal of R is the part of each function that the ones before do not
    // have.
    const Eigen::Index count = drifts.cols();
    if (count == 0)
    {
      this->Drifts = drifts;
      return true;
    }
    this->Drifts = this->Cholesky.matrixL().solve(drifts);
    const Eigen::HouseholderQR<Matrix> qr(this->Drifts);
    bool isRegular = count <= drifts.rows();
    for (Eigen::Index n = 0; isRegular && n < count; ++n)
    {
      isRegular = std::abs(qr.matrixQR()(n, n)) > MinimumDriftPivot * this->Drifts.col(n).norm();
    }
    if (!isRegular)
    {
      this->Why = "the data cannot tell the " + std::to_string(count) +
        " functions of the drift apart; take a drift of fewer functions, or more data that are not on one line";
      return false;
    }
    this->Root = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
    return true;
  }

  /// Advice in words for a user if Factor() failed.
  const std::string& Reason() const { return this->Why; }

  /// t = L^-1 k
  template <typename Right>
  Right Lower(const Right& right) const
  {
    return this->Cholesky.matrixL().solve(right);
  }

  /// A = L^-1 F
  const Matrix& LowerDrifts() const { return this->Drifts; }

  /// R'^-1 v with G = R' R: its squares sum to v' G^-1 v.
  Matrix DriftRoot(const Matrix& v) const { return this->Root.triangularView<Eigen::Upper>().transpose().solve(v); }

  /// G^-1 v
  Vector SolveDrift(const Vector& v) const
  {
    const auto root = this->Root.triangularView<Eigen::Upper>();
    return root.solve(root.transpose().solve(v));
  }

  /// Dual weights b and c with K b + F c = z, F' b = 0, so that an estimate is k' b + f' c.
  void Dual(const Vector& z, const Matrix& drifts, Vector& b, Vector& c) const
  {
    b = this->Cholesky.solve(z);
    c = Vector::Zero(drifts.cols());
    if (drifts.cols() > 0)
    {
      // c = G^-1 F' K^-1 z, b = K^-1 (z - F c)
      c = this->SolveDrift(drifts.transpose() * b);
      b = this->Cholesky.solve(z - drifts * c);
    }
  }

private:
  bool IsWellApart(const Vector& diagonal) const
  {
    for (Eigen::Index n = 0; n < diagonal.size(); ++n)
    {
      // The square of L's diagonal is the variance of a datum given those before it.
      const double own = this->Cholesky.matrixLLT()(n, n);
      if (!(own * own > MinimumPivot * diagonal(n)))
      {
        return false;
      }
    }
    return true;
  }

  Eigen::LLT<Matrix> Cholesky;
  Matrix Drifts;
  Matrix Root;
  std::string Why;
};

}

#endif
