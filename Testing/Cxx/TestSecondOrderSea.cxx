// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A wave of second order as surface, points and table: Stokes' crests and troughs; what cannot be of it is refused.
#include "ErrorCounter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaSurfaceFilter.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace
{

bool Check(bool good, const char* words)
{
  if (!good)
  {
    std::cerr << words << std::endl;
  }
  return good;
}

/// Half of the highest and the lowest point.
double MiddleOf(vtkDataObject* surface)
{
  double bounds[6];
  vtkPolyData::SafeDownCast(surface)->GetBounds(bounds);
  return 0.5 * (bounds[4] + bounds[5]);
}

}

int TestSecondOrderSea(int, char*[])
{
  // k h = 1 at h = 10 m: w2 = g k tanh kh, with eta2 / (k a2) = 1.36956 and a set-down of 0.13786
  const double k = 0.1;
  const double depth = 10.0;
  const double amplitude = 0.2;
  const double frequency = std::sqrt(9.80665 * k * std::tanh(k * depth));
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSpectrum(vtkSeaStateSource::Regular);
  sea->SetSeaBy(vtkSeaStateSource::HeightAndPeriod);
  sea->SetSignificantWaveHeight(2.0 * amplitude);
  sea->SetPeakPeriod(2.0 * 3.14159265358979 / frequency);
  sea->SetWaterDepth(depth);
  vtkNew<vtkSeaSurfaceFilter> surface;
  surface->SetInputConnection(sea->GetOutputPort());
  surface->SetRadius(70.0);
  surface->SetSpacing(0.5);
  surface->WaterColorsOff();
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(70.0, 0.0, 0.0);
  plane->SetPoint2(0.0, 1.0, 0.0);
  plane->SetXResolution(400);
  vtkNew<vtkParticleOrbitFilter> orbits;
  orbits->SetInputConnection(0, plane->GetOutputPort());
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  surface->Update();
  bool good = Check(std::abs(MiddleOf(surface->GetOutput())) < 1e-5, "first order: crests are not as high as troughs");
  good &= Check(!sea->GetOutput()->GetFieldData()->HasArray("Order"), "first order has new field data");
  sea->SetOrderToSecond();
  surface->Update();
  orbits->Update();
  const double stokes = (1.36956 - 0.13786) * k * amplitude * amplitude;
  good &= Check(std::abs(MiddleOf(surface->GetOutput()) / stokes - 1.0) < 0.01, "the surface is not Stokes' wave");
  good &= Check(
    std::abs(MiddleOf(orbits->GetOutputDataObject(0)) / stokes - 1.0) < 0.01, "points do not move in Stokes' wave");
  vtkFieldData* fields = sea->GetOutput()->GetFieldData();
  good &= Check(fields->GetArray("Order")->GetComponent(0, 0) == 2.0, "the order is not in the field data");
  // <eta1^2 eta2> / m0^1.5 = 3 a4 B / 4 / (a2/2)^1.5
  const double skewness = 3.0 * 1.36956 * k * amplitude / 4.0 / std::pow(0.5, 1.5);
  good &= Check(std::abs(fields->GetArray("Skewness")->GetComponent(0, 0) / skewness - 1.0) < 1e-4, "another skewness");

  vtkNew<ErrorCounter> errors;
  errors->Watch(sea);
  sea->SetOrder(3);
  good &= errors->ExpectOneNaming("Order");
  sea->SetOrderToSecond();
  sea->SetSpectrumToPiersonMoskowitz();
  sea->SetSeaByToWind();
  sea->SetNumberOfTrains(201);
  good &= errors->ExpectOneNaming("at most 200");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
