// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFlowPrimitives_h
#define LittoralFlowPrimitives_h

#include "Currents/LimitedSources.h"
#include "Currents/WaterLayer.h"
#include "Geometry/BoxCells.h"
#include "Geometry/ViewFrustum.h"

#include <string>
#include <vector>

namespace littoral
{

/// The four flow primitives of Coulais et al., section 3.2.2 and figure 2. Values are part of the data: never renumber.
enum class FlowType
{
  Uniform = 0,
  Source = 1,
  Sink = 2,
  Vortex = 3,
};

inline constexpr int NumberOfFlowTypes = 4;

/// Name and parameters of a type of flow, for its users. A new type is an enumerator, a row of FlowField and its
/// velocity.
struct FlowTraits
{
  const char* Name;  ///< as in the enumeration
  bool HasAxis;      ///< whether Axis counts
  bool HasCore;      ///< whether CoreRadius counts
  bool IsPoint;      ///< whether it flows from or to its center, which then has to lie in the water
  bool Captures;     ///< whether what comes into its core stays there
  bool IsSolenoidal; ///< whether it is free of divergence wherever its influence does not end
};

/// The traits of a type, which must be one of the enumeration.
const FlowTraits& TraitsOf(FlowType type);

/// A flow of water around a place. Cores keep its velocity finite everywhere.
struct FlowPrimitive
{
  FlowType Type = FlowType::Uniform;
  double Strength = 0.2;         ///< uniform: speed [m/s]; source, sink: discharge [m3/s]; vortex: circulation [m2/s]
  Vector3 Center{ 0.0 };         ///< [m]; of no effect in a uniform flow without InfluenceRadius
  Vector3 Axis{ 1.0, 0.0, 0.0 }; ///< of a uniform flow and of a vortex, of any length but 0
  double CoreRadius = 0.5;       ///< [m], positive; of no effect in a uniform flow
  double InfluenceRadius = 0.0;  ///< [m], beyond which there is no flow; 0: it reaches everywhere
  Box InfluenceBox;              ///< [m], within which the flow is whole; of no effect without InfluenceMargin
  double InfluenceMargin = 0.0;  ///< distance from the box [m] at which the flow has ended; 0: there is no box
};

/// Why a primitive cannot be, in words for a user; empty if it can.
std::string WhyInvalid(const FlowPrimitive& primitive);

/**
 * The sum of flow primitives. With R from the center, e the core and Q, G the strengths:
 *  - source: Q R / (4 pi (R^2 + e^2)^(3/2)), a sink with the other sign;
 *  - vortex: G / (2 pi q) (1 - exp(-q^2/e^2)) around the axis, q from the axis (Lamb and Oseen);
 *  - within an influence radius I: times (1 - R^2/I^2)^2, which ends with no jump in velocity or its slope;
 *  - at the distance d from an influence box of margin M: times (1 - d^2/M^2)^2, likewise, and 1 in the box.
 *
 * Primitives that end are found by a grid of cells: many of them cost no more than those that are near.
 *
 * In a layer of water nothing flows through the bed and the surface:
 *  - a uniform flow keeps its horizontal part alone;
 *  - sources and sinks have their images beyond the walls. Between two walls these are infinitely many: those up to
 * four depths away are summed one by one, the others as lines, with the first end correction of Euler and Maclaurin;
 *  - of a vortex, the part of its axis in the water counts, by the law of Biot and Savart times the core's share, and
 *    its images, so that the axis goes on beyond a wall as if seen in a mirror. It is a turn about its axis at any
 * place, hence free of divergence. Between two walls each of these parts is multiplied by (1 - d^2/(6 depths)^2)^2 at
 * the distance d from it, and a vertical vortex with a core of three depths or more makes up for their circulation. A
 *    vertical vortex is left as it is: it flows through no wall;
 *  - those that end have images that end, of which the ones in reach are summed; a uniform flow that ends has images of
 *    its vertical part.
 *
 * Sources and sinks out of the water have no flow in it.
 */
class FlowField
{
public:
  FlowField() = default;
  explicit FlowField(const std::vector<FlowPrimitive>& primitives, const WaterLayer& layer = {});

