// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkForestDensityFilter
 * @brief   leaf area, plant area and bulk density of a stand in cells
 *
 * Input, port 0, the stand, in one of three forms:
 * - plants as blocks (vtkMultiBlockDataSet or vtkPartitionedDataSetCollection): one of a plant source, or those of
 *   vtkPlantScatterFilter, all of them in the level High. A leaf is a polygon of High/Leaves, times the part of it that
 *   its picture covers: texels of an opacity of at least a half, where renderers cut a leaf out.
 * - instances of vtkPlantScatterFilter, whose leaves are those of the level High, whatever their level; switch
 * UseLevels off where sites have DBH, since the widths of far plants differ by some percent.
 * - trees without leaves (vtkPointSet), as of vtkStandInventoryFilter: point arrays `Height` [m], `CrownDiameter` [m]
 * or else `DBH` [m], and optionally `LeafArea` [m2] and `Species`. A tree is an upright cylinder with the leaf area
 *   `LeafArea`, else that of LeafAreaIndex, else that of its DBH (Jenkins et al. 2003); its density follows Lalic and
 *   Mihailovic (2004) along the height.
 *
 * Input, port 1, optional: a vtkImageData whose cells are those of the output, in place of Bounds and CellSize.
 *
 * Output 0: vtkImageData with cell arrays (float): a density is that of a cell, so that the sum of densities times the
 * volume of a cell is the amount within the image. `LeafAreaDensity` [m2/m3], one-sided; `PlantAreaDensity` [m2/m3],
 * the same and half the surface of the wood; `BulkDensity` [kg/m3], the dry mass of the leaves; with BySpecies also
 * `LeafAreaDensity NAME` for each species. Field data: `LeafArea` [m2] and `LeafMass` [kg] in the image,
 * `LeafAreaOutside` [m2] of it, `LeafAreaIndex`, the first over the area of the image, `SpeciesNames` with their
 * `LeafMassPerArea` [kg/m2], and with HeightsAboveGround an array of that name.
 *
 * Output 1: vtkTable, a row a layer of the image, the highest first: `Height` of its middle [m], `LeafAreaDensity` and
 * `PlantAreaDensity` [m2/m3] over the whole layer, and `CumulativeLeafArea` [m2/m2] down to its lower face.
 *
 * Output 2: vtkTable, a row for each angle from 0 to 85 degrees: `ZenithAngle` [degrees], `Projection` G of a unit of
 * leaf area, measured by the leaves' own normals, `GapFraction`, the mean of exp(-G times the leaf area density along a
 * line) over lines through the image, which repeats itself sideways, `RandomGapFraction` exp(-G LAI / cos t), and
 * `Clumping` ln(GapFraction) / ln(RandomGapFraction).
 *
 * Output 3: vtkPolyData, a vertex for each plant, at its foot, with `Height` and `CrownDiameter` [m], `LeafArea` [m2],
 * `LeafAreaIndex` of the crown, `MaximumHeight`, z_m over the height of the profile of Lalic and Mihailovic whose
 * leaves have the mean height of its own, `Species`, and `PlantId`, its number in the stand. The diameter is that of
 * the cylinder around its leaves.
 *
 * Leaves beyond the image are left out. A stand none of whose leaves is in the image, a stand without leaf area, plants
 * out of view or without their leaves, a number that is not finite, and a property out of range are reported as one
 * error. Numbers are those of the whole stand, whatever part is asked for, and the same on any number of threads.
 *
 * Ranks of the global controller that are asked for a piece each share a stand of instances: each counts its own
 * plants, and they exchange the sums of the cells that have any, 16 bytes a sum; output 3 has the own plants on each
 * rank. Of other stands each rank counts all, and the first one has output 3. Tables are on the first.
 *
 * Leaf mass per area follows the names of SpeciesNames, see LeafMassPerArea.
 */
#ifndef vtkForestDensityFilter_h
#define vtkForestDensityFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for std::unique_ptr

namespace littoral
{
struct WorkShare;
}

