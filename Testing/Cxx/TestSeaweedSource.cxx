// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Three kinds of seaweeds at their levels of detail: arrays, same bytes, pieces, bad input, a bed of them, a picture.
#include "Data/PlantBlocks.h"
#include "Data/SeaweedBlocks.h"
#include "Numerics/InvalidInput.h"
#include "PlantChecks.h"
#include "PlantScene.h"
#include "vtkPlantScatterFilter.h"
#include "vtkSeaweedSource.h"

#include "vtkActorCollection.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace
{

using Source = vtkSeaweedSource;

const char* const Segments[] = { "ParentId", "Radius", "Width", "Thickness", "Length", "YoungModulus", "DampingRatio",
  "Density", "Across", "Tissue", "Attachment", "RestTheta", "RestPhi" };

/// Segments are read back as they were written.
bool ReadsBack(Source* source)
{
  vtkPolyData* skeleton = PartOf(source, "High/Skeleton");
  const std::vector<littoral::SeaweedSegment> segments = littoral::ReadSegments(skeleton);
  bool good = Check(segments.size() == static_cast<std::size_t>(skeleton->GetNumberOfPoints()), "segments are missing");
  vtkDataArray* radius = skeleton->GetPointData()->GetArray("Radius");
  for (vtkIdType node = 0; good && node < skeleton->GetNumberOfPoints(); ++node)
  {
    const double expected = littoral::EquivalentRadius(segments[static_cast<std::size_t>(node)]);
    good = Check(std::abs(radius->GetTuple1(node) - expected) < 1e-6 * expected, "Radius is not that of the section");
  }
  const auto namesDensity = [](vtkPolyData* block) {
    return littoral::WhyRefused([block] { littoral::ReadSegments(block); }).find("Density") != std::string::npos;
  };
  vtkNew<vtkPolyData> poor;
  poor->ShallowCopy(skeleton);
  poor->GetPointData()->RemoveArray("Density");
  good = good && Check(namesDensity(poor), "a missing array is not named");
  vtkNew<vtkPolyData> weightless;
  weightless->DeepCopy(skeleton);
  weightless->GetPointData()->GetArray("Density")->SetTuple1(3, 0.0);
  return good && Check(namesDensity(weightless), "no mass is not noticed");
}

bool Levels()
{
  bool good = true;
  for (int preset = Source::Custom; preset <= Source::Eelgrass; ++preset)
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->Update();
    for (const char* name : Segments)
    {
      good &= HasArrays(source, "High/Skeleton", { name });
    }
    good = good && HasLevels(source) && CarriesTexture(source, "Medium/Crown", false);
    vtkPolyData* skeleton = PartOf(source, "High/Skeleton");
    good &= Check(skeleton->GetCellData()->GetArray("BranchId") && skeleton->GetCellData()->GetArray("Order") &&
        skeleton->GetNumberOfLines() == skeleton->GetNumberOfCells(),
      "the skeleton has no branches");
    good &= Check(PictureFits(source, 1, "Medium/Crown") && PictureFits(source, 2, "High/Leaves"),
      "a picture and the field data of its block differ");
    good = good && ReadsBack(source);
  }
  return good;
}

/// The resolution is free in any preset; it changes the chain and not the plant.
bool Resolution()
{
  vtkNew<Source> source;
  bool good = true;
  double heights[2];
  for (int i = 0; i < 2; ++i)
  {
    source->SetSegmentsPerBranch(i == 0 ? 8 : 32);
    source->Update();
    const vtkIdType nodes = PartOf(source, "High/Skeleton")->GetNumberOfPoints();
    const vtkIdType fronds = PartOf(source, "High/Skeleton")->GetNumberOfLines() - 1;
    good &= Check(nodes == 2 + fronds * (source->GetSegmentsPerBranch() + 1), "another number of segments");
    heights[i] = PartOf(source, "High/Leaves")->GetBounds()[5];
  }
  return good & Check(std::abs(heights[1] - heights[0]) < 0.05 * heights[0], "the plant depends on its segments");
}

