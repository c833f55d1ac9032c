// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportStandForms_h
#define LittoralSupportStandForms_h

// The forms of a stand, and what their readers share. Private: never installed, never wrapped.

#include "Data/StandFoliage.h"
#include "Plants/PlantFoliage.h"

#include <cstddef>
#include <memory>
#include <vector>

class vtkMultiBlockDataSet;
class vtkPointSet;
class vtkPolyData;

namespace littoral
{

constexpr int MostKinds = 1000; ///< species of a stand

/// Kinds by the names of the options, else by those of the data, else by numbers.
std::vector<StandKind> KindsOf(vtkDataObject* data, std::size_t count, const StandOptions& options);

/// A number of the field data; another one where there is none.
double FieldOf(vtkDataObject* data, const char* name, double otherwise);

/// All plants must be there, each at one of the processes. Throws InvalidInput.
void RequireWhole(vtkDataObject* data, const WorkShare& share = {});

/// Height, reach and mean height of the leaves of a plant from its foot.
struct CrownMeasure
{
  double Top = 0.0;
  double Reach = 0.0;
  double Moment = 0.0; ///< area times height
  double Area = 0.0;

  void Add(const FoliageTriangle& triangle, const Vector3& foot, bool isLeaf);
  StandCrown Crown(const Vector3& foot, int plant, int kind) const;
};

/// Instances of plants, as vtkPlantScatterFilter makes them. Throws InvalidInput, as do the next two.
std::unique_ptr<StandFoliage> InstancedFoliage(
  vtkMultiBlockDataSet* blocks, vtkPolyData* instances, const StandOptions& options, const WorkShare& share);

/// One plant, or many merged, with all their leaves.
std::unique_ptr<StandFoliage> MergedFoliage(vtkMultiBlockDataSet* blocks, const StandOptions& options);

/// Trees by their dimensions, as vtkStandInventoryFilter makes them.
std::unique_ptr<StandFoliage> TreeFoliage(vtkPointSet* trees, const StandOptions& options);

}

#endif
