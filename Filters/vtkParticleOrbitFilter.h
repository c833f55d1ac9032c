// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleOrbitFilter
 * @brief   moves points on their orbits in waves
 *
 * Input 0: any vtkPointSet, or a vtkMultiBlockDataSet or vtkPartitionedDataSetCollection of them: particles, a mesh, or
 * a plane at sea level, which becomes the surface of the water. Its points are the centers of the orbits; those above
 * the sea move as its surface does, those below the bed as the water at the bed. Input 1: a sea state, as
 * vtkSeaStateSource makes it.
 *
 * Output: the same at the requested time, in the precision of the input, with the point array `Center`[3] of its type.
 * On request `Velocity` [m/s] and `Acceleration` [m/s2]; the velocity is that of the orbit, and of the Stokes drift
 * where that is on. Points that all lie at sea level get `Normals` and `Jacobian` (1 at rest; at 0 or below the surface
 * folds over itself: there is foam). Field data: `DepthRegime`, how the highest train feels the bed (deep,
 * intermediate or shallow), and `RegimeTrains`, the numbers of trains that are deep, intermediate and shallow.
 *
 * Optional arrays of the input are honoured, as vtkParticleLevelOfDetailFilter makes them. Point array `TrainCount`:
 * only that many trains, from the first, move the point; the field array `TrainOrder` tells which train is the first.
 * Point arrays `MasterId` with `Offset`[3]: the point is a slave and lies at that offset from where its master is, a
 * point of the same data set by its index; a negative index, or the point's own, makes it no slave, and a master may
 * not be a slave.
 *
 * Coulais et al., eq. 2 with the misprints put right, and the axes of water of any depth; see Documentation/errata.md.
 *
 * @sa vtkSeaStateSource vtkParticleLevelOfDetailFilter
 */
#ifndef vtkParticleOrbitFilter_h
#define vtkParticleOrbitFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <string> // for what is wrong with a property

class vtkPointSet;

class LITTORALFILTERS_EXPORT vtkParticleOrbitFilter : public vtkPassInputTypeAlgorithm
{
public:
  static vtkParticleOrbitFilter* New();
  vtkTypeMacro(vtkParticleOrbitFilter, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether centers drift with the waves, by the second order in their amplitudes. The paper's do not. Default off.
  vtkSetMacro(StokesDrift, bool);
  vtkGetMacro(StokesDrift, bool);
  vtkBooleanMacro(StokesDrift, bool);
  ///@}

  ///@{
  /**
   * Whether particles that Current carries keep the period of their orbits, as waves that ride on the current do. Off,
   * as in the paper, they run through waves that know nothing of the current. Default off.
   */
  vtkSetMacro(DopplerShift, bool);
  vtkGetMacro(DopplerShift, bool);
  vtkBooleanMacro(DopplerShift, bool);
  ///@}

  ///@{
  /// Along x and y [m/s], with which the centers come carried to this filter; it does not move them itself. Of no
  /// effect without DopplerShift. Default 0 0.
  vtkSetVector2Macro(Current, double);
  vtkGetVector2Macro(Current, double);
  ///@}

  ///@{
  /// Factor of the horizontal motion, 0 to 1. 1 is that of water, with sharp crests; less keeps steep seas from folding
  /// over themselves. Default 1.
  vtkSetMacro(Choppiness, double);
  vtkGetMacro(Choppiness, double);
  ///@}

  ///@{
  /// Whether to add the array Velocity. Default off.
  vtkSetMacro(GenerateVelocity, bool);
  vtkGetMacro(GenerateVelocity, bool);
  vtkBooleanMacro(GenerateVelocity, bool);
  ///@}

  ///@{
  /// Whether to add the array Acceleration. Default off.
  vtkSetMacro(GenerateAcceleration, bool);
  vtkGetMacro(GenerateAcceleration, bool);
  vtkBooleanMacro(GenerateAcceleration, bool);
  ///@}

  ///@{
  /// Whether to add Normals and Jacobian to points that all lie at sea level; of no effect on others. Default on.
  vtkSetMacro(GenerateSurface, bool);
  vtkGetMacro(GenerateSurface, bool);
  vtkBooleanMacro(GenerateSurface, bool);
  ///@}

  ///@{
  /// First and last time that players are told of [s], increasing. Any time can be asked for. Default 0 60.
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

protected:
  vtkParticleOrbitFilter();
  ~vtkParticleOrbitFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool StokesDrift;
  bool DopplerShift;
  double Current[2];
  double Choppiness;
  bool GenerateVelocity;
  bool GenerateAcceleration;
  bool GenerateSurface;
  double TimeRange[2];

private:
  vtkParticleOrbitFilter(const vtkParticleOrbitFilter&) = delete;
  void operator=(const vtkParticleOrbitFilter&) = delete;

  class Sea;
  std::string WhyBadProperties(double time) const;
  bool MoveAll(const Sea& sea, vtkDataObject* input, vtkDataObject* output);
  bool Move(const Sea& sea, vtkPointSet* input, vtkPointSet* output);
  template <typename Array>
  bool MoveAs(const Sea& sea, vtkPointSet* input, vtkPointSet* output);
};

#endif
