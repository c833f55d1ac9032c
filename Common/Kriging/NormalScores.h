// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNormalScores_h
#define LittoralNormalScores_h

#include <vector>

namespace littoral
{

/**
 * The monotone map between values of any distribution and standard normal scores (Deutsch and Journel 1998, section
 * V.1). The value of rank k among n has the score of the normal quantile (k - 1/2) / n; equal values share the score of
 * their mean rank. Between the values the map is linear. Beyond them it is flat: scores beyond the outermost ones are
 * the least and the largest value, so that the way back makes nothing lower or higher than what was measured.
 */
class NormalScores
{
public:
  /// Of values that are finite, at least two of them different; else empty.
  explicit NormalScores(std::vector<double> values);

  /// Whether there were no two different values.
  bool IsEmpty() const { return this->Values.size() < 2; }

  /// The score of a value.
  double ScoreOf(double value) const;

  /// The value of a score.
  double ValueOf(double score) const;

private:
  std::vector<double> Values; ///< each once, increasing
  std::vector<double> Scores;
};

}

#endif
