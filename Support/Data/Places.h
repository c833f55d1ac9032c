// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPlaces_h
#define LittoralSupportPlaces_h

// Coordinates of data that come from elsewhere: lengths, never degrees. Private: never installed, never wrapped.

#include "Geometry/PlaceUnits.h"

class vtkDataSet;

namespace littoral
{

/**
 * Throws InvalidInput where the coordinates of data are or look like degrees: "Input lies at 5 to 9, 41 to 45, which look
 * like degrees ...". Data with a georeference are in metres; point arrays named as longitudes and latitudes, which have
 * the values of the coordinates, are their names; else the numbers decide, see UnitOfPlaces().
 */
void RequireLengths(vtkDataSet* data, const char* input, double far);

}

#endif
