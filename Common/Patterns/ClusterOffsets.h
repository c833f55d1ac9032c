// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralClusterOffsets_h
#define LittoralClusterOffsets_h

#include <cstddef>

namespace littoral
{

/// Normal offsets reach no farther than so many standard deviations: all but 1.5e-8 of them would not anyway.
inline constexpr double NormalReach = 6.0;

/**
 * Normal offsets in the plane of two uniform numbers each: r = s (-2 ln u')^(1/2), the angle 2 pi v, where u' is u on
 * (exp(-NormalReach^2 / 2), 1). Plain arithmetic, so that every processor gives the same bytes; relative errors are
 * below 1e-9. Offsets take the place of the uniform numbers.
 */
void MakeNormalOffsets(double deviation, std::size_t count, double* u, double* v);

/// Offsets that are uniform on a disc: r = R u^(1/2), the angle 2 pi v.
void MakeDiscOffsets(double radius, std::size_t count, double* u, double* v);

/// ln u of uniform numbers in (0, 1), in place, by the same arithmetic.
void MakeLogarithms(std::size_t count, double* u);

}

#endif
