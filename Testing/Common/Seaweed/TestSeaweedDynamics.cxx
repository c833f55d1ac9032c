// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Chains in three dimensions against equations in joint coordinates: Lagrange's for the tissue, whose kinetic energy
// comes from complex-step derivatives of positions and frames and is differentiated by differences; and d'Alembert's
// for the water, strip by strip, f = -m_b (dV_c/dt)_c - (m_n - m_b) d/dt(V.n) n, V the velocity through the water, c
// its part across the link, with the time derivatives as differences along the motion. All is taken through time by
// Runge and Kutta's rule. Nothing is shared with the recursion under test but the description of the links.
#include "Numerics/Constants.h"
#include "Seaweed/SeaweedJoint.h"
#include "Seaweed/SeaweedMotion.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

using namespace littoral;

namespace
{

using Complex = std::complex<double>;
using Vector = Eigen::Matrix<Complex, 3, 1>;
using Matrix = Eigen::Matrix<Complex, 3, 3>;
using Coordinates = Eigen::VectorXd;

Eigen::Vector3d ToEigen(const Vector3& v)
{
  return { v.x, v.y, v.z };
}

Complex DotOf(const Vector& a, const Vector& b) // without conjugates, so that derivatives pass through
{
  return a(0) * b(0) + a(1) * b(1) + a(2) * b(2);
}

/// Rodrigues' formula: a turn by an angle about a unit axis.
Matrix TurnAbout(const Vector& axis, Complex cosine, Complex sine)
{
  Matrix cross;
  cross << 0.0, -axis(2), axis(1), axis(2), 0.0, -axis(0), -axis(1), axis(0), 0.0;
  return Matrix::Identity() + sine * cross + (1.0 - cosine) * cross * cross;
}

/// Water that is the same everywhere: its velocity at a time [s] is Velocity + time Acceleration.
struct UniformWater
{
  Vector3 Velocity{ 0.0 };
  Vector3 Acceleration{ 0.0 };
};

/// Points of a link, as parts of its length. Two of Gauss's are exact for squares of what is linear along it.
constexpr std::array<double, 2> GaussPoints{ 0.21132486540518713, 0.78867513459481287 };

/// Links as a system of two coordinates a joint. Bending: the logarithm of the direction about the axis of rest;
/// Tilting: theta and phi.
class RodSystem
{
public:
  RodSystem(const std::vector<SeaweedLink>& links, const SeaweedOptions& options, const UniformWater& water)
    : Links(links)
    , Joint(options.Joint)
    , Water(water)
  {
  }

  int Size() const { return 2 * static_cast<int>(this->Links.size()); }

  struct Rod
  {
    Vector Foot;
    Matrix Frame; // from rest
  };

  std::vector<Rod> RodsAt(const Eigen::VectorXcd& q) const
  {
    std::vector<Rod> rods;
    for (std::size_t i = 0; i < this->Links.size(); ++i)
    {
      const SeaweedLink& link = this->Links[i];
      Rod rod;
      Matrix below = Matrix::Identity();
      rod.Foot = ToEigen(link.Foot).cast<Complex>();
      if (link.Parent >= 0)
      {
        below = rods[link.Parent].Frame;
        rod.Foot = rods[link.Parent].Foot + below * ToEigen(link.Foot - this->Links[link.Parent].Foot).cast<Complex>();
      }
      rod.Frame = below * this->JointAt(i, q(2 * i), q(2 * i + 1));
      rods.push_back(rod);
    }
    return rods;
  }

  /// The direction of a link in the frame of its parent, at rest on the axis of rest.
  Vector DirectionAt(std::size_t i, Complex a, Complex b) const
  {
    const Eigen::Vector3d axis = ToEigen(this->Links[i].Axis);
    const Eigen::Vector3d x = axis.unitOrthogonal();
    const Eigen::Vector3d y = axis.cross(x);
    const Complex angle = std::sqrt(a * a + b * b + 1e-24);
    return std::cos(angle) * axis.cast<Complex>() +
      std::sin(angle) / angle * (a * x.cast<Complex>() + b * y.cast<Complex>());
  }

