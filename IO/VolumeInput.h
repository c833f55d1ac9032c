// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralVolumeInput_h
#define LittoralVolumeInput_h

#include "Volume.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataArraySelection;
class vtkDataObject;

namespace littoral
{

/// Part of the input that this rank holds.
struct VolumeInput
{
  std::vector<Volume> Volumes;
  VolumeRemarks Remarks;                                ///< of the input as a whole
  std::size_t Samples = 0;                              ///< points and cells, with or without arrays
  std::array<int, 6> Extent{ { 0, -1, 0, -1, 0, -1 } }; ///< of an input that is an image
  std::string Reason; ///< why it cannot be written, in words for a user; empty if it can
};

/// Volumes of an image, or of the images in a composite. The selections may hold switched-off names.
VolumeInput ReadVolumes(vtkDataObject* input, vtkDataArraySelection* points, vtkDataArraySelection* cells);

/// Makes one volume of boxes of the same lattice, block and array; gives each volume a name of its own.
void JoinVolumes(std::vector<Volume>& volumes);

}

#endif
