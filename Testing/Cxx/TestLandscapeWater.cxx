// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Pixels of water by vtkLandscapePass against closed forms and against chance: what its surface reflects and lets
// through, from above and from below, and what is seen in it.
#include "LandscapePicture.h"

#include "vtkActorCollection.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <random>
#include <vector>

namespace
{

constexpr double Index = 1.333;

double Radians(double degrees)
{
  return vtkMath::RadiansFromDegrees(degrees);
}

/// Part of light that is reflected by its angles in air and in water  (Fresnel, by sines and tangents)
double ReflectedPart(double inAir)
{
  if (inAir < 1e-6)
  {
    return std::pow((Index - 1.0) / (Index + 1.0), 2.0);
  }
  const double inWater = std::asin(std::sin(inAir) / Index);
  const double across = std::sin(inAir - inWater) / std::sin(inAir + inWater);
  const double along = std::tan(inAir - inWater) / std::tan(inAir + inWater);
  return 0.5 * (across * across + along * along);
}

/// Black water under an even sky is as bright as the part of light that it reflects.
bool TestMirror()
{
  bool good = true;
  for (const double angle : { 0.0, 45.0, 60.0, 75.0, 85.0 })
  {
    Water picture({ 100.0, 100.0, 100.0 }, { 0.0, 0.0, 0.0 });
    picture.Pass->SetSkyToEven();
    const double a = Radians(angle);
    picture.Look(
      { 0.0, -10.0 * std::sin(a), 10.0 * std::cos(a) }, { 0.0, 0.0, 0.0 }, { 0.0, std::cos(a), std::sin(a) });
    picture.Draw();
    const double part = ReflectedPart(a);
    good &= Near(picture.LinearAt(Width / 2, Height / 2), { part, part, part }, 0.0, 0.01,
      "Water seen at " + std::to_string(angle) + " degrees");
  }
  return good;
}

/// From below clear water, the sky is in a window of 48.6 degrees, n2 times as bright; around it is the dark water.
bool TestWindow()
{
  bool good = true;
  for (const double angle : { 0.0, 30.0, 45.0, 55.0 })
  {
    Water picture({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 });
    picture.Pass->SetSkyToEven();
    picture.Pass->SetExposureCompensation(-2.0); // an eye in water sees half the light as white
    const double a = Radians(angle);
    picture.Look(
      { 0.0, -3.0 * std::sin(a), -3.0 * std::cos(a) }, { 0.0, 0.0, 0.0 }, { 0.0, -std::cos(a), std::sin(a) });
    picture.Draw();
    const double sine = Index * std::sin(a);
    const double seen = sine < 1.0 ? 0.5 * Index * Index * (1.0 - ReflectedPart(std::asin(sine))) : 0.0;
    good &= Near(picture.LinearAt(Width / 2, Height / 2), { seen, seen, seen }, 0.0, 0.01,
      "The sky seen at " + std::to_string(angle) + " degrees from below");
  }
  return good;
}

/// A grey bed below flat water, seen from its zenith: F L + (1 - F) / n2 albedo / pi E exp(-(K + c) h)
bool TestBed()
{
  bool good = true;
  for (const double depth : { 0.5, 4.0 })
  {
    const Color absorption{ 0.3, 0.1, 0.02 };
    Water picture(absorption, { 0.0, 0.0, 0.0 });
    picture.Pass->SetSkyToEven();
    picture.Add(Level(100.0, -depth), 0.5);
    picture.Look({ 0.0, 0.0, 5.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    picture.Draw();
    const double back = ReflectedPart(0.0);
    Color expected;
    for (int c = 0; c < 3; ++c)
    {
      expected[c] = back + (1.0 - back) / (Index * Index) * 0.5 * 0.934 * std::exp(-2.0 * absorption[c] * depth);
    }
    good &= Near(picture.LinearAt(Width / 2, Height / 2), expected, 0.0, 0.005,
      "A bed below " + std::to_string(depth) + " m of water");
  }
  return good;
}

/// A river below the level of a sea that is not there: as a bed of wet ground below 0.8 m of water. Ground of a coarser
/// mesh hides it by no more than 0.2 % of the distance.
bool TestRiver()
{
  bool good = true;
  for (const double rise : { -0.05, 0.01, 0.05 })
  {
    Picture picture;
    picture.Pass->SetSkyToEven();
    picture.Pass->SetOcclusionRadius(0.0);
    const Color absorption{ 0.3, 0.1, 0.02 };
    const Color none{ 0.0, 0.0, 0.0 };
    picture.Pass->SetWaterAbsorption(absorption.data());
    picture.Pass->SetWaterScattering(none.data());
    picture.Pass->SetWaterSlopeVariance(0.0);
    vtkLandscapePass::SetMaterial(picture.Add(Level(20.0, -50.0), 0.2), vtkLandscapePass::River);
    picture.Add(Level(100.0, rise - 50.0), 0.5);
    picture.Look({ 0.0, 0.0, -40.0 }, { 0.0, 0.0, -50.0 }, { 0.0, 1.0, 0.0 });
    picture.Draw();
    const double back = ReflectedPart(0.0);
    Color expected{ 0.5, 0.5, 0.5 };
    for (int c = 0; rise < 0.04 && c < 3; ++c)
    {
      const double way = 0.8 + std::max(-rise, 0.0);
      expected[c] = back + (1.0 - back) / (Index * Index) * 0.5 * 0.5 * 0.934 * std::exp(-absorption[c] * way);
    }
    good &= Near(picture.LinearAt(Width / 2, Height / 2), expected, 0.0, 0.005,
      "A river with ground " + std::to_string(rise) + " m above it");
  }
  return good;
}

/// Banks hide the sky that a narrow river mirrors, and none that a wide one or one without a width does; none from
/// above.
bool TestBanksAcross()
{
  Picture picture;
  picture.Pass->SetSkyToEven();
  picture.Pass->SetOcclusionRadius(0.0);
  const Color black{ 100.0, 100.0, 100.0 };
  picture.Pass->SetWaterAbsorption(black.data());
  picture.Pass->SetWaterSlopeVariance(0.0);
  picture.Pass->SetWaterLevel(-100.0);
  const auto river = Level(100.0, 0.0);
  vtkNew<vtkFloatArray> widths;
  widths->SetName("ChannelWidth");
  widths->SetNumberOfValues(river->GetNumberOfPoints());
  river->GetPointData()->AddArray(widths);
  vtkLandscapePass::SetMaterial(picture.Add(river, 0.2), vtkLandscapePass::River);
  const auto seen = [&](double width, double elevation) {
    widths->Fill(width);
    widths->Modified();
    const double a = Radians(elevation);
    picture.Look({ 0.0, -20.0 * std::cos(a), 20.0 * std::sin(a) }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    picture.Draw();
    return picture.LinearAt(Width / 2, Height / 2)[1];
  };
  // All of the even sky is 1: F(e); sedges and trees of 0.2 to 10 m send back less than 0.1 of the light
  const double flat = ReflectedPart(Radians(80.0));
  const double steep = ReflectedPart(Radians(20.0));
  return Check(std::abs(seen(0.0, 10.0) - flat) < 0.01, "A river without a width mirrors no even sky.") &
    Check(std::abs(seen(1000.0, 10.0) - flat) < 0.01, "The banks of a wide river hide the sky.") &
    Check(seen(0.5, 10.0) < 0.15 * flat, "The banks of a narrow river do not hide the sky.") &
    Check(std::abs(seen(10.0, 70.0) - steep) < 0.01, "Banks hide the sky above.");
}

/// A river has 0.3 of the slopes of a sea: its glitter is that of 0.09 of the variance.
bool TestRiverSlopes()
{
  Color glitter[3];
  for (const int k : { 0, 1, 2 })
  {
    Picture picture;
    const Color black{ 100.0, 100.0, 100.0 };
    picture.Pass->SetWaterAbsorption(black.data());
    picture.Pass->WaterRipplesOff();
    picture.Pass->SetWaterSlopeVariance(k == 1 ? 0.0036 : 0.04);
    picture.Pass->SetWaterLevel(k == 0 ? -100.0 : 0.0);
    picture.Pass->SetSunElevation(20.0);
    picture.Pass->SetSunAzimuth(0.0);
    picture.Pass->SetExposureCompensation(-5.0);
    vtkLandscapePass::SetMaterial(
      picture.Add(Level(100.0, 0.0), 0.2), k == 0 ? vtkLandscapePass::River : vtkLandscapePass::Water);
    picture.Look({ 0.0, -10.0, 3.64 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    picture.Draw();
    glitter[k] = picture.LinearAt(Width / 2, Height / 2);
  }
  return Near(glitter[0], glitter[1], 0.0, 0.01, "The glitter of a river") &
    Check(glitter[1][1] > 1.5 * glitter[2][1], "The glitter of calm water is no brighter than that of a sea.");
}

/**
 * A grey card in water: its light, that of the sun after refraction and of the sky, weakened downward and along the
 * line of sight, and the light that the water scatters into the line, summed in small steps.
 */
bool TestCard()
{
  bool good = true;
  const Color a{ 0.32, 0.08, 0.06 };
  const Color b{ 0.06, 0.07, 0.08 };
  for (const double depth : { 0.01, 5.0 })
  {
    for (const double distance : { 1.0, 5.0, 20.0 })
    {
      Water picture(a, b);
      picture.Pass->ShadowsOff();
      picture.Pass->SetSunElevation(40.0);
      picture.Pass->SetSunAzimuth(210.0);
      picture.Pass->SetExposureCompensation(0.5);
      const double side = 2.0 * distance;
      // Its near side looks south, at eye's height.
      picture.Add(
        Plane({ -side, distance, -depth - side }, { side, distance, -depth - side }, { -side, distance, side - depth }),
        0.5);
      picture.Look({ 0.0, 0.0, -depth }, { 0.0, 1.0, -depth }, { 0.0, 0.0, 1.0 });
      picture.Renderer->GetActiveCamera()->SetClippingRange(0.1, 3000.0);
      picture.Draw();
      const Color sun = picture.Sun();
      const double inAir = std::acos(sun[2]);
      const double inWater = std::asin(std::sin(inAir) / Index);
      const double south = std::sin(inWater) * -sun[1] / std::hypot(sun[0], sun[1]);
      const double g = 0.9;
      const double phase = (1.0 - g * g) / (4.0 * vtkMath::Pi() * std::pow(1.0 + g * g + 2.0 * g * south, 1.5));
      Color expected;
      for (int c = 0; c < 3; ++c)
      {
        const double below = picture.SunLight()[c] * (1.0 - ReflectedPart(inAir)) * sun[2] / std::cos(inWater);
        const double sky = 0.934 * picture.SkyLight()[c];
        const double left = std::exp(-(a[c] + 0.02 * b[c]) * depth);
        const double card = 0.5 / vtkMath::Pi() * (below * south + 0.5 * sky) * left;
        const double source = b[c] * (phase * below + 0.25 / vtkMath::Pi() * sky) * left;
        const int steps = 2000;
        double scattered = 0.0;
        for (int step = 0; step < steps; ++step)
        {
          scattered += source * std::exp(-(a[c] + b[c]) * distance * (step + 0.5) / steps) * distance / steps;
        }
        expected[c] =
          CodeOf(picture.Pass->GetExposureFactor() * (card * std::exp(-(a[c] + b[c]) * distance) + scattered));
      }
      good &= Near(picture.At(Width / 2, Height / 2 - 1), expected, 0.0, 1.01 / 255.0,
        "A card behind " + std::to_string(distance) + " m of water at " + std::to_string(depth) + " m");
    }
  }
  return good;
}

vtkSmartPointer<vtkFloatArray> ByX(const char* name, float left, float right)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  for (const float value : { left, right, left, right })
  {
    array->InsertNextValue(value);
  }
  return array;
}

/// Water has foam, of the albedo 0.6 on the mean, brighter in places, where its surface nearly folds, or did some time
/// before.
bool TestFoam(float jacobian, float left)
{
  Picture picture;
  picture.Pass->SetSkyToEven();
  picture.Pass->SetOcclusionRadius(0.0);
  const double black[3] = { 100.0, 100.0, 100.0 };
  picture.Pass->SetWaterAbsorption(black);
  vtkSmartPointer<vtkPolyData> surface = Level(10.0);
  surface->GetPointData()->AddArray(ByX("Jacobian", jacobian, 1.0F));
  if (left > 0.0F)
  {
    surface->GetPointData()->AddArray(ByX("Foam", left, 0.0F));
  }
  vtkLandscapePass::SetMaterial(picture.Add(surface, 0.2), vtkLandscapePass::Water);
  picture.Look({ 0.0, 0.0, 35.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  picture.Draw();
  double foam = 0.0;
  double most = 0.0;
  constexpr int side = 40; // of a square of 5 m, with bubbles of all sizes
  for (int pixel = 0; pixel < side * side; ++pixel)
  {
    const double one = picture.LinearAt(Width / 2 - 84 + pixel % side, Height / 2 - side / 2 + pixel / side)[1];
    foam += one / (side * side);
    most = std::max(most, one);
  }
  const double water = picture.LinearAt(Width / 2 + 70, Height / 2)[1];
  return Check(foam > 0.5 && foam < 0.62 && most > 0.66 && most < 0.9 && water < 0.05,
    "Foam is " + std::to_string(foam) + " up to " + std::to_string(most) + " and water " + std::to_string(water));
}

/// A level leaf in clear water, from below over from above: its transmittance, times its color over the largest one.
bool TestLeafInWater()
{
  std::array<Color, 2> seen;
  for (int isAbove = 0; isAbove < 2; ++isAbove)
  {
    Water picture({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 });
    picture.Pass->SetSunElevation(50.0);
    picture.Pass->ShadowsOff();
    vtkActor* leaf = picture.Add(Level(50.0, -2.0), 0.5);
    leaf->GetProperty()->SetColor(CodeOf(0.36), CodeOf(0.24), CodeOf(0.12));
    vtkLandscapePass::SetTransmittance(leaf, 0.5);
    const double eye = isAbove ? -1.0 : -3.0;
    picture.Look({ 0.0, 0.0, eye }, { 0.0, 0.0, -2.0 }, { 0.0, 1.0, 0.0 });
    picture.Draw();
    seen[isAbove] = picture.LinearAt(Width / 2, Height / 2);
  }
  const Color part{ 0.5, 0.5 * 0.24 / 0.36, 0.5 * 0.12 / 0.36 };
  return Near(seen[0], { part[0] * seen[1][0], part[1] * seen[1][1], part[2] * seen[1][2] }, 0.02, 0.004,
    "A leaf against the light");
}

/// Strings of foam cover the part of the water that its stretch tells, 0.5 halfway between none and all.
bool TestLace()
{
  bool good = true;
  for (const double t : { 0.3, 0.5, 0.7 })
  {
    Water picture({ 100.0, 100.0, 100.0 }, { 0.0, 0.0, 0.0 });
    picture.Pass->SetSkyToEven();
    picture.Pass->SetFoamThreshold(0.6);
    auto* water = vtkActor::SafeDownCast(picture.Renderer->GetActors()->GetLastActor());
    const auto stretch = static_cast<float>(0.35 + 0.25 * t);
    vtkPolyData::SafeDownCast(water->GetMapper()->GetInput())
      ->GetPointData()
      ->AddArray(ByX("Jacobian", stretch, stretch));
    picture.Look({ 0.0, 0.0, 15.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    picture.Draw();
    double mean = 0.0;
    for (int pixel = 0; pixel < Width * Height; ++pixel)
    {
      mean += picture.LinearAt(pixel % Width, pixel / Width)[1] / (Width * Height);
    }
    const double part = 1.0 - t * t * (3.0 - 2.0 * t);
    good &= Near({ mean, mean, mean }, { 0.02 + 0.58 * part, 0.02 + 0.58 * part, 0.02 + 0.58 * part }, 0.0, 0.03,
      "Water of a stretch of " + std::to_string(stretch));
  }
  return good;
}

/// Strings of foam go with the water that they are on: the picture of it from as far away is the same.
bool TestCarriedFoam()
{
  const Color way{ 4.75, -2.5, 0.0 };
  std::array<std::vector<double>, 3> pixels;
  for (int k = 0; k < 3; ++k) // at rest, carried, and that without telling
  {
    Water picture({ 100.0, 100.0, 100.0 }, { 0.0, 0.0, 0.0 });
    picture.Pass->SetSkyToEven();
    picture.Pass->SetFoamThreshold(0.6);
    auto* water = vtkActor::SafeDownCast(picture.Renderer->GetActors()->GetLastActor());
    vtkPointData* arrays = vtkPolyData::SafeDownCast(water->GetMapper()->GetInput())->GetPointData();
    arrays->AddArray(ByX("Jacobian", 0.45F, 0.45F));
    vtkNew<vtkFloatArray> ways;
    ways->SetName("Displacement");
    ways->SetNumberOfComponents(2);
    ways->SetNumberOfTuples(4);
    ways->FillComponent(0, k == 1 ? way[0] : 0.0);
    ways->FillComponent(1, k == 1 ? way[1] : 0.0);
    arrays->AddArray(ways);
    const Color at = k == 0 ? Color{ 0.0, 0.0, 0.0 } : way;
    picture.Look({ at[0], at[1], 15.0 }, at, { 0.0, 1.0, 0.0 });
    picture.Draw();
    for (int pixel = 0; pixel < Width * Height; ++pixel)
    {
      pixels[k].push_back(picture.LinearAt(pixel % Width, pixel / Width)[1]);
    }
  }
  std::array<double, 2> apart{};
  for (int pixel = 0; pixel < Width * Height; ++pixel)
  {
    apart[0] += std::abs(pixels[1][pixel] - pixels[0][pixel]) / (Width * Height);
    apart[1] += std::abs(pixels[2][pixel] - pixels[0][pixel]) / (Width * Height);
  }
  return Check(apart[0] < 0.01 && apart[1] > 0.1,
    "Carried foam is " + std::to_string(apart[0]) + " apart, other foam " + std::to_string(apart[1]));
}

/// The sun's glitter against facets of random slopes, which send its light into a cone around the line of sight.
bool TestGlitter()
{
  constexpr double variance = 0.04;
  constexpr double elevation = 40.0;
  std::mt19937 random(5);
  std::normal_distribution<double> slope(0.0, std::sqrt(0.5 * variance));
  const double s = Radians(elevation);
  const std::array<double, 2> views = { 40.0, 55.0 }; // elevations of the eye, opposite to the sun
  std::array<double, 2> light{};
  constexpr double cone = 0.04;
  constexpr int count = 1000000;
  for (int k = 0; k < count; ++k)
  {
    Color facet{ slope(random), slope(random), 1.0 };
    vtkMath::Normalize(facet.data());
    const Color sun{ 0.0, std::cos(s), std::sin(s) };
    const double cosine = vtkMath::Dot(facet.data(), sun.data());
    if (cosine <= 0.0)
    {
      continue;
    }
    for (std::size_t view = 0; view < views.size(); ++view)
    {
      const double v = Radians(views[view]);
      const Color eye{ 0.0, -std::cos(v), std::sin(v) };
      Color out;
      for (int c = 0; c < 3; ++c)
      {
        out[c] = 2.0 * cosine * facet[c] - sun[c];
      }
      if (vtkMath::Dot(out.data(), eye.data()) > std::cos(cone))
      {
        light[view] += ReflectedPart(std::acos(cosine)) * cosine / facet[2] / count;
      }
    }
  }
  bool good = true;
  for (std::size_t view = 0; view < views.size(); ++view)
  {
    const double v = Radians(views[view]);
    const double solid = 2.0 * vtkMath::Pi() * (1.0 - std::cos(cone));
    std::array<Color, 2> pixels;
    Color sunLight;
    double exposure = 0.0;
    for (int hasSun = 0; hasSun < 2; ++hasSun)
    {
      Water picture({ 100.0, 100.0, 100.0 }, { 0.0, 0.0, 0.0 });
      picture.Pass->SetSunElevation(elevation);
      picture.Pass->SetSunAzimuth(0.0);
      picture.Pass->SetWaterSlopeVariance(variance);
      picture.Pass->WaterRipplesOff();
      picture.Pass->SetExposureCompensation(-1.0);
      if (!hasSun) // a roof, which is not seen, shades the water
      {
        picture.Add(Plane({ -5.0, 30.0, 20.0 }, { 5.0, 30.0, 20.0 }, { -5.0, 20.0, 30.0 }), 0.0);
      }
      picture.Look({ 0.0, -10.0 * std::cos(v), 10.0 * std::sin(v) }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
      picture.Draw();
      pixels[hasSun] = picture.LinearAt(Width / 2, Height / 2);
      sunLight = picture.SunLight();
      exposure = picture.Pass->GetExposureFactor();
    }
    Color found;
    Color expected;
    for (int c = 0; c < 3; ++c)
    {
      found[c] = pixels[1][c] - pixels[0][c];
      expected[c] = exposure * light[view] * sunLight[c] / (std::sin(v) * solid);
    }
    good &= Near(found, expected, 0.05, 0.01, "Glitter seen at " + std::to_string(views[view]) + " degrees");
  }
  return good;
}

}

//----------------------------------------------------------------------------
int TestLandscapeWater(int, char*[])
{
  bool good = TestMirror();
  good &= TestWindow();
  good &= TestBed();
  good &= TestRiver();
  good &= TestRiverSlopes();
  good &= TestBanksAcross();
  good &= TestCard();
  good &= TestFoam(0.01F, 0.0F);
  good &= TestFoam(1.0F, 0.99F);
  good &= TestLeafInWater();
  good &= TestLace();
  good &= TestCarriedFoam();
  good &= TestGlitter();
  return good ? 0 : 1;
}
