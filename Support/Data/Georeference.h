// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportGeoreference_h
#define LittoralSupportGeoreference_h

// Place of data on earth, as field data that travel with them: `CoordinateSystem`, text (WKT); `CoordinateUnit`, metres
// per unit of that system; `CoordinateOffset`, two numbers [m]. The map coordinates of a point are (position +
// CoordinateOffset) / CoordinateUnit. Private: never installed, never wrapped.

#include <array>
#include <string>

class vtkDataObject;

namespace littoral
{

struct Georeference
{
  std::string System;                       ///< WKT; empty: none
  double MetresPerUnit = 1.0;               ///< of the system
  std::array<double, 2> Offset{ 0.0, 0.0 }; ///< [m]
};

/// Adds the arrays to the field data; of an empty system only the offset, and that only where it is not 0.
void AddGeoreference(vtkDataObject* data, const Georeference& place);

/// The place of data. Throws InvalidInput if its arrays cannot be used.
Georeference ReadGeoreference(vtkDataObject* data);

/// Copies the arrays, if there are some.
void PassGeoreference(vtkDataObject* from, vtkDataObject* to);

}

#endif
