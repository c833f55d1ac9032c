// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A far wood: each plant one rectangle that faces the camera, with the textures of all species; seen from low and from
// 60 degrees above.
#include "Check.h"
#include "PlantScene.h"
#include "vtkPlantScatterFilter.h"
#include "vtkReevesTreeSource.h"

#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{

constexpr double Angle = 12.0; // of the view [degrees]
constexpr double Distance = 500.0;
const double Middle[3] = { 0.0, 0.0, 4.0 };

/// Pines, oaks and birches on a plain of 200 m.
struct Wood
{
  vtkNew<vtkPlantScatterFilter> Filter;

  Wood()
  {
    vtkNew<vtkPoints> points;
    for (int site = 0; site < 900; ++site)
    {
      points->InsertNextPoint(7.0 * (site % 30 - 14.5) + 2.5 * std::sin(3.1 * site),
        7.0 * (site / 30 - 14.5) + 2.5 * std::cos(5.3 * site), 0.0);
    }
    vtkNew<vtkPolyData> sites;
    sites->SetPoints(points);
    this->Filter->SetInputData(sites);
    for (const int preset : { vtkReevesTreeSource::Pine, vtkReevesTreeSource::Oak, vtkReevesTreeSource::Birch })
    {
      vtkNew<vtkReevesTreeSource> tree;
      tree->SetPreset(preset);
      this->Filter->AddPrototypeConnection(tree->GetOutputPort());
    }
    this->Filter->UseCullingOff();
  }

  vtkPolyData* Low() { return vtkPolyData::SafeDownCast(BlockAt(this->Filter->GetOutputDataObject(0), "Low")); }
};

vtkSmartPointer<vtkPolyData> Meadow()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2000.0, -2000.0, 0.0);
  plane->SetPoint1(2000.0, -2000.0, 0.0);
  plane->SetPoint2(-2000.0, 2000.0, 0.0);
  plane->Update();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  for (int corner = 0; corner < 4; ++corner)
  {
    colors->InsertNextTuple3(92, 104, 56);
  }
  vtkSmartPointer<vtkPolyData> meadow = plane->GetOutput();
  meadow->GetPointData()->SetScalars(colors);
  return meadow;
}

/// Shows the wood from an elevation [degrees] in a part of the picture's height.
void Show(PlantScene& scene, Wood& wood, double elevation, double low, double high)
{
  const double up = vtkMath::RadiansFromDegrees(elevation);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(Middle[0] - 0.3 * Distance * std::cos(up), Middle[1] - 0.954 * Distance * std::cos(up),
    Middle[2] + Distance * std::sin(up));
  camera->SetFocalPoint(Middle);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(Angle);
  wood.Filter->SetCamera(camera);
  wood.Filter->Update();
  vtkNew<vtkMultiBlockDataSet> plants;
  plants->DeepCopy(wood.Filter->GetOutputDataObject(0));
  scene.AddAsCarried(Meadow());
  scene.AddAsCarried(plants);
  scene.Renderer->SetViewport(0.0, low, 1.0, high);
  scene.Renderer->ResetCameraClippingRange();
}

/// One rectangle a plant, or the four of its prototype that do not depend on the view.
bool Rectangles(Wood& wood)
{
  const double plants = wood.Filter->GetOutputDataObject(0)->GetFieldData()->GetArray("PlantsLow")->GetTuple1(0);
  bool good = Check(plants == 900.0 && wood.Low()->GetNumberOfPolys() == 900, "a far plant is not one rectangle");
  good &= Check(wood.Low()->GetFieldData()->GetArray("NormalTexture")->GetNumberOfTuples() ==
      wood.Low()->GetFieldData()->GetArray("Texture")->GetNumberOfTuples(),
    "normals of other texels than those of the texture");
  vtkNew<vtkPolyData> first;
  wood.Filter->FaceCameraOff();
  wood.Filter->Update();
  first->DeepCopy(wood.Low());
  good &= Check(first->GetNumberOfPolys() == 3600, "without facing the camera, a plant is not that of its prototype");
  wood.Filter->SetViewPoint(0.0, 900.0, 300.0);
  wood.Filter->Update();
  double farthest = 0.0;
  for (vtkIdType point = 0; point < first->GetNumberOfPoints(); ++point)
  {
    double a[3];
    double b[3];
    first->GetPoint(point, a);
    wood.Low()->GetPoint(point, b);
    farthest = std::max(farthest, std::sqrt(vtkMath::Distance2BetweenPoints(a, b)));
  }
  return good & Check(farthest == 0.0, "without facing the camera, plants depend on the view");
}

}

int TestFarWood(int argc, char* argv[])
{
  Wood wood;
  PlantScene above;
  PlantScene low;
  low.Window->SetSize(200, 150);
  low.Window->AddRenderer(above.Renderer);
  Show(above, wood, 60.0, 0.4, 1.0);
  Show(low, wood, 4.0, 0.0, 0.4);
  if (!Rectangles(wood))
  {
    return EXIT_FAILURE;
  }
  const double* eye = low.Renderer->GetActiveCamera()->GetPosition();
  const double from[3] = { eye[0], eye[1], eye[2] };
  return low.Compare(argc, argv, from, Middle, 0.5 * Angle);
}