class LITTORALFILTERS_EXPORT vtkForestDensityFilter : public vtkImageAlgorithm
{
public:
  static vtkForestDensityFilter* New();
  vtkTypeMacro(vtkForestDensityFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Bounds of the image, as minimum and maximum x, y and z [m], increasing; default 0 100 0 100 0 30. They are rounded
   * up to whole cells. Used only without a Grid.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Sides of a cell along x, y and z [m], positive; default 2 2 2. Used only without a Grid.
   */
  vtkSetVector3Macro(CellSize, double);
  vtkGetVector3Macro(CellSize, double);
  ///@}

  ///@{
  /**
   * An array of leaf area density for each species; default off.
   */
  vtkSetMacro(BySpecies, bool);
  vtkGetMacro(BySpecies, bool);
  vtkBooleanMacro(BySpecies, bool);
  ///@}

  ///@{
  /**
   * Names of the species, in the order of the prototypes, separated by semicolons; default empty: the `Kinds` of an
   * inventory, else `Species 0` and so on.
   */
  vtkSetStringMacro(SpeciesNames);
  vtkGetStringMacro(SpeciesNames);
  ///@}

  ///@{
  /**
   * Dry mass of the leaves of all species over their one-sided area [kg/m2], 0 to 1; default 0, by the names of the
   * species: pine 0.161, spruce 0.202, birch 0.0738 (Majasalmi et al. 2013), larch 0.0855 (Dirnberger et al. 2016), oak
   * 0.080 (Meir et al. 2002), all others 0.0686 (Niinemets and Kull 1994, the mean of 85 woody species).
   */
  vtkSetMacro(LeafMassPerArea, double);
  vtkGetMacro(LeafMassPerArea, double);
  ///@}

  enum DetailType
  {
    Automatic = 0,
    Leaves = 1,
    Parcels = 2,
  };

  ///@{
  /**
   * The way instances are counted, a DetailType; default Automatic: Leaves, where all plants together have at most 20
   * million triangles, else Parcels. Leaves: each leaf is cut at the faces of the cells. Parcels: leaves of a plant
   * that lie together in two thirds of a cell are one box, for a million trees; totals are as exact, places within a
   * cell.
   */
  vtkSetMacro(Detail, int);
  vtkGetMacro(Detail, int);
  void SetDetailToAutomatic() { this->SetDetail(Automatic); }
  void SetDetailToLeaves() { this->SetDetail(Leaves); }
  void SetDetailToParcels() { this->SetDetail(Parcels); }
  ///@}

  ///@{
  /**
   * Leaf area over the area below the crown, of trees without leaves and without the array LeafArea, 0 to 30; default
   * 0, by the diameter of the stem.
   */
  vtkSetMacro(LeafAreaIndex, double);
  vtkGetMacro(LeafAreaIndex, double);
  ///@}

  ///@{
  /**
   * Height of the largest leaf area density of trees without leaves, over the height of the tree, 0.05 to 0.95; default
   * 0.7. Lalic and Mihailovic's forests have 0.4 to 0.84.
   */
  vtkSetMacro(MaximumHeight, double);
  vtkGetMacro(MaximumHeight, double);
  ///@}

  ///@{
  /**
   * Heights above the ground: z of the image is that above the foot of each plant, as codes on terrain-following grids
   * take it (PALM's lad); default off, the z of the stand. All feet are then at z = 0, in the output of plants too.
   */
  vtkSetMacro(HeightsAboveGround, bool);
  vtkGetMacro(HeightsAboveGround, bool);
  vtkBooleanMacro(HeightsAboveGround, bool);
  ///@}

  /// Connects an image whose cells those of the output are, port 1.
  void SetGridConnection(vtkAlgorithmOutput* grid) { this->SetInputConnection(1, grid); }

  /// Removes the connection of port 1, the grid.
  void RemoveGrid() { this->RemoveAllInputConnections(1); }

protected:
  vtkForestDensityFilter();
  ~vtkForestDensityFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Bounds[6];
  double CellSize[3];
  bool BySpecies;
  char* SpeciesNames;
  double LeafMassPerArea;
  int Detail;
  double LeafAreaIndex;
  double MaximumHeight;
  bool HeightsAboveGround;

private:
  vtkForestDensityFilter(const vtkForestDensityFilter&) = delete;
  void operator=(const vtkForestDensityFilter&) = delete;

  struct Frame;
  class vtkInternals;

  void CheckProperties() const;
  Frame FrameOf(vtkInformationVector* grids) const;
  bool Keeps(vtkInformation* request, vtkInformationVector* outputs);
  std::unique_ptr<vtkInternals> Measure(
    vtkInformationVector** inputs, const littoral::WorkShare& share, bool hasTables);
  std::unique_ptr<vtkInternals> MeasureShared(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs);
  void Write(const vtkInternals& made, vtkInformationVector* outputs, bool hasTables);

  std::unique_ptr<vtkInternals> Shared;
};

#endif
