// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlantScatterFilter
 * @brief   place plants on sites with levels of detail and culling
 *
 * Inputs: port 0, the sites (vtkPointSet; z is used where there is no terrain); port 1, a prototype per species from
 * the plant sources (vtkMultiBlockDataSet, or vtkPartitionedDataSetCollection whose assembly has the same blocks, each
 * part in one partition; any number of connections); port 2, optional, the terrain (vtkImageData of one layer, point
 * array `Elevation` [m] or else the active scalars).
 *
 * Optional point arrays of the sites: `SiteId` (identity, which determines the random numbers; else the index of the
 * site), `Species` (index of the prototype), `Scale`, `Azimuth` [rad], `Height` [m] and `DBH` [m], see UseDimensions.
 * Missing values are random functions of the seed
 * and the identity of the site alone, so a plant does not depend on the other sites.
 *
 * Output 0: vtkMultiBlockDataSet with the blocks `High` {`Skeleton`, `Skin`, `Leaves`}, `Medium` {`Trunk`, `Crown`} and
 * `Low`, always all of them, each one vtkPolyData for all plants of its level, in single precision. Point arrays are
 * those that all prototypes have in the block, and `PlantId` (index of the site; also a cell array of Skeleton).
 * `JointIds` and `ParentId` refer to the nodes of the merged Skeleton. Each plant is in exactly one level.
 *
 * Field data of output 0: arrays with a value per shown plant: `PlantId`, `SiteId`, `Species`, `Scale`, `Azimuth`
 * [rad], `Position` [m] and `Level` (0 High, 1 Medium, 2 Low), and `WidthScale` (factor of the width beside Scale) if a
 * site has DBH and Height, and `Tint` (factors of red, green and blue, for all but the wood) if surfaces are not
 * passed; and the counters `PlantsInAll`, `PlantsShown`, `PlantsHigh`, `PlantsMedium`, `PlantsLow`, `CellsInAll`,
 * `CellsShown` (cells that hold a plant), `PolygonsShown`, `PolygonsInAll` (of all plants in full) and `OutputBytes`
 * (without textures).
 *
 * `Leaves`, `Crown` and `Low` carry the textures of all species, one above the other, as field data like those of the
 * prototypes (see vtkPlantSource), and texture coordinates refer to them; a species without a texture has a white area.
 * Where the prototypes have another TextureMean each, texels are scaled to the smallest. Low is one rectangle a plant
 * that faces the camera, with the picture of the prototype from the nearest direction, see FaceCamera; other
 * prototypes' Low, as that of seaweed, is copied.
 *
 * Outputs 1 and 2: vtkImageData, the textures of Crown and Leaves.
 *
 * With OutputForm Instances, output 0 has the block `Instances`, a vertex for each shown plant at its foot, with the
 * point arrays `Prototype` (1 + 3 Species + Level, the index of another block), `Rotation` (quaternion w, x, y, z),
 * `Scale` (one value, or x, y and z if a site has DBH and Height), `Tint` (factors of red, green and blue, for all but
 * the wood), `PlantId`, `SiteId`, `Species` and `Level`; and then a block for each level of each prototype, as it is
 * there: `0 High` {`Skin`, `Leaves`}, `0 Medium` {`Trunk`, `Crown`}, `0 Low` {`Low`}, `1 High` and so on. Their parts
 * have the field arrays `Prototype`, the same index, and `Tinted` and `Seaweed`, 0 or 1; with levels, the points have
 * the field array `FarDistance` [m]; they have `CoordinateSystem`, `CoordinateUnit` and `CoordinateOffset` of the
 * terrain, or else of the sites, where these have them (see vtkElevationReader). A plant is its prototype scaled,
 * rotated and moved to the point, as vtkGlyph3DMapper does with SourceIndexing, this output as SourceTableTree,
 * quaternions, and three scales by components. The counters are field data, as of merged plants.
 *
 * Culling (Setas et al., section 4): the sites are sorted into a regular grid of cells; cells whose bounding box is
 * outside the view frustum are left out, and all plants in the others are kept. The grid and the plants' positions are
 * kept between executions until sites, prototypes, terrain or a relevant property change.
 *
 * The sizes of the textures are known before the prototypes are made where their sources announce them by
 * vtkPlantSource::TEXTURE_SIZES(), which other filters pass on, and where the data are there already. Else they are
 * known after an execution: update this filter before filters that process one of these images.
 *
 * A piece has the plants of its cells, about as many as any other. Ranks that are asked for a piece each share the
 * sites of vtkQuadratPointSource where these come directly: each reads a run of them, and deals out the plants in the
 * cells of others, which are few. Else a piece reads all sites, and the first one looks whether all of
 * them can have a plant. Prototypes and the terrain are whole on each rank; where ranks share the sites, and all plant
 * sources have changed on all of them, each draws some of the pictures from afar, and gets those of the others, 86 kB
 * each. Defaults of inherited properties: NearDistance 30 m, FarDistance 130 m. A property or a site value out of
 * range, or a site beyond the terrain, is reported as one error.
 */
