// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralStemShape_h
#define LittoralStemShape_h

#include "Numerics/Vector3.h"
#include "Plants/PlantScatter.h"

#include <array>
#include <string>
#include <vector>

namespace littoral
{

/// A height and a diameter at breast height of a tree; 0 where one is not given.
struct TreeDimensions
{
  double Height = 0.0;   ///< from the foot to the top [m]
  double Diameter = 0.0; ///< girth of the stem at breast height over pi [m]
};

/// Breast height of a tree [m], at which foresters measure its diameter: 1.3 m; half the height of a tree lower than
/// 2.6 m.
double BreastHeight(double height);

/// Why no tree has such dimensions, in words for a user that name a site; empty if one may.
std::string WhyInvalid(const TreeDimensions& tree, const std::string& site);

/**
 * Stem of a plant as a tape measures it: its diameter at a height is the girth of its surface there over pi. The stem
 * is the closed surface with the lowest vertex; branches have surfaces of their own.
 */
class StemShape
{
public:
  /// A plant without a stem.
  StemShape() = default;

  /// Vertices and triangles of the bark [m], and the highest point of the plant.
  StemShape(const std::vector<Vector3>& points, const std::vector<std::array<int, 3>>& triangles, double top);

  bool IsThere() const { return !this->Triangles.empty(); }

  /// Girth over pi at a height [m]; 0 above and below the stem.
  double DiameterAt(double height) const;

  /// Sets Scale and WidthScale of a plant by its dimensions. One of them alone keeps the proportions. Why it cannot
  /// have them, in words for a user; empty if it has.
  std::string Fit(const TreeDimensions& tree, PlantPlace& place) const;

private:
  std::vector<std::array<Vector3, 3>> Triangles;
  double Top = 0.0;
  double StemTop = 0.0;

  /// The diameter where a plant of a scale is measured, before it is scaled.
  double MeasuredDiameter(double scale) const;
  double ScaleOfDiameter(double diameter) const;
};

}

#endif