  /// Rods at coordinates whose imaginary parts are rates, as those of all that follows from them.
  std::vector<Rod> MovingRods(const Coordinates& q, const Coordinates& rates) const
  {
    Eigen::VectorXcd moved(q.size());
    for (int k = 0; k < q.size(); ++k)
    {
      moved(k) = Complex(q(k), Tiny * rates(k));
    }
    return this->RodsAt(moved);
  }

  Vector PlaceOn(const Rod& rod, const SeaweedLink& link, double part) const
  {
    return rod.Foot + rod.Frame * (part * link.Length * ToEigen(link.Axis)).cast<Complex>();
  }

  /// The kinetic energy of the tissue, and of the water that moves with it if `hasWater`, which is at rest otherwise.
  double KineticEnergy(const Coordinates& q, const Coordinates& rates, bool hasWater) const
  {
    const std::vector<Rod> rods = this->MovingRods(q, rates);
    double energy = 0.0;
    for (std::size_t i = 0; i < rods.size(); ++i)
    {
      const SeaweedLink& link = this->Links[i];
      const Eigen::Matrix3d frame = rods[i].Frame.real();
      const Eigen::Vector3d edge = frame * ToEigen(link.Side);
      const Eigen::Vector3d axis = frame * ToEigen(link.Axis);
      const Eigen::Vector3d normal = axis.cross(edge);
      for (const double part : GaussPoints)
      {
        const Eigen::Vector3d v = this->PlaceOn(rods[i], link, part).imag() / Tiny;
        energy += 0.25 * link.Mass * v.squaredNorm();
        energy += hasWater
          ? 0.25 * (link.FaceMass * std::pow(v.dot(normal), 2) + link.EdgeMass * std::pow(v.dot(edge), 2))
          : 0.0;
      }
      const Eigen::Matrix3d spin = rods[i].Frame.imag() / Tiny * frame.transpose();
      const Eigen::Vector3d w(spin(2, 1), spin(0, 2), spin(1, 0));
      energy += 0.5 * link.AxialInertia * std::pow(w.dot(axis), 2);
    }
    return energy;
  }

  /// The motion of a strip across a link through the water.
  struct Strip
  {
    Eigen::Vector3d Across; ///< V_c [m/s]
    double Normal;          ///< V.n [m/s]
    Eigen::Vector3d Axis;
    Eigen::Vector3d Face; ///< n
  };

  std::vector<Strip> StripsAt(const Coordinates& q, const Coordinates& rates, double time) const
  {
    std::vector<Strip> strips;
    const std::vector<Rod> rods = this->MovingRods(q, rates);
    const Eigen::Vector3d water = ToEigen(this->Water.Velocity + time * this->Water.Acceleration);
    for (std::size_t i = 0; i < rods.size(); ++i)
    {
      const SeaweedLink& link = this->Links[i];
      Strip strip;
      strip.Axis = rods[i].Frame.real() * ToEigen(link.Axis);
      strip.Face = strip.Axis.cross(rods[i].Frame.real() * ToEigen(link.Side));
      for (const double part : GaussPoints)
      {
        const Eigen::Vector3d slip = this->PlaceOn(rods[i], link, part).imag() / Tiny - water;
        strip.Across = slip - slip.dot(strip.Axis) * strip.Axis;
        strip.Normal = slip.dot(strip.Face);
        strips.push_back(strip);
      }
    }
    return strips;
  }

  /// Forces of the water on the coordinates, which change at constant rates: f of the strips, and that of its pressure
  /// by its own acceleration.
  Coordinates WaterForce(const Coordinates& q, const Coordinates& rates, double time) const
  {
    constexpr double step = 1e-5;
    const std::vector<Strip> now = this->StripsAt(q, rates, time);
    const std::vector<Strip> ahead = this->StripsAt(q + step * rates, rates, time + step);
    const std::vector<Strip> behind = this->StripsAt(q - step * rates, rates, time - step);
    std::vector<Eigen::Vector3d> forces;
    for (std::size_t n = 0; n < now.size(); ++n)
    {
      const SeaweedLink& link = this->Links[n / 2];
      const Eigen::Vector3d change = (ahead[n].Across - behind[n].Across) / (2.0 * step);
      const Eigen::Vector3d across = change - change.dot(now[n].Axis) * now[n].Axis;
      const double normal = (ahead[n].Normal - behind[n].Normal) / (2.0 * step);
      forces.emplace_back(0.5 *
        (link.WaterMass * ToEigen(this->Water.Acceleration) - link.EdgeMass * across -
          (link.FaceMass - link.EdgeMass) * normal * now[n].Face));
    }
    Coordinates force(this->Size());
    for (int k = 0; k < this->Size(); ++k)
    {
      const std::vector<Rod> rods = this->MovingRods(q, Coordinates::Unit(this->Size(), k));
      force(k) = 0.0;
      for (std::size_t n = 0; n < now.size(); ++n)
      {
        const Vector place = this->PlaceOn(rods[n / 2], this->Links[n / 2], GaussPoints[n % 2]);
        force(k) += forces[n].dot(Eigen::Vector3d(place.imag() / Tiny));
      }
    }
    return force;
  }

