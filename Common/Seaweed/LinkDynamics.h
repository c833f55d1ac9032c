// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLinkDynamics_h
#define LittoralLinkDynamics_h

#include "Seaweed/SeaweedJoint.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

// The equations of motion of a batch of trees in a sub-step, a SIMD lane each: for the one file that steps them.

namespace littoral
{

namespace
{

template <typename Real>
using Vector3Of = glm::vec<3, Real>;
template <typename Real>
using Matrix3Of = glm::mat<3, 3, Real>;

// Forward dynamics by the articulated-body algorithm (R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008,
// chapter 7, table 7.1) inside an implicit midpoint rule. Spatial vectors are (linear, angular), about the foot of a
// link, in axes of the world. Equations of a link, f = the link, p = its parent, g = half of the step:
//
//   (1) c   = X c_p + g (dS/dt q' + w_p x S q') + S (q' - q0')   velocity product, summed down the tree
//   (2) I^A = I + g R                                            inertia, R: resistance of the water, f = f_0 - R v
//   (3) -p^A = g f - g (v x* I v - f_A) - I c                    bias impulse
//   (4) U   = I^A S,  D = S^T U + g (g K + d + 2 c_f)            joint inertia
//   (5) u   = -S^T p^A - g (K q + d q' + c_f (2 q' - q0'))       joint impulse
//   (6) I^a = I^A - U D^-1 U^T,  p^a = p^A + U D^-1 u
//   (7) I^A_p += X^T I^a X,  p^A_p += X^T p^a
//   (8) dq' = D^-1 (u - U^T X dv_p),  dv = X dv_p + S dq'
//
// Table 7.1 has accelerations and forces; here they are corrections of the velocities in the middle of the step and
// impulses over its half. Velocity products are known before the pass to the root, so that the whole of them is in the
// bias (3), and (6) has no term I^a c. In v x* I v are the masses of the tissue; what the added mass exerts on a link
// that turns is f_A (StripForce), with its velocity over the ground, which does no work; that with the water's is in f.
// Joints push back within the step: K, d are their stiffness and damping, c_f the damping of springs that the step does
// not resolve.

/// Largest rotation of a joint in a step [rad], whatever drives it, so that what blows up stays finite.
constexpr double MaximumRotation = 0.8;
/// A step in which a link turns further [rad] is halved.
constexpr double SubstepRotation = 0.5;
/// The midpoint is iterated until no joint is corrected by more than ConvergedCorrection [rad in the step]. Where
/// corrections exceed MaximumCorrection after MaximumIterations, the step is halved.
constexpr double ConvergedCorrection = 5e-3;
constexpr double MaximumCorrection = 0.05;
constexpr int MinimumIterations = 2; // for second order
constexpr int MaximumIterations = 4;
/// A step that gains more energy than the work of the loads, by this part of the kinetic energy, is halved. Smaller
/// gains are removed by scaling the rates.
constexpr double MaximumEnergyError = 0.05;
/// Sub-steps are 1, 2, 4 ... of these parts of a step.
constexpr int TicksPerStep = 64;
/// The stop of a joint, which keeps blades from folding flat: x beyond MaximumBend [rad] its potential is
/// K_s/2 x^2 / (1 - x/X) with X = StopRange [rad], from StopLinearPart of X on continued by its tangent force.
constexpr double MaximumBend = 1.75;
constexpr double StopRange = 1.05;
constexpr double StopLinearPart = 0.95;

/// A symmetric 3 x 3 matrix.
template <typename Real>
struct SymmetricMatrix
{
  using Vector = Vector3Of<Real>;
  Real xx, xy, xz, yy, yz, zz;

