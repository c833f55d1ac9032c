// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Textures of scattered plants: the common picture, what is announced of it, kinds of plants beside each other.
#include "Check.h"
#include "ScatteredForest.h"
#include "vtkAonoKuniiTreeSource.h"
#include "vtkGardnerPlantSource.h"
#include "vtkReevesTreeSource.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkInformation.h"
#include "vtkInformationDataObjectMetaDataKey.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <map>
#include <string>

namespace
{

/// The atlas is the prototypes' pictures one above the other, and leaves' coordinates point into their own.
bool Atlas()
{
  Forest forest;
  forest.Filter->UseLevelsOff();
  forest.Filter->UseCullingOff();
  forest.Filter->Update();
  auto* image = vtkImageData::SafeDownCast(forest.Filter->GetOutputDataObject(1));
  int size[3];
  image->GetDimensions(size);
  bool good = Check(size[0] == 64 + 4 && size[1] == 16 + 24 + 8 && size[2] == 1, "size of the atlas of crowns");
  auto* crown = vtkImageData::SafeDownCast(forest.Shrub->GetOutputDataObject(1));
  for (int row = 0; row < 24; ++row)
  {
    for (int column = 0; column < 64; ++column)
    {
      for (int channel = 0; channel < 4; ++channel)
      {
        good &= image->GetScalarComponentAsDouble(column + 2, 16 + 4 + 2 + row, 0, channel) ==
          crown->GetScalarComponentAsDouble(column, row, 0, channel);
      }
    }
  }
  good = Check(good, "the atlas does not hold the shrub's crown");
  vtkDataArray* species = forest.Fields()->GetArray("Species");
  vtkDataArray* plants = forest.Array("High/Leaves", "PlantId");
  vtkDataArray* coordinates = forest.Part("High/Leaves")->GetPointData()->GetTCoords();
  auto* leaves = vtkImageData::SafeDownCast(forest.Filter->GetOutputDataObject(2));
  const double middle = 0.5; // two pictures of the same height
  for (vtkIdType point = 0; good && point < coordinates->GetNumberOfTuples(); ++point)
  {
    const double v = coordinates->GetComponent(point, 1);
    good =
      v > 0.0 && v < 1.0 && (v > middle) == (species->GetTuple1(static_cast<vtkIdType>(plants->GetTuple1(point))) == 1);
  }
  good = Check(good && leaves->GetDimensions()[1] > 0, "leaves point into the picture of another species");
  vtkDataArray* texels = forest.Part("Medium/Crown")->GetFieldData()->GetArray("Texture");
  return Check(
    good && texels && texels->GetNumberOfTuples() == size[0] * size[1], "the crown does not carry the atlas");
}

/// Passes data on, and counts how often.
class CountingFilter : public vtkPassInputTypeAlgorithm
{
public:
  static CountingFilter* New();
  vtkTypeMacro(CountingFilter, vtkPassInputTypeAlgorithm);

  int Executions = 0;
  /// Whether what is announced with the data is held back.
  bool IsSilent = false;

protected:
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    if (this->IsSilent)
    {
      outputs->GetInformationObject(0)->Remove(vtkPlantSource::TEXTURE_SIZES());
    }
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    ++this->Executions;
    vtkDataObject::GetData(outputs)->ShallowCopy(vtkDataObject::GetData(inputs[0]));
    return 1;
  }
};
vtkStandardNewMacro(CountingFilter);

/// Columns and rows of an image that is announced, or that is there.
std::array<int, 2> Announced(vtkAlgorithm* algorithm, int port)
{
  int extent[6];
  algorithm->GetOutputInformation(port)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  return { extent[1] + 1, extent[3] + 1 };
}
std::array<int, 2> Columns(vtkAlgorithm* algorithm, int port)
{
  auto* image = vtkImageData::SafeDownCast(algorithm->GetOutputDataObject(port));
  return { image->GetDimensions()[0], image->GetDimensions()[1] };
}