  double Potential(const Coordinates& q) const
  {
    const std::vector<Rod> rods = this->RodsAt(q.cast<Complex>());
    double energy = 0.0;
    for (std::size_t i = 0; i < rods.size(); ++i)
    {
      const SeaweedLink& link = this->Links[i];
      const Eigen::Vector3d axis = rods[i].Frame.real() * ToEigen(link.Axis);
      energy -= link.Buoyancy * (rods[i].Foot.real() + 0.5 * link.Length * axis).z();
      const double a = q(2 * i) - (this->Joint == SeaweedJoint::Tilting ? link.Theta : 0.0);
      const double b = q(2 * i + 1) - (this->Joint == SeaweedJoint::Tilting ? link.Phi : 0.0);
      energy += 0.5 * link.Stiffness * (a * a + b * b);
    }
    return energy;
  }

  Eigen::MatrixXd MassAt(const Coordinates& q, bool hasWater) const
  {
    const int n = this->Size();
    Eigen::MatrixXd mass(n, n);
    std::vector<double> single;
    for (int k = 0; k < n; ++k)
    {
      single.push_back(this->KineticEnergy(q, Coordinates::Unit(n, k), hasWater));
      mass(k, k) = 2.0 * single[k];
      for (int j = 0; j < k; ++j)
      {
        const double both = this->KineticEnergy(q, Coordinates::Unit(n, k) + Coordinates::Unit(n, j), hasWater);
        mass(k, j) = mass(j, k) = both - single[k] - single[j];
      }
    }
    return mass;
  }

  /// M q'' = d(T - V)/dq - dM_t/dt q' + W: T and M_t of the tissue, W of the water.
  Coordinates Acceleration(const Coordinates& q, const Coordinates& rates, double time) const
  {
    constexpr double step = 1e-5;
    Coordinates force = this->WaterForce(q, rates, time);
    for (int k = 0; k < this->Size(); ++k)
    {
      const Coordinates off = step * Coordinates::Unit(this->Size(), k);
      const double ahead = this->KineticEnergy(q + off, rates, false) - this->Potential(q + off);
      const double behind = this->KineticEnergy(q - off, rates, false) - this->Potential(q - off);
      force(k) += (ahead - behind) / (2.0 * step);
    }
    const Coordinates change =
      (this->MassAt(q + step * rates, false) - this->MassAt(q - step * rates, false)) * rates / (2.0 * step);
    return this->MassAt(q, true).ldlt().solve(force - change);
  }