  LITTORAL_INLINE SymmetricMatrix(const Real& diagonal = 0.0)
    : xx(diagonal)
    , xy(0.0)
    , xz(0.0)
    , yy(diagonal)
    , yz(0.0)
    , zz(diagonal)
  {
  }
  LITTORAL_INLINE Vector operator*(const Vector& v) const
  {
    return { this->xx * v.x + this->xy * v.y + this->xz * v.z, this->xy * v.x + this->yy * v.y + this->yz * v.z,
      this->xz * v.x + this->yz * v.y + this->zz * v.z };
  }
  LITTORAL_INLINE void operator+=(const SymmetricMatrix& o)
  {
    this->xx += o.xx;
    this->xy += o.xy;
    this->xz += o.xz;
    this->yy += o.yy;
    this->yz += o.yz;
    this->zz += o.zz;
  }
  LITTORAL_INLINE void AddDiagonal(const Real& d)
  {
    this->xx += d;
    this->yy += d;
    this->zz += d;
  }
  /// Adds f a a^T.
  LITTORAL_INLINE void AddOuterProduct(const Real& f, const Vector& a)
  {
    const Vector b = f * a;
    this->xx += a.x * b.x;
    this->xy += a.x * b.y;
    this->xz += a.x * b.z;
    this->yy += a.y * b.y;
    this->yz += a.y * b.z;
    this->zz += a.z * b.z;
  }
  /// Subtracts a b^T + c d^T, which must be symmetric.
  LITTORAL_INLINE void Subtract(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
  {
    this->xx -= a.x * b.x + c.x * d.x;
    this->xy -= a.x * b.y + c.x * d.y;
    this->xz -= a.x * b.z + c.x * d.z;
    this->yy -= a.y * b.y + c.y * d.y;
    this->yz -= a.y * b.z + c.y * d.z;
    this->zz -= a.z * b.z + c.z * d.z;
  }
};

/// S [a], with the cross-product matrix [a]: [a] x = a x x.
template <typename Real>
LITTORAL_INLINE Matrix3Of<Real> TimesCross(const SymmetricMatrix<Real>& s, const Vector3Of<Real>& a)
{
  // Columns of [a] are a x e_k.
  const Real none(0.0);
  using Vector = Vector3Of<Real>;
  return { s * Vector(none, a.z, -a.y), s * Vector(-a.z, none, a.x), s * Vector(a.y, -a.x, none) };
}

/// [a] M.
template <typename Real>
LITTORAL_INLINE Matrix3Of<Real> CrossTimes(const Vector3Of<Real>& a, const Matrix3Of<Real>& m)
{
  return { glm::cross(a, m[0]), glm::cross(a, m[1]), glm::cross(a, m[2]) };
}

/// A unit vector rotated by a small rotation vector at a right angle to it.
template <typename Real>
LITTORAL_INLINE Vector3Of<Real> RotateUnit(const Vector3Of<Real>& direction, const Vector3Of<Real>& turn)
{
  const Real square = glm::dot(turn, turn);
  const Vector3Of<Real> swung =
    CosineOfSmall(square) * direction + SineRatioOfSmall(square) * glm::cross(turn, direction);
  return swung / Length(swung);
}

/// A link during a sub-step. The unknown is the correction of the velocity of its foot and of its spin in the middle of
/// the sub-step. I^A is the quadratic form [InertiaLinear InertiaMixed; InertiaMixed^T InertiaAngular] in both.
template <typename Real>
struct LinkDynamics
{
  using Vector = Vector3Of<Real>;
  LinkStateOf<Real> Start; // of the sub-step
  LinkPoseOf<Real> StartPose;
  WaterOf<Real> Water; // in the middle of the step
  LinkStateOf<Real> End;
  LinkPoseOf<Real> EndPose;
  LinkStateOf<Real> State; // in its middle, the current iterate
  Vector MiddleRate;       // rate of State; Bending: tangent to the sphere at Start
  LinkPoseOf<Real> Pose;   // of State
  LinkFaceOf<Real> Face;
  glm::qua<Real> ParentRotation;
  Vector Arm;                   // from the parent's foot to the link's, now [m]
  Vector VelocityProductLinear; // c, eq. 1
  Vector VelocityProductAngular;
  Vector JointAxes[2];                 // at right angles to the link
  Vector MotionSubspace[2];            // S: spin for a unit rate about these axes, twist included; no linear part
  Vector AxisRate;                     // dS/dt q'
  Real Rate[2];                        // q', along the axes
  Real RateChange[2];                  // q' - q0', since the start
  Real Deflection[2];                  // q, along the axes
  Real StopTorque;                     // of the stop, for a deflection of 1 [N m/rad]
  Real StopStiffness;                  // [N m/rad]
  SymmetricMatrix<Real> InertiaLinear; // I^A, eq. 2
  Matrix3Of<Real> InertiaMixed;
  SymmetricMatrix<Real> InertiaAngular;
  Vector BiasImpulseLinear; // -p^A, eq. 3; in the pass from the root: the correction dv, eq. 8
  Vector BiasImpulseAngular;
  Vector Force;          // of the water on the link and all that grows on it [N]
  LinkLoadOf<Real> Load; // of the water on the link [N, N m]
  Vector WorkForce;      // Load of the last iteration that counted in a lane
  Vector WorkMoment;
  Vector Spin;
  Real Tension;      // arms times pulls, which straighten the link [N m]
  Vector ULinear[2]; // U, eq. 4
  Vector UAngular[2];
  Real InverseJointInertia[3]; // D^-1: 00, 01, 11
  Real JointImpulse[2];        // u, eq. 5
};

/// Lane by lane, the first where isFirst is 1, the second where it is 0.
template <typename Real>
LITTORAL_INLINE Vector3Of<Real> Select(const Real& isFirst, const Vector3Of<Real>& first, const Vector3Of<Real>& second)
{
  const Real half(0.5);
  return { SelectLess(half, isFirst, first.x, second.x), SelectLess(half, isFirst, first.y, second.y),
    SelectLess(half, isFirst, first.z, second.z) };
}

template <typename Real>
LITTORAL_INLINE glm::qua<Real> Select(const Real& isFirst, const glm::qua<Real>& first, const glm::qua<Real>& second)
{
  const Real half(0.5);
  return { SelectLess(half, isFirst, first.w, second.w), SelectLess(half, isFirst, first.x, second.x),
    SelectLess(half, isFirst, first.y, second.y), SelectLess(half, isFirst, first.z, second.z) };
}

template <typename Real>
LITTORAL_INLINE Real Square(const Real& x)
{
  return x * x;
}

/// Mean of (v + s t)^2 over 0 <= s <= 1: v^2 + v t + t^2 / 3.
template <typename Real>
LITTORAL_INLINE Real MeanSquare(const Real& v, const Real& t)
{
  return v * (v + t) + Real(1.0 / 3.0) * t * t;
}

/// Parallel transport of a tangent vector of the unit sphere along the great circle from one direction to another.
template <typename Real>
LITTORAL_INLINE Vector3Of<Real> ParallelTransport(
  const Vector3Of<Real>& tangent, const Vector3Of<Real>& from, const Vector3Of<Real>& to)
{
  const Real open = Max(Real(1.0) + glm::dot(from, to), Real(0.05));
  return tangent - (glm::dot(tangent, to) / open) * (from + to);
}

/// The equations of a link in an iteration for the middle of a sub-step, whose length is each lane's own.
template <typename Real>
class BatchDynamics
{
public:
  using Vector = Vector3Of<Real>;
  using Matrix = Matrix3Of<Real>;
  using Symmetric = SymmetricMatrix<Real>;
  using Link = LinkDynamics<Real>;