/// Sizes of the pictures are announced right, and nothing upstream executes for that.
bool Information()
{
  Forest forest;
  vtkNew<CountingFilter> sites;
  vtkNew<CountingFilter> pine;
  sites->SetInputData(forest.Sites);
  pine->SetInputConnection(forest.Pine->GetOutputPort());
  forest.Filter->RemoveAllPrototypes();
  forest.Filter->SetInputConnection(0, sites->GetOutputPort());
  forest.Filter->AddPrototypeConnection(pine->GetOutputPort());
  forest.Filter->AddPrototypeConnection(forest.Shrub->GetOutputPort());
  int executions = 0;
  for (vtkAlgorithm* source : { forest.Pine.Get(), forest.Shrub.Get() })
  {
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&executions);
    count->SetCallback([](vtkObject*, unsigned long, void* counter, void*) { ++*static_cast<int*>(counter); });
    source->AddObserver(vtkCommand::StartEvent, count);
  }
  forest.Filter->UpdateInformation();
  bool good = Check(
    sites->Executions == 0 && pine->Executions == 0 && executions == 0, "inputs execute when information is asked for");
  good &= Check(Announced(forest.Filter, 1) == std::array<int, 2>{ 64 + 4, 16 + 24 + 8 }, "crowns announced");
  const std::array<int, 2> leaves = Announced(forest.Filter, 2);
  forest.Filter->Update();
  good &= Check(sites->Executions == 1 && pine->Executions == 1 && executions == 2, "inputs must execute once each");
  good &= Check(Columns(forest.Filter, 1) == Announced(forest.Filter, 1), "crowns are not as announced");
  good &= Check(Columns(forest.Filter, 2) == leaves, "leaves are not as announced");
  const vtkMTimeType before = forest.Filter->GetMTime();
  forest.Pine->SetTextureSize(128, 8);
  forest.Filter->UpdateInformation();
  good &= Check(Announced(forest.Filter, 1) == std::array<int, 2>{ 128 + 4, 8 + 24 + 8 } && executions == 2,
    "another size is not announced, or its source executes");
  forest.Filter->Update();
  return good &
    Check(Columns(forest.Filter, 1) == Announced(forest.Filter, 1) && forest.Filter->GetMTime() == before,
      "another size is not as announced");
}

/// Prototypes of which nothing is announced: pictures are as announced if the data are there, else after an execution.
bool SilentPrototypes()
{
  Forest there;
  there.Pine->Update();
  there.Filter->RemoveAllPrototypes();
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(there.Pine->GetOutputDataObject(0));
  there.Filter->AddPrototypeConnection(producer->GetOutputPort());
  there.Filter->UpdateInformation();
  bool good = Check(
    Announced(there.Filter, 1) == std::array<int, 2>{ 32 + 4, 16 + 4 }, "the size of a picture that is there is wrong");

  Forest forest;
  vtkNew<CountingFilter> pine;
  pine->IsSilent = true;
  pine->SetInputConnection(forest.Pine->GetOutputPort());
  forest.Filter->RemoveAllPrototypes();
  forest.Filter->AddPrototypeConnection(pine->GetOutputPort());
  vtkNew<vtkImageShiftScale> later;
  later->SetInputConnection(forest.Filter->GetOutputPort(1));
  forest.Filter->UpdateInformation();
  good &= Check(pine->Executions == 0, "a silent prototype executes when information is asked for");
  for (const int columns : { 32, 60 })
  {
    forest.Pine->SetTextureSize(columns, 16);
    const std::array<int, 2> size{ columns + 4, 16 + 4 };
    forest.Filter->Update();
    good &= Check(Columns(forest.Filter, 1) == size && Announced(forest.Filter, 1) == size, "a picture is not whole");
    later->UpdateWholeExtent();
    good &= Check(Columns(later, 0) == size, "a filter of a picture does not see all of it");
  }
  return good & Check(pine->Executions == 2, "a silent prototype executes more than once");
}

/// What plant sources announce of their textures is what the textures are.
bool AnnouncedTextures()
{
  vtkNew<vtkReevesTreeSource> reeves;
  vtkNew<vtkAonoKuniiTreeSource> aono;
  vtkNew<vtkGardnerPlantSource> gardner;
  bool good = true;
  for (vtkPlantSource* source : std::initializer_list<vtkPlantSource*>{ reeves, aono, gardner })
  {
    source->SetTextureSize(48, 20);
    source->UpdateInformation();
    vtkDataObject* sizes = source->GetOutputInformation(0)->Get(vtkPlantSource::TEXTURE_SIZES());
    source->Update();
    for (const char* path : { "Medium/Crown", "High/Leaves" })
    {
      vtkDataArray* size = BlockAt(source->GetOutputDataObject(0), path)->GetFieldData()->GetArray("TextureSize");
      vtkDataArray* announced = sizes ? sizes->GetFieldData()->GetArray(std::strrchr(path, '/') + 1) : nullptr;
      good &= Check(size && announced && announced->GetComponent(0, 0) == size->GetVariantValue(0).ToDouble() &&
          announced->GetComponent(0, 1) == size->GetVariantValue(1).ToDouble(),
        std::string(source->GetClassName()) + ": the texture of " + path + " is not as announced");
    }
  }
  return good;
}

