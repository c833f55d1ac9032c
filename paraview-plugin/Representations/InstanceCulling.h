// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInstanceCulling_h
#define LittoralInstanceCulling_h

#include "Instances.h"

#include <vector>

class vtkMatrix4x4;

namespace littoral
{

/// Values of the instances of a batch that may show in the clip volume, in their order: those whose box is not beyond
/// one of its planes. The matrix goes from the coordinates of the instances to those of the clip volume.
std::vector<float> InstancesInSight(const InstanceBatch& batch, const vtkMatrix4x4* toClip);

}

#endif
