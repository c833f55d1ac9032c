// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Four species at their three levels of detail: arrays, same bytes, pieces, bad input, a picture.
#include "PlantChecks.h"
#include "vtkReevesTreeSource.h"

#include "vtkCellData.h"
#include "vtkImageData.h"

#include <limits>

namespace
{

using Source = vtkReevesTreeSource;

bool Levels()
{
  bool good = true;
  for (int preset = Source::Pine; preset <= Source::Shrub; ++preset)
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->SetTextureSize(32, 16); // small pictures cost less
    source->Update();
    good &= IsTree(source);
  }
  return good;
}

/// A small plant costs less.
void Shrink(Source* source)
{
  source->SetPreset(Source::Custom);
  source->SetNumberOfLeaves(500);
}

bool BadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= Fails<Source>("Preset", [](Source* s) { s->SetPreset(9); });
  good &= Fails<Source>("SpeciesHeight", [](Source* s) { s->SetSpeciesHeight(0.01); });
  good &= Fails<Source>("SpeciesDiameter", [](Source* s) { s->SetSpeciesDiameter(0.001); });
  good &= Fails<Source>("SpeciesCrown", [](Source* s) { s->SetSpeciesCrown(0.001); });
  good &= Fails<Source>("Height", [](Source* s) { s->SetHeight(0.0); });
  good &= Fails<Source>("Height", [=](Source* s) { s->SetHeight(nan); });
  good &= Fails<Source>("CrownBase", [](Source* s) { s->SetCrownBase(100.0); });
  good &= Fails<Source>("CrownShape", [](Source* s) { s->SetCrownShape(2); });
  return RefusesBadLeaves<Source>() && good;
}

}

int TestReevesTreeSource(int argc, char* argv[])
{
  if (!Levels() || !Reproducible<Source>(Shrink) || !Pieces<Source>(Shrink) || !BadInput())
  {
    return EXIT_FAILURE;
  }
  PlantScene scene;
  double x = 0.0;
  for (int preset = Source::Pine; preset <= Source::Shrub; ++preset)
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->Update();
    const double step = preset == Source::Shrub ? 3.2 : preset == Source::Oak ? 11.5 : 7.0;
    scene.AddAsCarried(BlockAt(source->GetOutputDataObject(0), "High"), x);
    scene.AddAsCarried(BlockAt(source->GetOutputDataObject(0), "Medium"), x + step);
    scene.AddAsCarried(PartOf(source, "Low"), x + 1.9 * step);
    x += preset == Source::Pine ? 23.0 : preset == Source::Oak ? 30.0 : 18.0;
  }
  const double eye[3] = { 36.5, -120.0, 10.0 };
  const double focus[3] = { 36.5, 0.0, 7.0 };
  return scene.Compare(argc, argv, eye, focus, 16.5);
}