  /// Takes coordinates and rates on from a time to another.
  void Integrate(Coordinates& q, Coordinates& rates, double from, double to, int steps) const
  {
    const double h = (to - from) / steps;
    for (int n = 0; n < steps; ++n)
    {
      const double time = from + n * h;
      const Coordinates a1 = this->Acceleration(q, rates, time);
      const Coordinates v2 = rates + 0.5 * h * a1;
      const Coordinates a2 = this->Acceleration(q + 0.5 * h * rates, v2, time + 0.5 * h);
      const Coordinates v3 = rates + 0.5 * h * a2;
      const Coordinates a3 = this->Acceleration(q + 0.5 * h * v2, v3, time + 0.5 * h);
      const Coordinates v4 = rates + h * a3;
      const Coordinates a4 = this->Acceleration(q + h * v3, v4, time + h);
      q += h / 6.0 * (rates + 2.0 * v2 + 2.0 * v3 + v4);
      rates += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
  }

  /// The state of a link in the terms of the chain under test.
  LinkState StateAt(std::size_t i, const Coordinates& q, const Coordinates& rates) const
  {
    if (this->Joint == SeaweedJoint::Tilting)
    {
      return { { q(2 * i), q(2 * i + 1), 0.0 }, { rates(2 * i), rates(2 * i + 1), 0.0 } };
    }
    const Vector direction =
      this->DirectionAt(i, { q(2 * i), Tiny * rates(2 * i) }, { q(2 * i + 1), Tiny * rates(2 * i + 1) });
    const Eigen::Vector3d e = direction.real();
    const Eigen::Vector3d rate = e.cross(Eigen::Vector3d(direction.imag() / Tiny));
    return { { e(0), e(1), e(2) }, { rate(0), rate(1), rate(2) } };
  }

  Vector3 TipAt(const Coordinates& q) const
  {
    const Rod last = this->RodsAt(q.cast<Complex>()).back();
    const Eigen::Vector3d tip =
      last.Foot.real() + last.Frame.real() * (this->Links.back().Length * ToEigen(this->Links.back().Axis));
    return { tip(0), tip(1), tip(2) };
  }

private:
  static constexpr double Tiny = 1e-30; // of complex steps

  const std::vector<SeaweedLink>& Links;
  SeaweedJoint Joint;
  UniformWater Water;

  /// The frame of a link against that of its parent, both from rest.
  Matrix JointAt(std::size_t i, Complex a, Complex b) const
  {
    const SeaweedLink& link = this->Links[i];
    if (this->Joint == SeaweedJoint::Bending)
    {
      // The shortest arc: the turn by the angle between axis and direction, about what is normal to both.
      const Vector axis = ToEigen(link.Axis).cast<Complex>();
      const Vector to = this->DirectionAt(i, a, b);
      Vector normal(
        axis(1) * to(2) - axis(2) * to(1), axis(2) * to(0) - axis(0) * to(2), axis(0) * to(1) - axis(1) * to(0));
      const Complex sine = std::sqrt(DotOf(normal, normal) + 1e-28);
      return TurnAbout(normal / sine, DotOf(axis, to), sine);
    }
    // theta about the parent's Y, phi about the new X (figure 7), against the same at rest.
    const auto turned = [](Complex theta, Complex phi) {
      const Matrix azimuth = TurnAbout(Vector(0.0, 1.0, 0.0), std::cos(theta), std::sin(theta));
      const Matrix tilt = TurnAbout(Vector(1.0, 0.0, 0.0), std::cos(phi), std::sin(phi));
      return Matrix(azimuth * tilt);
    };
    Matrix base;
    base << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0; // X = x, Y = up, Z = -y
    std::vector<std::size_t> below;
    for (int parent = link.Parent; parent >= 0; parent = this->Links[parent].Parent)
    {
      below.insert(below.begin(), static_cast<std::size_t>(parent));
    }
    for (const std::size_t parent : below)
    {
      base = base * turned(this->Links[parent].Theta, this->Links[parent].Phi);
    }
    return base * turned(a, b) * (base * turned(link.Theta, link.Phi)).transpose();
  }
};

struct Chain
{
  std::vector<SeaweedLink> Links;
  Coordinates Q;
  Coordinates Rates;
};

/// Rods of unequal lengths and masses that bend out of the plane, each with inertia about its axis and a face, bent and
/// spinning. `branch`: the last grows on the middle.
Chain MakeChain(int rods, double stiffness, double buoyancy, bool hasWater, bool isBranched = false)
{
  Chain chain;
  Vector3 foot(0.0, 0.0, -20.0);
  for (int i = 0; i < rods; ++i)
  {
    SeaweedLink link;
    link.Parent = isBranched && i == rods - 1 ? rods / 2 - 1 : i - 1;
    link.Axis = glm::normalize(Vector3(0.25 * std::sin(2.0 * i), 0.3 * std::cos(1.3 * i), 1.0));
    link.Side = glm::normalize(glm::cross(link.Axis, Vector3(0.3, 1.0, 0.1 * i)));
    link.Length = (1.0 + 0.2 * std::sin(5.0 * i)) / rods;
    if (link.Parent >= 0)
    {
      const SeaweedLink& parent = chain.Links[link.Parent];
      link.Foot = parent.Foot + parent.Length * parent.Axis;
    }
    else
    {
      link.Foot = foot;
    }
    link.Mass = (1.0 + 0.3 * std::cos(3.0 * i)) / rods;
    link.AxialInertia = 0.05 * link.Mass * link.Length * link.Length;
    link.FaceMass = hasWater ? 3.0 * link.Mass : 0.0;
    link.EdgeMass = hasWater ? 0.2 * link.Mass : 0.0;
    link.WaterMass = hasWater ? 1.1 * link.Mass : 0.0;
    link.Stiffness = stiffness;
    link.Damping = 0.0;
    link.Buoyancy = buoyancy / rods;
    link.Weight = 0.0;
    chain.Links.push_back(link);
  }
  chain.Q = Coordinates(2 * rods);
  chain.Rates = Coordinates(2 * rods);
  for (int i = 0; i < rods; ++i)
  {
    chain.Q(2 * i) = 0.35 * std::sin(1.0 + 2.0 * i);
    chain.Q(2 * i + 1) = 0.3 * std::cos(2.5 * i);
    chain.Rates(2 * i) = 1.6 * std::cos(1.7 * i);
    chain.Rates(2 * i + 1) = 1.4 * std::sin(0.5 + i);
  }
  return chain;
}

SeaweedOptions Still(SeaweedJoint joint = SeaweedJoint::Bending)
{
  SeaweedOptions options;
  options.Joint = joint;
  options.DragCoefficient = 0.0;
  options.FrictionCoefficient = 0.0;
  return options;
}

struct Mover
{
  SeaweedMotion Motion;
  UniformWater Flow;
  double Time = 0.0;
  std::vector<LinkState> States;
  std::vector<LinkPose> Poses;

