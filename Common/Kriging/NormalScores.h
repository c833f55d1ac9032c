// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNormalScores_h
#define LittoralNormalScores_h

#include <vector>

namespace littoral
{

/**
 * Normal score transform of values of any distribution (Deutsch and Journel 1998, section V.1), y = G^-1((k - 1/2) / n)
 * for the value of rank k among n; equal values share the score of their mean rank. The transform is linear between the
 * values and constant beyond them, so that the back transform stays between the smallest and the largest value.
 */
class NormalScores
{
public:
  /// Transform of a sample: finite values, at least two of them different; else empty.
  explicit NormalScores(std::vector<double> values);

  /// Whether all values are equal.
  bool IsEmpty() const { return this->Values.size() < 2; }

  /// Normal score of a value.
  double ScoreOf(double value) const;

  /// Back transform of a score.
  double ValueOf(double score) const;

private:
  std::vector<double> Values; ///< distinct values, increasing
  std::vector<double> Scores;
};

}

#endif
