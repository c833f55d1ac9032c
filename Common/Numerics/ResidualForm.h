// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralResidualForm_h
#define LittoralResidualForm_h

#include <Eigen/Core>

namespace littoral
{

/// The types that Eigen's least squares ask of a function from unknowns to residuals.
struct ResidualForm
{
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum
  {
    InputsAtCompileTime = Eigen::Dynamic,
    ValuesAtCompileTime = Eigen::Dynamic
  };
};

}

#endif
