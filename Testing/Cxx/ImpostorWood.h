// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Oaks in a row, in full or as impostors, for tests of vtkImpostorMapper.
#ifndef ImpostorWood_h
#define ImpostorWood_h

#include "LandscapePicture.h"
#include "PlantScene.h"
#include "vtkImpostorMapper.h"
#include "vtkReevesTreeSource.h"

#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <vector>

namespace
{

constexpr int Oaks = 4;
constexpr double Turns[Oaks] = { 17.0, 123.0, 201.0, 318.0 }; // about z [degrees]

/// An actor of a block with the texture that it carries, in its own coordinates.
inline vtkSmartPointer<vtkActor> PartOf(vtkDataObject* block, double transmittance)
{
  PlantScene scene;
  scene.AddAsCarried(block);
  vtkSmartPointer<vtkActor> actor = scene.Renderer->GetActors()->GetLastActor();
  vtkLandscapePass::SetTransmittance(actor, transmittance);
  return actor;
}

/// Wood and leaves of an oak.
inline std::vector<vtkSmartPointer<vtkActor>> PartsOf(vtkReevesTreeSource* oak)
{
  oak->Update();
  vtkDataObject* data = oak->GetOutputDataObject(0);
  return { PartOf(BlockAt(data, "High/Skin"), 0.0), PartOf(BlockAt(data, "High/Leaves"), 0.4) };
}

/// A picture of oaks that are apart from each other, of a size of each of them [pixels].
struct Row : Picture
{
  int Columns = 0;
  int Rows = 0;
  double Radius = 0.0;
  double Middle = 0.0; ///< height [m]

  Row()
  {
    this->Pass->BackgroundOff();
    this->Pass->SetExposureCompensation(-1.0);
    this->Pass->SetMapSize(512);
  }

  void Resize(int pixels)
  {
    this->Columns = Oaks * (pixels + pixels / 8);
    this->Rows = pixels + pixels / 8;
    this->Window->SetSize(this->Columns, this->Rows);
  }

  /// Whether there is the light of the sun and of the sky by what hides them.
  void SetShadows(bool areOn)
  {
    this->Pass->SetShadows(areOn);
    this->Pass->SetOcclusionRadius(areOn ? 5.0 : 0.0);
  }

  /// Places of the oaks for a sphere around each of them.
  void Take(const std::vector<vtkSmartPointer<vtkActor>>& parts)
  {
    vtkBoundingBox box;
    for (vtkActor* part : parts)
    {
      box.AddBounds(part->GetBounds());
    }
    this->Radius = 0.5 * box.GetDiagonalLength();
    this->Middle = 0.5 * (box.GetMinPoint()[2] + box.GetMaxPoint()[2]);
  }

  Color PlaceOf(int oak) const { return { (oak - 0.5 * (Oaks - 1)) * 2.25 * this->Radius, 0.0, 0.0 }; }

  void AddHigh(vtkReevesTreeSource* oak)
  {
    const auto parts = PartsOf(oak);
    this->Take(parts);
    for (int tree = 0; tree < Oaks; ++tree)
    {
      for (vtkActor* part : parts)
      {
        vtkNew<vtkActor> actor;
        actor->SetMapper(part->GetMapper());
        actor->SetProperty(part->GetProperty());
        actor->SetTexture(part->GetTexture());
        actor->SetShaderProperty(part->GetShaderProperty());
        actor->SetForceOpaque(part->GetForceOpaque());
        vtkLandscapePass::SetTransmittance(actor, vtkLandscapePass::GetTransmittance(part));
        actor->SetPosition(this->PlaceOf(tree).data());
        actor->RotateZ(Turns[tree]);
        this->Renderer->AddActor(actor);
      }
    }
  }

  vtkSmartPointer<vtkImpostorMapper> AddImpostors(vtkReevesTreeSource* oak)
  {
    const auto parts = PartsOf(oak);
    this->Take(parts);
    auto mapper = vtkSmartPointer<vtkImpostorMapper>::New();
    for (vtkActor* part : parts)
    {
      mapper->AddPart(part);
    }
    vtkNew<vtkPoints> places;
    vtkNew<vtkFloatArray> rotations;
    rotations->SetName("Rotation");
    rotations->SetNumberOfComponents(4);
    for (int tree = 0; tree < Oaks; ++tree)
    {
      const double half = vtkMath::RadiansFromDegrees(0.5 * Turns[tree]);
      places->InsertNextPoint(this->PlaceOf(tree).data());
      rotations->InsertNextTuple4(std::cos(half), 0.0, 0.0, std::sin(half));
    }
    vtkNew<vtkPolyData> points;
    points->SetPoints(places);
    points->GetPointData()->AddArray(rotations);
    mapper->SetInputData(points);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return mapper;
  }

  /// Looks from an elevation [degrees], in perspective or in parallel projection.
  void LookFrom(double elevation, bool isParallel = false)
  {
    const double up = vtkMath::RadiansFromDegrees(elevation);
    const double away = 12.0 * this->Radius;
    this->Look(
      { 0.0, -away * std::cos(up), this->Middle + away * std::sin(up) }, { 0.0, 0.0, this->Middle }, { 0.0, 0.0, 1.0 });
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetParallelProjection(isParallel);
    camera->SetParallelScale(1.125 * this->Radius);
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(1.125 * this->Radius / away)));
    this->Renderer->ResetCameraClippingRange();
  }

  /// Part of each pixel of a picture of fewer pixels that is covered, by samples along its side.
  std::vector<double> Covered(int samples)
  {
    this->Window->Render();
    vtkNew<vtkFloatArray> depths;
    this->Window->GetZbufferData(0, 0, this->Columns - 1, this->Rows - 1, depths);
    const int columns = this->Columns / samples;
    std::vector<double> parts(static_cast<std::size_t>(columns) * (this->Rows / samples));
    for (int row = 0; row < this->Rows; ++row)
    {
      for (int column = 0; column < this->Columns; ++column)
      {
        const bool isThere = depths->GetValue(row * this->Columns + column) < 1.0F;
        parts[(row / samples) * columns + column / samples] += isThere ? 1.0 / (samples * samples) : 0.0;
      }
    }
    return parts;
  }

  /// Mean luminance of what is there.
  double MeanLuminance()
  {
    const std::vector<double> there = this->Covered(1);
    this->Window->GetRGBACharPixelData(0, 0, this->Columns - 1, this->Rows - 1, 0, this->Pixels);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < there.size(); ++k)
    {
      const unsigned char* code = this->Pixels->GetPointer(4 * static_cast<vtkIdType>(k));
      const double luminance =
        0.2126 * LinearOf(code[0] / 255.0) + 0.7152 * LinearOf(code[1] / 255.0) + 0.0722 * LinearOf(code[2] / 255.0);
      sum += there[k] * luminance;
      count += there[k];
    }
    return count > 0.0 ? sum / count : 0.0;
  }
};

/// The oaks in full and as impostors.
struct Pair
{
  Row High;
  Row Impostors;

  explicit Pair(vtkReevesTreeSource* oak)
  {
    this->High.AddHigh(oak);
    this->Impostors.AddImpostors(oak);
  }

  std::array<Row*, 2> Both() { return { &this->High, &this->Impostors }; }
};

}

#endif
