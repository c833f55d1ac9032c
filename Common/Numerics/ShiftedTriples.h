// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralShiftedTriples_h
#define LittoralShiftedTriples_h

#include "Numerics/Vector3.h"

#include <cstddef>

namespace littoral
{

///@{
/// Places, three numbers each, moved by the same way [m]; sums are of double precision.
void ShiftTriples(const float* from, std::size_t count, const Vector3& way, float* to);
void ShiftTriples(const double* from, std::size_t count, const Vector3& way, double* to);
///@}

}

#endif
