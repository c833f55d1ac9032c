// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRoundedUp_h
#define LittoralRoundedUp_h

namespace littoral
{

/// The least single precision number that is not below: bounds stay bounds.
float RoundedUp(double value);

}

#endif
