// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// What filters made of their inputs stays for shallow copies of them, as ParaView makes anew for each consumer in turn,
// and for plants that a camera moves past; whatever changes in the data is noticed.
#include "Pipeline/DataStamp.h"
#include "PlantChecks.h"
#include "ScatteredForest.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkTerrainLevelOfDetailFilter.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTable.h"

#include <functional>
#include <utility>
#include <vector>

namespace
{

using littoral::StampOf;

vtkSmartPointer<vtkDataObject> ShallowCopy(vtkDataObject* data)
{
  auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

vtkSmartPointer<vtkFloatArray> Numbers(const char* name, int count)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  for (int k = 0; k < count; ++k)
  {
    array->InsertNextValue(0.1F * static_cast<float>(k % 7));
  }
  return array;
}

vtkSmartPointer<vtkImageData> Image()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(33, 33, 1);
  image->GetPointData()->SetScalars(Numbers("Elevation", 33 * 33));
  image->GetPointData()->AddArray(Numbers("Other", 33 * 33));
  return image;
}

vtkSmartPointer<vtkPolyData> Triangle()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  mesh->SetPoints(points);
  mesh->AllocateExact(1, 3);
  const vtkIdType corners[3] = { 0, 1, 2 };
  mesh->InsertNextCell(VTK_TRIANGLE, 3, corners);
  return mesh;
}

/// The stamp of data is that of a shallow copy, and each change makes another.
template <typename Data>
bool NoticesEach(const char* what, const std::function<vtkSmartPointer<Data>()>& make,
  const std::vector<std::function<void(Data*)>>& changes)
{
  bool good = true;
  for (std::size_t k = 0; k < changes.size(); ++k)
  {
    const auto data = make();
    const littoral::DataStamp stamp = StampOf(data);
    good &= Check(stamp == StampOf(ShallowCopy(data)), std::string("A shallow copy has another stamp: ") + what);
    changes[k](data);
    good &= Check(!(stamp == StampOf(data)), "Change " + std::to_string(k) + " is not noticed: " + what);
  }
  return good;
}

bool Stamps()
{
  bool good = NoticesEach<vtkImageData>("image", Image,
    { [](vtkImageData* image) { image->SetOrigin(1.0, 0.0, 0.0); },
      [](vtkImageData* image) { image->SetSpacing(1.0, 2.0, 1.0); },
      [](vtkImageData* image) { image->SetExtent(1, 33, 0, 32, 0, 0); },
      [](vtkImageData* image) { image->SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, -1); },
      [](vtkImageData* image) { image->GetPointData()->GetScalars()->Modified(); },
      [](vtkImageData* image) { image->GetPointData()->SetActiveScalars("Other"); },
      [](vtkImageData* image) { image->GetPointData()->GetArray("Other")->SetName("Another"); },
      [](vtkImageData* image) { image->GetCellData()->AddArray(Numbers("Cells", 32 * 32)); },
      [](vtkImageData* image) { image->GetFieldData()->AddArray(Numbers("Fields", 1)); } });
  good &= NoticesEach<vtkPolyData>("mesh", Triangle,
    { [](vtkPolyData* mesh) { mesh->GetPoints()->GetData()->Modified(); },
      [](vtkPolyData* mesh) { mesh->GetPolys()->GetConnectivityArray()->Modified(); },
      [](vtkPolyData* mesh) { mesh->SetLines(vtkSmartPointer<vtkCellArray>::New()); },
      [](vtkPolyData* mesh) { mesh->SetPoints(nullptr); } });
  const auto blocks = [] {
    auto data = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    data->SetBlock(0, Triangle());
    data->SetBlock(1, Image());
    return data;
  };
  good &= NoticesEach<vtkMultiBlockDataSet>("blocks", blocks,
    { [](vtkMultiBlockDataSet* data) { data->SetBlock(1, nullptr); },
      [](vtkMultiBlockDataSet* data) { data->SetNumberOfBlocks(3); },
      [](vtkMultiBlockDataSet* data) { data->GetMetaData(0U)->Set(vtkCompositeDataSet::NAME(), "Low"); },
      [](vtkMultiBlockDataSet* data) {
        vtkImageData::SafeDownCast(data->GetBlock(1))->GetPointData()->GetScalars()->Modified();
      } });
  const auto collection = [] {
    auto data = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
    data->SetPartition(0, 0, Triangle());
    return data;
  };
  good &= NoticesEach<vtkPartitionedDataSetCollection>("collection", collection,
    { [](vtkPartitionedDataSetCollection* data) { data->SetPartition(0, 0, Image()); },
      [](vtkPartitionedDataSetCollection* data) { data->SetPartition(0, 1, Image()); },
      [](vtkPartitionedDataSetCollection* data) { data->SetNumberOfPartitionedDataSets(2); } });
  const auto table = [] {
    auto data = vtkSmartPointer<vtkTable>::New();
    data->AddColumn(Numbers("Waves", 3));
    return data;
  };
  good &= NoticesEach<vtkTable>("table", table, { [](vtkTable* data) { data->GetColumn(0)->Modified(); } });
  return good &
    Check(StampOf(static_cast<vtkDataObject*>(nullptr)) == StampOf(static_cast<vtkDataObject*>(nullptr)),
      "Null has two stamps.");
}

