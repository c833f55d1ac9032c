// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBeamTreeDeformationFilter
 * @brief   deform trees and shrubs by wind
 *
 * Inputs: port 0, one plant or several from the plant sources (vtkMultiBlockDataSet with High {Skeleton, Skin,
 * Leaves}); port 1, the wind as a frozen field (vtkImageData, x along the wind, point array `Velocity`[3] [m/s], field
 * data `ConvectionSpeed` [m/s]; the optional field data `Period` [s] must be the length of the image divided by that
 * speed); port 2, optional, the prototypes of a scattered forest, in their order. The wind is convected along x and
 * periodic; it is requested once, at its time 0, and not for each frame. Heights in the wind are heights above the foot
 * of a plant. Plants may also be a vtkPartitionedDataSetCollection whose assembly has these blocks, each part in one
 * partition, and whose field data are those of the plants; the output has blocks.
 *
 * Output 0: the plants at the requested time (Setas et al., section 3.2): branches are cantilever beams clamped in
 * their parents, with modal vibrations, a periodic steady state and segments of constant length; skins follow the
 * joints, and leaves align with the wind and flutter (eq. 26). Any time can be requested; without wind all points keep
 * their positions, to the bit. In the level Medium, the crowns follow the motion of the trunk at full detail, in a
 * scattered forest only if its prototypes are connected; envelopes (vtkPlantSource::SetMediumCrown()) show textures of
 * the moving crown in turn (section 4.2). Low does not move. Times are those of the wind.
 *
 * Field data `Frequency` [Hz] of output 0: the natural frequency of the first mode of each trunk with all that it
 * carries, by the row of the plant in the field data of a scattered forest, one number for a single plant; 0 for plants
 * that do not move.
 *
 * Output 1: the textures (RGBA), one above the other, those of the first species first; texture coordinates of
 * Medium/Crown refer to the current one. They are also field data `Texture`, `TextureSize` and `TextureMean` of the
 * crowns.
 *
 * Between its points the wind is interpolated without loss of variance: along x as the sum of its Fourier components,
 * across and up with the power of each component at the surrounding points.
 *
 * Memory between frames: the Fourier components of the wind, as large as its image, and for each plant an amount that
 * does not grow with the length of the wind: about 100 kB for the interpolated responses of a plant of 300 branches,
 * 0.7 kB per branch and mode of the direct ones. A property out of range or an input without these arrays is reported
 * as one error.
 */
#ifndef vtkBeamTreeDeformationFilter_h
#define vtkBeamTreeDeformationFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <memory> // for what is kept between frames
#include <string> // for checks

namespace littoral
{
struct SwaySettings;
}

