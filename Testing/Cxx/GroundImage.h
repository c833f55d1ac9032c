// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GroundImage_h
#define GroundImage_h

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <functional>

/// An image of elevations, 10 m apart along x and 20 m along y.
inline vtkNew<vtkImageData> Image(int nx, int ny, int nz, const std::function<double(int, int)>& valueAt)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(nx, ny, nz);
  image->SetSpacing(10.0, 20.0, 1.0);
  image->SetOrigin(500.0, -300.0, 0.0);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Elevation");
  for (int n = 0; n < nx * ny * nz; ++n)
  {
    values->InsertNextValue(valueAt(n % nx, n / nx % ny));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// Height of a plane at a point of an image.
inline double Ramp(int i, int j)
{
  return 3.0 * i + 0.5 * j;
}

#endif