  BatchDynamics(const SeaweedOptions& options)
    : Options(options)
    , IsImplicit(options.Integrator == SeaweedIntegrator::Implicit)
  {
  }

  Real Half{ 0.0 }; // g: half of the sub-step [s]; explicit Euler: the step

  /// Predicts the middle with the rates of the start.
  LITTORAL_INLINE void StartLink(Link& link) const
  {
    link.State.Shape = link.Start.Shape;
    link.State.Rate = link.Start.Rate;
    link.MiddleRate = link.Start.Rate;
    if (this->IsImplicit)
    {
      this->MoveToMiddle(link);
    }
  }

  /// Pose, joint, velocity product (1), inertia (2), loads and bias (3) of the link alone, those of its parent known.
  LITTORAL_INLINE void InitializeLink(
    const LinkBody<Real>& body, const LinkBody<Real>* parentBody, const Link* parent, Link& link) const
  {
    const Real g = this->Half;
    PoseLink<Real>(this->Options.Joint, body, link.State, parentBody, parent ? &parent->Pose : nullptr, link.Pose);
    const LinkPoseOf<Real>& pose = link.Pose;
    link.Face = FaceOf<Real>(body, pose);
    link.ParentRotation = parent ? parent->Pose.Rotation : IdentityRotation<Real>();
    const Vector relative = this->SetAxes(body, parentBody, link);

    // (1) c = X c_p + g (dS/dt q' + w_p x S q') + S (q' - q0'); on the arm r, g w_p x (w_p x r)
    link.Arm = Vector(Real(0.0));
    link.VelocityProductLinear = link.Arm;
    link.VelocityProductAngular =
      g * link.AxisRate + link.RateChange[0] * link.MotionSubspace[0] + link.RateChange[1] * link.MotionSubspace[1];
    if (parent)
    {
      const Vector& spin = parent->Pose.Spin;
      link.Arm = pose.Foot - parent->Pose.Foot;
      link.VelocityProductAngular += parent->VelocityProductAngular + g * glm::cross(spin, relative);
      link.VelocityProductLinear = parent->VelocityProductLinear +
        glm::cross(parent->VelocityProductAngular, link.Arm) + g * glm::cross(spin, glm::cross(spin, link.Arm));
    }

    link.Load = LoadOn<Real>(this->Options, body, pose, link.Face, link.Water);
    link.Force = link.Load.Force;
    link.Tension = glm::dot(pose.Axis, link.Load.Moment);
    // With the water's velocity in it, a tension would depend on who observes
    link.Load.Force += link.Load.Turning;
    link.Load.Moment += Real(0.5) * body.Length * link.Load.Turning;
    // (3) -p^A = g f - g (v x* I v - f_A) - I c
    this->SetBias(body, link);
    // (2) I^A = I + g R: drag falls as the velocity is corrected
    this->SetInertia(body, this->IsImplicit ? g : Real(0.0), link);
  }

