// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Four kinds of plants at their three levels of detail: arrays, pictures, same bytes, pieces, bad input, a picture.
#include "PlantChecks.h"
#include "vtkGardnerPlantSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace
{

using Source = vtkGardnerPlantSource;

bool EachPointIsUsed(vtkPolyData* part)
{
  std::set<vtkIdType> used;
  for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    part->GetCellPoints(cell, size, corners);
    used.insert(corners, corners + size);
  }
  return static_cast<vtkIdType>(used.size()) == part->GetNumberOfPoints();
}

/// The Medium crown reaches no farther than the ellipsoid that its own height and width span.
bool CrownIsInside(Source* source)
{
  vtkPolyData* crown = PartOf(source, "Medium/Crown");
  double bounds[6];
  crown->GetBounds(bounds);
  const double middle = 0.5 * (bounds[4] + bounds[5]);
  const double half = 0.5 * (bounds[5] - bounds[4]);
  const double radius = std::max({ -bounds[0], bounds[1], -bounds[2], bounds[3] });
  for (vtkIdType point = 0; point < crown->GetNumberOfPoints(); ++point)
  {
    double p[3];
    crown->GetPoint(point, p);
    if (std::hypot(std::hypot(p[0], p[1]) / radius, (p[2] - middle) / half) > 1.0 + 1e-5)
    {
      return Check(false, "the medium crown reaches out of its volume");
    }
  }
  double leaves[6];
  PartOf(source, "High/Leaves")->GetBounds(leaves);
  const double tolerance = 0.15 * (leaves[5] - leaves[4]);
  const bool about = std::abs(bounds[4] - leaves[4]) < tolerance && std::abs(bounds[5] - leaves[5]) < tolerance;
  if (!about)
  {
    std::cerr << bounds[4] << " to " << bounds[5] << " for " << leaves[4] << " to " << leaves[5] << std::endl;
  }
  return Check(about, "the medium crown is not where the leaves are");
}

using Plants = std::map<int, vtkNew<Source>>;

bool Levels(Plants& plants)
{
  bool good = true;
  for (const int preset : { Source::Tree, Source::Bush })
  {
    Source* source = plants[preset];
    source->Update();
    good &= HasLevels(source) && CarriesTexture(source, "Medium/Crown", false) && CarriesTexture(source, "Low", true);
    good &= Check(EachPointIsUsed(PartOf(source, "High/Leaves")), "vertices without triangles");
    good &= Check(PictureFits(source, 1, "Medium/Crown") && PictureFits(source, 2, "High/Leaves"),
      "a picture and the field data of its block differ");
  }
  Source* tree = plants[Source::Tree];
  tree->SetMediumCrownToEnvelope();
  tree->Update();
  return good && CrownIsInside(tree);
}

/// A small plant costs less.
void Shrink(Source* source)
{
  source->SetPreset(Source::Custom);
  source->SetNumberOfQuadrics(6);
}

bool BadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= Fails<Source>("Preset", [](Source* s) { s->SetPreset(9); });
  good &= Fails<Source>("Height", [](Source* s) { s->SetHeight(0.0); });
  good &= Fails<Source>("Height", [=](Source* s) { s->SetHeight(nan); });
  good &= Fails<Source>("CrownBase", [](Source* s) { s->SetCrownBase(100.0); });
  good &= Fails<Source>("NumberOfQuadrics", [](Source* s) { s->SetNumberOfQuadrics(0); });
  good &= Fails<Source>("Shells", [](Source* s) { s->SetShells(9); });
  good &= Fails<Source>("Terms", [](Source* s) { s->SetTerms(3); });
  good &= Fails<Source>("Frequency", [](Source* s) { s->SetFrequency(5); });
  good &= Fails<Source>("Offset", [=](Source* s) { s->SetOffset(nan); });
  good &= Fails<Source>("CenterThreshold", [](Source* s) { s->SetCenterThreshold(0.9); });
  good &= Fails<Source>("SilhouetteThreshold", [](Source* s) { s->SetSilhouetteThreshold(1.1); });
  good &= Fails<Source>("Variation", [](Source* s) { s->SetVariation(-0.1); });
  good &= Fails<Source>("LeafColor", [](Source* s) { s->SetLeafColor(2.0, 0.0, 0.0); });
  good &= Fails<Source>("TextureSize", [](Source* s) { s->SetTextureSize(0, 64); });
  good &= Fails<Source>("MediumCrown", [](Source* s) { s->SetMediumCrown(2); });
  good &= Fails<Source>("CrownJitter", [](Source* s) { s->SetCrownJitter(-0.1); });
  return good;
}

}

int TestGardnerPlantSource(int argc, char* argv[])
{
  Plants plants;
  for (const int preset : { Source::Tree, Source::Cypress, Source::Bush })
  {
    plants[preset]->SetPreset(preset);
    plants[preset]->SetTextureSize(32, 16); // small pictures cost less
  }
  if (!Levels(plants) || !Reproducible<Source>(Shrink) || !Pieces<Source>(Shrink) || !BadInput())
  {
    return EXIT_FAILURE;
  }
  PlantScene scene;
  scene.Window->SetSize(300, 200);
  double x = 0.0;
  for (const int preset : { Source::Tree, Source::Cypress, Source::Bush })
  {
    Source* source = plants[preset];
    source->Update();
    const double half = preset == Source::Tree ? 5.0 : 1.8;
    x += half;
    scene.Add(PartOf(source, "High/Skin"), x);
    scene.Add(
      PartOf(source, "High/Leaves"), x, vtkImageData::SafeDownCast(source->GetOutputDataObject(2)), false, true);
    x += half;
  }
  const double eye[3] = { 0.5 * x, -60.0, 6.0 };
  const double focus[3] = { 0.5 * x, 0.0, 6.0 };
  return scene.Compare(argc, argv, eye, focus, 12.0);
}
