// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralMissingCodes_h
#define LittoralMissingCodes_h

#include <set>
#include <vector>

namespace littoral
{

/// Whether a number is written like a code for a missing value: nothing but nines, three or more, or any where it is
/// negative (999, 9999, 999.9, -9, -99), or 5005, as of inventories of tropical forests.
bool IsCodeLike(double number);

/**
 * Codes for missing values in a column of measures, which are positive: what is like a code and negative, or more than
 * twice the largest other number; and the largest number, if it is there twice or more, above `largestLikely` and more
 * than twice the next.
 * Numbers that are not finite do not count.
 */
std::set<double> MissingCodes(const std::vector<double>& column, double largestLikely);

}

#endif
