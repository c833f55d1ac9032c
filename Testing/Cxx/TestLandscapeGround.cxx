// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Ground by vtkLandscapePass: its color and grass; and bark.
#include "LandscapePicture.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

/// Grass stands on a sloping ground and is not higher than it should be; there is none on other surfaces. Its ground
/// has the data's color on average.
bool TestGrass()
{
  constexpr double slope = 0.2;
  constexpr double high = 0.5;
  int above[2] = { 0, 0 };
  double mean[2] = { 0.0, 0.0 };
  bool good = true;
  for (const bool isGround : { false, true })
  {
    Picture picture;
    picture.Pass->SetSkyToEven();
    picture.Pass->SetCoverHeight(high);
    picture.Pass->SetCoverRadius(20.0);
    picture.Pass->SetOcclusionRadius(0.0);
    const double x = 1000.0;
    vtkActor* ground = picture.Add(
      Plane({ x - 30.0, -30.0, -30.0 * slope }, { x + 30.0, -30.0, 30.0 * slope }, { x - 30.0, 30.0, -30.0 * slope }),
      0.3);
    vtkLandscapePass::SetMaterial(ground, isGround ? vtkLandscapePass::Ground : vtkLandscapePass::Surface);
    picture.Look({ x, -10.0, 0.0 }, { x, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    vtkCamera* camera = picture.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(4.0);
    picture.Renderer->ResetCameraClippingRange();
    picture.Draw();
    const double metres = 8.0 / Height;
    for (int column = 20; column < Width - 20; ++column)
    {
      for (int row = 0; row < Height; ++row)
      {
        const double over = (row + 0.5 - 0.5 * Height) * metres - slope * (column + 0.5 - 0.5 * Width) * metres;
        const bool isSky = picture.LinearAt(column, row)[2] > 0.9;
        above[isGround] += over > 0.1 && !isSky;
        good &= over < 1.1 * high || isSky;
      }
    }
    // From above, without grass
    picture.Pass->SetCoverRadius(0.0);
    camera->SetPosition(x, 0.0, 100.0);
    camera->SetFocalPoint(x, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetParallelScale(14.0);
    picture.Renderer->ResetCameraClippingRange();
    picture.Draw();
    for (int pixel = 0; pixel < Width * Height; ++pixel)
    {
      mean[isGround] += picture.LinearAt(pixel % Width, pixel / Width)[1] / (Width * Height);
    }
  }
  good = Check(good, "Grass is higher than it should be.");
  good &= Check(above[0] == 0 && above[1] > 500, "Pixels of grass: " + std::to_string(above[1]));
  return good &&
    Check(std::abs(mean[1] / mean[0] - 1.0) < 0.05,
      "Ground is " + std::to_string(mean[1]) + " on average for " + std::to_string(mean[0]));
}

/// Beyond its blades grass stands up too: at a flat angle its pattern is less flat than that of a ground without grass,
/// and as bright on average.
bool TestTurf()
{
  double mean[2] = { 0.0, 0.0 };
  double ratio[2] = { 0.0, 0.0 };
  for (const bool hasGrass : { false, true })
  {
    Picture picture;
    picture.Pass->SetSkyToEven();
    picture.Pass->SetOcclusionRadius(0.0);
    picture.Pass->SetContactRadius(0.0);
    picture.Pass->SetCoverRadius(5.0);
    picture.Pass->SetCoverHeight(hasGrass ? 0.4 : 0.0);
    vtkLandscapePass::SetMaterial(picture.Add(Level(300.0), 0.3), vtkLandscapePass::Ground);
    picture.Look({ 0.0, 0.0, 4.0 }, { 0.0, 30.0, 0.0 }, { 0.0, 0.0, 1.0 });
    picture.Renderer->GetActiveCamera()->SetViewAngle(4.0);
    picture.Renderer->ResetCameraClippingRange();
    picture.Draw();
    double across = 0.0;
    double up = 0.0;
    for (int pixel = 0; pixel < (Width - 1) * (Height - 1); ++pixel)
    {
      const int column = pixel % (Width - 1);
      const int row = pixel / (Width - 1);
      const double here = picture.LinearAt(column, row)[1];
      mean[hasGrass] += here / ((Width - 1) * (Height - 1));
      across += std::pow(picture.LinearAt(column + 1, row)[1] - here, 2);
      up += std::pow(picture.LinearAt(column, row + 1)[1] - here, 2);
    }
    ratio[hasGrass] = std::sqrt(across / up);
  }
  std::cout << "Turf: changes across over those upward " << ratio[0] << ", with grass " << ratio[1] << ", as bright "
            << mean[1] / mean[0] << "\n";
  return Check(std::abs(mean[1] / mean[0] - 1.0) < 0.05, "Grass beyond its blades changes the mean of the ground.") &&
    Check(ratio[1] > 1.4 * ratio[0], "Grass beyond its blades does not stand.");
}

/// Grass on a beach, seen from above through clear water: none is in the sea.
bool TestGrassAtSea()
{
  Water picture({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 });
  vtkActor* ground = picture.Add(Plane({ -30.0, -30.0, -6.0 }, { 30.0, -30.0, 6.0 }, { -30.0, 30.0, -6.0 }), 0.3);
  vtkLandscapePass::SetMaterial(ground, vtkLandscapePass::Ground);
  picture.Pass->SetSkyToEven();
  picture.Pass->SetCoverHeight(0.3);
  picture.Look({ 0.0, 0.0, 20.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
  picture.Draw();
  vtkNew<vtkUnsignedCharArray> grown;
  grown->DeepCopy(picture.Pixels);
  picture.Pass->SetCoverRadius(0.0);
  picture.Draw();
  int pixels[2] = { 0, 0 };
  for (int k = 0; k < Width * Height; ++k)
  {
    const int column = k % Width;
    const bool isLand = column > Width / 2;
    pixels[isLand] += grown->GetValue(4 * k) != picture.Pixels->GetValue(4 * k);
  }
  return Check(pixels[0] == 0 && pixels[1] > Width * Height / 20,
    "Grass in the sea and on its shore: " + std::to_string(pixels[0]) + " and " + std::to_string(pixels[1]) +
      " pixels");
}

/// A picture has the grass of the middle of one three times as wide and high, level, downwards and along a slope.
bool TestGrassAtEdges()
{
  bool good = true;
  for (const Color& ahead : { Color{ 3.0, 0.3, -0.2 }, Color{ -2.0, -2.0, -2.5 }, Color{ 0.1, -3.0, 0.6 } })
  {
    Picture picture;
    picture.Pass->SetSkyToEven();
    picture.Pass->ShadowsOff();
    picture.Pass->SetOcclusionRadius(0.0);
    picture.Pass->SetContactRadius(0.0);
    picture.Pass->SetCoverHeight(0.5);
    vtkActor* ground = picture.Add(Plane({ -40.0, -40.0, 12.0 }, { 40.0, -40.0, 12.0 }, { -40.0, 40.0, -12.0 }), 0.3);
    vtkLandscapePass::SetMaterial(ground, vtkLandscapePass::Ground);
    const Color eye{ 3.7, 1.2, 1.5 };
    picture.Look(eye, { eye[0] + ahead[0], eye[1] + ahead[1], eye[2] + ahead[2] }, { 0.0, 0.0, 1.0 });
    vtkCamera* camera = picture.Renderer->GetActiveCamera();
    camera->SetViewAngle(24.0);
    camera->SetClippingRange(0.05, 200.0);
    picture.Draw();
    int grass = 0;
    for (int k = 0; k < Width * Height; ++k)
    {
      grass += picture.Pixels->GetValue(4 * k) != picture.Pixels->GetValue(4 * (Width * Height - 1));
    }
    camera->SetViewAngle(
      2.0 * vtkMath::DegreesFromRadians(std::atan(3.0 * std::tan(vtkMath::RadiansFromDegrees(12.0)))));
    picture.Window->SetSize(3 * Width, 3 * Height);
    picture.Window->Render();
    vtkNew<vtkUnsignedCharArray> middle;
    picture.Window->GetRGBACharPixelData(Width, Height, 2 * Width - 1, 2 * Height - 1, 0, middle);
    int others = 0;
    for (int k = 0; k < Width * Height; ++k)
    {
      others += std::abs(middle->GetValue(4 * k) - picture.Pixels->GetValue(4 * k)) > 4;
    }
    good &= Check(grass > Width * Height / 4 && others < Width * Height / 500,
      std::to_string(others) + " pixels of grass are others than in a wider picture, of " + std::to_string(grass));
  }
  return good;
}

/// A level ground from above, whose grass is too low to be seen.
struct CoveredGround : Picture
{
  CoveredGround()
  {
    this->Pass->SetSkyToEven();
    this->Pass->ShadowsOff();
    this->Pass->SetOcclusionRadius(0.0);
    this->Pass->SetContactRadius(0.0);
    vtkLandscapePass::SetMaterial(this->Add(Level(60.0), 0.3), vtkLandscapePass::Ground);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  }

  /// Draws half of so many metres up and down with a height of grass.
  void DrawBare(double scale, double height)
  {
    this->Look({ 1.0, 2.0, 5.0 }, { 1.0, 2.0, 0.0 }, { 0.0, 1.0, 0.0 });
    this->Renderer->GetActiveCamera()->SetParallelScale(scale);
    this->Renderer->ResetCameraClippingRange();
    this->Pass->SetCoverHeight(height);
    this->CoveredBy(0.0, 0.0, 0.0);
    this->Bare->DeepCopy(this->Pixels);
  }

  /// Part that is another than bare.
  double CoveredBy(double herbs, double litter, double stones)
  {
    this->Pass->SetCoverHerbs(herbs);
    this->Pass->SetCoverLitter(litter);
    this->Pass->SetCoverStones(stones);
    this->Draw();
    int others = 0;
    for (int k = 0; k<4 * Width * Height&& this->Bare->GetNumberOfValues()> 0; k += 4)
    {
      others += this->Bare->GetValue(k) != this->Pixels->GetValue(k) ||
        this->Bare->GetValue(k + 2) != this->Pixels->GetValue(k + 2);
    }
    return static_cast<double>(others) / (Width * Height);
  }

  vtkNew<vtkUnsignedCharArray> Bare;
};

/// Leaves that fall anywhere hide 1 - exp(-n A) of the ground: 167 at most a square metre, of the mean area 0.6 (0.65 /
/// 2 + 0.25) E l^2, with lengths from 5 to 11 cm. Half of them is half of n. Herbs and stones are there too.
bool TestCoverKinds()
{
  CoveredGround ground;
  ground.Pass->SetCoverRadius(20.0);
  ground.DrawBare(2.0, 0.001);
  bool good = true;
  for (const double share : { 0.5, 1.0 })
  {
    const double area = 0.6 * (0.5 * 0.65 + 0.25) * (0.08 * 0.08 + 0.06 * 0.06 / 12.0);
    const double expected = 1.0 - std::exp(-share * 24000.0 / 144.0 * area);
    const double litter = ground.CoveredBy(0.0, share, 0.0);
    std::cout << "Litter hides " << litter << " of the ground, by chance " << expected << "\n";
    good &= Check(std::abs(litter / expected - 1.0) < 0.08, "Litter hides another part.");
  }
  ground.Pass->SetCoverRadius(40.0);
  ground.DrawBare(10.0, 0.001);
  const double stones = ground.CoveredBy(0.0, 0.0, 1.0);
  ground.DrawBare(10.0, 0.2);
  const double herbs = ground.CoveredBy(1.0, 0.0, 0.0);
  std::cout << "Herbs hide " << herbs << ", stones " << stones << "\n";
  return good & Check(herbs > 0.01 && herbs < 0.5 && stones > 0.001 && stones < 0.1, "There are no herbs or stones.");
}

/// Places with grass in a square of 2 m on a level ground, of 400, from another place.
int GrassSeen(const Color& square, const Color& eye)
{
  Picture picture;
  picture.Pass->SetSkyToEven();
  picture.Pass->ShadowsOff();
  picture.Pass->SetOcclusionRadius(0.0);
  picture.Pass->SetContactRadius(0.0);
  picture.Pass->SetCoverHeight(2.0);
  vtkLandscapePass::SetMaterial(picture.Add(Level(60.0), 0.3), vtkLandscapePass::Ground);
  picture.Look(eye, square, { 0.0, 1.0, 0.0 });
  picture.Renderer->GetActiveCamera()->SetViewAngle(8.0);
  picture.Renderer->ResetCameraClippingRange();
  picture.Draw();
  vtkNew<vtkUnsignedCharArray> grown;
  grown->DeepCopy(picture.Pixels);
  picture.Pass->SetCoverRadius(0.0);
  picture.Draw();
  int grass = 0;
  for (int k = 0; k < 400; ++k)
  {
    picture.Renderer->SetWorldPoint(square[0] + 0.1 * (k % 20) - 0.95, square[1] + 0.1 * (k / 20) - 0.95, 0.0, 1.0);
    picture.Renderer->WorldToDisplay();
    const double* at = picture.Renderer->GetDisplayPoint();
    const int pixel = 4 * (static_cast<int>(at[1]) * Width + static_cast<int>(at[0]));
    grass += grown->GetValue(pixel) != picture.Pixels->GetValue(pixel);
  }
  return grass;
}

/// As much grass is seen 23 m from the eye, where the tiles begin anew, as nearer to it; none from 60 m up.
bool TestGrassAround()
{
  bool good = true;
  for (const Color& side : { Color{ -1.0, 0.0 }, Color{ 0.0, -1.0 } })
  {
    const Color square{ 0.3 + 23.0 * side[0], 0.3 + 23.0 * side[1], 0.0 };
    const int far = GrassSeen(square, { 0.3, 0.3, 40.0 });
    const int near = GrassSeen(square, { 0.3 + 6.0 * side[0], 0.3 + 6.0 * side[1], 40.0 });
    good &= Check(far > 40 && far > 0.9 * near,
      "Of 400 places " + std::to_string(far) + " have grass, from near by " + std::to_string(near));
  }
  good &= Check(GrassSeen({ 0.3, 5.0, 0.0 }, { 0.3, 0.3, 61.0 }) == 0, "There is grass far below the eye.");
  return good;
}

/// What a level meadow looks like to an eye at 2 m that has looked in other directions before [rad].
std::vector<unsigned char> Meadow(const std::vector<double>& directions)
{
  Picture picture;
  picture.Pass->SetCoverHeight(0.5);
  picture.Pass->SetCoverRadius(30.0);
  vtkLandscapePass::SetMaterial(picture.Add(Level(60.0), 0.3), vtkLandscapePass::Ground);
  for (const double direction : directions)
  {
    picture.Look({ 0.3, 0.3, 2.0 }, { 0.3 + 10.0 * std::cos(direction), 0.3 + 10.0 * std::sin(direction), 1.0 },
      { 0.0, 0.0, 1.0 });
    picture.Draw();
  }
  return { picture.Pixels->GetPointer(0), picture.Pixels->GetPointer(0) + picture.Pixels->GetNumberOfValues() };
}

/// Grass is the same whatever was seen, and so made, before.
bool TestGrassAfterTurns()
{
  const std::vector<unsigned char> seen = Meadow({ 0.5 });
  return Check(seen == Meadow({ 3.0, 1.2, 0.5 }), "Grass depends on what was seen before.") &&
    Check(seen != Meadow({ 1.2 }), "A meadow looks alike in all directions.");
}

/// Bark of a grey, seen across from a distance: its mean, and the squares of its changes across and upward.
std::array<double, 3> BarkOf(double grey, double distance)
{
  Picture picture;
  picture.Pass->SetSkyToEven();
  picture.Pass->SetOcclusionRadius(0.0);
  picture.Pass->SetContactRadius(0.0);
  vtkLandscapePass::SetMaterial(
    picture.Add(Plane({ -15.0, 0.0, -15.0 }, { 15.0, 0.0, -15.0 }, { -15.0, 0.0, 15.0 }), grey),
    vtkLandscapePass::Bark);
  picture.Look({ 0.0, -distance, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  picture.Renderer->GetActiveCamera()->SetViewAngle(10.0);
  picture.Renderer->ResetCameraClippingRange();
  picture.Draw();
  std::array<double, 3> found{};
  constexpr int pixels = (Width - 1) * (Height - 1);
  for (int pixel = 0; pixel < pixels; ++pixel)
  {
    const int column = pixel % (Width - 1);
    const int row = pixel / (Width - 1);
    const double here = picture.LinearAt(column, row)[1];
    found[0] += here / pixels;
    found[1] += std::pow(picture.LinearAt(column + 1, row)[1] - here, 2) / pixels;
    found[2] += std::pow(picture.LinearAt(column, row + 1)[1] - here, 2) / pixels;
  }
  return found;
}

/// Bark has furrows along the trunk, and marks across it where it is bright; it has the color of its data on average,
/// and is smooth from afar.
bool TestBark()
{
  const std::array<double, 3> near = BarkOf(0.2, 15.0);
  const std::array<double, 3> far = BarkOf(0.2, 80.0);
  const std::array<double, 3> bright = BarkOf(0.6, 15.0);
  std::cout << "Bark: mean " << near[0] << ", changes across over those upward " << std::sqrt(near[1] / near[2])
            << "; bright, mean " << bright[0] << ", " << std::sqrt(bright[1] / bright[2]) << "\n";
  return Check(std::abs(near[0] / 0.2 - 1.0) < 0.05 && std::abs(bright[0] / 0.6 - 1.0) < 0.05,
           "Bark has another color near by.") &&
    Check(near[1] > 2.0 * near[2], "Bark has no furrows.") &&
    Check(bright[2] > 4.0 * bright[1], "Marks on bright bark are not across it.") &&
    Check(far[1] + far[2] < 1e-7, "Bark is rough from afar.");
}

}

int TestLandscapeGround(int, char*[])
{
  bool good = TestGrass();
  good &= TestGrassAtSea();
  good &= TestGrassAtEdges();
  good &= TestGrassAround();
  good &= TestGrassAfterTurns();
  good &= TestCoverKinds();
  good &= TestTurf();
  good &= TestBark();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
