// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Woods of the ground by vtkLandscapePass: their part of it, what their crowns hide, and where their shadows fall; and
// banks of rivers.
#include "LandscapePicture.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

/// Woods cover the part of a level ground that they shall, and more of a lush one: with c = 1 / (1 + exp(1.702 x)) of a
/// field of the deviation 0.1306, from a value that is lower by 0.12.
bool TestWoods()
{
  bool good = true;
  for (const double cover : { 0.0, 0.15, 0.5, 0.9, 0.457 })
  {
    const bool isLush = cover == 0.457;
    Picture picture;
    picture.Pass->SetSkyToEven();
    picture.Pass->SetOcclusionRadius(0.0);
    picture.Pass->SetWoodCover(isLush ? 0.15 : cover);
    vtkActor* ground = picture.Add(Level(40000.0), 0.6);
    vtkLandscapePass::SetMaterial(ground, vtkLandscapePass::Ground);
    if (isLush)
    {
      ground->GetProperty()->SetColor(0.54, 0.85, 0.48);
    }
    picture.Look({ 0.0, 0.0, 1000.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
    picture.Renderer->GetActiveCamera()->ParallelProjectionOn();
    picture.Renderer->GetActiveCamera()->SetParallelScale(25000.0);
    picture.Renderer->ResetCameraClippingRange();
    picture.Draw();
    int woods = 0;
    for (int pixel = 0; pixel < Width * Height; ++pixel)
    {
      woods += picture.LinearAt(pixel % Width, pixel / Width)[1] < 0.1;
    }
    const double part = static_cast<double>(woods) / (Width * Height);
    good &= Check(std::abs(part - cover) < 0.04,
      "Woods cover " + std::to_string(part) + " of the ground for " + std::to_string(cover));
  }
  return good;
}

const Color Middle{ -2000.0, -500.0, 0.0 };
constexpr double Step = 4.0; // between places [m]
constexpr int Across = 100;
constexpr int Along = 80;

/// Places in rows from south to north.
using Places = std::vector<double>;

double At(const Places& places, int column, int row)
{
  return places[Across * row + column];
}

/// A level ground with woods on some of it, without what hides the sky.
struct Country : Picture
{
  Country()
  {
    this->Pass->SetOcclusionRadius(0.0);
    this->Pass->SetContactRadius(0.0);
    this->Pass->SetWoodCover(0.3);
    this->Pass->ShadowsOff();
    vtkLandscapePass::SetMaterial(this->Add(Level(4000.0), 0.4), vtkLandscapePass::Ground);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->Renderer->GetActiveCamera()->SetParallelScale(200.0);
  }

  /// Green light of places, seen from the south at an elevation [degrees].
  Places Seen(double elevation)
  {
    const double up = vtkMath::RadiansFromDegrees(elevation);
    this->Look({ Middle[0], Middle[1] - 3000.0 * std::cos(up), 3000.0 * std::sin(up) }, Middle, { 0.0, 1.0, 0.1 });
    this->Draw();
    Places seen;
    for (int k = 0; k < Across * Along; ++k)
    {
      this->Renderer->SetWorldPoint(Middle[0] + Step * (k % Across - 0.5 * Across + 0.5),
        Middle[1] + Step * (k / Across - 0.5 * Along + 0.5), 0.0, 1.0);
      this->Renderer->WorldToDisplay();
      const double* at = this->Renderer->GetDisplayPoint();
      seen.push_back(this->LinearAt(static_cast<int>(at[0]), static_cast<int>(at[1]))[1]);
    }
    return seen;
  }

  /// Green light by an even sky: of woods it is below 0.08.
  Places SeenEven(double elevation)
  {
    this->Pass->SetSkyToEven();
    return this->Seen(elevation);
  }
};

/// Whether there is wood from one row to another, in a column of places seen from above.
bool HasWood(const Places& above, int column, int from, int to)
{
  bool has = false;
  for (int row = std::max(from, 0); row <= to; ++row)
  {
    has |= At(above, column, row) < 0.08;
  }
  return has;
}

/// At 15 degrees crowns of 22 m at most hide 82 m behind them: of meadows, what has a wood near towards the eye is
/// hidden, and what has none in 100 m is not.
bool TestStand()
{
  Country country;
  const Places above = country.SeenEven(89.9);
  const Places flat = country.SeenEven(15.0);
  int behind[2] = { 0, 0 };
  int open[2] = { 0, 0 };
  for (int k = 25 * Across; k < Across * Along; ++k)
  {
    const int column = k % Across;
    const int row = k / Across;
    const bool isHidden = flat[k] < 0.08;
    if (above[k] > 0.08 && HasWood(above, column, row - 4, row - 3))
    {
      ++behind[isHidden];
    }
    else if (above[k] > 0.08 && !HasWood(above, column, row - 25, row - 1))
    {
      ++open[isHidden];
    }
  }
  std::cout << "Behind a wood " << behind[1] << " places are hidden, " << behind[0] << " not; on open ground "
            << open[1] << " and " << open[0] << "\n";
  return Check(behind[1] > 0.6 * (behind[0] + behind[1]) && behind[1] > 100, "Woods do not stand.") &&
    Check(open[1] < 0.06 * open[0] && open[0] > 100, "What has no wood before it is hidden.");
}

/// A sun 20 degrees high: meadows just north of a wood are darker by one in the south than by one in the north, and
/// what has no wood near is as bright by both.
bool TestShadow()
{
  Country country;
  country.Pass->SetVisibility(1e8);
  const Places above = country.SeenEven(89.9);
  country.Pass->SetSkyToClear();
  country.Pass->SetSunElevation(20.0);
  country.Pass->SetSunAzimuth(180.0);
  const Places south = country.Seen(89.9);
  country.Pass->SetSunAzimuth(0.0);
  const Places north = country.Seen(89.9);
  double sum[2] = { 0.0, 0.0 };
  int places[2] = { 0, 0 };
  for (int k = 20 * Across; k < Across * (Along - 20); ++k)
  {
    const int column = k % Across;
    const int row = k / Across;
    const bool isBehind = HasWood(above, column, row - 3, row - 2) && !HasWood(above, column, row, row + 8);
    const bool isOpen = !HasWood(above, column, row - 20, row + 20);
    if (above[k] > 0.08 && (isBehind || isOpen))
    {
      sum[isBehind] += south[k] / north[k];
      ++places[isBehind];
    }
  }
  const double shaded = sum[1] / places[1];
  const double open = sum[0] / places[0];
  std::cout << "Light north of woods " << shaded << " in " << places[1] << " places, in the open " << open << "\n";
  return Check(places[1] > 25 && shaded < 0.85, "Woods cast no shadow away from the sun.") &&
    Check(places[0] > 50 && std::abs(open - 1.0) < 0.05, "Open ground is in the shadow of woods.");
}

/// Whether there is wood near the places of a ridge, seen from above, for columns of metres.
std::vector<int> WoodsOnRidge(Picture& picture, const Color& middle)
{
  picture.Look({ middle[0], middle[1], 1000.0 }, middle, { 0.0, 1.0, 0.0 });
  picture.Renderer->GetActiveCamera()->ParallelProjectionOn();
  picture.Renderer->GetActiveCamera()->SetParallelScale(0.5 * Height);
  picture.Renderer->ResetCameraClippingRange();
  picture.Draw();
  std::vector<int> woods(Width);
  for (int x = 0; x < Width; ++x)
  {
    for (int k = 0; k < 24 * 12; ++k)
    {
      const int at = std::clamp(x - 12 + k % 24, 0, Width - 1);
      woods[x] += picture.LinearAt(at, Height / 2 - 13 + k / 24)[1] < 0.08 ? 1 : 0;
    }
  }
  return woods;
}

/// Highest rows of what is before the sky, by columns, seen along a ground from 2 km away with pixels of 1 m.
std::vector<int> OutlineOf(Picture& picture, const Color& middle)
{
  constexpr double eye = 3.0;
  vtkCamera* camera = picture.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetViewAngle(vtkMath::DegreesFromRadians(2.0 * std::atan(0.5 * Height / 2000.0)));
  picture.Look({ middle[0], middle[1] - 2000.0, eye }, { middle[0], middle[1], eye }, { 0.0, 0.0, 1.0 });
  picture.Draw();
  std::vector<int> tops(Width, Height);
  for (int x = 0; x < Width; ++x)
  {
    while (tops[x] > 0 && picture.LinearAt(x, tops[x] - 1)[1] > 0.5)
    {
      --tops[x];
    }
    tops[x] += static_cast<int>(eye) - Height / 2; // heights over the ground
  }
  return tops;
}

/// The edge of a level ground against the sky: where woods stand on it, the outline is raised by their crowns, 24 m at
/// most, and where there are none in 12 m it is not.
bool TestOutline()
{
  Picture picture;
  picture.Pass->SetSkyToEven();
  picture.Pass->SetOcclusionRadius(0.0);
  picture.Pass->SetContactRadius(0.0);
  picture.Pass->ShadowsOff();
  picture.Pass->SetWoodCover(0.3);
  picture.Pass->SetVisibility(1e8);
  vtkLandscapePass::SetMaterial(
    picture.Add(Plane({ -4000.0, -4000.0, 0.0 }, { 0.0, -4000.0, 0.0 }, { -4000.0, -500.0, 0.0 }), 0.4),
    vtkLandscapePass::Ground);
  int columns[2] = { 0, 0 };
  int raised[2] = { 0, 0 };
  double height = 0.0;
  int highest = 0;
  for (int part = 0; part < 6; ++part)
  {
    const Color middle{ -2700.0 + Width * part, -500.0, 0.0 };
    const std::vector<int> woods = WoodsOnRidge(picture, middle);
    const std::vector<int> tops = OutlineOf(picture, middle);
    for (int x = 12; x < Width - 12; ++x)
    {
      highest = std::max(highest, tops[x]);
      if (woods[x] == 0 || woods[x] > 200)
      {
        ++columns[woods[x] > 0];
        raised[woods[x] > 0] += tops[x] > 4 ? 1 : 0;
        height += woods[x] > 0 ? tops[x] : 0.0;
      }
    }
  }
  std::cout << "Of " << columns[1] << " columns with woods on a ridge " << raised[1] << " are raised, by "
            << height / columns[1] << " m and " << highest << " m, of " << columns[0] << " without " << raised[0]
            << "\n";
  return Check(columns[0] > 100 && raised[0] == 0, "Crowns stand where there are no woods.") &&
    Check(columns[1] > 100 && raised[1] > 0.7 * columns[1] && height > 10.0 * columns[1], "Woods have no outline.") &&
    Check(highest <= 24, "Crowns are too high.");
}

/// A river's rims are darker than its middle, where an even sky is mirrored from above, if its data have banks.
bool TestBanks()
{
  double rim[2] = { 0.0, 0.0 };
  for (const bool hasBanks : { false, true })
  {
    Picture picture;
    picture.Pass->SetSkyToEven();
    picture.Pass->SetOcclusionRadius(0.0);
    const auto band = Level(20.0);
    vtkNew<vtkFloatArray> banks;
    banks->SetName(hasBanks ? "Bank" : "Other");
    for (vtkIdType point = 0; point < band->GetNumberOfPoints(); ++point)
    {
      banks->InsertNextValue(band->GetPoint(point)[0] < 0.0 ? 1.0F : -1.0F);
    }
    band->GetPointData()->AddArray(banks);
    vtkLandscapePass::SetMaterial(picture.Add(band, 0.5), vtkLandscapePass::River);
    picture.Look({ 0.0, -60.0, 20.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
    picture.Renderer->GetActiveCamera()->ParallelProjectionOn();
    picture.Renderer->GetActiveCamera()->SetParallelScale(15.0);
    picture.Renderer->ResetCameraClippingRange();
    picture.Draw();
    double sum[2] = { 0.0, 0.0 };
    for (int off = 0; off < 8; ++off)
    {
      sum[0] += picture.LinearAt(Width / 2 - 4 + off, Height / 2)[2];
      sum[1] += picture.LinearAt(Width / 2 - 105 + off, Height / 2)[2] / 2.0;
      sum[1] += picture.LinearAt(Width / 2 + 97 + off, Height / 2)[2] / 2.0;
    }
    rim[hasBanks] = sum[1] / sum[0];
  }
  std::cout << "Rims of a river over its middle " << rim[0] << ", with banks " << rim[1] << "\n";
  return Check(std::abs(rim[0] - 1.0) < 0.05, "A river without banks is not even.") &&
    Check(rim[1] < 0.6, "Nothing grows on banks.");
}

}

int TestLandscapeWoods(int, char*[])
{
  bool good = TestWoods();
  good &= TestStand();
  good &= TestShadow();
  good &= TestOutline();
  good &= TestBanks();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
