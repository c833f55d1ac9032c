// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SymmetricModes.h"

#include <Eigen/Eigenvalues>

namespace littoral::testing
{

SymmetricModes ModesOf(const Eigen::MatrixXd& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return { solver.eigenvalues(), solver.eigenvectors() };
}

Eigen::VectorXd GeneralizedValues(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass)
{
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness, mass, Eigen::EigenvaluesOnly)
    .eigenvalues();
}

}