  /// Velocity at a place [m/s].
  Vector3 Velocity(const Vector3& place) const;

  /// Whether the flow is the same everywhere, as that of no primitive is.
  bool IsUniform() const { return this->Around.empty() && this->Ending.empty() && this->Columns.empty(); }

  /// Whether there is no primitive.
  bool IsEmpty() const { return this->Count == 0; }

  /// Whether any primitive is a sink.
  bool HasSinks() const { return !this->Sinks.empty(); }

  /**
   * Whether the way from one place to another touches the core of a sink. If so, `to` becomes the place of the way that
   * is nearest to the center of that sink, the first of them in order.
   */
  bool Capture(const Vector3& from, Vector3& to) const;

private:
  /// A primitive, or an image of one, with what does not depend on the place worked out.
  struct Local
  {
    FlowType Type;
    Vector3 Center;
    Vector3 Axis;            ///< of length 1
    double Factor;           ///< uniform: speed; source, sink: Q/4pi, signed; vortex: G/2pi
    double CoreSquared;      ///< [m2]
    double InverseCore;      ///< 1 / CoreSquared
    double InverseInfluence; ///< one over the square of the influence radius; 0: it has none
    Box Whole;               ///< the influence box
    double InverseMargin;    ///< one over the square of its margin; 0: it has none
    bool IsPart = false;     ///< whether it is a part of a vortex, not all of its axis
    double First = 0.0;      ///< begin of that part along the axis [m], or -infinity
    double Last = 0.0;       ///< end of it [m], or infinity
    double InverseFade =
      0.0; ///< one over the square of the distance from the part at which it has ended; 0: it has none

    /// The flow at a place, of an arm from the center, with a factor in place of Factor.
    Vector3 Flow(const Vector3& arm, double squaredArm, double factor) const;
    /// Flow of this segment of the axis over that of the whole axis, at the squared distance q2 from the axis and s
    /// along it.
    double PartShare(double q2, double s) const;
    /// Attenuation of the flow at a place, 0 to 1.
    double Share(const Vector3& place, double squaredArm) const;
  };
  /// The far images of a source between two walls: an even vertical line, less the part where images are summed.
  struct Column
  {
    double X;
    double Y;
    double Factor; ///< half of Q/4pi over the depth
    double CoreSquared;
    double Lows[2]; ///< ends of what is left out, of the source's own sequence and the mirrored one [m]
    double Highs[2];

    Vector3 Flow(const Vector3& place) const;
  };
  struct Ball
  {
    Vector3 Center;
    double RadiusSquared;
  };

  struct Reflection;
  struct Row;
  static const Row Rows[NumberOfFlowTypes];
  friend const FlowTraits& TraitsOf(FlowType type);
  static std::vector<Reflection> ReflectionsOf(const WaterLayer& layer, int maximumImages);
  static Local Reflected(const Local& local, const Reflection& reflection);

  static bool IsLevelUniform(const Local& local);
  static void MirrorUniform(Local& image, const Reflection& reflection);
  static bool IsUprightVortex(const Local& local);
  static bool ClipVortex(Local& local, const WaterLayer& layer);
  static void MirrorVortex(Local& image, const Reflection& reflection);

  void Add(const Local& local, const FlowPrimitive& primitive);
  void AddBetweenWalls(const Local& local, const FlowPrimitive& primitive, const WaterLayer& layer);
  void AddImages(const Local& local, const FlowPrimitive& primitive, const WaterLayer& layer);
  void AddSourceStack(const Local& local, const WaterLayer& layer);
  void AddVortexChain(const Local& local, const WaterLayer& layer);

  Vector3 Everywhere{ 0.0 };
  std::vector<Local> Around; ///< flows that reach everywhere
  std::vector<Local> Ending; ///< flows with an end
  LimitedSources Limited;    ///< the same, if all are sources and sinks that end about a box
  std::vector<Box> Reaches;  ///< where they end
  std::vector<Column> Columns;
  BoxCells Cells; ///< of Reaches
  std::vector<Ball> Sinks;
  std::size_t Count = 0;
};

}

#endif
