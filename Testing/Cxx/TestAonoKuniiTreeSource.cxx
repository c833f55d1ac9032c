// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Four of the twelve published trees at their three levels of detail: arrays, the crown's volume, sound polygons, same
// bytes, pieces, bad input, a picture.
#include "PlantChecks.h"
#include "Plants/AonoKuniiTree.h"
#include "vtkAonoKuniiTreeSource.h"

#include "vtkCellData.h"
#include "vtkImageData.h"

#include <limits>

namespace
{

using Source = vtkAonoKuniiTreeSource;

/// The Medium crown lies within the volume around the leaves.
bool CrownWithin(Source* source, int preset)
{
  littoral::AonoKuniiParameters parameters = littoral::PresetParameters(static_cast<littoral::ForkPreset>(preset));
  const littoral::CrownVolume crown = littoral::GrowAonoKuniiTree(parameters).Crown;
  vtkPolyData* envelope = PartOf(source, "Medium/Crown");
  for (vtkIdType point = 0; point < envelope->GetNumberOfPoints(); ++point)
  {
    const double* x = envelope->GetPoint(point);
    const double part = (x[2] - crown.Foot.z) / crown.Height;
    const double reach = std::hypot(x[0] - crown.Foot.x, x[1] - crown.Foot.y) / crown.Radius;
    const double widest =
      crown.Shape == littoral::CrownShape::Cone ? 1.0 - part : std::sqrt(std::max(0.0, 4.0 * part * (1.0 - part)));
    if (part < -1e-6 || part > 1.0 + 1e-6 || reach > widest + 1e-5)
    {
      return Check(false, "the Medium crown is not within its volume");
    }
  }
  return true;
}

bool Levels()
{
  bool good = true;
  for (int preset = Source::MonopodialA; preset <= Source::TernaryD; preset += 3)
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->SetTextureSize(32, 16); // small pictures cost less
    source->Update();
    good &= IsTree(source);
    source->SetMediumCrownToEnvelope();
    source->Update();
    good = good && CrownWithin(source, preset);
  }
  return good;
}

/// A small plant costs less.
void Shrink(Source* source)
{
  source->SetPreset(Source::Custom);
  source->SetIterations(7);
}

bool BadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= Fails<Source>("Preset", [](Source* s) { s->SetPreset(13); });
  good &= Fails<Source>("Branching", [](Source* s) { s->SetBranching(3); });
  good &= Fails<Source>("Iterations", [](Source* s) { s->SetIterations(0); });
  good &= Fails<Source>("Iterations", [](Source* s) { s->SetIterations(40); });
  good &= Fails<Source>("LengthRatio1", [=](Source* s) { s->SetLengthRatio1(nan); });
  good &= Fails<Source>("Angle2", [](Source* s) { s->SetAngle2(180.0); });
  good &= Fails<Source>("Tropism", [=](Source* s) { s->SetTropism(0.0, nan, 0.0); });
  good &= Fails<Source>("TrunkLength", [](Source* s) { s->SetTrunkLength(0.0); });
  good &= Fails<Source>("Variation", [](Source* s) { s->SetVariation(0.6); });
  return RefusesBadLeaves<Source>() && good;
}

}

int TestAonoKuniiTreeSource(int argc, char* argv[])
{
  if (!Levels() || !Reproducible<Source>(Shrink) || !Pieces<Source>(Shrink) || !BadInput())
  {
    return EXIT_FAILURE;
  }
  PlantScene scene;
  double x = 0.0;
  for (const int preset : { Source::MonopodialA, Source::SympodialB, Source::TernaryA })
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->Update();
    scene.AddAsCarried(BlockAt(source->GetOutputDataObject(0), "High"), x);
    scene.AddAsCarried(BlockAt(source->GetOutputDataObject(0), "Medium"), x + 15.0);
    scene.AddAsCarried(PartOf(source, "Low"), x + 30.0);
    x += 47.0;
  }
  const double eye[3] = { 62.0, -180.0, 9.0 };
  const double focus[3] = { 62.0, 0.0, 6.5 };
  return scene.Compare(argc, argv, eye, focus, 19.5);
}
