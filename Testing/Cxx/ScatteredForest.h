// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScatteredForest_h
#define ScatteredForest_h

// A small forest for tests of the scatter filter.
#include "PlantScene.h"
#include "vtkPlantScatterFilter.h"
#include "vtkReevesTreeSource.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>
#include <limits>
#include <string>

inline const char* const Parts[] = { "High/Skeleton", "High/Skin", "High/Leaves", "Medium/Trunk", "Medium/Crown",
  "Low" };

/// A forest of pines and shrubs that has plants at all levels.
struct Forest
{
  vtkNew<vtkPolyData> Sites;
  vtkNew<vtkReevesTreeSource> Pine;
  vtkNew<vtkReevesTreeSource> Shrub;
  vtkNew<vtkImageData> Terrain;
  vtkNew<vtkPlantScatterFilter> Filter;

  /// Of its own trees, or of those of another, which are grown once.
  explicit Forest(int sites = 60, const Forest* grown = nullptr)
  {
    vtkNew<vtkPoints> points;
    for (int site = 0; site < sites; ++site)
    {
      points->InsertNextPoint(7.0 * (site % 8) - 24.5, 9.0 * (site / 8) + 0.5 * (site % 3), 0.1 * site);
    }
    this->Sites->SetPoints(points);
    this->Pine->SetPreset(vtkReevesTreeSource::Custom);
    this->Pine->SetCrownShapeToCone();
    this->Pine->SetNumberOfLeaves(300);
    this->Pine->SetMainBranches(8);
    this->Pine->SetTextureSize(32, 16);
    this->Shrub->SetPreset(vtkReevesTreeSource::Shrub);
    this->Shrub->SetTextureSize(64, 24);
    this->Filter->SetInputData(0, this->Sites);
    this->Filter->AddPrototypeConnection(this->Pine->GetOutputPort());
    this->Filter->AddPrototypeConnection(this->Shrub->GetOutputPort());
    this->Filter->SetViewPoint(0.0, -10.0, 5.0);
    this->Filter->SetViewAngle(60.0);
    this->Filter->SetNearDistance(25.0);
    this->Filter->SetFarDistance(50.0);
    if (grown)
    {
      this->TakeTrees(*grown);
    }
  }

  /// Takes the trees of another forest, which are grown once.
  void TakeTrees(const Forest& other)
  {
    this->Filter->SetInputConnection(1, other.Pine->GetOutputPort());
    this->Filter->AddPrototypeConnection(other.Shrub->GetOutputPort());
  }

  /// Hills of 2 m, from -40 to 40 m along x and from -10 to 90 m along y.
  void AddTerrain()
  {
    this->Terrain->SetOrigin(-40.0, -10.0, 0.0);
    this->Terrain->SetSpacing(4.0, 5.0, 1.0);
    this->Terrain->SetExtent(0, 20, 0, 20, 0, 0);
    vtkNew<vtkDoubleArray> heights;
    heights->SetName("Elevation");
    for (int point = 0; point < 441; ++point)
    {
      heights->InsertNextValue(2.0 * std::sin(0.8 * (point % 21)));
    }
    this->Terrain->GetPointData()->SetScalars(heights);
    this->Filter->SetInputData(2, this->Terrain);
  }

  vtkFieldData* Fields() { return this->Filter->GetOutputDataObject(0)->GetFieldData(); }
  double Counter(const char* name)
  {
    vtkDataArray* counter = this->Fields()->GetArray(name);
    return counter ? counter->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
  }
  vtkPolyData* Part(const char* path)
  {
    return vtkPolyData::SafeDownCast(BlockAt(this->Filter->GetOutputDataObject(0), path));
  }
  vtkDataArray* Array(const char* path, const char* name) { return this->Part(path)->GetPointData()->GetArray(name); }
};

inline std::string BytesOf(vtkDataArray* array)
{
  return array ? std::string(static_cast<const char*>(array->GetVoidPointer(0)),
                   static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize())
               : std::string("none");
}

/// All bytes of the blocks and the table.
inline std::string BytesOf(Forest& forest)
{
  std::string bytes;
  for (const char* path : Parts)
  {
    vtkPolyData* part = forest.Part(path);
    bytes += BytesOf(part->GetPoints()->GetData());
    for (int array = 0; array < part->GetPointData()->GetNumberOfArrays(); ++array)
    {
      bytes += BytesOf(part->GetPointData()->GetArray(array));
    }
    for (vtkCellArray* cells : { part->GetPolys(), part->GetLines() })
    {
      bytes += BytesOf(cells->GetConnectivityArray()) + BytesOf(cells->GetOffsetsArray());
    }
  }
  for (int array = 0; array < forest.Fields()->GetNumberOfArrays(); ++array)
  {
    bytes += BytesOf(forest.Fields()->GetArray(array));
  }
  return bytes;
}

#endif