/// A plant of quadrics among trees of particles: each shows its own part of the common picture of leaves.
bool MixedKinds()
{
  Forest forest;
  vtkNew<vtkGardnerPlantSource> bush;
  bush->SetPreset(vtkGardnerPlantSource::Bush);
  bush->SetTextureSize(32, 16);
  forest.Filter->AddPrototypeConnection(bush->GetOutputPort());
  forest.Filter->UseLevelsOff();
  forest.Filter->UseCullingOff();
  forest.Filter->Update();
  auto* atlas = vtkImageData::SafeDownCast(forest.Filter->GetOutputDataObject(2));
  auto* own = vtkImageData::SafeDownCast(bush->GetOutputDataObject(2));
  auto* leaf = vtkImageData::SafeDownCast(forest.Pine->GetOutputDataObject(2));
  const int* size = atlas->GetDimensions();
  bool good = Check(
    size[0] == own->GetDimensions()[0] + 4 && size[1] == own->GetDimensions()[1] + 2 * leaf->GetDimensions()[1] + 12,
    "the pictures of leaves do not lie one above the other");
  int announced[6];
  forest.Filter->GetOutputInformation(2)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), announced);
  good &= Check(announced[1] == size[0] - 1 && announced[3] == size[1] - 1, "the announced picture of leaves");
  vtkDataArray* plants = forest.Array("High/Leaves", "PlantId");
  vtkDataArray* coordinates = forest.Array("High/Leaves", "TCoords");
  vtkDataArray* species = forest.Fields()->GetArray("Species");
  auto* bushLeaves = vtkPolyData::SafeDownCast(BlockAt(bush->GetOutputDataObject(0), "High/Leaves"));
  vtkDataArray* bushCoordinates = bushLeaves->GetPointData()->GetTCoords();
  // The bush is the third from the foot; each picture has a border of two texels.
  const int corner[2] = { 2, 2 * (leaf->GetDimensions()[1] + 4) + 2 };
  for (int row = 0; row < own->GetDimensions()[1]; ++row)
  {
    const auto* from = static_cast<unsigned char*>(own->GetScalarPointer(0, row, 0));
    const auto* to = static_cast<unsigned char*>(atlas->GetScalarPointer(corner[0], corner[1] + row, 0));
    if (std::memcmp(from, to, 4 * static_cast<std::size_t>(own->GetDimensions()[0])) != 0)
    {
      return Check(false, "the picture of leaves is not in the common one");
    }
  }
  std::map<int, vtkIdType> next; // vertex of the bush, by plant
  vtkIdType compared = 0;
  double farthest = 0.0; // [texels]
  for (vtkIdType point = 0; point < plants->GetNumberOfTuples(); ++point)
  {
    const int plant = static_cast<int>(plants->GetTuple1(point));
    if (species->GetTuple1(plant) != 2.0)
    {
      continue;
    }
    ++compared;
    const vtkIdType vertex = next[plant]++;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double there = coordinates->GetComponent(point, axis) * size[axis];
      const double here = bushCoordinates->GetComponent(vertex, axis) * own->GetDimensions()[axis];
      farthest = std::max(farthest, std::abs(there - corner[axis] - here));
    }
  }
  const auto bushes = static_cast<vtkIdType>(next.size());
  good &= Check(bushes > 0 && bushes < 60, "the kinds are not mixed");
  good &= Check(compared == bushes * bushLeaves->GetNumberOfPoints(), "leaves of quadrics got lost");
  return good & Check(farthest < 1e-3, "quadrics show another part of the picture of leaves");
}

}

int TestPlantScatterTextures(int, char*[])
{
  return Atlas() && Information() && SilentPrototypes() && AnnouncedTextures() && MixedKinds() ? EXIT_SUCCESS
                                                                                               : EXIT_FAILURE;
}
