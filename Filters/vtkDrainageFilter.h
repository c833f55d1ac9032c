// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDrainageFilter
 * @brief   carve a terrain until it drains, and find its rivers
 *
 * Input 0: a vtkImageData of one layer, at least 3 x 3, with a scalar point array, the elevation [m]
 * (SetInputArrayToProcess; default the active scalars, which also stand in for an absent `Elevation`), not constant.
 * Each value is the height of a cell. Missing values (NaN) are outside the terrain: no water comes from there, all
 * statistics leave them out, and they stay NaN. Input 1, optional: a vtkImageData of another terrain,
 * the target, with the same array or its active scalars; its size and spacing may differ. Input 2, optional and without
 * a target alone: a vtkTable as output 0 of vtkGroundStatisticsFilter, whose first row replaces HypsometricIntegral,
 * ElevationSkewness and Concavity, each where the table has its column and a number there; KeepHypsometry does not
 * count then.
 *
 * With Carve the terrain is graded iteratively until every cell has a flow path downhill and the slopes of channels
 * fall with their drainage area, S ~ A^-Concavity, while its statistics stay those of the target: the radial spectrum
 * (and with it the variogram), the distribution of heights, and the plane. Without a target these are the terrain's
 * own, but for KeepHypsometry, HypsometricIntegral, ElevationSkewness and Concavity. After MaximumNumberOfIterations
 * the result nearest to the target is taken, and the statistics that it does not meet are in the field data.
 *
 * With Method Growth the terrain is grown anew instead, by an evolution of rivers and hillslopes over irregular points
 * under an uplift that follows the terrain's long waves, with the slopes, curvature, concavity, variogram and heights
 * of the target: ground whose valleys and ridges prefer no direction of the grid. Rivers, ridges and heights of input 3
 * are held: water runs along the rivers and over no ridge, and the ground goes through the heights as far as it drains.
 *
 * With Method Quilting the terrain becomes a quilt of overlapping pieces of the target, cut where they differ least,
 * that follow the terrain's long waves, or where both have 160 cells along a side and more, those of a coarse quilt of
 * the target: valleys, slopes and textures are the target's own, in another order. About as many cells lie in
 * depressions as in the target; a quilt of a target without any drains everywhere. Of terrain of up to 450000 cells
 * several quilts are made, and the one whose streams are most like the target's is taken.
 *
 * Output 0: the vtkImageData with the point arrays of the input and `Elevation` double [m], `DrainageArea` double [m^2]
 * (flow accumulation times the area of a cell, the cell included), `FlowDirection` signed char (D8: the receiving
 * neighbour, 0 to 7 counter-clockwise in steps of 45 degrees, 0 along x; -1 at outlets), `StreamOrder` unsigned char
 * (Strahler's; 0 where fewer than StreamThreshold cells drain), `DepressionDepth` double [m] (below the spill
 * elevation; 0 outside of depressions). Drainage areas at the outlets sum to the area of the terrain.
 *
 * Output 1: a vtkPolyData of the rivers, a polyline each from its head to its confluence with a stream of higher order,
 * or to an outlet. Cell arrays: `StreamOrder` int, `DrainageArea` double [m^2] at its lower end, `Length` double [m],
 * `Slope` double [m/m] from head to end. Point arrays: `DrainageArea` double [m^2], `RGB` (blue, the darker the higher
 * the order). Field data of both outputs, of two components, before and after: `DepressionFraction` (cells in
 * depressions over all cells), `HypsometricIntegral`, `ElevationSkewness`, `Concavity`, `CurvatureSkewness`; and
 * `Iterations`, `Converged` (1 or 0) and `UnmetTargets` (text: the statistics that are not met).
 *
 * Sources: Barnes et al. 2014 (priority-flood), Lindsay 2016 (breaching), Braun & Willett 2013 (stream power in O(n)).
 *
 * The whole image is requested, whatever part of the output is, since flow is not local. With a TileSize it is asked
 * for tile by tile instead, twice, and then about the part that is asked of the output, of which alone the arrays are
 * made: ground larger than memory drains as the whole would, cell for cell (Barnes 2016, 2017). There are no
 * StreamOrder and no rivers then, and DepressionFraction is all of the field data.
 * Threads and ranks change no byte. Rivers are in piece 0. A bad input or property is reported as one error.
 *
 * @sa vtkGroundStatisticsFilter
 */
#ifndef vtkDrainageFilter_h
#define vtkDrainageFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory>