  /// Joint inertia (4) and joint impulse (5), I^A and p^A being complete.
  LITTORAL_INLINE void SolveJoint(const LinkBody<Real>& body, Link& link) const
  {
    const Vector& e = link.Pose.Axis;
    const Real g = this->Half;
    const Real implicit = this->IsImplicit ? g : Real(0.0);
    // A tension T along a segment of length l is a spring T l against its rotation: I^A + g^2 T l (1 - e e^T)
    const Real straightens = implicit * implicit * Max(link.Tension, Real(0.0));
    link.InertiaAngular.AddDiagonal(straightens);
    link.InertiaAngular.AddOuterProduct(-straightens, e);
    // (4) U = I^A S
    for (int k = 0; k < 2; ++k)
    {
      link.UAngular[k] = link.InertiaAngular * link.MotionSubspace[k];
      link.ULinear[k] = link.InertiaMixed * link.MotionSubspace[k];
    }
    // (4) S^T U
    Real d00 = glm::dot(link.MotionSubspace[0], link.UAngular[0]);
    const Real d01 = glm::dot(link.MotionSubspace[0], link.UAngular[1]);
    Real d11 = glm::dot(link.MotionSubspace[1], link.UAngular[1]);
    const Real stiffness = body.Stiffness + link.StopStiffness;
    const Real damping = body.Damping + SelectLess(Real(0.0), link.StopTorque, body.StopDamping, Real(0.0));
    const Real bent = body.Stiffness + link.StopTorque;
    // Numerical damping of springs that the step does not resolve, by the rate at its end 2 q' - q0':
    // c_f = K g s / (1 + s), s = (g^2 K (D^-1)_kk)^2; it falls with the fifth power of the step.
    const Real stiff = implicit * implicit * body.Stiffness;
    const Real squared[2] = { Square(stiff * d11), Square(stiff * d00) };
    const Real det = Square(d00 * d11 - d01 * d01);
    const Real all = implicit * body.Stiffness;
    const Real filter[2] = { all * squared[0] / (squared[0] + det), all * squared[1] / (squared[1] + det) };
    // (5) u = -S^T p^A - g (K q + d q' + c_f (2 q' - q0'))
    for (int k = 0; k < 2; ++k)
    {
      link.JointImpulse[k] = glm::dot(link.MotionSubspace[k], link.BiasImpulseAngular) -
        g * (bent * link.Deflection[k] + damping * link.Rate[k] + filter[k] * (link.Rate[k] + link.RateChange[k]));
    }
    // (4) D = S^T U + g (g K + d + 2 c_f), inverted
    const Real soft = implicit * (implicit * stiffness + damping);
    d00 += soft + Real(2.0) * implicit * filter[0];
    d11 += soft + Real(2.0) * implicit * filter[1];
    const Real scale = Real(1.0) / (d00 * d11 - d01 * d01);
    link.InverseJointInertia[0] = scale * d11;
    link.InverseJointInertia[1] = -scale * d01;
    link.InverseJointInertia[2] = scale * d00;
  }