/// A filter with data as its input: what is written into them behind VTK's back shows whether it reads them again.
bool ReadsOnce(const char* what, vtkAlgorithm* filter, vtkDataObject* data, vtkDataArray* changed,
  const std::function<double()>& result)
{
  const auto update = [&] {
    filter->SetInputDataObject(0, ShallowCopy(data));
    filter->Update();
    return result();
  };
  const double first = update();
  changed->SetComponent(0, changed->GetNumberOfComponents() - 1, 5.0);
  bool good = Check(update() == first, std::string("A shallow copy is read again: ") + what);
  changed->Modified();
  return good & Check(update() != first, std::string("A change is not noticed: ") + what);
}

bool TerrainLevels()
{
  const auto image = Image();
  vtkNew<vtkTerrainLevelOfDetailFilter> levels;
  levels->SetViewPoint(0.0, -5.0, 5.0);
  return ReadsOnce("terrain", levels, image, image->GetPointData()->GetScalars(), [&levels] {
    const double* bounds = vtkPolyData::SafeDownCast(levels->GetOutput()->GetBlock(0))->GetBounds();
    return bounds[5];
  });
}

bool Seaweeds()
{
  vtkNew<vtkSeaweedSource> kelp;
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkSeaweedDeformationFilter> swell;
  kelp->Update();
  vtkDataObject* plants = kelp->GetOutputDataObject(0);
  swell->SetSeaStateConnection(sea->GetOutputPort());
  sea->SetSeaLevel(30.0);
  swell->SetStartTime(-0.1);
  vtkPolyData* skin = PartOf(kelp, "High/Skin");
  return ReadsOnce("seaweeds", swell, plants, skin->GetPoints()->GetData(),
    [&swell] { return PartOf(swell, "High/Skin")->GetPoint(0)[2]; });
}

/// Blocks of plants that stay in their level are the same objects, and their bytes those of a filter that begins there.
bool Forests()
{
  Forest forest;
  forest.Filter->UseCullingOff();
  forest.Filter->Update();
  std::vector<vtkSmartPointer<vtkPolyData>> first;
  for (const char* path : Parts)
  {
    first.emplace_back(forest.Part(path));
  }
  bool good = true;
  for (const double step : { 0.01, 20.0 })
  {
    forest.Filter->SetViewPoint(step, -10.0, 5.0);
    forest.Filter->Update();
    Forest fresh(60, &forest);
    fresh.Filter->UseCullingOff();
    fresh.Filter->SetViewPoint(step, -10.0, 5.0);
    fresh.Filter->Update();
    good &= Check(BytesOf(forest) == BytesOf(fresh), "A camera leaves other plants behind.");
    for (std::size_t part = 0; part < first.size(); ++part)
    {
      const bool isKept = forest.Part(Parts[part]) == first[part];
      const bool turns = std::string(Parts[part]) == "Low"; // cards that face the camera
      good &= Check(isKept == (step < 1.0 && !turns), std::string(Parts[part]) + (isKept ? " is kept." : " is new."));
    }
  }
  return good;
}

}

int TestDataStamp(int, char*[])
{
  bool good = Stamps();
  good &= TerrainLevels();
  good &= Seaweeds();
  good &= Forests();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
