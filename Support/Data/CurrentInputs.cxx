// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/CurrentInputs.h"

#include "Pipeline/Pipeline.h"

#include "vtkInformationVector.h"

#include <cstddef>
#include <memory>

namespace littoral
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

//----------------------------------------------------------------------------
std::vector<CurrentSeries> AnnouncedCurrents(vtkInformationVector* inputs)
{
  std::vector<CurrentSeries> currents;
  for (int connection = 0; connection < inputs->GetNumberOfInformationObjects(); ++connection)
  {
    vtkInformation* info = inputs->GetInformationObject(connection);
    RequestAll(info);
    CurrentSeries current;
    if (info->Has(Pipeline::TIME_STEPS()))
    {
      const double* steps = info->Get(Pipeline::TIME_STEPS());
      current.Steps.assign(steps, steps + info->Length(Pipeline::TIME_STEPS()));
    }
    else if (info->Has(Pipeline::TIME_RANGE()))
    {
      info->Get(Pipeline::TIME_RANGE(), current.Range);
      current.IsContinuous = current.Range[0] < current.Range[1];
    }
    currents.push_back(current);
  }
  return currents;
}

//----------------------------------------------------------------------------
void AddTimes(const std::vector<CurrentSeries>& currents, std::vector<double>& key)
{
  for (const CurrentSeries& current : currents)
  {
    key.insert(key.end(), current.Steps.begin(), current.Steps.end());
    key.insert(key.end(), current.Range, current.Range + 2);
  }
}

//----------------------------------------------------------------------------
void AskForSnapshots(
  CurrentSet& currents, const TimeGrid& grid, const std::vector<StepMoment>& moments, vtkInformationVector* inputs)
{
  for (std::size_t connection = 0; connection < currents.Series.size(); ++connection)
  {
    CurrentSeries& current = currents.Series[connection];
    current.Asked = current.MissingTime(grid, moments).value_or(current.Asked);
    if (!current.IsSteady())
    {
      inputs->GetInformationObject(static_cast<int>(connection))->Set(Pipeline::UPDATE_TIME_STEP(), current.Asked);
    }
  }
}

//----------------------------------------------------------------------------
void TakeSnapshots(CurrentSet& currents, const TimeGrid& grid, const std::vector<StepMoment>& moments,
  vtkInformationVector* inputs, const char* velocityArray, VelocityInterpolation interpolation, CoastBehaviour coast)
{
  for (std::size_t connection = 0; connection < currents.Series.size(); ++connection)
  {
    CurrentSeries& current = currents.Series[connection];
    if (!current.MissingTime(grid, moments))
    {
      continue;
    }
    current.Keep(current.Asked,
      std::make_shared<CurrentSnapshot>(ReadCurrent(vtkDataObject::GetData(inputs, static_cast<int>(connection)),
        velocityArray ? velocityArray : "", currents.Layer, interpolation, coast)));
  }
}

}