  /// Adds the articulated inertia and bias of a link, as felt through its joint, to its parent.
  LITTORAL_INLINE void PropagateToParent(Link& link, Link& parent) const
  {
    // (6) I^a = I^A - U D^-1 U^T,  -p^a = -p^A - U D^-1 u
    Vector linearByD[2]; // U D^-1
    Vector angularByD[2];
    for (int k = 0; k < 2; ++k)
    {
      linearByD[k] = link.InverseJointInertia[k] * link.ULinear[0] + link.InverseJointInertia[k + 1] * link.ULinear[1];
      angularByD[k] =
        link.InverseJointInertia[k] * link.UAngular[0] + link.InverseJointInertia[k + 1] * link.UAngular[1];
    }
    link.InertiaLinear.Subtract(linearByD[0], link.ULinear[0], linearByD[1], link.ULinear[1]);
    link.InertiaAngular.Subtract(angularByD[0], link.UAngular[0], angularByD[1], link.UAngular[1]);
    Matrix mixed = link.InertiaMixed;
    for (int column = 0; column < 3; ++column)
    {
      mixed[column] -= linearByD[0] * link.UAngular[0][column] + linearByD[1] * link.UAngular[1][column];
    }
    const Vector linear =
      link.BiasImpulseLinear - linearByD[0] * link.JointImpulse[0] - linearByD[1] * link.JointImpulse[1];
    const Vector angular =
      link.BiasImpulseAngular - angularByD[0] * link.JointImpulse[0] - angularByD[1] * link.JointImpulse[1];
    // (7) X^T I^a X and X^T p^a, about the parent's foot: v = v_p - [r] w_p, with r = Arm
    const Matrix shifted = mixed - TimesCross(link.InertiaLinear, link.Arm);
    const Matrix a = CrossTimes(link.Arm, shifted);
    const Matrix b = CrossTimes(link.Arm, mixed);
    parent.InertiaLinear += link.InertiaLinear;
    parent.InertiaMixed += shifted;
    parent.InertiaAngular += link.InertiaAngular;
    parent.InertiaAngular.xx += a[0].x + b[0].x;
    parent.InertiaAngular.xy += a[1].x + b[0].y;
    parent.InertiaAngular.xz += a[2].x + b[0].z;
    parent.InertiaAngular.yy += a[1].y + b[1].y;
    parent.InertiaAngular.yz += a[2].y + b[1].z;
    parent.InertiaAngular.zz += a[2].z + b[2].z;
    parent.BiasImpulseLinear += linear;
    parent.BiasImpulseAngular += angular + glm::cross(link.Arm, linear);
    parent.Force += link.Force;
    parent.Tension += glm::dot(link.Arm, link.Force);
  }

  /// Corrects the middle of a link in lanes that are open, the correction of its parent being known. Returns the
  /// correction as a rotation in the step [rad].
  LITTORAL_INLINE Real IntegrateLink(const Real& isOpen, const Link* parent, Link& link) const
  {
    link.WorkForce = Select(isOpen, link.Load.Force, link.WorkForce);
    link.WorkMoment = Select(isOpen, link.Load.Moment, link.WorkMoment);
    link.Spin = Select(isOpen, link.Pose.Spin, link.Spin);
    Vector dv(Real(0.0));
    Vector dw(Real(0.0));
    if (parent)
    {
      // X dv_p
      dw = parent->BiasImpulseAngular;
      dv = parent->BiasImpulseLinear + glm::cross(dw, link.Arm);
    }
    // (8) dq' = D^-1 (u - U^T X dv_p),  dv = X dv_p + S dq'
    Real impulse[2];
    for (int k = 0; k < 2; ++k)
    {
      impulse[k] = link.JointImpulse[k] - glm::dot(link.UAngular[k], dw) - glm::dot(link.ULinear[k], dv);
    }
    Real change[2];
    for (int k = 0; k < 2; ++k)
    {
      change[k] = SelectLess(Real(0.5), isOpen,
        link.InverseJointInertia[k] * impulse[0] + link.InverseJointInertia[k + 1] * impulse[1], Real(0.0));
      dw += change[k] * link.MotionSubspace[k];
    }
    link.BiasImpulseLinear = dv;
    link.BiasImpulseAngular = dw;
    this->CorrectRate(change, link);
    return Real(2.0) * this->Half * Sqrt(change[0] * change[0] + change[1] * change[1]);
  }