  Mover(const Chain& chain, const SeaweedOptions& options, const UniformWater& flow = {})
    : Motion(chain.Links, options)
    , Flow(flow)
    , Poses(chain.Links.size())
  {
    const RodSystem system(chain.Links, options, flow);
    for (std::size_t i = 0; i < chain.Links.size(); ++i)
    {
      this->States.push_back(system.StateAt(i, chain.Q, chain.Rates));
    }
    this->Motion.Pose(this->States.data(), 0, this->Poses.size(), this->Poses.data());
  }
  void Run(int steps, double step)
  {
    const LinkBatch& batch = this->Motion.GetBatches().front();
    std::vector<WaterAtLink> water(batch.PaddedLinks());
    for (int n = 0; n < steps; ++n)
    {
      for (WaterAtLink& one : water)
      {
        one.Velocity = this->Flow.Velocity + (this->Time + 0.5 * step) * this->Flow.Acceleration;
        one.Acceleration = this->Flow.Acceleration;
      }
      this->Motion.Step(step, batch, water.data(), this->States.data(), this->Poses.data());
      this->Time += step;
    }
  }
  Vector3 Tip() const
  {
    return this->Poses.back().Foot + this->Motion.GetLinks().back().Length * this->Poses.back().Axis;
  }
  /// Kinetic energy and that of springs and buoyancy, by the poses.
  double Energy() const
  {
    double energy = 0.0;
    for (std::size_t i = 0; i < this->Poses.size(); ++i)
    {
      const SeaweedLink& link = this->Motion.GetLinks()[i];
      const LinkPose& pose = this->Poses[i];
      const Vector3 edge = pose.Rotation * link.Side;
      const Vector3 normal = glm::cross(pose.Axis, edge);
      for (const double part : GaussPoints)
      {
        const Vector3 v = pose.Velocity + glm::cross(pose.Spin, part * link.Length * pose.Axis);
        energy += 0.25 *
          (link.Mass * glm::dot(v, v) + link.FaceMass * std::pow(glm::dot(v, normal), 2) +
            link.EdgeMass * std::pow(glm::dot(v, edge), 2));
      }
      energy += 0.5 * link.AxialInertia * std::pow(glm::dot(pose.Spin, pose.Axis), 2);
      energy -= link.Buoyancy * (pose.Foot + 0.5 * link.Length * pose.Axis).z;
      const double bend = std::acos(std::clamp(glm::dot(link.Axis, this->States[i].Shape), -1.0, 1.0));
      energy += 0.5 * link.Stiffness * bend * bend;
    }
    return energy;
  }
};

/// Axes, sides and feet of rest that go with theta and phi.
void AlignWithAngles(std::vector<SeaweedLink>& links)
{
  glm::dquat base = GroundBase<double>();
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    SeaweedLink& link = links[i];
    base = base * glm::angleAxis(link.Theta, Vector3(0.0, 1.0, 0.0)) * glm::angleAxis(link.Phi, Vector3(1.0, 0.0, 0.0));
    link.Axis = base * Vector3(0.0, 1.0, 0.0);
    link.Side = base * Vector3(1.0, 0.0, 0.0);
    link.Foot = i == 0 ? link.Foot : links[i - 1].Foot + links[i - 1].Length * links[i - 1].Axis;
  }
}

/// How far the tip is from that of the equations in joint coordinates after a time, with steps of a length each.
std::vector<double> Errors(const Chain& chain, const SeaweedOptions& options, const UniformWater& water, double time,
  int exactSteps, const std::vector<int>& steps, double& bend)
{
  const RodSystem system(chain.Links, options, water);
  Coordinates q = chain.Q;
  Coordinates rates = chain.Rates;
  bend = 0.0;
  for (int part = 0; part < 10; ++part)
  {
    system.Integrate(q, rates, part * time / 10.0, (part + 1) * time / 10.0, exactSteps / 10);
    for (int i = 0; i < q.size(); i += 2)
    {
      bend = std::max(bend, std::hypot(q(i), q(i + 1)));
    }
  }
  std::vector<double> errors;
  for (const int count : steps)
  {
    Mover mover(chain, options, water);
    mover.Run(count, time / count);
    errors.push_back(glm::distance(mover.Tip(), system.TipAt(q)));
  }
  return errors;
}

}

