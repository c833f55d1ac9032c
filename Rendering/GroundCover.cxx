// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GroundCover.h"

#include "DepthMaps.h"
#include "GroundCoverDec.h"
#include "GroundCoverImpl.h"
#include "LandscapeGround.h"
#include "LandscapeNoise.h"
#include "Uniforms.h"
#include "vtkLandscapePass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace littoral
{

namespace
{

constexpr CoverTile Tiles[GroundCover::Layers] = {
  { CoverKind::Grass, 0.4, 90000, 0.032, 0.0, 0.2 },
  { CoverKind::Grass, 1.0, 170000, 0.045, 0.15, 0.5 },
  { CoverKind::Grass, 2.0, 100000, 0.085, 0.4, 1.0 },
  { CoverKind::Herb, 1.0, 60000, 0.4, 0.0, 0.5 },
  { CoverKind::Flower, 1.0, 24000, 0.055, 0.0, 0.5 },
  { CoverKind::Litter, 0.6, 24000, 0.6, 0.0, 0.3 },
  { CoverKind::Stone, 1.0, 8000, 0.0, 0.0, 0.5 },
};
constexpr int Cells = CoverTile::Cells;

/// Where elements of a kind are: a noise of cells of a size [m], 0 to 1, rises from a value to another; 0: everywhere.
struct Patches
{
  double Size;
  double From;
  double To;
};

Patches PatchesOf(CoverKind kind)
{
  switch (kind)
  {
    case CoverKind::Herb:
      return { 4.0, 0.4, 0.6 };
    case CoverKind::Flower:
      return { 8.0, 0.55, 0.7 };
    case CoverKind::Stone:
      return { 16.0, 0.45, 0.65 };
    default:
      return { 0.0, 0.0, 0.0 };
  }
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
  glm::dvec3 Eye;
  glm::dvec3 Ahead;               ///< of unit length
  std::array<glm::dvec3, 4> Near; ///< corners of the frustum, by the same edges
  std::array<glm::dvec3, 4> Far;

  Sight(vtkRenderer* renderer, const DepthMaps& maps)
    : Lowest(maps.GetLowest())
    , Highest(maps.GetHighest())
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    const double aspect = renderer->GetTiledAspectRatio();
    camera->GetFrustumPlanes(aspect, this->Planes);
    camera->GetPosition(&this->Eye.x);
    camera->GetDirectionOfProjection(&this->Ahead.x);
    glm::dmat4 toWorld; // VTK's matrices are by rows
    vtkMatrix4x4::Invert(*camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)->Element, &toWorld[0][0]);
    for (int edge = 0; edge < 4; ++edge)
    {
      const auto corner = [&](double z) {
        const glm::dvec4 at = glm::dvec4(edge % 2 * 2.0 - 1.0, edge / 2 * 2.0 - 1.0, z, 1.0) * toWorld;
        return glm::dvec3(at) / at.w;
      };
      this->Near[edge] = corner(-1.0);
      this->Far[edge] = corner(1.0);
    }
  }

  /// Whether some of a box is in the frustum, as far as its planes tell.
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

/// What is under the part of a frustum up to a distance from the eye on the plane, within the heights of all that is
/// shown: boxes between these heights are far taller than wide, and planes alone tell little of them.
class GroundCover::Footprint
{
public:
  Footprint(const Sight& sight, double distance)
  {
    const double rise =
      std::max(sight.Ahead.z * (sight.Lowest - sight.Eye.z), sight.Ahead.z * (sight.Highest - sight.Eye.z));
    const double depth = distance * glm::length(glm::dvec2(sight.Ahead)) + rise;
    for (int edge = 0; edge < 4; ++edge)
    {
      const double near = glm::dot(sight.Near[edge] - sight.Eye, sight.Ahead);
      const double far = glm::dot(sight.Far[edge] - sight.Eye, sight.Ahead);
      const double part = std::clamp((depth - near) / (far - near), 0.0, 1.0);
      this->Corners[2 * edge] = glm::dvec2(sight.Near[edge]);
      this->Corners[2 * edge + 1] = glm::dvec2(glm::mix(sight.Near[edge], sight.Far[edge], part));
    }
  }

  /// Whether a rectangle meets it: no line between two of its corners has the rectangle on one side and all corners on
  /// the other.
  bool Meets(const glm::dvec2& low, const glm::dvec2& high) const
  {
    for (std::size_t a = 0; a < this->Corners.size(); ++a)
    {
      for (std::size_t b = 0; b < this->Corners.size(); ++b)
      {
        const glm::dvec2 along = this->Corners[b] - this->Corners[a];
        const glm::dvec2 out(along.y, -along.x);
        const auto outside = [&](const glm::dvec2& point) { return glm::dot(out, point - this->Corners[a]); };
        const double nearest = std::min(out.x * low.x, out.x * high.x) + std::min(out.y * low.y, out.y * high.y) -
          glm::dot(out, this->Corners[a]);
        if (nearest > 0.0 && std::all_of(this->Corners.begin(), this->Corners.end(), [&](const glm::dvec2& corner) {
              return outside(corner) < nearest;
            }))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  std::array<glm::dvec2, 8> Corners;
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
void GroundCover::SetDensities(double herbs, double litter, double stones)
{
  this->Shares = { 1.0, 1.0, 1.0, herbs, herbs, litter, stones };
}

//----------------------------------------------------------------------------
std::vector<vtkProp*> GroundCover::GetProps() const
{
  std::vector<vtkProp*> props;
  for (const auto& elements : this->Elements)
  {
    props.push_back(elements);
  }
  return props;
}

//----------------------------------------------------------------------------
void GroundCover::Prepare(int layer, const DepthMaps& maps)
{
  const CoverTile& tile = Tiles[layer];
  vtkActor* actor = this->Elements[layer];
  GroundCoverMapper* mapper = this->Mappers[layer];
  mapper->MapDataArrayToVertexAttribute("coverFoot", "Foot", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  vtkNew<UniformCommand> uniforms;
  uniforms->Set = [this, &tile, &maps](vtkShaderProgram* program) { this->SetUniforms(program, tile, maps); };
  mapper->AddObserver(vtkCommand::UpdateShaderEvent, uniforms);
  actor->SetMapper(mapper);
  vtkLandscapePass::SetMaterial(actor, tile.HasOwnColor() ? vtkLandscapePass::Surface : vtkLandscapePass::Cover);
  vtkLandscapePass::SetTransmittance(actor, tile.Kind == CoverKind::Stone ? 0.0 : 0.4);
  vtkShaderProperty* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true,
    std::string(LandscapeNoise) + LandscapeGround + GroundCoverDec + "//VTK::Normal::Dec\n", false);
  shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, GroundCoverImpl, false);
}

//----------------------------------------------------------------------------
/// Has the mapper make cells beside those that it has, of which the graphics' memory is freed before; all of them where
/// this memory is not that of the processor.
void GroundCover::Make(int layer, const std::vector<int>& cells, vtkRenderWindow* window)
{
  CoverCells& made = this->Made[layer];
  const CoverCells before = made;
  for (const int cell : cells)
  {
    made[cell] = true;
  }
  if (made == before)
  {
    return;
  }
  if (!vtkLandscapePass::IsDrawnBySoftware(window))
  {
    made.fill(true);
  }
  this->Elements[layer]->ReleaseGraphicsResources(window);
  this->Mappers[layer]->SetMaker(
    [this, layer] { return CoverShapes(Tiles[layer], this->Made[layer], this->Ends[layer]); });
}

//----------------------------------------------------------------------------
/// How far elements reach from their feet [m]: blades are up to 1.2 times as high, and bend as far aside; stones are
/// 0.26 m wide.
double GroundCover::Margin() const
{
  return std::max(1.3 * this->Height, 0.26);
}

//----------------------------------------------------------------------------
bool GroundCover::IsCellSeen(
  const CoverTile& tile, int column, int row, const Sight& sight, const Footprint& footprint) const
{
  const double side = tile.Side * this->Radius;
  const double margin = this->Margin();
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
        sight.Sees({ low - margin, sight.Lowest }, { high + margin, sight.Highest }) &&
        footprint.Meets(low - margin, high + margin))
      {
        return true;
      }
    }
  }
  return false;
}

//----------------------------------------------------------------------------
std::vector<int> GroundCover::SeenCells(const CoverTile& tile, const Sight& sight) const
{
  const Footprint footprint(sight, tile.Reach * this->Radius + this->Margin());
  std::vector<int> seen;
  for (int cell = 0; cell < Cells * Cells; ++cell)
  {
    if (this->IsCellSeen(tile, cell % Cells, cell / Cells, sight, footprint))
    {
      seen.push_back(cell);
    }
  }
  return seen;
}

//----------------------------------------------------------------------------
/// The elements of cells: of each, the first ones.
std::vector<GroundCoverMapper::Run> GroundCover::RunsOf(int layer, const std::vector<int>& cells) const
{
  const std::vector<int>& ends = this->Ends[layer];
  std::vector<GroundCoverMapper::Run> runs;
  for (const int cell : cells)
  {
    if (runs.empty() || runs.back().To != ends[cell])
    {
      runs.push_back({ ends[cell], ends[cell] });
    }
    const int group = Tiles[layer].Group();
    const double groups = this->Shares[layer] * (ends[cell + 1] - ends[cell]) / group;
    runs.back().To = ends[cell] + group * static_cast<int>(groups);
  }
  return runs;
}

//----------------------------------------------------------------------------
void GroundCover::Draw(vtkRenderer* renderer, const DepthMaps& maps)
{
  Sight sight(renderer, maps);
  this->Eye = sight.Eye;
  if (this->Eye.z - sight.Highest > 2.0 * this->Radius)
  {
    return; // blades fade with the height of the eye
  }
  sight.Highest += this->Margin();
  for (int k = 0; k < Layers; ++k)
  {
    const CoverTile& tile = Tiles[k];
    const std::vector<int> cells = this->Shares[k] > 0.0 ? this->SeenCells(tile, sight) : std::vector<int>();
    if (cells.empty())
    {
      continue;
    }
    vtkActor* actor = this->Elements[k];
    if (!actor->GetMapper())
    {
      this->Prepare(k, maps);
    }
    this->Make(k, cells, renderer->GetRenderWindow());
    // Blades are relative to a corner of the tiles near the eye, so that single precision holds them.
    const double side = tile.Side * this->Radius;
    const auto corner = [&](double x) { return side * std::floor(x / side); };
    this->Anchor = { corner(this->Eye.x), corner(this->Eye.y), std::floor(this->Eye.z) };
    this->Mappers[k]->SetRuns(this->RunsOf(k, cells));
    actor->SetPosition(this->Anchor.x, this->Anchor.y, this->Anchor.z);
    actor->RenderOpaqueGeometry(renderer);
  }
}

//----------------------------------------------------------------------------
void GroundCover::SetUniforms(vtkShaderProgram* program, const CoverTile& tile, const DepthMaps& maps) const
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
  SetUniform(program, "coverTop", 2.0 * this->Radius);
  SetUniform(program, "coverHeight", this->Height);
  const Patches patches = PatchesOf(tile.Kind);
  SetUniform(program, "coverPatches", glm::dvec3(patches.Size, patches.From, patches.To));
  SetUniform(program, "coverSized", tile.HasOwnSize() ? 1 : 0);
  SetUniform(program, "coverLevel", this->SeaLevel - this->Anchor.z);
}

//----------------------------------------------------------------------------
void GroundCover::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& elements : this->Elements)
  {
    elements->ReleaseGraphicsResources(window);
  }
}

}
