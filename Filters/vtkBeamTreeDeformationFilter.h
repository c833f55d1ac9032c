// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBeamTreeDeformationFilter
 * @brief   plants that sway in the wind
 *
 * Inputs: port 0, one plant or several, as the plant sources make them (vtkMultiBlockDataSet with High {Skeleton, Skin,
 * Leaves}); port 1, the wind as a frozen field (vtkImageData, x along the wind, point array `Velocity`[3] [m/s], field
 * data `ConvectionSpeed` [m/s]; where there is field data `Period` [s] it has to be the length of the image over that
 * speed). The field is carried along x and repeats; it is asked for once, at its time 0, and not at each frame. Heights
 * in the wind are heights above a plant's foot. Port 2, optional: the prototypes of a scattered forest, in their order.
 * Plants may also be a vtkPartitionedDataSetCollection whose assembly has these blocks, each part in one partition, and
 * whose field data are those of the plants; the output has blocks.
 *
 * Output 0: the plants at the requested time (section 3.2 of Setas et al.): branches are cantilevers in their parents,
 * with modes, a periodic steady state and segments that keep their lengths; skins follow the joints, and leaves turn to
 * the wind and flutter (eq. 26). Any time can be asked for; without wind all points stay where they are, to the bit.
 * In the level Medium, envelopes sway as the trunk in full does, and show pictures of the moving crown in turn (section
 * 4.2); of a scattered forest they do where its prototypes are connected. Low stands still. Times are those of the
 * wind.
 *
 * Field data `Frequency` [Hz] of output 0: that of the first mode of each plant's trunk with all that it carries, by
 * the row of the plant in the field data of a scattered forest, one number for a single plant; 0 for plants that stand
 * still.
 *
 * Output 1: these pictures (RGBA), one above the other, those of the first species first; texture coordinates of
 * Medium/Crown point to the one of the moment. They also travel as field data `Texture` and `TextureSize` of the
 * crowns.
 *
 * Between its points the wind is read without loss: along x as the sum of its waves, across and up with the power that
 * each wave has at the points around.
 *
 * What is kept between frames is the waves of the wind, as large as its image, and for each plant an amount that does
 * not grow with the length of the wind: about 100 kB for the interpolated responses of a plant of 300 branches,
 * 0.7 kB for each branch and mode of the direct ones.
 */
#ifndef vtkBeamTreeDeformationFilter_h
#define vtkBeamTreeDeformationFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <memory> // for what is kept between frames
#include <string> // for reasons

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

  ///@{
  /// Modes of each branch, 1 to 10. Default 1, as in the paper.
  vtkSetMacro(NumberOfModes, int);
  vtkGetMacro(NumberOfModes, int);
  ///@}

  ///@{
  /// 0 Interpolated, from three orthogonal beams in the wind at the plant's middle (eq. 25); 1 Direct, each branch in
  /// the wind where it is, with a response of its own. Default 0.
  vtkSetMacro(Response, int);
  vtkGetMacro(Response, int);
  ///@}

  ///@{
  /// Of a bare cylinder, 0 to 10. Default 1.1.
  vtkSetMacro(DragCoefficient, double);
  vtkGetMacro(DragCoefficient, double);
  ///@}

  ///@{
  /// Of forces across the wind U and a branch e, to the side of U x e: to the right of the wind on an upright branch,
  /// up on one that points to the wind's left (eq. 16). A branch and what grows on it have as much of it as of drag,
  /// times LiftCoefficient over DragCoefficient. A round branch has none; -10 to 10. Default 0.
  vtkSetMacro(LiftCoefficient, double);
  vtkGetMacro(LiftCoefficient, double);
  ///@}

  ///@{
  /// 0 Projection, |U| times the wind across the branch; 1 Cross Flow, by the wind across the branch alone (of the
  /// direct response; the interpolated one is linear in the projection). Default 0.
  vtkSetMacro(DragLaw, int);
  vtkGetMacro(DragLaw, int);
  ///@}

  ///@{
  /// Adds weight to plants that stand as if there were none. Default off.
  vtkSetMacro(Gravity, bool);
  vtkGetMacro(Gravity, bool);
  vtkBooleanMacro(Gravity, bool);
  ///@}

  ///@{
  /// Whether plants that say of which wood they are (field data `Wood`, as the presets of the tree sources do) sway as
  /// that. Else, and where they say nothing, the next three properties hold. Default on.
  vtkSetMacro(WoodFromPlants, bool);
  vtkGetMacro(WoodFromPlants, bool);
  vtkBooleanMacro(WoodFromPlants, bool);
  ///@}

  ///@{
  /// Of living wood along the grain, for a section of a trunk with its bark [Pa], 1e5 to 1e12; branches have half of
  /// it. Default 5.1e9.
  vtkSetMacro(YoungModulus, double);
  vtkGetMacro(YoungModulus, double);
  ///@}

  ///@{
  /// Of the living wood [kg/m3], 1 to 1e5. Default 950.
  vtkSetMacro(WoodDensity, double);
  vtkGetMacro(WoodDensity, double);
  ///@}

  ///@{
  /// Damping ratio of all modes, 0.001 to 0.95. Default 0.08.
  vtkSetMacro(Damping, double);
  vtkGetMacro(Damping, double);
  ///@}

  ///@{
  /// How much leaves move, as part of the full motion in strong wind, 0 to 2. Default 1.
  vtkSetMacro(LeafFlutter, double);
  vtkGetMacro(LeafFlutter, double);
  ///@}

  ///@{
  /// Pictures of a crown of the level Medium, made at equal times of a swing of its trunk, 1 to 16; 1: a still one.
  /// Default 8.
  vtkSetMacro(NumberOfPictures, int);
  vtkGetMacro(NumberOfPictures, int);
  ///@}

  ///@{
  /// Columns and rows of such a picture [texels], each from 4 to 4096. Default 256 128.
  vtkSetVector2Macro(PictureSize, int);
  vtkGetVector2Macro(PictureSize, int);
  ///@}

  ///@{
  /// Of the flutter of leaves. Any whole number. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  /// The wind, on port 1.
  void SetWindConnection(vtkAlgorithmOutput* wind) { this->SetInputConnection(1, wind); }

  /// Disconnects all prototypes.
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
  double Damping;
  double LeafFlutter;
  int NumberOfPictures;
  int PictureSize[2];
  int Seed;

private:
  vtkBeamTreeDeformationFilter(const vtkBeamTreeDeformationFilter&) = delete;
  void operator=(const vtkBeamTreeDeformationFilter&) = delete;

  struct Memory;
  std::unique_ptr<Memory> Kept; // what was read from the last inputs

  std::string WhyInvalid() const;
  littoral::SwaySettings MakeSettings() const;
  std::string Remember(vtkInformationVector** inputs, vtkMultiBlockDataSet* plants);
};

#endif
