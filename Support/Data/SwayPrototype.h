// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportSwayPrototype_h
#define LittoralSupportSwayPrototype_h

// Prototypes of swaying plants between blocks and the numerics. Private: never installed, never wrapped.

#include "Sway/CrownPictures.h"
#include "Sway/SwaySpecies.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <optional>

class vtkMultiBlockDataSet;

namespace littoral
{

/// A plant at full detail as a species, and the blocks that its pictures are made of.
struct SwayPrototype
{
  SwaySpecies Species;
  vtkSmartPointer<vtkPolyData> Leaves;
  vtkSmartPointer<vtkPolyData> Crown; ///< of the level Medium; null where there is none
  std::optional<CrownVolume> Volume;  ///< of the crown, if it is an envelope

  /// Throws InvalidInput.
  void Read(vtkMultiBlockDataSet* plant, const SwaySettings& settings);

  /// The crown for its pictures; valid as long as this.
  CrownModel MakeCrown() const;

private:
  void ReadCrown(vtkPolyData* crown);
};

}

#endif
