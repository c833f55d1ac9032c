// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGroundCover_h
#define LittoralGroundCover_h

#include "CoverShapes.h"
#include "GroundCoverMapper.h"

#include "vtkNew.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

class vtkActor;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkWindow;

namespace littoral
{

class DepthMaps;

/**
 * Grass around the eye, and herbs, flowers, litter and stones in it. They are in square tiles that are repeated over
 * the plane, of dense blades near the eye and of sparser and broader ones farther off; the vertex shader moves each
 * element to the copy that is nearest to the eye and onto the ground, whose height it reads from a map of depths seen
 * from the zenith. So they cost the same on any ground. Tiles have square cells; those that the picture does not show
 * are not drawn, nor made where a processor draws until one shows them.
 */
class GroundCover
{
public:
  GroundCover();
  ~GroundCover();

  /// Height of blades [m], distance to which they are drawn [m]; an eye twice as high over the ground sees none.
  void SetSize(double height, double radius);

  /// Parts of the herbs and flowers, the fallen leaves and the stones of the tiles that are drawn, 0 to 1.
  void SetDensities(double herbs, double litter, double stones);

  /// Height of a sea, in which none grow [m].
  void SetSeaLevel(double level) { this->SeaLevel = level; }

  /// Draws the blades around the camera with the map of the ground, whose texture is bound.
  void Draw(vtkRenderer* renderer, const DepthMaps& maps);

  std::vector<vtkProp*> GetProps() const;
  void ReleaseGraphicsResources(vtkWindow* window);

  struct Sight;
  class Footprint;
  static constexpr int Layers = 7;

private:
  void Prepare(int layer, const DepthMaps& maps);
  void Make(int layer, const std::vector<int>& cells, vtkRenderWindow* window);
  double Margin() const;
  bool IsCellSeen(const CoverTile& tile, int column, int row, const Sight& sight, const Footprint& footprint) const;
  std::vector<int> SeenCells(const CoverTile& tile, const Sight& sight) const;
  std::vector<GroundCoverMapper::Run> RunsOf(int layer, const std::vector<int>& cells) const;
  void SetUniforms(vtkShaderProgram* program, const CoverTile& tile, const DepthMaps& maps) const;

  std::array<vtkNew<vtkActor>, Layers> Elements;
  std::array<vtkNew<GroundCoverMapper>, Layers> Mappers;
  std::array<CoverCells, Layers> Made{};     ///< cells that the mapper has
  std::array<std::vector<int>, Layers> Ends; ///< of the elements of each cell, and a 0 before the first
  std::array<double, Layers> Shares{};       ///< of the elements that are drawn
  double Height = 0.0;
  double Radius = 0.0;
  double SeaLevel = -1e9;
  glm::dvec3 Eye = glm::dvec3(0.0);    ///< of the picture that is drawn
  glm::dvec3 Anchor = glm::dvec3(0.0); ///< place to which the tile that is drawn is relative
};

}

#endif