TEST(SeaweedDynamics, RodsInSpaceMoveAsTheirEquationsSay)
{
  struct Case
  {
    int Rods;
    double Stiffness;
    double Buoyancy;
    bool HasWater;
    bool IsBranched;
    UniformWater Water{};
  };
  const UniformWater current{ { 0.8, -0.5, 0.3 } };
  const UniformWater surge{ { -0.4, 0.2, 0.5 }, { 2.0, 1.0, -1.5 } };
  for (const Case& one : { Case{ 1, 0.0, 0.0, false, false }, Case{ 2, 0.0, 0.0, false, false },
         Case{ 2, 0.3, 5.0, true, false }, Case{ 2, 0.3, 5.0, true, false, current }, Case{ 3, 0.2, 3.0, false, false },
         Case{ 3, 0.2, 3.0, true, true, surge }, Case{ 6, 0.3, 2.0, true, false, current } })
  {
    const Chain chain = MakeChain(one.Rods, one.Stiffness, one.Buoyancy, one.HasWater, one.IsBranched);
    double bend = 0.0;
    // Steps that resolve the turns of thin rods about themselves.
    const int coarse = one.Rods > 3 ? 400 : 75;
    const std::vector<double> errors =
      Errors(chain, Still(), one.Water, 0.6, 150, { coarse, 2 * coarse, 4 * coarse }, bend);
    SCOPED_TRACE(std::to_string(one.Rods) + " rods");
    EXPECT_GT(bend, 0.6);
    EXPECT_LT(bend, 1.7); // where no stop acts
    EXPECT_LT(errors[0], 1e-3);
    EXPECT_LT(errors[1], 0.3 * errors[0]);
    EXPECT_LT(errors[2], 1e-4);
    EXPECT_LT(errors[2], one.Rods > 3 ? 1e-4 : 0.3 * errors[1]); // six rods: as far as the reference goes
  }
}

