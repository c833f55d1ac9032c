// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Survey.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/Places.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace littoral
{

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Whether values differ by more than their places are apart, as heights of metres do between places in degrees.
bool IsSteep(vtkDataSet* data, vtkDataArray* values)
{
  double box[6];
  data->GetBounds(box);
  double range[2] = { box[4], box[5] };
  if (values)
  {
    values->GetFiniteRange(range);
  }
  return range[1] - range[0] > std::hypot(box[1] - box[0], box[3] - box[2]);
}

}

//----------------------------------------------------------------------------
void TakeData(vtkDataSet* data, vtkDataArray* values, vtkDataArray* errors, Survey& survey)
{
  if (!survey.IsRaster)
  {
    RequireLengths(data, "Data", IsSteep(data, values) ? FarForGrid : FarForPoints);
  }
  survey.Name = values && values->GetName() && *values->GetName() ? values->GetName() : "Elevation";
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
  {
    double point[3];
    data->GetPoint(n, point);
    const double value = values ? values->GetComponent(n, 0) : point[2];
    if (survey.IsRaster)
    {
      survey.Raster.push_back(std::isfinite(value) ? value : NaN);
    }
    if (survey.IsRaster && !std::isfinite(value))
    {
      continue; // a hole
    }
    survey.Data.Places.push_back({ point[0], point[1], 0.0 });
    survey.Data.Values.push_back(value);
    if (errors)
    {
      const double error = errors->GetComponent(n, 0);
      if (!(error >= 0.0))
      {
        Refuse("Datum ", n, " has the error ", TextOf(error), "; standard deviations of errors must be at least 0.");
      }
      survey.Data.ErrorVariances.push_back(error * error);
    }
  }
  survey.Measured = survey.Data.Values;
}

//----------------------------------------------------------------------------
void TakeGrid(vtkImageData* grid, Survey& survey)
{
  RequireUpright(grid, "Grid");
  const int* extent = grid->GetExtent();
  survey.Window = { { extent[0], extent[2] }, { extent[1], extent[3] } };
  survey.Grid = { { grid->GetOrigin()[0], grid->GetOrigin()[1] }, { grid->GetSpacing()[0], grid->GetSpacing()[1] } };
  survey.OriginZ = grid->GetOrigin()[2];
  survey.SpacingZ = grid->GetSpacing()[2];
}

//----------------------------------------------------------------------------
void TakeDrift(vtkDataArray* drift, Survey& survey)
{
  std::vector<double> values;
  SetSize(values, drift->GetNumberOfTuples());
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    values[n] = drift->GetComponent(static_cast<vtkIdType>(n), 0);
  }
  TakeDrift(std::move(values), survey);
}

//----------------------------------------------------------------------------
void TakeModel(const FieldStatistics& statistics, Survey& survey)
{
  survey.Model.Field = statistics.Field;
  survey.Model.Nugget = statistics.Nugget;
  survey.Model.AnisotropyRatio = statistics.AnisotropyRatio;
  survey.Model.AnisotropyAngle = statistics.AnisotropyAngle;
  survey.Mean = statistics.Mean;
  Require(WhyInvalid(survey.Model));
  Require(WhyInvalid(survey.Data, survey.Model));
}

}
