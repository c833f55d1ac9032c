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
 * in the wind are heights above a plant's foot.
 *
 * Output: the plants at the requested time (section 3.2 of Setas et al.): branches are cantilevers in their parents,
 * with modes, a periodic steady state and segments that keep their lengths; skins follow the joints, and leaves turn to
 * the wind and flutter (eq. 26). Any time can be asked for; without wind all points stay where they are, to the bit.
 * The lower levels of detail pass through as they are. Times are those of the wind.
 */
#ifndef vtkBeamTreeDeformationFilter_h
#define vtkBeamTreeDeformationFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <memory> // for what is kept between frames
#include <string> // for reasons

class vtkImageData;

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
  /// Of the living wood along the grain [Pa], 1e5 to 1e12. Default 9e9.
  vtkSetMacro(YoungModulus, double);
  vtkGetMacro(YoungModulus, double);
  ///@}

  ///@{
  /// Of the living wood [kg/m3], 1 to 1e5. Default 900.
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
  /// Of the flutter of leaves. Any whole number. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  /// The wind, on port 1.
  void SetWindConnection(vtkAlgorithmOutput* wind) { this->SetInputConnection(1, wind); }

protected:
  vtkBeamTreeDeformationFilter();
  ~vtkBeamTreeDeformationFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int NumberOfModes;
  int Response;
  double DragCoefficient;
  int DragLaw;
  bool Gravity;
  double YoungModulus;
  double WoodDensity;
  double Damping;
  double LeafFlutter;
  int Seed;

private:
  vtkBeamTreeDeformationFilter(const vtkBeamTreeDeformationFilter&) = delete;
  void operator=(const vtkBeamTreeDeformationFilter&) = delete;

  struct Forest;
  std::unique_ptr<Forest> Kept; // plants and tables of the last inputs

  std::string Prepare(vtkMultiBlockDataSet* plants, vtkImageData* wind);
};

#endif