  /// State and pose at the end of the sub-step: q1 = q0 + 2 g q', q1' = 2 q' - q0'; explicit Euler, eq. 10 of the
  /// paper: q1 = q0 + g q0', q1' = q'.
  LITTORAL_INLINE void FinishLink(
    const LinkBody<Real>& body, const LinkBody<Real>* parentBody, const Link* parent, Link& link) const
  {
    Vector rate = Real(2.0) * link.MiddleRate - link.Start.Rate;
    Vector turn = Real(2.0) * this->Half * link.MiddleRate;
    if (!this->IsImplicit)
    {
      rate = link.MiddleRate;
      turn = this->Half * link.Start.Rate;
    }
    const Real most = Max(Length(turn), this->Half * Length(rate));
    const Real factor =
      SelectLess(Real(MaximumRotation), most, Real(MaximumRotation) / Max(most, Real(1e-300)), Real(1.0));
    turn *= factor;
    rate *= factor;
    link.End.Rate = rate;
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      link.End.Shape = link.Start.Shape + turn;
    }
    else
    {
      link.End.Shape = RotateUnit(link.Start.Shape, turn);
      link.End.Rate = ParallelTransport(rate, link.Start.Shape, link.End.Shape);
      link.End.Rate -= glm::dot(link.End.Rate, link.End.Shape) * link.End.Shape;
    }
    PoseLink<Real>(this->Options.Joint, body, link.End, parentBody, parent ? &parent->EndPose : nullptr, link.EndPose);
  }

  /// Work of the loads on a link in the sub-step, F . dx + M . de [J]; exact for dead loads, which have a potential.
  LITTORAL_INLINE Real LoadWork(const Link& link) const
  {
    return glm::dot(link.WorkForce, link.EndPose.Foot - link.StartPose.Foot) +
      glm::dot(link.WorkMoment, link.EndPose.Axis - link.StartPose.Axis);
  }

  /// T = 1/2 integral of (m v.v + m_n (v.n)^2 + m_b (v.b)^2) + J/2 (w.e)^2 [J]
  LITTORAL_INLINE Real KineticEnergy(const LinkBody<Real>& body, const LinkPoseOf<Real>& pose) const
  {
    const LinkFaceOf<Real> face = FaceOf<Real>(body, pose);
    const Vector turning = body.Length * glm::cross(pose.Spin, pose.Axis);
    const Real normal = MeanSquare(glm::dot(pose.Velocity, face.Normal), glm::dot(turning, face.Normal));
    const Real edge = MeanSquare(glm::dot(pose.Velocity, face.Edge), glm::dot(turning, face.Edge));
    const Real along = Square(glm::dot(pose.Velocity, pose.Axis));
    const Real spin = Square(glm::dot(pose.Spin, pose.Axis));
    return Real(0.5) *
      ((body.Mass + body.FaceMass) * normal + (body.Mass + body.EdgeMass) * edge + body.Mass * along +
        body.AxialInertia * spin);
  }

  /// V = K/2 q^2 + K_s/2 x^2 / (1 - x/X) [J]; beyond StopLinearPart the stop's by its second order expansion.
  LITTORAL_INLINE Real SpringEnergy(const LinkBody<Real>& body, const LinkStateOf<Real>& state) const
  {
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      return Real(0.5) * body.Stiffness * (Square(state.Shape.x - body.Theta) + Square(state.Shape.y - body.Phi));
    }
    const Real angle = AngleOf(Length(glm::cross(body.Axis, state.Shape)), glm::dot(body.Axis, state.Shape));
    const Real ratio = Max(Real(0.0), angle - Real(MaximumBend)) * Real(1.0 / StopRange);
    const Real y = Min(ratio, Real(StopLinearPart));
    const Real left = Real(1.0) / (Real(1.0) - y);
    const Real beyond = ratio - y;
    const Real stop = Real(0.5) * y * y * left + Real(0.5) * y * (Real(2.0) - y) * left * left * beyond +
      Real(0.5) * left * left * left * beyond * beyond;
    return Real(0.5) * body.Stiffness * angle * angle + body.StopStiffness * Real(StopRange * StopRange) * stop;
  }

private:
  const SeaweedOptions& Options;
  bool IsImplicit;

