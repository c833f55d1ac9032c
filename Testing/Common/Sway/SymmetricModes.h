// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestSymmetricModes_h
#define LittoralTestSymmetricModes_h

// Eigen's solvers of symmetric matrices, compiled once for the programs that use them.

#include <Eigen/Core>

namespace littoral::testing
{

struct SymmetricModes
{
  Eigen::VectorXd Values; ///< smallest first
  Eigen::MatrixXd Vectors;
};

SymmetricModes ModesOf(const Eigen::MatrixXd& matrix);

/// Values x, smallest first, at which the determinant of stiffness - x mass is 0.
Eigen::VectorXd GeneralizedValues(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass);

}

#endif
