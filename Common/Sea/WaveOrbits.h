// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWaveOrbits_h
#define LittoralWaveOrbits_h

#include "Numerics/Vector3.h"
#include "Sea/SecondOrder.h"
#include "Sea/WaveTrains.h"

#include <array>
#include <cstddef>
#include <vector>

namespace littoral
{

/// Semi-axes of the orbit of a particle in one train.
struct OrbitAxes
{
  double Horizontal; ///< a [m]
  double Vertical;   ///< b [m]
};

/**
 * Semi-axes at a height z [m] below or at the mean sea level (0 there, negative below) on water of a depth [m]:
 * a = r cosh k(z+h) / sinh kh, b = r sinh k(z+h) / sinh kh, written with decaying exponentials alone, so that nothing
 * overflows and deep water needs no case of its own. Heights outside of the water count as the surface and the bed.
 */
OrbitAxes AxesAt(const WaveTrain& train, double height, double depth);

constexpr int MostAges = 16;

struct WaveOrbitOptions
{
  bool StokesDrift = false;         ///< orbit centers drift with the waves
  bool DopplerShift = false;        ///< orbits keep their periods in a current
  double Current[2] = { 0.0, 0.0 }; ///< current that carries the centers [m/s]; used with DopplerShift only
  double Choppiness = 1.0;          ///< factor of the horizontal motion, 0 to 1
  std::vector<double> Ages;         ///< of OrbitRequest::PastGradient, at most MostAges [s]
  /// Points in a sea of second order: whether they are followed, are the surface at sea level, or stay where they are.
  BoundWaveOptions Bound;
};

/// Points and what is asked of them; three numbers a point, null where it is not wanted.
template <typename Real>
struct OrbitRequest
{
  const Real* Centers = nullptr;
  const int* TrainCounts = nullptr; ///< one a point: only the first trains act on it; null: all
  Real* Displacement = nullptr;     ///< from the center [m]
  Real* Velocity = nullptr;         ///< [m/s]
  Real* Acceleration = nullptr;     ///< [m/s2]
  /// Five a point: dX/dx - 1, dX/dy = dY/dx, dY/dy - 1, dZ/dx, dZ/dy of places by their centers.
  Real* Gradient = nullptr;
  /// Three a point and age: the first three of Gradient of the same point so long before, without StokesDrift; in
  /// single precision alone.
  Real* PastGradient = nullptr;
  /// Five a point: du/dx, du/dy = dv/dx, dv/dy, dw/dx = du/dz, dw/dy = dv/dz [1/s]; dw/dz = -(du/dx + dv/dy).
  Real* VelocityGradient = nullptr;
  const float* Shares = nullptr;  ///< one a train: the part of its amplitude that acts; null: all of it
  const int* ShareSets = nullptr; ///< one a point: the set among Shares that acts on it; null: the first on all
  bool AddsCenters = false;       ///< Displacement becomes the place itself
};

/// The unit normal of a surface that was level, from the five numbers of OrbitRequest::Gradient.
Vector3 SurfaceNormal(const double gradient[5]);

/// Jacobian of the horizontal motion of the surface, from the first three of these numbers, 1 at rest; where it is 0 or
/// less, the surface folds over itself and foams.
double SurfaceJacobian(const double gradient[3]);

/**
 * A sea at a moment. A particle whose orbit is centered at x0, z0 is at x0 + sum a sin(phi) d, z0 - sum b cos(phi) with
 * phi = k d . x0 - w t + phase.
 *
 * Points in double precision go through the standard library's functions. Points in single precision go through
 * polynomials over whole blocks of points, with phases formed and reduced in double precision; their displacements are
 * good to some 1e-6 of the sum of amplitudes, up to 3e7 waves from the origin, where numbers in single precision are
 * whole waves apart. Each point is computed for itself: results do not depend on ranges.
 *
 * A sea of second order has the waves that pairs of trains force (BoundWave), each with the first trains up to its own
 * two, without PastGradient. Its gradient dX/dy is the mean of dX/dy and dY/dx.
 */
class WaveOrbits
{
public:
  WaveOrbits(const SeaState& sea, const WaveOrbitOptions& options, double time);

  void Evaluate(const OrbitRequest<double>& request, std::size_t begin, std::size_t end) const;
  void Evaluate(const OrbitRequest<float>& request, std::size_t begin, std::size_t end) const;

  /// Stokes drift of a particle at a height over sea level [m], second order in the amplitudes [m/s].
  std::array<double, 2> StokesVelocity(double height, std::size_t trains, const float* shares = nullptr) const;

private:
  enum class Form
  {
    Deep,    ///< a = b = r E
    Finite,  ///< from E and 1/E
    Shallow, ///< from polynomials of k (z + h)
  };

  /// A train at the moment.
  struct Train
  {
    double X; ///< k d
    double Y;
    double Phase; ///< -w t + phase, reduced
    double DirectionX;
    double DirectionY;
    double Frequency;
    Form Kind;
    float Octaves;              ///< k / ln 2
    float WaveNumber;           ///< k
    float Scale;                ///< r / (1 - e^-2kh), or r / sinh kh
    float Mirror;               ///< e^-2kh
    bool IsFree = true;         ///< else a bound wave
    float Up = 1.0f;            ///< vertical over the train's own semi-axis
    int Last = 0;               ///< of the trains that must act on a point
    int First = 0;              ///< the other one of a bound wave
    float PastCosine[MostAges]; ///< cos(w age)
    float PastSine[MostAges];
  };

  struct Block;
  Train MomentOf(const WaveTrain& wave, double depth) const;
  Train MomentOf(const BoundWave& wave) const;
  static double Cross(const Train& bound);
  float ShareOf(const Train& bound, const float* shares) const;
  float Weigh(Block& block, const OrbitRequest<float>& request, const Train& train, std::size_t begin, int count) const;

  void EvaluateBlock(Block& block, const OrbitRequest<float>& request, std::size_t begin, int count) const;
  void StartBlock(Block& block, const OrbitRequest<float>& request, std::size_t begin, int count) const;
  void AddDrift(Block& block, const OrbitRequest<float>& request, const int* counts, const int* sets, int count) const;
  void FindAxes(Block& block, const Train& train, int count) const;
  void AddTrain(Block& block, const OrbitRequest<float>& request, const Train& train, float share, int count) const;
  void AddPast(Block& block, const Train& train, float chop, int count) const;
  void AddLevels(Block& block, const Train& train, float share, int count) const;

  SeaState Sea;
  WaveOrbitOptions Options;
  double Time;
  std::vector<Train> Trains;
  std::vector<BoundWave> Waves;
  std::vector<Train> Bound; ///< Waves as trains with profiles of their own
  bool BySums = false;      ///< of the surface of IsSortedLongCrestedDeep, in place of Bound
};

}

#endif
