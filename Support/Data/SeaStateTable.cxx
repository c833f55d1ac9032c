// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SeaStateTable.h"

#include "Data/Tables.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

namespace littoral
{

void WriteSeaState(const SeaState& state, vtkTable* table)
{
  const auto column = [&](const char* name, double WaveTrain::*member) {
    AddColumn(table, name, state.Trains, [member](const WaveTrain& train) { return train.*member; });
  };
  column(sea::Amplitude, &WaveTrain::Amplitude);
  column(sea::AngularFrequency, &WaveTrain::AngularFrequency);
  column(sea::WaveNumber, &WaveTrain::WaveNumber);
  column(sea::Direction, &WaveTrain::Direction);
  column(sea::Phase, &WaveTrain::Phase);
  AddField(table, sea::WaterDepth, { state.Depth });
  AddField(table, sea::SeaLevel, { state.SeaLevel });
  AddField(table, sea::Period, { state.Period });
}

std::string ReadSeaState(vtkTable* table, SeaState& state)
{
  if (!table || table->GetNumberOfRows() == 0)
  {
    return "the sea state has no wave trains.";
  }
  state.Trains.assign(static_cast<std::size_t>(table->GetNumberOfRows()), WaveTrain{});
  const struct
  {
    const char* Name;
    double WaveTrain::*Member;
  } columns[] = { { sea::Amplitude, &WaveTrain::Amplitude }, { sea::AngularFrequency, &WaveTrain::AngularFrequency },
    { sea::WaveNumber, &WaveTrain::WaveNumber }, { sea::Direction, &WaveTrain::Direction },
    { sea::Phase, &WaveTrain::Phase } };
  for (const auto& column : columns)
  {
    vtkDataArray* array = vtkDataArray::SafeDownCast(table->GetColumnByName(column.Name));
    if (!array || array->GetNumberOfComponents() != 1)
    {
      return std::string("the sea state has no column of numbers ") + column.Name + ".";
    }
    for (std::size_t row = 0; row < state.Trains.size(); ++row)
    {
      state.Trains[row].*column.Member = array->GetTuple1(static_cast<vtkIdType>(row));
    }
  }
  const auto field = [table](const char* name, double& value) {
    vtkDataArray* array = table->GetFieldData()->GetArray(name);
    if (array && array->GetNumberOfValues() == 1)
    {
      value = array->GetTuple1(0);
    }
  };
  field(sea::WaterDepth, state.Depth);
  field(sea::SeaLevel, state.SeaLevel);
  field(sea::Period, state.Period);
  return WhyInvalid(state);
}

}
