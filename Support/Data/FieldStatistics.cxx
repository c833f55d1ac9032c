// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/FieldStatistics.h"

#include "Data/ArrayReader.h"
#include "Numerics/InvalidInput.h"

#include "vtkDataArray.h"
#include "vtkTable.h"

namespace littoral
{

//----------------------------------------------------------------------------
void TakeFit(vtkTable* fits, FieldStatistics& statistics)
{
  if (fits->GetNumberOfRows() == 0)
  {
    Refuse("The table of fits is empty; connect the first output of a covariance fit.");
  }
  const ArrayReader rows = ArrayReader::OfRows(fits, "The table of fits");
  const auto take = [&rows](const char* column, double& value) {
    vtkDataArray* array = rows.Find(column, 1);
    value = array ? array->GetComponent(0, 0) : value;
  };
  double model = -1.0;
  take("ModelId", model);
  if (!(model >= 0.0))
  {
    Refuse("The table of fits has no column ModelId with a model; connect the first output of a covariance fit.");
  }
  ReadWhole("ModelId", model, 0, NumberOfCovarianceModels - 1, statistics.Field.Model);
  take("Variance", statistics.Field.Variance);
  statistics.HasFittedVariance = rows.Has("Variance");
  take("Range", statistics.Field.Range);
  take("SecondRange", statistics.Field.SecondRange);
  take("FractalDimension", statistics.Field.FractalDimension);
  take("Nugget", statistics.Nugget);
  take("AnisotropyRatio", statistics.AnisotropyRatio);
  take("AnisotropyAngle", statistics.AnisotropyAngle);
  take("Mean", statistics.Mean);
  take("SlopeX", statistics.Slope[0]);
  take("SlopeY", statistics.Slope[1]);
  take("TrendWidth", statistics.TrendSides[0]);
  take("TrendHeight", statistics.TrendSides[1]);
}

}