TEST(SeaweedDynamics, OnlyVelocitiesThroughTheWaterCount)
{
  // A chain on the end of a boom so long and heavy that it moves evenly: through still water at U, and at -U in a
  // current of -2 U.
  constexpr double Reach = 1e11;
  const Vector3 speed(0.4, -0.25, 0.15);
  const auto run = [&](double way, const Vector3& water) {
    Chain chain = MakeChain(6, 0.3, 2.0, true);
    SeaweedLink boom;
    boom.Axis = glm::normalize(glm::cross(speed, Vector3(0.0, 0.0, 1.0)));
    boom.Side = glm::normalize(speed);
    boom.Length = Reach;
    boom.Foot = chain.Links[0].Foot - Reach * boom.Axis;
    boom.Mass = 1e12;
    boom.AxialInertia = 1e30;
    boom.WaterMass = boom.FrontalArea = boom.EdgeFrontalArea = boom.WettedArea = boom.Stiffness = 0.0;
    std::vector<SeaweedLink> links{ boom };
    for (SeaweedLink link : chain.Links)
    {
      ++link.Parent;
      links.push_back(link);
    }
    const SeaweedOptions options;
    Mover mover(chain, options);
    mover.Motion = SeaweedMotion(links, options);
    mover.Flow.Velocity = water;
    mover.States.insert(mover.States.begin(), { boom.Axis, way / Reach * glm::cross(boom.Axis, speed) });
    mover.Poses.resize(links.size());
    mover.Motion.Pose(mover.States.data(), 0, links.size(), mover.Poses.data());
    mover.Run(100, 1.0 / 48.0);
    return mover;
  };
  const Mover still = run(1.0, Vector3(0.0));
  const Mover current = run(-1.0, -2.0 * speed);
  EXPECT_LT(glm::distance(still.Poses[1].Velocity, speed), 1e-6);
  EXPECT_LT(glm::distance(current.Poses[1].Velocity, -speed), 1e-6);
  for (std::size_t i = 1; i < still.States.size(); ++i)
  {
    EXPECT_LT(glm::distance(still.States[i].Shape, current.States[i].Shape), 1e-9) << i;
    EXPECT_LT(glm::distance(still.States[i].Rate, current.States[i].Rate), 1e-8) << i;
  }
}

TEST(SeaweedDynamics, ATiltingJointMovesAsItsEquationsSay)
{
  for (const int rods : { 1, 3 })
  {
    Chain chain = MakeChain(rods, 0.5, 3.0, true);
    for (int i = 0; i < rods; ++i)
    {
      SeaweedLink& link = chain.Links[i];
      link.Theta = i == 0 ? 0.4 : 0.3;
      link.Phi = i == 0 ? 0.5 : 0.35;
      chain.Q(2 * i) += link.Theta;
      chain.Q(2 * i + 1) += link.Phi;
    }
    AlignWithAngles(chain.Links);
    double bend = 0.0;
    const SeaweedOptions options = Still(SeaweedJoint::Tilting);
    const std::vector<double> errors = Errors(chain, options, {}, 0.5, 120, { 40, 80, 160, 320 }, bend);
    EXPECT_LT(errors[2], 1e-3);
    EXPECT_LT(errors[3], 0.35 * errors[2]);
  }
}

TEST(SeaweedDynamics, ClosedChainsNeverGainEnergy)
{
  for (const bool hasWater : { false, true })
  {
    for (const int rods : { 2, 3, 6, 16, 32 })
    {
      for (const double stiffness : { 0.0, 0.3, 300.0 })
      {
        const Chain chain = MakeChain(rods, stiffness, 2.0, hasWater);
        Mover mover(chain, Still());
        const double start = mover.Energy(); // no stop is bent then; later it can hold some of it
        for (int step = 0; step < 240; ++step)
        {
          mover.Run(1, 1.0 / 48.0);
          ASSERT_LT(mover.Energy() - start, 1e-7 * std::abs(start)) << rods << " rods of " << stiffness << " N m/rad";
        }
      }
    }
  }
}

TEST(SeaweedDynamics, ABuoyantPairKeepsItsEnergyForMinutes)
{
  // Two links that float upright, pushed out of the plane: a double pendulum upside down.
  Chain chain = MakeChain(2, 0.0, 6.0, true);
  chain.Rates *= 0.5;
  Mover mover(chain, Still());
  const double start = mover.Energy();
  Mover still(chain, Still());
  still.States = still.Motion.AtRest();
  for (LinkState& state : still.States)
  {
    state.Shape = { 0.0, 0.0, 1.0 };
  }
  still.Motion.Pose(still.States.data(), 0, 2, still.Poses.data());
  const double least = still.Energy();
  double most = start;
  for (int second = 0; second < 300; ++second)
  {
    mover.Run(48, 1.0 / 48.0);
    most = std::max(most, mover.Energy());
  }
  EXPECT_LT(most - start, 1e-6 * (start - least));
  EXPECT_GT(mover.Energy() - least, 0.85 * (start - least));
}