  /// (2) I + time R of the link about its foot, in axes b (width), n (face normal) and e (axis).
  LITTORAL_INLINE void SetInertia(const LinkBody<Real>& body, const Real& time, Link& link) const
  {
    const LinkLoadOf<Real>& load = link.Load;
    const Vector& b = link.Face.Edge;
    const Vector& n = link.Face.Normal;
    const Real half = Real(0.5) * body.Length;
    const Real third = Real(1.0 / 3.0) * body.Length * body.Length;
    const Real massB = body.Mass + body.EdgeMass;
    const Real massN = body.Mass + body.FaceMass;
    const Real linearB = massB + time * load.EdgeDrag.Sum;
    const Real linearN = massN + time * load.FaceDrag.Sum;
    const Real linearE = body.Mass + time * load.Friction;
    const Real firstB = half * massB + time * load.EdgeDrag.First;
    const Real firstN = half * massN + time * load.FaceDrag.First;
    const Real secondB = third * massB + time * load.EdgeDrag.Second;
    const Real secondN = third * massN + time * load.FaceDrag.Second;
    // Linear = m_b b b^T + m_n n n^T + m_e e e^T
    link.InertiaLinear = Symmetric(linearE);
    link.InertiaLinear.AddOuterProduct(linearB - linearE, b);
    link.InertiaLinear.AddOuterProduct(linearN - linearE, n);
    // Mixed = first_b b n^T - first_n n b^T
    const Vector fb = firstB * b;
    const Vector fn = firstN * n;
    link.InertiaMixed = Matrix(fb * n.x - fn * b.x, fb * n.y - fn * b.y, fb * n.z - fn * b.z);
    // Angular = second_n b b^T + second_b n n^T + J e e^T
    link.InertiaAngular = Symmetric(body.AxialInertia);
    link.InertiaAngular.AddOuterProduct(secondN - body.AxialInertia, b);
    link.InertiaAngular.AddOuterProduct(secondB - body.AxialInertia, n);
  }

  /// (3) -p^A = g f - g (v x* I v - f_A) - I c of the link alone, by strips: on the part at s from the foot acts
  /// M (a_0 + s a_1) - g (f_0 + s f_1), with the mass M of tissue and water.
  LITTORAL_INLINE void SetBias(const LinkBody<Real>& body, Link& link) const
  {
    const Real g = this->Half;
    const Vector& b = link.Face.Edge;
    const Vector& n = link.Face.Normal;
    const Vector& e = link.Pose.Axis;
    const Real half = Real(0.5) * body.Length;
    const Real third = Real(1.0 / 3.0) * body.Length * body.Length;
    const Vector mass(body.Mass + body.EdgeMass, body.Mass + body.FaceMass, body.Mass);
    const Vector v = InAxes(link.Face, e, link.Pose.Velocity);
    const Vector w = InAxes(link.Face, e, link.Pose.Spin);
    const Vector angular = InAxes(link.Face, e, link.VelocityProductAngular);
    // a_0 = c_v, a_1 = c_w x e + g w x (w x e)
    const Vector first = InAxes(link.Face, e, link.VelocityProductLinear);
    const Vector second(angular.y + g * w.x * w.z, g * w.y * w.z - angular.x, -g * (w.x * w.x + w.y * w.y));
    // f_0 = f_A(v), f_1 = f_A(w x e)
    const Vector atFoot = mass * first - g * StripForce(body, w, v);
    const Vector along = mass * second - g * StripForce(body, w, Vector(w.y, -w.x, Real(0.0)));
    const Vector force = atFoot + half * along;
    const Vector moment = half * atFoot + third * along;
    // e x moment, and J (c_w.e) e + g w x J (w.e) e
    const Real axial = g * body.AxialInertia * w.z;
    const Vector torque(axial * w.y - moment.y, moment.x - axial * w.x, body.AxialInertia * angular.z);
    link.BiasImpulseLinear = g * link.Load.Force - (force.x * b + force.y * n + force.z * e);
    link.BiasImpulseAngular = g * glm::cross(e, link.Load.Moment) - (torque.x * b + torque.y * n + torque.z * e);
  }

  /// State in the middle: q = q0 + g q'.
  LITTORAL_INLINE void MoveToMiddle(Link& link) const
  {
    const Real speed = this->Half * Length(link.MiddleRate);
    const Real most(0.5 * MaximumRotation);
    link.MiddleRate *= SelectLess(most, speed, most / Max(speed, Real(1e-300)), Real(1.0));
    const Vector turn = this->Half * link.MiddleRate;
    link.State.Rate = link.MiddleRate; // the axis of the rotation, hence the same at both ends
    link.State.Shape =
      this->Options.Joint == SeaweedJoint::Tilting ? link.Start.Shape + turn : RotateUnit(link.Start.Shape, turn);
  }

