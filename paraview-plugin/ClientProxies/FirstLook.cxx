// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FirstLook.h"

#include "ColorHelper.h"

#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTransferFunctionManager.h"
#include "vtkSMTransferFunctionProxy.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace littoral
{
namespace
{

/// Optical depth along the diagonal of fog that is densest everywhere, at least.
constexpr double ThinnestFog = 100.0;
constexpr double Glitter = 0.5;
constexpr double GlitterPower = 60.0;
constexpr int OpacityPoints = 65;

/// Marks a transfer function that was set once.
constexpr const char* Mark = "Littoral.FirstLook";

/// Marks a transfer function of an array as set; false if it was marked before.
bool MarkOnce(vtkSMProxy* function)
{
  if (!function || function->HasAnnotation(Mark))
  {
    return false;
  }
  function->SetAnnotation(Mark, "1");
  return true;
}

double DiagonalOf(vtkPVDataInformation* data)
{
  const double* b = data->GetBounds();
  return std::max(
    1e-9, std::sqrt((b[1] - b[0]) * (b[1] - b[0]) + (b[3] - b[2]) * (b[3] - b[2]) + (b[5] - b[4]) * (b[5] - b[4])));
}

double LargestOf(vtkPVDataInformation* data, const char* array)
{
  vtkPVArrayInformation* ofPoints = data->GetArrayInformation(array, vtkDataObject::POINT);
  vtkPVArrayInformation* information = ofPoints ? ofPoints : data->GetArrayInformation(array, vtkDataObject::CELL);
  return information ? std::max(1e-9, information->GetComponentRange(0)[1]) : 1.0;
}

}

//----------------------------------------------------------------------------
void ColorDirectly(vtkSMProxy* representation, const char* array, bool isKnown)
{
  if (isKnown)
  {
    ColorHelper::SetScalarColoring(representation, array, vtkDataObject::POINT);
  }
  // First this: the window's color map editor then asks for the range of the array that is shown.
  vtkSMPropertyHelper(representation, "MapScalars").Set(0);
  vtkSMPropertyHelper(representation, "ColorArrayName").SetInputArrayToProcess(vtkDataObject::POINT, array);
  representation->UpdateVTKObjects();
}

//----------------------------------------------------------------------------
void ShadeSmoothly(vtkSMProxy* representation, const char* array)
{
  if (representation->GetProperty("SelectNormalArray"))
  {
    vtkSMPropertyHelper(representation, "SelectNormalArray").Set(array);
  }
}

//----------------------------------------------------------------------------
void ShadeAsWater(vtkSMProxy* representation, double ambient)
{
  vtkSMPropertyHelper(representation, "Ambient").Set(ambient);
  vtkSMPropertyHelper(representation, "Diffuse").Set(1.0 - ambient);
  vtkSMPropertyHelper(representation, "Specular").Set(Glitter);
  vtkSMPropertyHelper(representation, "SpecularPower").Set(GlitterPower);
}

//----------------------------------------------------------------------------
void ShadeUnderSky(vtkSMProxy* representation, double share)
{
  vtkSMPropertyHelper(representation, "Ambient").Set(share);
}

//----------------------------------------------------------------------------
void ColorByArray(vtkSMProxy* representation, const char* array, const char* preset)
{
  ColorHelper::SetScalarColoring(representation, array, vtkDataObject::POINT);
  vtkSMProxy* map = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  if (preset && MarkOnce(map))
  {
    vtkSMTransferFunctionProxy::ApplyPreset(map, preset, true);
    const double dryEarth[3] = { 0.57, 0.53, 0.45 }; // land in currents, holes of rasters
    vtkSMPropertyHelper(map, "NanColor").Set(dryEarth, 3);
  }
  ColorHelper::RescaleTransferFunctionToDataRange(representation, array, vtkDataObject::POINT);
}

//----------------------------------------------------------------------------
void ShowDarkLegend(vtkSMProxy* representation, vtkSMProxy* view, const char* title)
{
  ColorHelper::SetScalarBarVisibility(representation, view, true);
  vtkSMProxy* map = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  vtkNew<vtkSMTransferFunctionManager> functions;
  vtkSMProxy* legend = map ? functions->GetScalarBarRepresentation(map, view) : nullptr;
  if (MarkOnce(legend))
  {
    const double ink[3] = { 0.10, 0.14, 0.20 };
    vtkSMPropertyHelper(legend, "TitleColor").Set(ink, 3);
    vtkSMPropertyHelper(legend, "LabelColor").Set(ink, 3);
    if (title)
    {
      vtkSMPropertyHelper(legend, "Title").Set(title);
      vtkSMPropertyHelper(legend, "ComponentTitle").Set("");
    }
    legend->UpdateVTKObjects();
  }
}

//----------------------------------------------------------------------------
bool AreParticles(vtkPVDataInformation* data)
{
  return data->GetArrayInformation("ParticleId", vtkDataObject::POINT) &&
    data->GetArrayInformation("Radius", vtkDataObject::POINT);
}

//----------------------------------------------------------------------------
void ShowAsSprites(vtkSMProxy* representation, vtkPVDataInformation* data, double smallest)
{
  const double factor = std::max(1.0, smallest * DiagonalOf(data) / LargestOf(data, "Radius"));
  vtkSMPropertyHelper(representation, "Representation").Set("Point Gaussian");
  vtkSMPropertyHelper(representation, "ShaderPreset").Set("Sphere");
  vtkSMPropertyHelper(representation, "GaussianRadius").Set(factor);
  vtkSMPropertyHelper(representation, "ScaleByArray").Set(1);
  vtkSMPropertyHelper(representation, "SetScaleArray").SetInputArrayToProcess(vtkDataObject::POINT, "Radius");
  vtkSMPropertyHelper(representation, "UseScaleFunction").Set(0);
}

//----------------------------------------------------------------------------
void DrawLines(vtkSMProxy* representation, double width, const double* color)
{
  if (color)
  {
    ColorHelper::SetScalarColoring(representation, nullptr, vtkDataObject::POINT);
    vtkSMPropertyHelper(representation, "AmbientColor").Set(color, 3);
    vtkSMPropertyHelper(representation, "DiffuseColor").Set(color, 3);
  }
  vtkSMPropertyHelper(representation, "LineWidth").Set(width);
  vtkSMPropertyHelper(representation, "Ambient").Set(1.0); // as drawn on a map, not lit
  vtkSMPropertyHelper(representation, "Diffuse").Set(0.0);
}

//----------------------------------------------------------------------------
void ShowAsDots(vtkSMProxy* representation, double size, const double color[3])
{
  vtkSMPropertyHelper(representation, "Representation").Set("Points");
  vtkSMPropertyHelper(representation, "RenderPointsAsSpheres").Set(1);
  vtkSMPropertyHelper(representation, "PointSize").Set(size);
  vtkSMPropertyHelper(representation, "Ambient").Set(1.0); // all of one color, as ink is
  vtkSMPropertyHelper(representation, "Diffuse").Set(0.0);
  vtkSMPropertyHelper(representation, "AmbientColor").Set(color, 3);
  vtkSMPropertyHelper(representation, "DiffuseColor").Set(color, 3);
}

//----------------------------------------------------------------------------
void ShowAsFog(vtkSMProxy* representation, vtkPVDataInformation* data, const char* array, const double* color)
{
  const bool isOfPoints = data->GetArrayInformation(array, vtkDataObject::POINT) != nullptr;
  ColorHelper::SetScalarColoring(representation, array, isOfPoints ? vtkDataObject::POINT : vtkDataObject::CELL);
  vtkSMPropertyHelper(representation, "Representation").Set("Volume");
  vtkSMProxy* colors = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  vtkSMProxy* opacities = vtkSMPropertyHelper(representation, "ScalarOpacityFunction").GetAsProxy();
  if (!colors || !MarkOnce(opacities))
  {
    return;
  }
  const double largest = LargestOf(data, array);
  const double diagonal = DiagonalOf(data);
  const double factor = std::max(1.0, ThinnestFog / (largest * diagonal));
  const double unit = 0.1 * diagonal / factor; // so that alpha of the densest fog is between 0 and 1
  std::vector<double> points;
  for (int i = 0; i < OpacityPoints; ++i)
  {
    const double s = largest * i / (OpacityPoints - 1);
    const double alpha = -std::expm1(-factor * s * unit);
    points.insert(points.end(), { s, alpha, 0.5, 0.0 });
  }
  vtkSMPropertyHelper(opacities, "Points").Set(points.data(), static_cast<unsigned int>(points.size()));
  opacities->UpdateVTKObjects();
  vtkSMPropertyHelper(representation, "ScalarOpacityUnitDistance").Set(unit);
  double range[8] = { 0.0, 0.62, 0.80, 0.82, largest, 0.90, 0.96, 0.94 }; // pale, as water
  for (int c = 0; color && c < 3; ++c)
  {
    range[1 + c] = color[c];
    range[5 + c] = 0.6 * color[c];
  }
  vtkSMPropertyHelper(colors, "RGBPoints").Set(range, 8);
  vtkSMPropertyHelper(colors, "AutomaticRescaleRangeMode").Set("Never");
  colors->UpdateVTKObjects();
}

}
