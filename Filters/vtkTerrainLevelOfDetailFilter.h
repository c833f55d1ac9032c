// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainLevelOfDetailFilter
 * @brief   terrain in tiles, each as fine as the view needs
 *
 * Input: a vtkImageData of one layer with a scalar point array of heights [m] (SetInputArrayToProcess; default
 * `Elevation`, else the active scalars), all finite.
 *
 * Output: a vtkMultiBlockDataSet of vtkPolyData: `Level0` (all samples), `Level1` (every second) and so on, and
 * `Seams`, the vertical triangles that close the gaps between tiles of different levels, as Setas et al. propose in
 * section 4.1.1. Point arrays: `Elevation` (float) [m], `Normals` (of the full resolution, at any level), `TCoords`
 * (0 to 1 over the terrain), `RGB` (see GroundColors), and the other numeric point arrays of the input. Cell array:
 * `Level`, for a seam that of the coarser side. Field data: `TilesShown`, `TilesInAll`, `PolygonsShown`,
 * `PolygonsAtFullDetail`, `LargestScreenError` [pixels] (a bound of what is shown, for the farthest that any place is
 * on the screen from where the samples have it; infinite where a coarse tile reaches to the eye).
 *
 * What does not depend on the view is kept until the input changes. Piece 0 holds all, other pieces are empty.
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

  enum SelectionRules
  {
    Distance = 0,
    ScreenErrorRule
  };

  ///@{
  /// What decides on the level of a tile. Distance: level 0 to NearDistance, the coarsest from FarDistance on, changes
  /// at equal ratios of distance between. ScreenErrorRule: the coarsest level whose error is at most ScreenError.
  /// Default Distance.
  vtkSetMacro(Selection, int);
  vtkGetMacro(Selection, int);
  ///@}

  ///@{
  /// How far a level may be from the samples, anywhere on the screen [pixels], positive; of effect with
  /// ScreenErrorRule. Default 1.
  vtkSetMacro(ScreenError, double);
  vtkGetMacro(ScreenError, double);
  ///@}

  ///@{
  /// Levels of the pyramid, 1 to 8, of which those with cells larger than a tile do not count. Default 5.
  vtkSetMacro(NumberOfLevels, int);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /// Cells along the side of a tile, a power of two, 1 to 4096. Default 32.
  vtkSetMacro(TileSize, int);
  vtkGetMacro(TileSize, int);
  ///@}

  ///@{
  /// Whether tiles that the view cannot show are left out. Default on.
  vtkSetMacro(Cull, bool);
  vtkGetMacro(Cull, bool);
  vtkBooleanMacro(Cull, bool);
  ///@}

  ///@{
  /// Adds the point array `RGB`, the colors of a temperate country: meadow, dry grass where the array `Reflectance` of
  /// the input is high, rock where it is steep. An array `RGB` of the input goes before. Default on.
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
  double ScreenError;
  int NumberOfLevels;
  int TileSize;
  bool Cull;
  bool GroundColors;

private:
  vtkTerrainLevelOfDetailFilter(const vtkTerrainLevelOfDetailFilter&) = delete;
  void operator=(const vtkTerrainLevelOfDetailFilter&) = delete;

  bool CheckProperties();
  vtkDataArray* FindHeights(vtkImageData* image, vtkInformationVector** inputVector);
  bool UpdatePyramid(vtkImageData* image, vtkDataArray* heights);

  struct Internals;
  littoral::TerrainRule MakeRule() const;

  std::unique_ptr<Internals> Internal;
};

#endif