bool BadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= Fails<Source>("Preset", [](Source* s) { s->SetPreset(4); });
  good &= Fails<Source>("Form", [](Source* s) { s->SetForm(-1); });
  good &= Fails<Source>("NumberOfFronds", [](Source* s) { s->SetNumberOfFronds(0); });
  good &= Fails<Source>("HoldfastRadius", [](Source* s) { s->SetHoldfastRadius(0.0); });
  good &= Fails<Source>("SpreadAngle", [](Source* s) { s->SetSpreadAngle(90.0); });
  good &= Fails<Source>("StipeLength", [=](Source* s) { s->SetStipeLength(nan); });
  good &= Fails<Source>("StipeRadius", [](Source* s) { s->SetStipeRadius(-1.0); });
  good &= Fails<Source>("BladeLength", [](Source* s) { s->SetBladeLength(0.0); });
  good &= Fails<Source>("BladeWidth", [](Source* s) { s->SetBladeWidth(0.0); });
  good &= Fails<Source>("BladeThickness", [](Source* s) { s->SetBladeThickness(0.0); });
  good &= Fails<Source>("BladeSpacing", [](Source* s) { s->SetBladeSpacing(0.0); });
  good &= Fails<Source>("FloatRadius", [](Source* s) { s->SetFloatRadius(-0.1); });
  good &= Fails<Source>("Ruffle", [](Source* s) { s->SetRuffle(1.5); });
  good &= Fails<Source>("SegmentsPerBranch", [](Source* s) { s->SetSegmentsPerBranch(1); });
  good &= Fails<Source>("StipeModulus", [](Source* s) { s->SetStipeModulus(-1e7); });
  good &= Fails<Source>("BladeModulus", [=](Source* s) { s->SetBladeModulus(nan); });
  good &= Fails<Source>("DampingRatio", [](Source* s) { s->SetDampingRatio(-0.1); });
  good &= Fails<Source>("StipeDensity", [](Source* s) { s->SetStipeDensity(0.0); });
  good &= Fails<Source>("BladeDensity", [](Source* s) { s->SetBladeDensity(0.0); });
  good &= Fails<Source>("FloatDensity", [](Source* s) { s->SetFloatDensity(0.0); });
  good &= Fails<Source>("Variation", [](Source* s) { s->SetVariation(0.6); });
  good &= Fails<Source>("BladeColor", [](Source* s) { s->SetBladeColor(2.0, 0.0, 0.0); });
  good &= Fails<Source>("TextureSize", [](Source* s) { s->SetTextureSize(0, 64); });
  return good;
}