// A direction that turns for twenty minutes stays of unit length.
TEST(SeaweedDynamics, DirectionsStayOfUnitLength)
{
  const Chain chain = MakeChain(1, 40.0, 0.0, false);
  Mover mover(chain, Still());
  double most = 0.0;
  for (int part = 0; part < 20; ++part)
  {
    mover.Run(1500, 1.0 / 24.0);
    most = std::max(most, std::abs(glm::length(mover.States[0].Shape) - 1.0));
  }
  EXPECT_LT(most, 1e-15);
}

// A spring that the step does not resolve turns a rod by the midpoint rule with its numerical damping, of which each
// step is known: I q' = I q0' - g (K (q0 + g q') + c_f (2 q' - q0')), c_f = K g s / (1 + s), s = (g^2 K / I)^2.
TEST(SeaweedDynamics, StiffSpringsAreDampedAsTheirEquationSays)
{
  for (const double perStep : { 0.5, 2.0, 20.0 }) // g^2 K / I
  {
    Chain chain = MakeChain(1, 0.0, 0.0, false);
    SeaweedLink& link = chain.Links[0];
    const double half = 0.5 / 48.0;
    const double inertia = link.Mass * link.Length * link.Length / 3.0;
    link.Stiffness = perStep * inertia / (half * half);
    chain.Q << 0.02, 0.0;
    chain.Rates << 0.3, 0.0;
    Mover mover(chain, Still());
    const double s = perStep * perStep;
    const double filter = link.Stiffness * half * s / (1.0 + s);
    double q = 0.02;
    double rate = 0.3;
    for (int step = 0; step < 3; ++step)
    {
      mover.Run(1, 2.0 * half);
      const double middle = (inertia * rate - half * link.Stiffness * q + half * filter * rate) /
        (inertia + half * half * link.Stiffness + 2.0 * half * filter);
      q += 2.0 * half * middle;
      rate = 2.0 * middle - rate;
      EXPECT_NEAR(std::acos(glm::dot(link.Axis, mover.States[0].Shape)), std::abs(q), 1e-7) << perStep << " " << step;
    }
  }
}

// A leaf on a long arm without mass that goes along its own axis: m dv/dt = -rho/2 C_f A v^2, v = v_0 / (1 + c t).
TEST(SeaweedDynamics, FrictionAlongTheAxisSlowsAsItsEquationSays)
{
  constexpr double Reach = 1e6;
  constexpr double Start = 0.5;
  Chain chain = MakeChain(2, 0.0, 0.0, false);
  SeaweedLink& arm = chain.Links[0];
  SeaweedLink& leaf = chain.Links[1];
  arm.Axis = { 1.0, 0.0, 0.0 };
  arm.Side = leaf.Axis = { 0.0, 1.0, 0.0 };
  leaf.Side = { 1.0, 0.0, 0.0 };
  arm.Length = Reach;
  arm.Mass = 1e-9;
  arm.AxialInertia = 1e-9;
  arm.WettedArea = arm.FrontalArea = arm.EdgeFrontalArea = 0.0;
  leaf.Foot = arm.Foot + Reach * arm.Axis;
  leaf.Mass = 1.0;
  leaf.FrontalArea = leaf.EdgeFrontalArea = 0.0;
  leaf.WettedArea = 1.0;
  SeaweedOptions options = Still();
  options.FrictionCoefficient = 0.1;
  chain.Q.setZero();
  chain.Rates.setZero();
  Mover mover(chain, options);
  mover.States[0].Rate = Start / Reach * glm::cross(arm.Axis, Vector3(0.0, 1.0, 0.0));
  mover.Motion.Pose(mover.States.data(), 0, 2, mover.Poses.data());
  const double c = 0.5 * options.WaterDensity * options.FrictionCoefficient * leaf.WettedArea * Start / leaf.Mass;
  for (int step = 1; step <= 20; ++step)
  {
    mover.Run(1, 1.0 / 48.0);
    EXPECT_NEAR(mover.Poses[1].Velocity.y, Start / (1.0 + c * step / 48.0), 1e-5 * Start) << step;
  }
}