class LITTORALFILTERS_EXPORT vtkBeamTreeDeformationFilter : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkBeamTreeDeformationFilter* New();
  vtkTypeMacro(vtkBeamTreeDeformationFilter, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Number of bending modes per branch, 1 to 10; default 1, as in the paper.
   */
  vtkSetMacro(NumberOfModes, int);
  vtkGetMacro(NumberOfModes, int);
  ///@}

  enum ResponseType
  {
    Interpolated = 0,
    Direct = 1,
  };

  ///@{
  /**
   * Response of the branches to the wind, a ResponseType; default Interpolated. Interpolated: from the responses of
   * three orthogonal beams in the wind at the center of the plant (eq. 25). Direct: a separate response of each branch
   * to the wind at its position, slower and with more memory.
   */
  vtkSetMacro(Response, int);
  vtkGetMacro(Response, int);
  void SetResponseToInterpolated() { this->SetResponse(Interpolated); }
  void SetResponseToDirect() { this->SetResponse(Direct); }
  ///@}

  ///@{
  /**
   * Drag coefficient of a bare cylinder, 0 to 10; default 1.1.
   */
  vtkSetMacro(DragCoefficient, double);
  vtkGetMacro(DragCoefficient, double);
  ///@}

  ///@{
  /**
   * Lift coefficient of the force normal to wind U and branch axis e, along U x e, -10 to 10; default 0, that of a
   * circular branch. The force points to the right of the wind on an upright branch and up on a branch that points to
   * the left of the wind (eq. 16). The lift of a branch and of what grows on it is its drag times LiftCoefficient /
   * DragCoefficient.
   */
  vtkSetMacro(LiftCoefficient, double);
  vtkGetMacro(LiftCoefficient, double);
  ///@}

  enum DragLawType
  {
    Projection = 0,
    CrossFlow = 1,
  };

  ///@{
  /**
   * Drag law, a DragLawType; default Projection. Projection: |U| times the wind component normal to the branch.
   * CrossFlow: quadratic in the normal component alone. Used by the Direct response; the Interpolated one is linear in
   * the projection.
   */
  vtkSetMacro(DragLaw, int);
  vtkGetMacro(DragLaw, int);
  void SetDragLawToProjection() { this->SetDragLaw(Projection); }
  void SetDragLawToCrossFlow() { this->SetDragLaw(CrossFlow); }
  ///@}

  ///@{
  /**
   * Deflection by the weight of the plants, whose input shape is taken as unloaded; default off.
   */
  vtkSetMacro(Gravity, bool);
  vtkGetMacro(Gravity, bool);
  vtkBooleanMacro(Gravity, bool);
  ///@}

  ///@{
  /**
   * Wood properties from the plants; default on. Plants with the field data `Wood`, as the presets of the tree sources
   * write them, have those properties. If off, and for other plants, YoungModulus, WoodDensity and DampingRatio are
   * used.
   */
  vtkSetMacro(WoodFromPlants, bool);
  vtkGetMacro(WoodFromPlants, bool);
  vtkBooleanMacro(WoodFromPlants, bool);
  ///@}

  ///@{
  /**
   * Young's modulus of green wood along the grain, for a cross section of a trunk with its bark [Pa], 1e5 to 1e12;
   * default 5.1e9. Branches have half of it. Oak has 5.0e9, pine 4.2e9, birch 5.1e9.
   */
  vtkSetMacro(YoungModulus, double);
  vtkGetMacro(YoungModulus, double);
  ///@}

  ///@{
  /**
   * Density of green wood [kg/m3], 1 to 1e5; default 950. Oak has 1020, pine 850, birch 870.
   */
  vtkSetMacro(WoodDensity, double);
  vtkGetMacro(WoodDensity, double);
  ///@}

  ///@{
  /**
   * Damping ratio of all modes, 0.001 to 0.95; default 0.08. Wood alone has less than 0.05, trees in leaf more.
   */
  vtkSetMacro(DampingRatio, double);
  vtkGetMacro(DampingRatio, double);
  ///@}

  ///@{
  /**
   * Amplitude of the leaf motion relative to that in strong wind, 0 to 2; default 1.
   */
  vtkSetMacro(LeafFlutter, double);
  vtkGetMacro(LeafFlutter, double);
  ///@}

  ///@{
  /**
   * Number of textures per crown of the level Medium, at equal time intervals of one period of its trunk, 1 to 16;
   * default 8. With 1 the texture is constant.
   */
  vtkSetMacro(NumberOfTextures, int);
  vtkGetMacro(NumberOfTextures, int);
  ///@}

  ///@{
  /**
   * Columns and rows of a crown texture [texels], each 4 to 4096; default 256 128.
   */
  vtkSetVector2Macro(TextureSize, int);
  vtkGetVector2Macro(TextureSize, int);
  ///@}

  ///@{
  /**
   * Seed of the random numbers of the leaf flutter, any integer; default 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Addition of the block `Joints` to output 0, for programs that move skins themselves, as vtkGLTFSceneWriter does:
   * a point for each joint at its position, with the point arrays `ParentId` (-1: none), `RestPosition`[3] [m] and
   * `Rotation`[4] (quaternion w, x, y, z, since rest); default off. `JointIds` are indices of it, also those that
   * Medium/Trunk and Medium/Crown get. Leaf flutter is not in it.
   */
  vtkSetMacro(GenerateJoints, bool);
  vtkGetMacro(GenerateJoints, bool);
  vtkBooleanMacro(GenerateJoints, bool);
  ///@}

  ///@{
  /**
   * Whether points and normals of a time may be written over those of the time before, also where others still hold
   * them; default off. On: half the memory of what moves, for a scene that shows one time at a time. Whoever needs an
   * earlier time copies it in depth; a view at another time, or a cache of geometry, shows the latest one.
   */
  vtkSetMacro(OverwriteFrames, bool);
  vtkGetMacro(OverwriteFrames, bool);
  vtkBooleanMacro(OverwriteFrames, bool);
  ///@}

  /// Connects the wind, port 1.
  void SetWindConnection(vtkAlgorithmOutput* wind) { this->SetInputConnection(1, wind); }

  /// Removes the connection of port 1, the wind.
  void RemoveWind() { this->RemoveAllInputConnections(1); }

  /// Adds a prototype, to port 2.
  void AddPrototypeConnection(vtkAlgorithmOutput* prototype) { this->AddInputConnection(2, prototype); }

  /// Removes all connections of port 2, the prototypes.
  void RemoveAllPrototypes() { this->RemoveAllInputConnections(2); }

protected:
  vtkBeamTreeDeformationFilter();
  ~vtkBeamTreeDeformationFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int NumberOfModes;
  int Response;
  double DragCoefficient;
  double LiftCoefficient;
  int DragLaw;
  bool Gravity;
  bool WoodFromPlants;
  double YoungModulus;
  double WoodDensity;
  double DampingRatio;
  double LeafFlutter;
  int NumberOfTextures;
  int TextureSize[2];
  int Seed;
  bool GenerateJoints;
  bool OverwriteFrames;

private:
  vtkBeamTreeDeformationFilter(const vtkBeamTreeDeformationFilter&) = delete;
  void operator=(const vtkBeamTreeDeformationFilter&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals; // what was read from the last inputs

  std::string WhyInvalid(double time) const;
  littoral::SwaySettings MakeSettings() const;
  void Remember(vtkInformationVector** inputs, vtkMultiBlockDataSet* plants);
};

#endif