/// A bed of two kinds: lengths scale with the plant, material does not, the width turns with it.
bool Bed()
{
  vtkNew<vtkPolyData> sites;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> scales;
  scales->SetName("Scale");
  vtkNew<vtkDoubleArray> turns;
  turns->SetName("Azimuth");
  vtkNew<vtkDoubleArray> kinds;
  kinds->SetName("Species");
  for (int site = 0; site < 6; ++site)
  {
    points->InsertNextPoint(3.0 * site, 0.5 * site, -8.0);
    scales->InsertNextValue(site < 3 ? 1.0 : 1.5);
    turns->InsertNextValue(0.5 * 3.14159265358979 * (site % 2));
    kinds->InsertNextValue(site == 5 ? 1.0 : 0.0);
  }
  sites->SetPoints(points);
  for (vtkDoubleArray* array : { scales.Get(), turns.Get(), kinds.Get() })
  {
    sites->GetPointData()->AddArray(array);
  }
  vtkNew<Source> kelp;
  vtkNew<Source> grass;
  grass->SetPreset(Source::Eelgrass);
  vtkNew<vtkPlantScatterFilter> bed;
  bed->SetInputData(0, sites);
  bed->AddPrototypeConnection(kelp->GetOutputPort());
  bed->AddPrototypeConnection(grass->GetOutputPort());
  bed->SetUseLevels(false);
  bed->SetUseCulling(false);
  bed->Update();
  kelp->Update();
  vtkPolyData* own = PartOf(kelp, "High/Skeleton");
  vtkPolyData* all = PartOf(bed, "High/Skeleton");
  bool good = Check(all != nullptr, "no bed");
  for (const char* name : Segments)
  {
    good = good && HasArrays(bed, "High/Skeleton", { name });
  }
  good = good && Joints(bed, "High/Skin") && Joints(bed, "High/Leaves");
  if (!good)
  {
    return false;
  }
  const vtkIdType nodes = own->GetNumberOfPoints();
  const auto at = [](vtkPolyData* data, const char* name, vtkIdType node, int component = 0) {
    return data->GetPointData()->GetArray(name)->GetComponent(node, component);
  };
  for (vtkIdType node = 0; node < nodes; ++node)
  {
    const vtkIdType larger = 3 * nodes + node; // site 3: scale 1.5 and a quarter turn
    for (const char* name : { "Radius", "Width", "Thickness", "Length", "Attachment" })
    {
      const double wanted = 1.5 * at(own, name, node);
      good &= Check(std::abs(at(all, name, larger) - wanted) <= 1e-5 * std::abs(wanted) + 1e-9, name);
    }
    for (const char* name : { "YoungModulus", "DampingRatio", "Density", "Tissue", "RestTheta", "RestPhi" })
    {
      good &= Check(at(all, name, larger) == at(own, name, node), name);
    }
    good &= Check(std::abs(at(all, "Across", larger, 0) + at(own, "Across", node, 1)) < 1e-5 &&
        std::abs(at(all, "Across", larger, 1) - at(own, "Across", node, 0)) < 1e-5,
      "the width does not turn with the plant");
    const auto parent = static_cast<vtkIdType>(at(own, "ParentId", node));
    const vtkIdType wanted = parent < 0 ? -1 : parent + 3 * nodes;
    good &= Check(static_cast<vtkIdType>(at(all, "ParentId", larger)) == wanted, "ParentId");
  }
  bed->SetUseLevels(true);
  bed->SetNearDistance(0.001);
  bed->SetFarDistance(0.002);
  bed->Update();
  vtkPolyData* low = PartOf(bed, "Low");
  return good & Check(low && low->GetNumberOfPolys() == 24, "six plants far away are not 24 polygons");
}

}

int TestSeaweedSource(int argc, char* argv[])
{
  if (!Levels() || !Reproducible<Source>() || !Resolution() || !Pieces<Source>() || !BadInput() || !Bed())
  {
    return EXIT_FAILURE;
  }
  // A column a level, a row a kind; all are drawn about as high.
  const struct
  {
    int Preset;
    double Height;
  } kinds[] = { { Source::SugarKelp, 2.0 }, { Source::GiantKelp, 15.0 }, { Source::Eelgrass, 0.75 } };
  PlantScene scene;
  scene.Window->SetSize(300, 300);
  scene.Renderer->SetBackground(0.35, 0.6, 0.65);
  double bottom = 2.0;
  for (const auto& kind : kinds)
  {
    vtkNew<Source> source;
    source->SetPreset(kind.Preset);
    source->Update();
    double left = -1.0;
    for (const char* level : { "High", "Medium", "Low" })
    {
      const int before = scene.Renderer->GetActors()->GetNumberOfItems();
      scene.Add(BlockAt(source->GetOutputDataObject(0), level), left);
      for (int i = before; i < scene.Renderer->GetActors()->GetNumberOfItems(); ++i)
      {
        auto* actor = vtkActor::SafeDownCast(scene.Renderer->GetActors()->GetItemAsObject(i));
        actor->SetPosition(left, 0.0, bottom);
        actor->SetScale(0.9 / kind.Height);
      }
      left += 1.0;
    }
    bottom -= 1.0;
  }
  const double eye[3] = { 0.0, -40.0, 2.4 };
  const double focus[3] = { 0.0, 0.0, 1.5 };
  return scene.Compare(argc, argv, eye, focus, 4.6);
}
