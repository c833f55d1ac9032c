// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GroundCover.h"

#include "DepthMaps.h"
#include "GroundCoverDec.h"
#include "GroundCoverImpl.h"
#include "LandscapeGround.h"
#include "LandscapeNoise.h"
#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Uniforms.h"
#include "vtkLandscapePass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace littoral
{

/// Blades of a tile.
struct GroundCover::Tile
{
  double Side;  ///< over the radius of the cover, at least twice Reach
  int Count;    ///< blades
  double Width; ///< of a blade at its foot, over its height
  double From;  ///< distances between which they are drawn, over the radius of the cover
  double Reach;
};

namespace
{

using Tile = GroundCover::Tile;
constexpr Tile Tiles[GroundCover::Densities] = {
  { 0.4, 90000, 0.032, 0.0, 0.2 },
  { 1.0, 170000, 0.045, 0.15, 0.5 },
  { 2.0, 100000, 0.085, 0.4, 1.0 },
};
constexpr int Cells = 8;        // of a tile along its sides
constexpr double MeanUp = 0.75; // part of the blades' normal that is upward, as of the grass that they stand for

/// A blade as two quadrangles and a tip, bent over; its five points are relative to its foot.
void AddBlade(const Tile& tile, const RandomStream& random, std::uint64_t blade, vtkPolyData* data, vtkFloatArray* feet,
  vtkFloatArray* normals, vtkUnsignedCharArray* shades)
{
  const std::array<double, 2> foot = random.UniformPair(blade, 0);
  const std::array<double, 2> turn = random.UniformPair(blade, 1);
  const std::array<double, 2> form = random.UniformPair(blade, 2);
  const double around = TwoPi * turn[0];
  const double bend = 0.15 + 0.75 * turn[1];
  const double height = 0.45 + 0.55 * form[0];
  const glm::dvec3 ahead(std::cos(around), std::sin(around), 0.0);
  const glm::dvec3 aside(-ahead.y, ahead.x, 0.0);
  const glm::dvec3 normal = glm::normalize(MeanUp * glm::dvec3(0.0, 0.0, 1.0) + (1.0 - MeanUp) * ahead);
  const vtkIdType first = data->GetNumberOfPoints();
  const auto add = [&](double t, double side) {
    // A parabola from the foot upward and over
    const glm::dvec3 at = height * (t * glm::dvec3(0.0, 0.0, 1.0 - 0.35 * bend * t) + bend * t * t * ahead) +
      side * 0.5 * tile.Width * (1.0 - 0.4 * t) * aside;
    data->GetPoints()->InsertNextPoint(at.x, at.y, at.z);
    feet->InsertNextTuple2(foot[0], foot[1]);
    normals->InsertNextTuple3(normal.x, normal.y, normal.z);
    // Dark among the others at the foot; no two blades are of one age.
    const double shade = 255.0 * (0.76 + 0.24 * t) * (0.88 + 0.12 * form[1]);
    shades->InsertNextTuple3(shade, shade, shade * (1.0 - 0.12 * form[1]));
  };
  for (const double t : { 0.0, 0.55 })
  {
    add(t, -1.0);
    add(t, 1.0);
  }
  add(1.0, 0.0);
  const vtkIdType strip[5] = { first, first + 1, first + 2, first + 3, first + 4 };
  data->GetStrips()->InsertNextCell(5, strip);
}

/// The blades of a tile by cells, with the ends of these among them.
std::vector<int> ByCells(const Tile& tile, const RandomStream& random, std::vector<int>& ends)
{
  std::vector<std::vector<int>> cells(Cells * Cells);
  for (int blade = 0; blade < tile.Count; ++blade)
  {
    const std::array<double, 2> foot = random.UniformPair(static_cast<std::uint64_t>(blade), 0);
    const int cell = static_cast<int>(Cells * foot[0]) + Cells * static_cast<int>(Cells * foot[1]);
    cells[static_cast<std::size_t>(cell)].push_back(blade);
  }
  std::vector<int> blades;
  ends = { 0 };
  for (const std::vector<int>& cell : cells)
  {
    blades.insert(blades.end(), cell.begin(), cell.end());
    ends.push_back(static_cast<int>(blades.size()));
  }
  return blades;
}

vtkSmartPointer<vtkPolyData> BladesOf(const Tile& tile, std::vector<int>& ends)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtkNew<vtkPoints>());
  data->SetStrips(vtkNew<vtkCellArray>());
  vtkNew<vtkFloatArray> feet;
  feet->SetName("Foot");
  feet->SetNumberOfComponents(2);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> shades;
  shades->SetName("Shade");
  shades->SetNumberOfComponents(3);
  const RandomStream random(tile.Count, RandomPurpose::GrassBlades);
  for (const int blade : ByCells(tile, random, ends))
  {
    AddBlade(tile, random, static_cast<std::uint64_t>(blade), data, feet, normals, shades);
  }
  data->GetPointData()->AddArray(feet);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->SetScalars(shades);
  return data;
}

