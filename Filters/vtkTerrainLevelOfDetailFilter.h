// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainLevelOfDetailFilter
 * @brief   show a terrain in tiles whose resolution depends on the view
 *
 * Input: a vtkImageData of one layer with a scalar point array of elevations [m] (SetInputArrayToProcess; default
 * `Elevation`, else the active scalars, also where an absent Elevation is chosen by name). Where it is NaN there is a
 * hole: triangles with such a point are left out, and tiles with such points are shown at level 0.
 *
 * Output: a vtkMultiBlockDataSet of vtkPolyData: `Level0` (all samples), `Level1` (every second sample) and so on, and
 * `Seams`, vertical triangles that close the gaps between tiles of different levels, as Setas et al. propose in section
 * 4.1.1. Point arrays: `Elevation` (float) [m], `Normals` (of the full resolution, at any level), `TCoords` (0 to 1
 * over the terrain), `RGB` (see GroundColors), and the other numeric point arrays of the input. Cell array: `Level`,
 * for a seam that of the coarser side. Field data: `TilesShown`, `TilesInAll`, `PolygonsShown`, `PolygonsAtFullDetail`,
 * `MaximumScreenError` [pixels] (an upper bound of the distance on the screen between the surface shown and the
 * samples; infinite where a coarse tile reaches the camera).
 *
 * What does not depend on the view is kept until the input changes. Piece 0 holds the whole output, other pieces are
 * empty. Defaults of inherited properties: NearDistance 250 m, FarDistance 4000 m. A property out of range, an image of
 * several layers or without a positive spacing, or an elevation that is infinite or NaN everywhere, is reported as one
 * error.
 *
 * @sa vtkViewDependentAlgorithm
 */
#ifndef vtkTerrainLevelOfDetailFilter_h
#define vtkTerrainLevelOfDetailFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkViewDependentAlgorithm.h"

#include <memory> // for what is kept

class vtkDataArray;
class vtkImageData;

namespace littoral
{
struct TerrainRule;
}

class LITTORALFILTERS_EXPORT vtkTerrainLevelOfDetailFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkTerrainLevelOfDetailFilter* New();
  vtkTypeMacro(vtkTerrainLevelOfDetailFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SelectionType
  {
    Distance = 0,
    PixelErrorRule
  };

  ///@{
  /**
   * Criterion for the level of a tile, a SelectionType; default PixelErrorRule. Distance: level 0 up to NearDistance, the
   * coarsest level from FarDistance, and transitions at equal ratios of distance between. PixelErrorRule: the coarsest
   * level whose screen-space error is at most PixelError.
   */
  vtkSetMacro(Selection, int);
  vtkGetMacro(Selection, int);
  void SetSelectionToDistance() { this->SetSelection(Distance); }
  void SetSelectionToPixelError() { this->SetSelection(PixelErrorRule); }
  ///@}

  ///@{
  /**
   * Maximum screen-space error of a tile [pixels], positive; default 1. Used only if Selection is PixelErrorRule.
   */
  vtkSetMacro(PixelError, double);
  vtkGetMacro(PixelError, double);
  ///@}

  ///@{
  /**
   * Number of resolution levels, 1 to 8; default 5. Each level has half the samples per side of the previous one;
   * levels with cells larger than a tile are not used.
   */
  vtkSetMacro(NumberOfLevels, int);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /**
   * Number of cells along the side of a tile, a power of two, 1 to 4096; default 32.
   */
  vtkSetMacro(TileSize, int);
  vtkGetMacro(TileSize, int);
  ///@}

  ///@{
  /**
   * Culling of tiles outside the view frustum; default on.
   */
  vtkSetMacro(UseCulling, bool);
  vtkGetMacro(UseCulling, bool);
  vtkBooleanMacro(UseCulling, bool);
  ///@}

  ///@{
  /**
   * Addition of the point array `RGB`, the ground colors of a temperate landscape; default on. Meadows are green,
   * lush beside water where the input has the array `DrainageArea` [m^2]; ground where the input array `Reflectance` is
   * high has dry grass, steep ground is rock. An array `RGB` of the input has priority.
   */
  vtkSetMacro(GroundColors, bool);
  vtkGetMacro(GroundColors, bool);
  vtkBooleanMacro(GroundColors, bool);
  ///@}

protected:
  vtkTerrainLevelOfDetailFilter();
  ~vtkTerrainLevelOfDetailFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Selection;
  double PixelError;
  int NumberOfLevels;
  int TileSize;
  bool UseCulling;
  bool GroundColors;

private:
  vtkTerrainLevelOfDetailFilter(const vtkTerrainLevelOfDetailFilter&) = delete;
  void operator=(const vtkTerrainLevelOfDetailFilter&) = delete;

  void CheckProperties();
  vtkDataArray* FindHeights(vtkImageData* image, vtkInformationVector** inputVector);
  void CheckHeights(vtkDataArray* heights);
  void UpdatePyramid(vtkImageData* image, vtkDataArray* heights);

  class vtkInternals;
  littoral::TerrainRule MakeRule() const;

  std::unique_ptr<vtkInternals> Internals;
};

#endif
