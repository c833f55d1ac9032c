// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Pictures that are lit by vtkLandscapePass, for tests that read their pixels.
#ifndef LandscapePicture_h
#define LandscapePicture_h

#include "Check.h"
#include "vtkLandscapePass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{

using Color = std::array<double, 3>;

constexpr int Width = 240;
constexpr int Height = 160;

inline double LinearOf(double code)
{
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

inline double CodeOf(double linear)
{
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

/// A window that is lit by the pass, with colors in proportion to luminances.
struct Picture
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLandscapePass> Pass;
  vtkNew<vtkUnsignedCharArray> Pixels;

  Picture()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetPass(this->Pass);
    this->Pass->FilmCurveOff();
    this->Pass->SetMapSize(1024);
    this->Pass->SetCloudCover(0.0);
    this->Pass->SetExposureCompensation(0.0);
  }

  vtkActor* Add(vtkPolyData* data, double grey)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(CodeOf(grey), CodeOf(grey), CodeOf(grey));
    this->Renderer->AddActor(actor);
    return actor;
  }

  void Look(const Color& from, const Color& to, const Color& up)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(from.data());
    camera->SetFocalPoint(to.data());
    camera->SetViewUp(up.data());
    this->Renderer->ResetCameraClippingRange();
  }

  void Draw()
  {
    this->Window->Render();
    this->Window->GetRGBACharPixelData(0, 0, Width - 1, Height - 1, 0, this->Pixels);
  }

  Color At(int x, int y) const
  {
    const unsigned char* pixel = this->Pixels->GetPointer(4 * (y * Width + x));
    return { pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0 };
  }

  /// Exposed luminance of a pixel.
  Color LinearAt(int x, int y) const
  {
    const Color code = this->At(x, y);
    return { LinearOf(code[0]), LinearOf(code[1]), LinearOf(code[2]) };
  }
};

inline vtkSmartPointer<vtkPolyData> Plane(const Color& origin, const Color& a, const Color& b)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(origin[0], origin[1], origin[2]);
  source->SetPoint1(a[0], a[1], a[2]);
  source->SetPoint2(b[0], b[1], b[2]);
  source->Update();
  return source->GetOutput();
}

inline vtkSmartPointer<vtkPolyData> Level(double half, double z = 0.0)
{
  return Plane({ -half, -half, z }, { half, -half, z }, { -half, half, z });
}

inline vtkSmartPointer<vtkPolyData> Box(const Color& center, const Color& size)
{
  vtkNew<vtkCubeSource> source;
  source->SetCenter(center[0], center[1], center[2]);
  source->SetXLength(size[0]);
  source->SetYLength(size[1]);
  source->SetZLength(size[2]);
  source->Update();
  return source->GetOutput();
}

/// Flat water at the height 0.
struct Water : Picture
{
  explicit Water(const Color& absorption, const Color& scattering)
  {
    this->Pass->SetWaterAbsorption(absorption.data());
    this->Pass->SetWaterScattering(scattering.data());
    this->Pass->SetWaterSlopeVariance(0.0);
    this->Pass->SetOcclusionRadius(0.0);
    this->Pass->SetVisibility(1e9);
    vtkLandscapePass::SetMaterial(this->Add(Level(1000.0), 0.2), vtkLandscapePass::Water);
  }

  Color Sun()
  {
    Color sun;
    this->Pass->GetSunDirection(sun.data());
    return sun;
  }
  Color SunLight()
  {
    Color light;
    this->Pass->GetSunLight(light.data());
    return light;
  }
  Color SkyLight()
  {
    Color light;
    this->Pass->GetSkyLight(0.0, 0.0, 1.0, light.data());
    return light;
  }
};

inline bool Near(const Color& found, const Color& expected, double relative, double absolute, const std::string& what)
{
  bool good = true;
  for (int c = 0; c < 3; ++c)
  {
    good &= std::abs(found[c] - expected[c]) <= relative * expected[c] + absolute;
  }
  return Check(good,
    what + ": " + std::to_string(found[0]) + " " + std::to_string(found[1]) + " " + std::to_string(found[2]) + " for " +
      std::to_string(expected[0]) + " " + std::to_string(expected[1]) + " " + std::to_string(expected[2]));
}

}

#endif
