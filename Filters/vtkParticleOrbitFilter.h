// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkParticleOrbitFilter
 * @brief   move points on their orbits in waves
 *
 * Input 0: any vtkPointSet, or a vtkMultiBlockDataSet or vtkPartitionedDataSetCollection of them: particles, a mesh, or
 * a plane at sea level, which becomes the free surface. Its points are the centers of the orbits; those above the sea
 * move like the surface, those below the bed like the water at the bed. Input 1: a sea state from vtkSeaStateSource.
 *
 * Output: the same data at the requested time, in the precision of the input, with the point array `Center`[3] [m] of
 * the type of the points. Optional point arrays are `Velocity`[3] [m/s] and `Acceleration`[3] [m/s2]; the velocity is
 * that of the orbit, and of the Stokes drift where that is on. Points that all lie at sea level get `Normals` and
 * `Jacobian` (1 at rest; 0 or less where the surface folds over itself, which indicates foam). Field data:
 * `DepthRegime` of the highest train (deep, intermediate or shallow), and `RegimeTrains`, the numbers of deep,
 * intermediate and shallow trains.
 *
 * Optional arrays of the input, as written by vtkParticleLevelOfDetailFilter: the point array `TrainCount` is the
 * number of trains that move a point, counted in the order of the field array `TrainOrder`. The point arrays `MasterId`
 * and `Offset`[3] [m] make a point a slave, which keeps that offset from its master, the point of this index in the
 * same data set; a point with a negative index, or its own, is no slave, and a master must not be a slave.
 *
 * A property out of range, a table that is no sea state or arrays that contradict each other are reported as one error.
 * Coulais et al., eq. 2 with corrected misprints, and orbital axes for any water depth; see Documentation/errata.md.
 *
 * @sa vtkSeaStateSource vtkParticleLevelOfDetailFilter
 */
#ifndef vtkParticleOrbitFilter_h
#define vtkParticleOrbitFilter_h

#include "LittoralFiltersModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <memory> // for what is kept
#include <string> // for what is wrong with a property

class vtkPointSet;

namespace littoral
{
class WaveOrbits;
}

class LITTORALFILTERS_EXPORT vtkParticleOrbitFilter : public vtkPassInputTypeAlgorithm
{
public:
  static vtkParticleOrbitFilter* New();
  vtkTypeMacro(vtkParticleOrbitFilter, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Stokes drift of the centers, to second order in the wave amplitudes; default off. The model of the paper has none.
   */
  vtkSetMacro(StokesDrift, bool);
  vtkGetMacro(StokesDrift, bool);
  vtkBooleanMacro(StokesDrift, bool);
  ///@}

  ///@{
  /**
   * Doppler shift of the waves seen by particles that Current carries, so that they keep their orbital periods; default
   * off. Off, as in the paper, they move through waves that do not travel with the current.
   */
  vtkSetMacro(DopplerShift, bool);
  vtkGetMacro(DopplerShift, bool);
  vtkBooleanMacro(DopplerShift, bool);
  ///@}

  ///@{
  /**
   * Velocity of the current that carries the centers, along x and y [m/s]; default 0 0. This filter does not apply it
   * to the centers. Used only with DopplerShift.
   */
  vtkSetVector2Macro(Current, double);
  vtkGetVector2Macro(Current, double);
  ///@}

  ///@{
  /**
   * Factor of the horizontal displacement, 0 to 1; default 1, that of water, with sharp crests. A smaller factor keeps
   * steep seas from folding over themselves.
   */
  vtkSetMacro(Choppiness, double);
  vtkGetMacro(Choppiness, double);
  ///@}

  ///@{
  /**
   * Addition of the point array `Velocity`[3] [m/s]; default off.
   */
  vtkSetMacro(GenerateVelocity, bool);
  vtkGetMacro(GenerateVelocity, bool);
  vtkBooleanMacro(GenerateVelocity, bool);
  ///@}

  ///@{
  /**
   * Addition of the point array `Acceleration`[3] [m/s2]; default off.
   */
  vtkSetMacro(GenerateAcceleration, bool);
  vtkGetMacro(GenerateAcceleration, bool);
  vtkBooleanMacro(GenerateAcceleration, bool);
  ///@}

  ///@{
  /**
   * Addition of the point arrays `Normals` and `Jacobian` if all points lie at sea level; default on.
   */
  vtkSetMacro(GenerateSurface, bool);
  vtkGetMacro(GenerateSurface, bool);
  vtkBooleanMacro(GenerateSurface, bool);
  ///@}

  ///@{
  /**
   * First and last time of an animation, announced as TIME_RANGE [s], increasing; default 0 60. Any time can be
   * requested.
   */
  vtkSetVector2Macro(TimeRange, double);
  vtkGetVector2Macro(TimeRange, double);
  ///@}

  /// Connects the sea state, port 1.
  void SetSeaStateConnection(vtkAlgorithmOutput* sea) { this->SetInputConnection(1, sea); }

  /// Removes the connection of port 1, the sea state.
  void RemoveSeaState() { this->RemoveAllInputConnections(1); }

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
  class vtkInternals;
  std::string WhyBadProperties(double time) const;
  void MoveAll(Sea& sea, vtkDataObject* input, vtkDataObject* output);
  void Move(Sea& sea, vtkPointSet* input, vtkPointSet* output);
  template <typename Array>
  void MoveAs(const littoral::WaveOrbits& orbits, double seaLevel, vtkPointSet* input, vtkPointSet* output);

  std::unique_ptr<vtkInternals> Internals;
};

#endif
