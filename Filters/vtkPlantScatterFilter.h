// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlantScatterFilter
 * @brief   plants at sites, near ones in full, far ones in few polygons, none outside of the view
 *
 * Inputs: port 0, the sites (vtkPointSet; z counts where there is no terrain); port 1, a prototype for each species, as
 * the plant sources make them (vtkMultiBlockDataSet, or vtkPartitionedDataSetCollection whose assembly has the same
 * blocks, each part in one partition; any number of connections); port 2, optional, the terrain (vtkImageData of one
 * layer, point array `Elevation` or else the active scalars).
 *
 * Optional point arrays of the sites: `SiteId` (identity, to which random numbers belong; else the index of the site),
 * `Species` (index of the prototype), `Scale`, `Azimuth` [radians]. What is not given is drawn from the seed and the
 * site's identity alone, so a plant is the same whatever else is in the sites.
 *
 * Output 0: vtkMultiBlockDataSet with the blocks `High` {`Skeleton`, `Skin`, `Leaves`}, `Medium` {`Trunk`, `Crown`} and
 * `Low`, always all of them, each one vtkPolyData for all plants of its level, in single precision. Point arrays are
 * those that all prototypes have in the block, and `PlantId` (index of the site; on Skeleton as a cell array too).
 * `JointIds` and `ParentId` count the nodes of the merged Skeleton. Each plant is in exactly one level.
 *
 * Field data of output 0: the shown plants, arrays of one length `PlantId`, `SiteId`, `Species`, `Scale`, `Azimuth`,
 * `Position` [m] and `Level` (0 High, 1 Medium, 2 Low); and the counters `PlantsInAll`, `PlantsShown`, `PlantsHigh`,
 * `PlantsMedium`, `PlantsLow`, `CellsInAll`, `CellsShown` (cells that hold a plant), `PolygonsShown`, `PolygonsInAll`
 * (of all plants in full) and `OutputBytes`.
 *
 * Outputs 1 and 2: the pictures of the crowns and of the leaves of all species, one above the other (RGBA); texture
 * coordinates of Crown and Leaves point into them. They also travel as field data `Texture` and `TextureSize` of the
 * blocks. A species without a picture has a white area.
 *
 * Culling (Setas et al., section 4): the sites are sorted into a regular grid of cells; cells whose box the view does
 * not meet are left out, and all plants in the others are kept. The grid, and what stands where, is kept between
 * executions until sites, prototypes, terrain or a property that matters change.
 *
 * Sizes of the pictures are known before the prototypes are made where their sources announce them by
 * vtkPlantSource::TEXTURE_SIZES(), which other filters pass on, and where the data are there already. Else they are
 * known after an execution: update this filter before filters that process one of these images.
 *
 * A piece reads all sites and makes the plants whose index is in its share.
 */
#ifndef vtkPlantScatterFilter_h
#define vtkPlantScatterFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkViewDependentAlgorithm.h"

#include <memory> // for what is kept between executions
#include <vector> // for the weights

class LITTORALFILTERS_EXPORT vtkPlantScatterFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkPlantScatterFilter* New();
  vtkTypeMacro(vtkPlantScatterFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Any whole number; another seed gives other species, sizes, azimuths and colors. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// How common a prototype is among the others, not negative; not all may be 0. Default 1 for each.
  void SetWeight(int prototype, double weight);
  double GetWeight(int prototype);
  void ClearWeights();
  ///@}

  ///@{
  /// Standard deviation of the size as part of the prototype's, 0 to 0.45; deviations end at twice that. Default 0.15.
  vtkSetMacro(ScaleVariation, double);
  vtkGetMacro(ScaleVariation, double);
  ///@}

  ///@{
  /// Standard deviation of the brightness of a plant's leaves and crown, 0 to 0.45; their warmth varies too. Default
  /// 0.08.
  vtkSetMacro(TintVariation, double);
  vtkGetMacro(TintVariation, double);
  ///@}

  ///@{
  /// Steepest ground on which a plant stands [degrees], 0 to 90, if there is a terrain. Default 90: any.
  vtkSetMacro(SlopeLimit, double);
  vtkGetMacro(SlopeLimit, double);
  ///@}

  ///@{
  /// Lowest and highest ground on which a plant stands [m]. Default -1e30 1e30: any.
  vtkSetVector2Macro(HeightRange, double);
  vtkGetVector2Macro(HeightRange, double);
  ///@}

  ///@{
  /// Whether far plants are shown in less detail; else all are High. Default on.
  vtkSetMacro(UseLevels, bool);
  vtkGetMacro(UseLevels, bool);
  vtkBooleanMacro(UseLevels, bool);
  ///@}

  ///@{
  /// Whether cells outside of the view are left out. Default on.
  vtkSetMacro(UseCells, bool);
  vtkGetMacro(UseCells, bool);
  vtkBooleanMacro(UseCells, bool);
  ///@}

  ///@{
  /// About how many plants a cell holds, positive. Default 1.
  vtkSetMacro(PlantsPerCell, double);
  vtkGetMacro(PlantsPerCell, double);
  ///@}

  ///@{
  /// Distance from the eye, or from its plane in parallel projection, beyond which no plant is shown [m], not negative.
  /// Default 0: no limit.
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  /// Disconnects all prototypes.
  void RemoveAllPrototypes() { this->RemoveAllInputConnections(1); }

protected:
  vtkPlantScatterFilter();
  ~vtkPlantScatterFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Seed;
  double ScaleVariation;
  double TintVariation;
  double SlopeLimit;
  double HeightRange[2];
  bool UseLevels;
  bool UseCells;
  double PlantsPerCell;
  double MaximumDistance;

private:
  vtkPlantScatterFilter(const vtkPlantScatterFilter&) = delete;
  void operator=(const vtkPlantScatterFilter&) = delete;

  class Internals; // what is kept between executions
  struct Request;

  bool CheckProperties();
  bool RememberPrototypes(vtkInformationVector* prototypes);
  bool RememberPlaces(vtkInformationVector** inputs);
  bool Merge(const Request& request, vtkMultiBlockDataSet* output);

  std::vector<double> Weights;
  std::unique_ptr<Internals> Internal;
};

#endif