class LITTORALFILTERS_EXPORT vtkDrainageFilter : public vtkImageAlgorithm
{
public:
  static vtkDrainageFilter* New();
  vtkTypeMacro(vtkDrainageFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  /// Places where water leaves the terrain.
  enum OutletsType
  {
    Border = 0,
    Sea = 1,
    Chosen = 2,
    LowestOfBorder = 3,
    SeaAlone = 4
  };

  ///@{
  /**
   * Places where water leaves the terrain, 0 to 4; default Border, every cell at the border, and beside missing
   * heights, which are outside. Sea: also every cell at or below SeaLevel. Chosen: the cells at which the point array
   * `Outlets` of the input is not 0, and no other. LowestOfBorder: the lowest of those of Border alone, in each
   * connected part of the terrain, as of a catchment. SeaAlone: the cells at or below SeaLevel alone.
   */
  vtkSetMacro(Outlets, int);
  vtkGetMacro(Outlets, int);
  void SetOutletsToBorder() { this->SetOutlets(Border); }
  void SetOutletsToSea() { this->SetOutlets(Sea); }
  void SetOutletsToChosen() { this->SetOutlets(Chosen); }
  void SetOutletsToLowestOfBorder() { this->SetOutlets(LowestOfBorder); }
  void SetOutletsToSeaAlone() { this->SetOutlets(SeaAlone); }
  ///@}

  ///@{
  /**
   * Height of the sea [m], a finite number; default 0. Used only with Outlets Sea and SeaAlone.
   */
  vtkSetMacro(SeaLevel, double);
  vtkGetMacro(SeaLevel, double);
  ///@}

  ///@{
  /**
   * Flow accumulation at which streams begin [cells], 2 to 10^9; default 100.
   */
  vtkSetMacro(StreamThreshold, int);
  vtkGetMacro(StreamThreshold, int);
  ///@}

  ///@{
  /**
   * Carving of the terrain; default on. If off, flow is routed over the terrain as it is, out of depressions over the
   * spill point.
   */
  vtkSetMacro(Carve, bool);
  vtkGetMacro(Carve, bool);
  vtkBooleanMacro(Carve, bool);
  ///@}

  /// Ways in which a landscape is made of the terrain.
  enum MethodType
  {
    Carving = 0,
    Growth = 1,
    Quilting = 2
  };

  ///@{
  /**
   * Way in which a landscape is made of the terrain, 0 to 2; default Carving. Used only with Carve. Growth and Quilting
   * need a target, Outlets Border, and 16 rows and columns or more, as the target; ChannelThreshold and ValleyWidth do
   * not count. Quilting needs cells of the target's size.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToCarving() { this->SetMethod(Carving); }
  void SetMethodToGrowth() { this->SetMethod(Growth); }
  void SetMethodToQuilting() { this->SetMethod(Quilting); }
  ///@}

  ///@{
  /**
   * Rock and faults of the terrain's point arrays; default off. Used only with Method Growth; needs one of these at
   * least, each a number a point, finite where the terrain has heights: `Erodibility`, by which K of the rivers is
   * multiplied, and `UpliftFactor`, by which the uplift is, both 0.001 to 1000 over their geometric mean, for slopes of
   * rivers of a steady state that go with UpliftFactor / Erodibility; `FaultThrow` [m], by which faults lift the grown
   * ground at last. Under factors that differ from place to place heights have the target's mean and deviation only.
   */
  vtkSetMacro(UseRock, bool);
  vtkGetMacro(UseRock, bool);
  vtkBooleanMacro(UseRock, bool);
  ///@}

  ///@{
  /**
   * Heights of the points of input 3's lines, too; default off: lines are flat drawings, whose heights do not count.
   * Those of a river must not rise towards its lower end. Used only with Method Growth.
   */
  vtkSetMacro(UseLineHeights, bool);
  vtkGetMacro(UseLineHeights, bool);
  vtkBooleanMacro(UseLineHeights, bool);
  ///@}

  ///@{
  /**
   * Distribution of heights kept as the terrain has it; default off: a lognormal distribution of HypsometricIntegral
   * and ElevationSkewness. Used only without a target image and a table of statistics.
   */
  vtkSetMacro(KeepHypsometry, bool);
  vtkGetMacro(KeepHypsometry, bool);
  vtkBooleanMacro(KeepHypsometry, bool);
  ///@}

  ///@{
  /**
   * Hypsometric integral of the carved terrain, (mean - lowest)/(highest - lowest), 0 to 1; default 0.4. It must fit
   * ElevationSkewness: low for a positive one. Used only without a target image and with KeepHypsometry off.
   */
  vtkSetMacro(HypsometricIntegral, double);
  vtkGetMacro(HypsometricIntegral, double);
  ///@}

  ///@{
  /**
   * Skewness of the heights of the carved terrain, -2 to 2; default 0.4. Used only without a target image and with
   * KeepHypsometry off.
   */
  vtkSetMacro(ElevationSkewness, double);
  vtkGetMacro(ElevationSkewness, double);
  ///@}

  ///@{
  /**
   * Concavity index theta of the channels of the carved terrain, S ~ A^-theta, 0 to 1; default 0.45. Used only without
   * a target image.
   */
  vtkSetMacro(Concavity, double);
  vtkGetMacro(Concavity, double);
  ///@}

  ///@{
  /**
   * Maximum number of iterations of carving, 1 to 100; default 40. Carving ends before, when the target is met. Growth
   * makes at most 12.
   */
  vtkSetMacro(MaximumNumberOfIterations, int);
  vtkGetMacro(MaximumNumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Flow accumulation of channel heads [cells], 1 to 10^6; default 50. Hillslopes, which have less, are graded to a
   * tenth of the slope at a head.
   */
  vtkSetMacro(ChannelThreshold, double);
  vtkGetMacro(ChannelThreshold, double);
  ///@}

  ///@{
  /**
   * Width of valleys [cells], 0.5 to 50; default 3. The standard deviation over which a cut is spread: the floor of a
   * lone channel is 3.2 times, its valley at half the depth 4 times as wide.
   */
  vtkSetMacro(ValleyWidth, double);
  vtkGetMacro(ValleyWidth, double);
  ///@}

  ///@{
  /**
   * Seed of the random waves that are added where the terrain has less than a tenth of the target's power, and of the
   * points of growth or the pieces of a quilt, any integer; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Side of the tiles by which the terrain is drained [cells], 16 to 2048; default 0, as a whole. Needs Carve off and
   * Outlets Border or Sea. Ask for the output in rows of tiles, as the terrain is asked for by whole tiles.
   */
  vtkSetMacro(TileSize, int);
  vtkGetMacro(TileSize, int);
  ///@}

  /// Connects the target, port 1.
  void SetTargetConnection(vtkAlgorithmOutput* target) { this->SetInputConnection(1, target); }

  /// Removes the connection of port 1, the target.
  void RemoveTarget() { this->RemoveAllInputConnections(1); }

  /// Connects the table of statistics, port 2.
  void SetStatisticsConnection(vtkAlgorithmOutput* statistics) { this->SetInputConnection(2, statistics); }

  /// Removes the connection of port 2, the table of statistics.
  void RemoveStatistics() { this->RemoveAllInputConnections(2); }

  /// Connects given rivers, ridges and heights, port 3.
  void SetGivenConnection(vtkAlgorithmOutput* given) { this->SetInputConnection(3, given); }

  /// Removes the connection of port 3.
  void RemoveGiven() { this->RemoveAllInputConnections(3); }

protected:
  vtkDrainageFilter();
  ~vtkDrainageFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int Outlets;
  double SeaLevel;
  int StreamThreshold;
  bool Carve;
  int Method;
  bool UseRock;
  bool UseLineHeights;
  bool KeepHypsometry;
  double HypsometricIntegral;
  double ElevationSkewness;
  double Concavity;
  int MaximumNumberOfIterations;
  double ChannelThreshold;
  double ValleyWidth;
  int Seed;
  int TileSize;

private:
  vtkDrainageFilter(const vtkDrainageFilter&) = delete;
  void operator=(const vtkDrainageFilter&) = delete;

  struct Ground;
  class vtkInternals;

  int RequestTiles(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  void AskForTile(vtkInformation* input, vtkInformation* output);
  void ReadGround(vtkInformationVector** inputVector, Ground& ground);
  void CarveGround(vtkInformationVector** inputVector, Ground& ground);
  void GrowGround(vtkInformationVector** inputVector, Ground& ground);
  void QuiltGround(vtkInformationVector** inputVector, Ground& ground);
  void WriteGround(vtkImageData* image, const Ground& ground, vtkImageData* output);

  std::unique_ptr<vtkInternals> Internals;
};

#endif