#ifndef vtkPlantScatterFilter_h
#define vtkPlantScatterFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkViewDependentAlgorithm.h"

#include <memory> // for what is kept between executions
#include <vector> // for the weights

class vtkFieldData;

namespace littoral
{
class RankTeam;
struct WorkShare;
}

class LITTORALFILTERS_EXPORT vtkPlantScatterFilter : public vtkViewDependentAlgorithm
{
public:
  static vtkPlantScatterFilter* New();
  vtkTypeMacro(vtkPlantScatterFilter, vtkViewDependentAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1. Another seed gives other species, sizes, azimuths and colors.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Relative frequency of a prototype, not negative; default 1 for each. At least one must be positive.
   */
  void SetWeight(int prototype, double weight);
  double GetWeight(int prototype);
  void ClearWeights();
  ///@}

  ///@{
  /**
   * Standard deviation of the plant size relative to the prototype, 0 to 0.45; default 0.15. Deviations are truncated
   * at two standard deviations.
   */
  vtkSetMacro(ScaleVariation, double);
  vtkGetMacro(ScaleVariation, double);
  ///@}

  ///@{
  /**
   * Trees with the dimensions of their sites, where the sites have the arrays HeightArray or DiameterArray; default on.
   * The highest point of a plant is then its height above the foot, and the girth of its stem 1.3 m above the foot is
   * pi times its diameter; in a tree lower than 2.6 m the stem is measured at half the height. Scale and
   * ScaleVariation do not count. With both arrays a plant is its prototype scaled by one factor in height and another
   * in width; with one of them it keeps the proportions of its prototype. Both hold for the
   * polygons of High and Medium; a plant in Low has the factors of High.
   */
  vtkSetMacro(UseDimensions, bool);
  vtkGetMacro(UseDimensions, bool);
  vtkBooleanMacro(UseDimensions, bool);
  ///@}

  ///@{
  /**
   * Name of the point array of the sites that holds heights of trees [m], positive and at most 150 m; default `Height`.
   */
  vtkSetStringMacro(HeightArray);
  vtkGetStringMacro(HeightArray);
  ///@}

  ///@{
  /**
   * Name of the point array of the sites that holds diameters at breast height [m], positive and at most 20 m; default
   * `DBH`.
   */
  vtkSetStringMacro(DiameterArray);
  vtkGetStringMacro(DiameterArray);
  ///@}

  ///@{
  /**
   * Standard deviation of the brightness of leaves and crown between plants, 0 to 0.45; default 0.08. The color
   * temperature varies too.
   */
  vtkSetMacro(TintVariation, double);
  vtkGetMacro(TintVariation, double);
  ///@}

  ///@{
  /**
   * Maximum slope of the ground at a plant [degrees], 0 to 90; default 90, no limit. Used only with a terrain.
   */
  vtkSetMacro(SlopeLimit, double);
  vtkGetMacro(SlopeLimit, double);
  ///@}

  ///@{
  /**
   * Minimum and maximum elevation of the ground at a plant [m], not decreasing; default -1e30 1e30, no limits.
   */
  vtkSetVector2Macro(HeightRange, double);
  vtkGetVector2Macro(HeightRange, double);
  ///@}

  ///@{
  /**
   * Levels of detail depending on the distance from the camera; default on. If off, all plants are High.
   */
  vtkSetMacro(UseLevels, bool);
  vtkGetMacro(UseLevels, bool);
  vtkBooleanMacro(UseLevels, bool);
  ///@}

  ///@{
  /**
   * Culling of cells outside the view frustum; default on.
   */
  vtkSetMacro(UseCulling, bool);
  vtkGetMacro(UseCulling, bool);
  vtkBooleanMacro(UseCulling, bool);
  ///@}

  ///@{
  /**
   * Far plants as one rectangle each that faces the camera, with the picture of the plant from there; default on. If
   * off, they are the Low of their prototypes, which looks the same from all sides and does not depend on the view:
   * for a forest that is written to a file.
   */
  vtkSetMacro(FaceCamera, bool);
  vtkGetMacro(FaceCamera, bool);
  vtkBooleanMacro(FaceCamera, bool);
  ///@}

  /// Forms of output 0.
  enum OutputFormType
  {
    Merged = 0,
    Instances = 1
  };

  ///@{
  /**
   * Plants merged into a block for each part of each level, or as instances: points that refer to blocks
   * of prototypes; default Merged. Instances take 84 bytes a plant, or 92 with dimensions, and far ones are the Low of
   * their prototypes whatever FaceCamera is.
   */
  vtkSetMacro(OutputForm, int);
  vtkGetMacro(OutputForm, int);
  void SetOutputFormToMerged() { this->SetOutputForm(Merged); }
  void SetOutputFormToInstances() { this->SetOutputForm(Instances); }
  ///@}

  ///@{
  /**
   * Whether merged plants have `JointIds` and `JointWeights`, 32 bytes a vertex in full; default on. If off,
   * vtkBeamTreeDeformationFilter takes those of its prototypes, and moves plants alike.
   */
  vtkSetMacro(PassJoints, bool);
  vtkGetMacro(PassJoints, bool);
  vtkBooleanMacro(PassJoints, bool);
  ///@}

  ///@{
  /**
   * Whether merged plants of the levels High and Medium have their surfaces; default on. If off, their skins, leaves,
   * trunks and crowns are empty blocks, the table has `Tint`, and vtkBeamTreeDeformationFilter makes the surfaces of
   * its prototypes and moves plants alike, without a copy of them at rest.
   */
  vtkSetMacro(PassSurfaces, bool);
  vtkGetMacro(PassSurfaces, bool);
  vtkBooleanMacro(PassSurfaces, bool);
  ///@}

  ///@{
  /**
   * Mean number of plants per culling cell, positive; default 1.
   */
  vtkSetMacro(PlantsPerCell, double);
  vtkGetMacro(PlantsPerCell, double);
  ///@}

  ///@{
  /**
   * Distance from the camera, or from its plane in parallel projection, beyond which no plant is shown [m], not
   * negative; default 0, no limit.
   */
  vtkSetMacro(VisibleDistance, double);
  vtkGetMacro(VisibleDistance, double);
  ///@}

  /// Connects the terrain, port 2.
  void SetTerrainConnection(vtkAlgorithmOutput* terrain) { this->SetInputConnection(2, terrain); }

  /// Removes the connection of port 2, the terrain.
  void RemoveTerrain() { this->RemoveAllInputConnections(2); }

  /// Adds a prototype, to port 1.
  void AddPrototypeConnection(vtkAlgorithmOutput* prototype) { this->AddInputConnection(1, prototype); }

  /// Removes all connections of port 1, the prototypes.
  void RemoveAllPrototypes() { this->RemoveAllInputConnections(1); }

protected:
  vtkPlantScatterFilter();
  ~vtkPlantScatterFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool DependsOnDirection() const override;

  int Seed;
  double ScaleVariation;
  bool UseDimensions;
  char* HeightArray;
  char* DiameterArray;
  double TintVariation;
  double SlopeLimit;
  double HeightRange[2];
  bool UseLevels;
  bool UseCulling;
  bool FaceCamera;
  int OutputForm;
  bool PassJoints;
  bool PassSurfaces;
  double PlantsPerCell;
  double VisibleDistance;

private:
  vtkPlantScatterFilter(const vtkPlantScatterFilter&) = delete;
  void operator=(const vtkPlantScatterFilter&) = delete;

  class vtkInternals; // what is kept between executions
  struct Request;

  void CheckProperties();
  void CheckSites(vtkInformationVector* inputs);
  void RememberPrototypes(vtkInformationVector* prototypes);
  void RememberPlaces(vtkInformationVector** inputs, vtkInformation* output, const littoral::WorkShare& share);
  void RememberShared(vtkInformationVector** inputs, vtkInformation* output, littoral::RankTeam& team);
  void Merge(const Request& request, vtkMultiBlockDataSet* output);
  void AddInstances(const Request& request, vtkMultiBlockDataSet* output);
  void WriteCounters(const Request& request, double polygons, double bytes, vtkFieldData* fields) const;

  std::vector<double> Weights;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