  /// Torque and stiffness of the stop, the derivatives of K_s/2 x^2 / (1 - x/X), y = x/X: K_s X y (2 - y) / (1 - y)^2 /
  /// 2 and K_s / (1 - y)^3. The paper has no stop.
  LITTORAL_INLINE void SetStop(const LinkBody<Real>& body, const Real& angle, Link& link) const
  {
    const Real one(1.0);
    const Real strength = this->IsImplicit ? body.StopStiffness : Real(0.0);
    const Real ratio = Max(Real(0.0), angle - Real(MaximumBend)) * Real(1.0 / StopRange);
    const Real y = Min(ratio, Real(StopLinearPart));
    const Real left = one / (one - y);
    const Real stiffness = strength * left * left * left;
    const Real torque = strength * Real(0.5) * y * (Real(2.0) - y) * left * left + stiffness * (ratio - y);
    link.StopTorque = Real(StopRange) * torque / Max(angle, Real(MaximumBend));
    link.StopStiffness = SelectLess(Real(0.0), ratio, stiffness, Real(0.0));
  }

  /// Axes and motion subspace S of the joint, dS/dt q', and q, q', q' - q0' along the axes. Returns S q'.
  LITTORAL_INLINE Vector SetAxes(const LinkBody<Real>& body, const LinkBody<Real>* parentBody, Link& link) const
  {
    const LinkStateOf<Real>& state = link.State;
    if (this->Options.Joint == SeaweedJoint::Bending)
    {
      const Vector& e = link.Pose.Axis;
      link.JointAxes[0] = link.Face.Edge;
      link.JointAxes[1] = link.Face.Normal;
      const Vector relative = Rotated(link.ParentRotation, state.Rate);
      const Vector gain =
        Rotated(link.ParentRotation, state.Rate - ParallelTransport(link.Start.Rate, link.Start.Shape, state.Shape));
      const Vector a = Rotated(link.ParentRotation, body.Axis);
      // S = b - (b.a) / (1 + a.e) e for each axis b: the shortest arc from the rest direction a to e twists about e
      for (int k = 0; k < 2; ++k)
      {
        link.MotionSubspace[k] = link.JointAxes[k] + ArcTwist(a, e, link.JointAxes[k]);
      }
      const Real open = ArcOpening(a, e);
      const Real part = glm::dot(relative, a) / open;
      const Vector swing = glm::cross(relative, e);
      link.AxisRate = (part * glm::dot(swing, a) / open) * e - part * swing;
      const Vector bend = Rotated(link.ParentRotation, ArcVector(body.Axis, state.Shape, body.Side));
      for (int k = 0; k < 2; ++k)
      {
        link.Rate[k] = glm::dot(relative, link.JointAxes[k]);
        link.RateChange[k] = glm::dot(gain, link.JointAxes[k]);
        link.Deflection[k] = glm::dot(bend, link.JointAxes[k]);
      }
      this->SetStop(body, Length(bend), link);
      return relative + ArcTwist(a, e, relative);
    }
    link.StopTorque = Real(0.0);
    link.StopStiffness = Real(0.0);
    const glm::qua<Real> frame = parentBody ? link.ParentRotation * parentBody->Base : GroundBase<Real>();
    const Vector y = Rotated(frame, Vector(Real(0.0), Real(1.0), Real(0.0)));
    const Vector x = Rotated(frame, Vector(Cos(state.Shape.x), Real(0.0), -Sin(state.Shape.x)));
    link.MotionSubspace[0] = y;
    link.MotionSubspace[1] = x;
    link.AxisRate = (state.Rate.x * state.Rate.y) * glm::cross(y, x); // the tilt's axis turns with the azimuth
    for (int k = 0; k < 2; ++k)
    {
      link.Rate[k] = state.Rate[k];
      link.RateChange[k] = state.Rate[k] - link.Start.Rate[k];
    }
    link.Deflection[0] = state.Shape.x - body.Theta;
    link.Deflection[1] = state.Shape.y - body.Phi;
    return link.Rate[0] * y + link.Rate[1] * x;
  }

  /// Adds dq' to the rates.
  LITTORAL_INLINE void CorrectRate(const Real change[2], Link& link) const
  {
    if (this->Options.Joint == SeaweedJoint::Tilting)
    {
      link.MiddleRate += Vector(change[0], change[1], Real(0.0));
    }
    else
    {
      const Vector turned =
        Rotated(Conjugate(link.ParentRotation), change[0] * link.JointAxes[0] + change[1] * link.JointAxes[1]);
      link.MiddleRate += ParallelTransport(turned, link.State.Shape, link.Start.Shape);
    }
    if (this->IsImplicit)
    {
      this->MoveToMiddle(link);
    }
  }
};

}

}

#endif
