// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// A request that was stopped leaves nothing behind: once stopping is over, which is for the caller to say, the next one
// gives what a fresh object gives, byte by byte.

#include "Check.h"
#include "vtkBeamTreeDeformationFilter.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkReevesTreeSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaSurfaceFilter.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkSuspendedParticleSource.h"
#include "vtkWindFieldSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace
{

using Algorithm = vtkSmartPointer<vtkAlgorithm>;

std::vector<vtkDataSet*> LeavesOf(vtkDataObject* data)
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks)
  {
    return { vtkDataSet::SafeDownCast(data) };
  }
  std::vector<vtkDataSet*> leaves;
  auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    leaves.push_back(vtkDataSet::SafeDownCast(each->GetCurrentDataObject()));
  }
  return leaves;
}

/// Points and point arrays of all leaves as bytes.
std::string BytesOf(vtkAlgorithm* algorithm)
{
  std::string bytes;
  const auto add = [&](vtkDataArray* array) {
    const vtkIdType size = array->GetNumberOfValues() * array->GetDataTypeSize();
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)), static_cast<std::size_t>(size));
  };
  for (vtkDataSet* leaf : LeavesOf(algorithm->GetOutputDataObject(0)))
  {
    if (auto* set = vtkPointSet::SafeDownCast(leaf); set && set->GetPoints())
    {
      add(set->GetPoints()->GetData());
    }
    for (int index = 0; leaf && index < leaf->GetPointData()->GetNumberOfArrays(); ++index)
    {
      if (vtkDataArray* array = leaf->GetPointData()->GetArray(index))
      {
        add(array);
      }
    }
  }
  return bytes;
}

/// Asks for a time, and stops the request when its progress is above a share; whether it was stopped.
bool StopAbove(vtkAlgorithm* algorithm, double share, double time)
{
  struct Stop
  {
    double Share;
    bool IsDone = false;
  } stop{ share };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&stop);
  command->SetCallback([](vtkObject* caller, unsigned long, void* data, void*) {
    auto* own = static_cast<Stop*>(data);
    auto* running = vtkAlgorithm::SafeDownCast(caller);
    if (running->GetProgress() > own->Share && running->GetProgress() < 1.0)
    {
      own->IsDone = true;
      running->SetAbortExecute(1);
    }
  });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  algorithm->UpdateTimeStep(time);
  algorithm->RemoveObserver(tag);
  algorithm->SetAbortExecute(0);
  return stop.IsDone;
}

bool IsAsFresh(const std::string& name, const std::function<Algorithm()>& make, double later)
{
  const Algorithm fresh = make();
  fresh->UpdateTimeStep(0.0);
  const std::string wanted = BytesOf(fresh);
  bool good = Check(wanted.size() > 1000, name + " puts nothing out");
  const Algorithm used = make();
  int stops = 0;
  for (const double share : { -1.0, 0.0, 0.3, 0.6, 0.95 })
  {
    stops += StopAbove(used, share, later);
    used->UpdateTimeStep(0.0);
    good &= Check(BytesOf(used) == wanted, name + " differs after it was stopped above " + std::to_string(share));
  }
  return good && Check(stops > 0, name + " was never stopped");
}

template <typename Class>
vtkSmartPointer<Class> Made()
{
  return vtkSmartPointer<Class>::New();
}

vtkSmartPointer<vtkSuspendedParticleSource> Water()
{
  auto water = Made<vtkSuspendedParticleSource>();
  water->SetDensity(0.1);
  return water;
}

vtkSmartPointer<vtkSeaStateSource> Sea(double level)
{
  auto sea = Made<vtkSeaStateSource>();
  sea->SetNumberOfTrains(8);
  sea->SetSeaLevel(level);
  return sea;
}

vtkSmartPointer<vtkWindFieldSource> Wind()
{
  auto wind = Made<vtkWindFieldSource>();
  wind->SetDimensions(32, 4, 4);
  return wind;
}

Algorithm Connected(const Algorithm& filter, const std::vector<Algorithm>& inputs)
{
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    filter->SetInputConnection(static_cast<int>(port), inputs[port]->GetOutputPort());
  }
  return filter;
}

Algorithm Drift()
{
  auto primitive = Made<vtkFlowPrimitiveSource>();
  primitive->SetFlowTypeToVortex();
  return Connected(Made<vtkCurrentDriftFilter>(), { Water(), primitive });
}

/// In a wind, whose velocities vary in time.
Algorithm DriftInWind()
{
  return Connected(Made<vtkCurrentDriftFilter>(), { Water(), Wind() });
}

Algorithm Kelp()
{
  auto weed = Made<vtkSeaweedSource>();
  weed->SetSegmentsPerBranch(4);
  return Connected(Made<vtkSeaweedDeformationFilter>(), { weed, Sea(4.0) });
}

Algorithm Tree()
{
  auto tree = Made<vtkReevesTreeSource>();
  tree->SetNumberOfLeaves(100);
  tree->SetTextureSize(16, 8);
  auto sway = Made<vtkBeamTreeDeformationFilter>();
  sway->SetTextureSize(16, 8);
  return Connected(sway, { tree, Wind() });
}

}

int TestStoppedRequests(int, char*[])
{
  bool good = IsAsFresh("Drift", Drift, 30.0);
  good &= IsAsFresh("Drift in a wind", DriftInWind, 20.0);
  good &= IsAsFresh("Kelp", Kelp, 3.0);
  good &= IsAsFresh("Tree", Tree, 3.0);
  good &= IsAsFresh(
    "Orbits",
    [] {
      return Connected(Made<vtkParticleOrbitFilter>(), { Water(), Sea(0.0) });
    },
    3.0);
  good &= IsAsFresh(
    "Surface", [] { return Connected(Made<vtkSeaSurfaceFilter>(), { Sea(0.0) }); }, 3.0);
  good &= IsAsFresh(
    "Particles", [] { return Algorithm(Water()); }, 3.0);
  good &= IsAsFresh(
    "Wind", [] { return Algorithm(Wind()); }, 3.0);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