/// Gives a program its uniforms before it draws.
class UniformCommand : public vtkCommand
{
public:
  static UniformCommand* New() { return new UniformCommand; }

  void Execute(vtkObject*, unsigned long, void* program) override
  {
    this->Set(static_cast<vtkShaderProgram*>(program));
  }

  std::function<void(vtkShaderProgram*)> Set;
};

/// Copies of a cell of a tile along an axis that are the nearest to the eye for some of its blades, from the first to
/// the last one; eye over the side of the tile.
std::array<double, 2> CopiesOf(int cell, double eye)
{
  const auto nearest = [eye](double foot) { return std::floor(eye - foot + 0.5); };
  return { nearest((cell + 1.0) / Cells), nearest(static_cast<double>(cell) / Cells) };
}

}

/// What of the world a picture shows.
struct GroundCover::Sight
{
  double Planes[24]; ///< of the view's frustum: a x + b y + c z + d is not negative in it
  double Lowest;     ///< heights of all that is shown [m]
  double Highest;

  /// Whether some of a box is seen.
  bool Sees(const glm::dvec3& low, const glm::dvec3& high) const
  {
    for (const double* plane = this->Planes; plane < this->Planes + 24; plane += 4)
    {
      // Of the corner that is farthest inwards
      double inside = plane[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        inside += std::max(plane[axis] * low[axis], plane[axis] * high[axis]);
      }
      if (inside < 0.0)
      {
        return false;
      }
    }
    return true;
  }
};

//----------------------------------------------------------------------------
GroundCover::GroundCover() = default;
GroundCover::~GroundCover() = default;

//----------------------------------------------------------------------------
void GroundCover::SetSize(double height, double radius)
{
  this->Height = height;
  this->Radius = radius;
}

//----------------------------------------------------------------------------
std::vector<vtkProp*> GroundCover::GetProps() const
{
  std::vector<vtkProp*> props;
  for (const auto& blades : this->Blades)
  {
    props.push_back(blades);
  }
  return props;
}

//----------------------------------------------------------------------------
void GroundCover::Prepare(int density, const DepthMaps& maps)
{
  const Tile& tile = Tiles[density];
  vtkActor* actor = this->Blades[density];
  GroundCoverMapper* mapper = this->Mappers[density];
  mapper->SetInputData(BladesOf(tile, this->Ends[density]));
  mapper->MapDataArrayToVertexAttribute("coverFoot", "Foot", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  vtkNew<UniformCommand> uniforms;
  uniforms->Set = [this, &tile, &maps](vtkShaderProgram* program) { this->SetUniforms(program, tile, maps); };
  mapper->AddObserver(vtkCommand::UpdateShaderEvent, uniforms);
  actor->SetMapper(mapper);
  vtkLandscapePass::SetMaterial(actor, vtkLandscapePass::Cover);
  vtkShaderProperty* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true,
    std::string(LandscapeNoise) + LandscapeGround + GroundCoverDec + "//VTK::Normal::Dec\n", false);
  shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, GroundCoverImpl, false);
}

