// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/CompositeQuadrature.h"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace littoral
{

namespace
{

constexpr int MostHalvings = 40;
/// Limit of the number of panels, beyond which none is halved any more: the function is noise.
constexpr std::size_t MostPanels = 20000;
/// Newton's last step, relative to the place [bits]; what it leaves is of the square of that.
constexpr int LastStep = 26;

double Rule(const CompositeQuadrature::Function& function, double low, double high)
{
  return boost::math::quadrature::gauss<double, 10>::integrate(function, low, high);
}

}

CompositeQuadrature::CompositeQuadrature(const Function& function, const std::vector<double>& cuts, double agreement)
  : Agreement(agreement)
  , Edges{ cuts.front() }
  , Sums{ 0.0 }
{
  for (std::size_t cut = 1; cut < cuts.size(); ++cut)
  {
    this->AddPanels(function, cuts[cut - 1], cuts[cut], Rule(function, cuts[cut - 1], cuts[cut]), 0);
  }
}

void CompositeQuadrature::AddPanels(const Function& function, double low, double high, double integral, int halvings)
{
  const double middle = 0.5 * (low + high);
  const double left = Rule(function, low, middle);
  const double right = Rule(function, middle, high);
  const bool agrees = std::abs(integral - (left + right)) <= this->Agreement * (left + right);
  if (!agrees && halvings < MostHalvings && this->Integrals.size() < MostPanels)
  {
    this->AddPanels(function, low, middle, left, halvings + 1);
    this->AddPanels(function, middle, high, right, halvings + 1);
    return;
  }
  this->Edges.push_back(high);
  this->Integrals.push_back(left + right);
  this->Sums.push_back(this->Sums.back() + left + right);
}

std::size_t CompositeQuadrature::PanelAt(double place) const
{
  const auto next = std::upper_bound(this->Edges.begin() + 1, this->Edges.end() - 1, place);
  return static_cast<std::size_t>(next - this->Edges.begin()) - 1;
}

double CompositeQuadrature::Integral(const Function& function, double low, double high) const
{
  if (this->Edges.empty())
  {
    return 0.0;
  }
  low = std::max(low, this->Edges.front());
  high = std::min(high, this->Edges.back());
  if (!(high > low))
  {
    return 0.0;
  }
  const std::size_t first = this->PanelAt(low);
  const std::size_t last = this->PanelAt(high);
  if (first == last)
  {
    return Rule(function, low, high);
  }
  double sum = Rule(function, low, this->Edges[first + 1]);
  for (std::size_t panel = first + 1; panel < last; ++panel)
  {
    sum += this->Integrals[panel];
  }
  return high > this->Edges[last] ? sum + Rule(function, this->Edges[last], high) : sum;
}

double CompositeQuadrature::Quantile(const Function& function, double part) const
{
  const double wanted = part * this->Sums.back();
  const auto above = std::upper_bound(this->Sums.begin() + 1, this->Sums.end() - 1, wanted);
  const std::size_t panel = static_cast<std::size_t>(above - this->Sums.begin()) - 1;
  const double low = this->Edges[panel];
  const double high = this->Edges[panel + 1];
  const double remainder = wanted - this->Sums[panel];
  if (!(remainder > 0.0))
  {
    return low;
  }
  const auto excess = [&](double place) {
    return std::make_pair(place > low ? Rule(function, low, place) - remainder : -remainder, function(place));
  };
  const double guess = low + (high - low) * std::min(1.0, remainder / this->Integrals[panel]);
  return boost::math::tools::newton_raphson_iterate(excess, guess, low, high, LastStep);
}

}
