// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Zoom through the pipeline: the same ground in finer cells, means that hold, parts of one whole, every bad input.
#include "Check.h"
#include "ErrorCounter.h"
#include "GroundImage.h"
#include "vtkTerrainZoomFilter.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace
{

double Hills(int i, int j)
{
  return 3.0 * j + 12.0 * std::abs(std::sin(0.9 * i + 0.3 * j)) + 5.0 * std::sin(1.3 * j);
}

double HeightAt(vtkImageData* image, int i, int j)
{
  int point[3] = { i, j, 0 };
  return image->GetPointData()->GetScalars()->GetComponent(image->ComputePointId(point), 0);
}

/// The fine cells cover the coarse ones, wherever their extent begins, and keep their means.
bool CoversTheSameGround()
{
  vtkNew<vtkImageData> coarse = Image(12, 10, 1, Hills);
  coarse->SetExtent(4, 15, -3, 6, 0, 0);
  vtkNew<vtkTerrainZoomFilter> zoom;
  zoom->SetInputData(coarse);
  zoom->SetFactor(4);
  zoom->Update();
  vtkImageData* fine = zoom->GetOutput();
  const int* extent = fine->GetExtent();
  const double* spacing = fine->GetSpacing();
  bool good = Check(extent[0] == 16 && extent[1] == 63 && extent[2] == -12 && extent[3] == 27, "another extent");
  good &= Check(spacing[0] == 2.5 && spacing[1] == 5.0 && spacing[2] == 1.0, "another spacing");
  std::array<double, 6> outer;
  std::array<double, 6> whole;
  fine->GetBounds(outer.data());
  coarse->GetBounds(whole.data());
  for (int axis : { 0, 1 })
  {
    // half a cell beyond the first and last points
    const double half = 0.5 * coarse->GetSpacing()[axis];
    good &= Check(std::abs(outer[2 * axis] - spacing[axis] / 2 - (whole[2 * axis] - half)) < 1e-9, "begins elsewhere");
    good &=
      Check(std::abs(outer[2 * axis + 1] + spacing[axis] / 2 - (whole[2 * axis + 1] + half)) < 1e-9, "ends elsewhere");
  }
  const double most = fine->GetFieldData()->GetArray("LargestShift")->GetComponent(0, 0);
  double shift = 0.0;
  for (int n = 0; n < 120; ++n)
  {
    const int i = 4 + n % 12;
    const int j = n / 12 - 3;
    double mean = 0.0;
    for (int k = 0; k < 16; ++k)
    {
      mean += HeightAt(fine, 4 * i + k % 4, 4 * j + k / 4) / 16.0;
    }
    shift = std::max(shift, std::abs(mean - HeightAt(coarse, i, j)));
  }
  return good && Check(shift < 12.0 && std::abs(shift - most) < 1e-9, "means have moved");
}

bool PartsAreOfOneWhole()
{
  vtkNew<vtkTerrainZoomFilter> zoom;
  zoom->SetInputData(Image(12, 10, 1, Hills));
  zoom->SetFactor(2);
  zoom->Update();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(zoom->GetOutput());
  vtkNew<vtkTerrainZoomFilter> part;
  part->SetInputData(Image(12, 10, 1, Hills));
  part->SetFactor(2);
  const int extent[6] = { 3, 9, 11, 19, 0, 0 };
  part->UpdateExtent(extent);
  bool good = Check(part->GetOutput()->GetNumberOfPoints() == 63, "another part");
  for (int j = 11; j <= 19; ++j)
  {
    for (int i = 3; i <= 9; ++i)
    {
      good &= HeightAt(whole, i, j) == HeightAt(part->GetOutput(), i, j);
    }
  }
  return Check(good, "a part is not the whole's");
}

bool BadInput()
{
  vtkNew<vtkTerrainZoomFilter> zoom;
  vtkNew<ErrorCounter> errors;
  errors->Watch(zoom);
  zoom->SetInputData(Image(12, 10, 1, Hills));
  bool good = true;
  zoom->SetFactor(1);
  good &= errors->ExpectOneNaming("Factor is 1");
  zoom->SetFactor(17);
  good &= errors->ExpectOneNaming("Factor is 17");
  zoom->SetFactor(2);
  zoom->SetGrowth(-1.0);
  good &= errors->ExpectOneNaming("Growth");
  zoom->SetGrowth(std::numeric_limits<double>::quiet_NaN());
  good &= errors->ExpectOneNaming("Growth");
  zoom->SetGrowth(1.0);
  zoom->SetMaximumShift(1.5);
  good &= errors->ExpectOneNaming("MaximumShift");
  zoom->SetMaximumShift(0.5);
  zoom->SetInputData(Image(2, 2, 1, Hills));
  good &= errors->ExpectOneNaming("at least 3 x 3");
  zoom->SetInputData(Image(5, 4, 1, [](int, int) { return 7.0; }));
  good &= errors->ExpectOneNaming("constant");
  zoom->SetInputData(Image(5, 4, 1, [](int, int) { return std::numeric_limits<double>::quiet_NaN(); }));
  good &= errors->ExpectOneNaming("no heights");
  zoom->SetInputData(Image(4, 4, 1, Hills));
  zoom->Update();
  return good && Check(zoom->GetOutput()->GetNumberOfPoints() == 64, "nothing is zoomed after refusals");
}

}

int TestTerrainZoomFilter(int, char*[])
{
  return CoversTheSameGround() && PartsAreOfOneWhole() && BadInput() ? EXIT_SUCCESS : EXIT_FAILURE;
}