//----------------------------------------------------------------------------
bool GroundCover::IsCellSeen(const Tile& tile, int column, int row, const Sight& sight) const
{
  const double side = tile.Side * this->Radius;
  const double margin = 1.3 * this->Height; // blades are up to 1.2 times as high, and bend as far aside
  const std::array<double, 2> columns = CopiesOf(column, this->Eye.x / side);
  const std::array<double, 2> rows = CopiesOf(row, this->Eye.y / side);
  for (double x = columns[0]; x <= columns[1]; ++x)
  {
    for (double y = rows[0]; y <= rows[1]; ++y)
    {
      const glm::dvec2 low = side * (glm::dvec2(x, y) + glm::dvec2(column, row) / static_cast<double>(Cells));
      const glm::dvec2 high = low + side / Cells;
      const glm::dvec2 eye(this->Eye);
      const double near = glm::distance(eye, glm::clamp(eye, low, high));
      const double far = glm::length(glm::max(glm::abs(low - eye), glm::abs(high - eye)));
      if (near < tile.Reach * this->Radius && far > tile.From * this->Radius &&
        sight.Sees({ low - margin, sight.Lowest }, { high + margin, sight.Highest + margin }))
      {
        return true;
      }
    }
  }
  return false;
}

//----------------------------------------------------------------------------
/// The blades of the cells that a picture shows.
std::vector<GroundCoverMapper::Run> GroundCover::RunsOf(int density, const Sight& sight) const
{
  const std::vector<int>& ends = this->Ends[density];
  std::vector<GroundCoverMapper::Run> runs;
  for (int cell = 0; cell < Cells * Cells; ++cell)
  {
    if (this->IsCellSeen(Tiles[density], cell % Cells, cell / Cells, sight))
    {
      if (runs.empty() || runs.back().To != ends[cell])
      {
        runs.push_back({ ends[cell], ends[cell] });
      }
      runs.back().To = ends[cell + 1];
    }
  }
  return runs;
}

//----------------------------------------------------------------------------
void GroundCover::Draw(vtkRenderer* renderer, const DepthMaps& maps)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->GetPosition(&this->Eye.x);
  Sight sight;
  camera->GetFrustumPlanes(renderer->GetTiledAspectRatio(), sight.Planes);
  sight.Lowest = maps.GetLowest();
  sight.Highest = maps.GetHighest();
  for (int k = 0; k < Densities; ++k)
  {
    const Tile& tile = Tiles[k];
    vtkActor* actor = this->Blades[k];
    if (!actor->GetMapper())
    {
      this->Prepare(k, maps);
    }
    // Blades are relative to a corner of the tiles near the eye, so that single precision holds them.
    const double side = tile.Side * this->Radius;
    const auto corner = [&](double x) { return side * std::floor(x / side); };
    this->Anchor = { corner(this->Eye.x), corner(this->Eye.y), std::floor(this->Eye.z) };
    this->Mappers[k]->SetRuns(this->RunsOf(k, sight));
    actor->SetPosition(this->Anchor.x, this->Anchor.y, this->Anchor.z);
    actor->RenderOpaqueGeometry(renderer);
  }
}

//----------------------------------------------------------------------------
void GroundCover::SetUniforms(vtkShaderProgram* program, const Tile& tile, const DepthMaps& maps) const
{
  const glm::dmat4& toMap = maps.GetMatrix(DepthMaps::Ground);
  SetUniform(program, "coverGround", maps.GetGroundTexture()->GetTextureUnit());
  SetUniform(program, "coverTexel", maps.GetTexelSize(DepthMaps::Ground));
  // From places to the map x and y by a scale, and z from depths
  SetUniform(program, "coverToMap", glm::dvec3(toMap[0][0], toMap[1][1], toMap[2][2]));
  SetUniform(program, "coverCorner", glm::dvec3(toMap * glm::dvec4(this->Anchor, 1.0)));
  SetUniform(program, "coverEye", this->Eye - this->Anchor);
  SetUniform(program, "coverAnchor", this->Anchor - NoisePeriod * glm::floor(this->Anchor / NoisePeriod));
  SetUniform(program, "coverSide", tile.Side * this->Radius);
  SetUniform(program, "coverFrom", tile.From * this->Radius);
  SetUniform(program, "coverReach", tile.Reach * this->Radius);
  SetUniform(program, "coverHeight", this->Height);
  SetUniform(program, "coverLevel", this->SeaLevel - this->Anchor.z);
}

//----------------------------------------------------------------------------
void GroundCover::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& blades : this->Blades)
  {
    blades->ReleaseGraphicsResources(window);
  }
}

}
