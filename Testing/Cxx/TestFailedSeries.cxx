// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// An input that fails at a later time, or at a later tile, ends a request that asks for one after the other; and when
// it is mended, all is as if it had never failed. VTK's own loop (CONTINUE_EXECUTING) would never end.

#include "Check.h"
#include "DriftScene.h"
#include "ErrorCounter.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkDrainageFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"

#include "vtkDoubleArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// An image of heights and a steady current, at times 0 to 4 s, that fails once it has been asked some times.
class FailingSource : public vtkImageAlgorithm
{
public:
  static FailingSource* New();
  vtkTypeMacro(FailingSource, vtkImageAlgorithm);

  int CallsUntilFailure = -1; ///< -1: none
  int Calls = 0;

protected:
  FailingSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const int whole[6] = { 0, 63, 0, 63, 0, 0 };
    const double times[5] = { 0.0, 1.0, 2.0, 3.0, 4.0 };
    const double range[2] = { 0.0, 4.0 };
    info->Set(Pipeline::WHOLE_EXTENT(), whole, 6);
    info->Set(Pipeline::TIME_STEPS(), times, 5);
    info->Set(Pipeline::TIME_RANGE(), range, 2);
    info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    if (this->Calls++ == this->CallsUntilFailure)
    {
      return 0;
    }
    vtkInformation* info = outputs->GetInformationObject(0);
    vtkImageData* image = vtkImageData::GetData(outputs);
    int extent[6];
    info->Get(Pipeline::UPDATE_EXTENT(), extent);
    image->SetExtent(extent);
    image->SetOrigin(-32.0, -32.0, -5.0);
    vtkNew<vtkDoubleArray> heights;
    heights->SetName("Elevation");
    vtkNew<vtkDoubleArray> velocity;
    velocity->SetName("Velocity");
    velocity->SetNumberOfComponents(3);
    const double time = info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        heights->InsertNextValue(std::sin(0.3 * i) * std::cos(0.2 * j) + 0.01 * i);
        velocity->InsertNextTuple3(0.1 + 0.1 * time, 0.2, 0.0);
      }
    }
    image->GetPointData()->AddArray(velocity);
    image->GetPointData()->SetScalars(heights);
    return 1;
  }
};
vtkStandardNewMacro(FailingSource);

/// How often an input is asked until it fails, if it does; whether an update of a fresh algorithm succeeds.
bool EndsWhereItsInputFails(
  const std::string& name, vtkAlgorithm* algorithm, FailingSource* source, double time, int leastCalls)
{
  vtkNew<ErrorCounter> echoes; // of failed requests
  echoes->Watch(source);
  vtkNew<ErrorCounter> errors;
  errors->Watch(algorithm);
  const bool isUpdated = algorithm->UpdateTimeStep(time) == 1;
  bool good = Check(isUpdated, name + " fails: " + errors->Last);
  const vtkMTimeType size = algorithm->GetOutputDataObject(0)->GetActualMemorySize();
  good &= Check(source->Calls >= leastCalls, name + " does not ask one after the other");
  source->CallsUntilFailure = leastCalls - 1;
  source->Calls = 0;
  algorithm->Modified();
  source->Modified();
  good &= Check(algorithm->UpdateTimeStep(time) == 0, name + " does not fail with its input");
  good &= Check(source->Calls == leastCalls, name + " asks on after a failure");
  good &= Check(errors->Count == 0, name + " says again what its input has said");
  source->CallsUntilFailure = -1;
  source->Modified();
  good &= Check(algorithm->UpdateTimeStep(time) == 1, name + " stays failed");
  good &= Check(algorithm->GetOutputDataObject(0)->GetActualMemorySize() == size, name + " has less output");
  return good;
}

}

int TestFailedSeries(int, char*[])
{
  bool good = true;
  {
    vtkNew<FailingSource> source;
    vtkNew<vtkCurrentDriftFilter> drift;
    drift->SetInputData(0, DriftScene::Particles(10));
    drift->AddCurrentConnection(source->GetOutputPort());
    good &= EndsWhereItsInputFails("a drift", drift, source, 4.0, 3);
  }
  {
    vtkNew<FailingSource> source;
    vtkNew<vtkSeaweedSource> plants;
    vtkNew<vtkSeaweedDeformationFilter> moved;
    vtkNew<vtkSeaStateSource> sea;
    sea->SetSeaLevel(5.0);
    moved->SetInputConnection(0, plants->GetOutputPort());
    moved->SetInputConnection(1, sea->GetOutputPort());
    moved->AddCurrentConnection(source->GetOutputPort());
    good &= EndsWhereItsInputFails("a seaweed", moved, source, 4.0, 3);
  }
  {
    vtkNew<FailingSource> source;
    vtkNew<vtkDrainageFilter> drainage;
    drainage->SetCarve(false);
    drainage->SetTileSize(16);
    drainage->SetInputConnection(source->GetOutputPort());
    good &= EndsWhereItsInputFails("drainage by tiles", drainage, source, 0.0, 5);
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
