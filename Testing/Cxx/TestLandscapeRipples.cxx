// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Pixels of water by vtkLandscapePass whose waves are shorter than its mesh: its mean is that of their statistics.
#include "LandscapePicture.h"

#include "vtkActorCollection.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"

#include <vector>

namespace
{

/// Green of the middle of a picture.
std::vector<double> MiddleOf(const Picture& picture)
{
  std::vector<double> greens;
  for (int y = Height / 4; y < 3 * Height / 4; ++y)
  {
    for (int x = Width / 4; x < 3 * Width / 4; ++x)
    {
      greens.push_back(picture.LinearAt(x, y)[1]);
    }
  }
  return greens;
}

/// Mean and deviation of the middle of a picture.
std::array<double, 2> MeanOf(const Picture& picture)
{
  double sum = 0.0;
  double squares = 0.0;
  const std::vector<double> greens = MiddleOf(picture);
  for (const double green : greens)
  {
    sum += green;
    squares += green * green;
  }
  const double mean = sum / static_cast<double>(greens.size());
  return { mean, std::sqrt(std::max(0.0, squares / static_cast<double>(greens.size()) - mean * mean)) };
}

/**
 * Waves that pixels show: water is as bright on the mean as by the statistics of its slopes, near, where they differ
 * from pixel to pixel and with time, and far, where they do not; far from the origin.
 */
bool TestRipples()
{
  bool good = true;
  constexpr double east = 4096000.0;
  for (const double distance : { 6.0, 1500.0 })
  {
    std::array<std::array<double, 2>, 2> means;
    bool changed = false;
    for (int hasRipples = 0; hasRipples < 2; ++hasRipples)
    {
      Water picture({ 100.0, 100.0, 100.0 }, { 0.0, 0.0, 0.0 });
      picture.Pass->SetSkyToEven();
      picture.Pass->ShadowsOff();
      picture.Pass->SetWaterSlopeVariance(0.03);
      picture.Pass->SetWaterRipples(hasRipples != 0);
      picture.Renderer->GetActors()->GetLastActor()->SetPosition(east, 0.0, 0.0);
      const double a = vtkMath::RadiansFromDegrees(65.0);
      picture.Look({ east, -distance * std::sin(a), distance * std::cos(a) }, { east, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
      picture.Draw();
      means[hasRipples] = MeanOf(picture);
      if (hasRipples && distance < 100.0)
      {
        const vtkIdType bytes = picture.Pixels->GetNumberOfValues();
        const std::vector<unsigned char> before(picture.Pixels->GetPointer(0), picture.Pixels->GetPointer(bytes));
        picture.Pass->SetWaterTime(0.1);
        picture.Draw();
        changed = !std::equal(before.begin(), before.end(), picture.Pixels->GetPointer(0));
        // In single precision, places here are 0.4 m apart, 13 pixels.
        const std::vector<double> greens = MiddleOf(picture);
        int same = 0;
        for (std::size_t n = 1; n < greens.size(); ++n)
        {
          same += greens[n] == greens[n - 1] ? 1 : 0;
        }
        good &= Check(2 * same < static_cast<int>(greens.size()), "Ripples in blocks: " + std::to_string(same));
      }
    }
    const std::string where = " of ripples at " + std::to_string(distance) + " m: ";
    good &= Check(std::abs(means[1][0] / means[0][0] - 1.0) < 0.06,
      "Mean" + where + std::to_string(means[1][0]) + " for " + std::to_string(means[0][0]));
    // Without ripples the angle changes it.
    const double more = (means[1][1] - means[0][1]) / means[1][0];
    good &= Check(distance > 100.0 ? std::abs(more) < 0.01 : more > 0.03 && changed,
      "Deviation" + where + "more by " + std::to_string(more));
  }
  return good;
}

/**
 * Light on a bed below waves, and light that deep water scatters into a line of sight: as much as in level water, but
 * in patterns.
 */
bool TestGatheredLight()
{
  bool good = true;
  for (const double bed : { 3.0, 300.0 })
  {
    std::array<std::vector<double>, 2> greens;
    for (int hasRipples = 0; hasRipples < 2; ++hasRipples)
    {
      Water picture({ 0.1, 0.05, 0.02 }, { 0.06, 0.06, 0.06 });
      picture.Pass->SetSunElevation(60.0);
      picture.Pass->SetSunAzimuth(0.0);
      picture.Pass->SetWaterSlopeVariance(0.02);
      picture.Pass->SetWaterRipples(hasRipples != 0);
      picture.Pass->ShadowsOff();
      picture.Add(Level(1000.0, -bed), 0.5);
      // Deep water is looked up through, shallow water down on its bed.
      picture.Look({ 0.0, 0.0, -2.5 }, { 0.0, 1.0, bed > 100.0 ? -2.4 : -3.5 }, { 0.0, 0.0, 1.0 });
      picture.Renderer->GetActiveCamera()->SetClippingRange(0.1, 3000.0);
      picture.Draw();
      greens[hasRipples] = MiddleOf(picture);
    }
    double mean = 0.0;
    double change = 0.0;
    double changes = 0.0;
    const auto count = static_cast<double>(greens[0].size());
    for (std::size_t n = 0; n < greens[0].size(); ++n)
    {
      const double difference = greens[1][n] - greens[0][n];
      mean += greens[0][n] / count;
      change += difference / count;
      changes += difference * difference / count;
    }
    good &= Check(std::abs(change) < 0.05 * mean && std::sqrt(changes) > 0.015 * mean,
      "Light at " + std::to_string(bed) + " m: " + std::to_string(mean) + " and " + std::to_string(change) + ", by " +
        std::to_string(std::sqrt(changes)));
  }
  return good;
}

/// Deep water along a level line of sight from 2.5 m below its surface, towards the sun or from it, below a raft or
/// not.
struct Along : Water
{
  Along(double north, bool isBelowRaft)
    : Water({ 0.4, 0.3, 0.3 }, { 0.2, 0.2, 0.2 })
  {
    this->Pass->SetSunElevation(40.0);
    this->Pass->SetSunAzimuth(0.0);
    this->Pass->SetWaterSlopeVariance(0.01);
    this->Pass->SetWaterRipples(isBelowRaft);
    this->Pass->SetShadowDistance(60.0);
    this->Pass->SetExposureCompensation(2.0);
    if (isBelowRaft)
    {
      this->Add(Level(60.0, -1.0), 0.5);
    }
    this->Look({ 0.0, 0.0, -2.5 }, { 0.0, north, -2.5 }, { 0.0, 0.0, 1.0 });
    this->Renderer->GetActiveCamera()->SetClippingRange(0.1, 3000.0);
  }

  /// Green at a column.
  double Green(int x = Width / 2) const
  {
    return 0.5 * (this->LinearAt(x, Height / 2)[1] + this->LinearAt(x, Height / 2 - 1)[1]);
  }
};

double GreenAlong(double north, bool isBelowRaft)
{
  Along picture(north, isBelowRaft);
  picture.Draw();
  return picture.Green();
}

/// Water in the shadow of a raft scatters no light of the sun: what is left is the same in both directions, and in
/// sunlight it is what Henyey and Greenstein's law for two angles leaves of two luminances.
bool TestShadowInWater()
{
  const double along = std::cos(vtkMath::RadiansFromDegrees(40.0)) / 1.333;
  const auto phase = [](double cosine) { return std::pow(1.81 - 1.8 * cosine, -1.5); }; // g = 0.9
  const double ahead = GreenAlong(1.0, false);
  const double back = GreenAlong(-1.0, false);
  const double sky = ahead - (ahead - back) * phase(along) / (phase(along) - phase(-along));
  bool good = Check(ahead < 1.0 && sky < 0.8 * ahead, "The sun gives too little: " + std::to_string(sky));
  for (const double north : { 1.0, -1.0 })
  {
    const double found = GreenAlong(north, true);
    good &= Check(std::abs(found - sky) < 0.03 * ahead,
      "Water in a shadow is " + std::to_string(found) + " for " + std::to_string(sky));
  }
  return good;
}

/// Water in a shadow is as bright before the rim of a board as before its middle, and beside the rim as away from it.
bool TestRimInWater()
{
  Along picture(1.0, true);
  picture.Add(Plane({ 0.001, 1.0, -5.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 5.0 }), 0.0);
  picture.Draw();
  const double rim = picture.Green(Width / 2);
  const double beside = picture.Green(Width / 2 - 1);
  return Check(rim < 0.5 * beside, "The board is not seen.") &&
    Check(std::abs(rim - picture.Green(Width / 2 + 5)) < 0.02 * beside &&
        std::abs(beside - picture.Green(Width / 2 - 6)) < 0.02 * beside,
      "At the rim: " + std::to_string(rim) + " and " + std::to_string(beside));
}

/// A sprite in air is as bright as a sphere, white for a white furnace; in water, as a wall of its albedo at its
/// distance.
bool TestSprite()
{
  bool good = true;
  constexpr double albedo = 0.5;
  constexpr double distance = 5.0;
  const Color absorption{ 0.2, 0.1, 0.05 };
  for (const bool isInWater : { false, true })
  {
    Picture picture;
    picture.Pass->SetSkyToEven();
    picture.Pass->ShadowsOff();
    picture.Pass->SetOcclusionRadius(0.0);
    picture.Pass->SetCloudCover(0.0);
    picture.Pass->SetWaterAbsorption(absorption.data());
    const Color none{ 0.0, 0.0, 0.0 };
    picture.Pass->SetWaterScattering(none.data());
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, distance, -0.01);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetScaleFactor(0.5);
    mapper->EmissiveOff();
    // As ParaView paints spheres
    mapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                               "float dist = sqrt(dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy));\n"
                               "if (dist > 1.0) { discard; } else {\n"
                               "  float scale = (1.0 - dist);\n"
                               "  ambientColor *= scale;\n"
                               "  diffuseColor *= scale;\n"
                               "}\n");
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(CodeOf(albedo), CodeOf(albedo), CodeOf(albedo));
    picture.Renderer->AddActor(actor);
    if (isInWater)
    {
      vtkLandscapePass::SetMaterial(picture.Add(Level(100.0), 0.2), vtkLandscapePass::Water);
    }
    picture.Look({ 0.0, 0.0, -0.01 }, { 0.0, 1.0, -0.01 }, { 0.0, 0.0, 1.0 });
    picture.Renderer->GetActiveCamera()->SetClippingRange(0.1, 200.0);
    picture.Draw();
    for (const int off : { 0, 10 })
    {
      Color expected;
      for (int c = 0; c < 3; ++c)
      {
        // Half of the light below the surface, 0.934 of that above it, on what is upright; the eye sees half of it as
        // white
        const double inWater = 0.934 * std::exp(-absorption[c] * (distance + 0.01 + 0.01));
        expected[c] = albedo * (isInWater ? inWater : 1.0);
      }
      Color found = picture.LinearAt(Width / 2 + off, Height / 2);
      const Color below = picture.LinearAt(Width / 2 + off, Height / 2 - 1);
      std::transform(found.begin(), found.end(), below.begin(), found.begin(),
        [](double one, double other) { return 0.5 * (one + other); });
      good &= Near(found, expected, 0.01, 0.005, std::string("A sprite in ") + (isInWater ? "water" : "air"));
    }
  }
  return good;
}

}

//----------------------------------------------------------------------------
int TestLandscapeRipples(int, char*[])
{
  bool good = TestRipples();
  good &= TestGatheredLight();
  good &= TestShadowInWater();
  good &= TestRimInWater();
  good &= TestSprite();
  return good ? 0 : 1;
}
