// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCompositeQuadrature_h
#define LittoralCompositeQuadrature_h

#include <cstddef>
#include <functional>
#include <vector>

namespace littoral
{

/**
 * Integrals of one function over many intervals, by the rule of Gauss and Legendre with ten points on panels that are
 * made once: between cuts, where the function is smooth, a panel is halved until its rule agrees with that of its
 * halves to a part of 1e-12, 40 times at most.
 *
 * An interval takes one rule in a panel, or two and the integrals of the panels between them, which are added, never
 * subtracted: small integrals of a function that is not negative are as good, relative to themselves, as large ones.
 */
class CompositeQuadrature
{
public:
  using Function = std::function<double(double)>;

  /// Rule without panels; all integrals are 0.
  CompositeQuadrature() = default;

  /// Rule for a function that is not negative, finite between its cuts, two or more of them, increasing. Panels and
  /// their halves agree to a part of their integral, which must be above what rounding makes of the function.
  CompositeQuadrature(const Function& function, const std::vector<double>& cuts, double agreement);

  /// Integral of the same function between two places; 0 outside of the cuts, and if high is not above low.
  double Integral(const Function& function, double low, double high) const;

  /// The place up to which the same function has a part, 0 to 1, of its whole integral, which must be positive.
  double Quantile(const Function& function, double part) const;

private:
  void AddPanels(const Function& function, double low, double high, double integral, int halvings);
  std::size_t PanelAt(double place) const;

  double Agreement = 0.0;
  std::vector<double> Edges;
  std::vector<double> Integrals; ///< of the panels
  std::vector<double> Sums;      ///< of the panels below an edge
};

}

#endif
