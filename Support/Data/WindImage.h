// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportWindImage_h
#define LittoralSupportWindImage_h

// Wind fields between VTK and the numerics. Private: never installed, never wrapped.

#include "Wind/FrozenWind.h"
#include "Wind/WindField.h"

#include <memory>
#include <vector>

class vtkDataObject;
class vtkImageData;

namespace littoral
{

/// Reads a frozen wind: point array Velocity, field data ConvectionSpeed and, if there is one, Period. Throws
/// InvalidInput.
std::shared_ptr<const FrozenWind> ReadWind(vtkImageData* image);

/// Writes the model of a wind as field data: each parameter as an array of its name.
void WriteWindModel(const WindModel& model, vtkDataObject* data);

/// A whole wind field with its model.
struct ModelledWind
{
  WindModel Model;
  WindGrid Grid;
  std::vector<float> Velocities; ///< along and across the mean of their layer, as WindField::Make gives them
};

/// Reads a wind field with the field data of WriteWindModel. Throws InvalidInput.
ModelledWind ReadModelledWind(vtkImageData* image);

/// A place at a height [m], halfway between the sides of a wind field.
Vector3 MiddleOfWind(vtkImageData* image, double height);

}

#endif
