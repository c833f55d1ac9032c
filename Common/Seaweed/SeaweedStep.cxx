// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/LinkDynamics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

// One step of a batch of trees, a SIMD lane each, in sub-steps.

namespace littoral
{

namespace
{

/// A batch in a step. Each lane has sub-steps and iterations of its own, a function of its own state alone.
template <typename Real>
class BatchMarch
{
public:
  using Link = LinkDynamics<Real>;
  static constexpr std::size_t Lanes = Real::Count;

  BatchMarch(const SeaweedOptions& options, double step, std::size_t count, Link* links, const LinkBody<Real>* bodies,
    const int* parents)
    : Dynamics(options)
    , IsImplicit(options.Integrator == SeaweedIntegrator::Implicit)
    , Step(step)
    , Count(count)
    , Links(links)
    , Bodies(bodies)
    , Parents(parents)
  {
  }

  /// All sub-steps of all lanes.
  LITTORAL_INLINE void Run()
  {
    this->StartSubsteps();
    while (*std::min_element(this->Done.begin(), this->Done.end()) < TicksPerStep)
    {
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        const double length = this->Step * this->Size[lane] / TicksPerStep;
        this->Dynamics.Half.Values[lane] = this->IsImplicit ? 0.5 * length : length;
      }
      this->FindMiddle();
      this->FindEnd();
      this->AcceptSubsteps();
    }
  }

private:
  BatchDynamics<Real> Dynamics;
  bool IsImplicit;
  double Step;
  std::size_t Count;
  Link* Links;
  const LinkBody<Real>* Bodies;
  const int* Parents;            // -1: the ground
  std::array<int, Lanes> Done{}; // ticks of the step
  std::array<int, Lanes> Size{}; // ticks of the next sub-step
  Real Energy{ 0.0 };            // at the start of the sub-step [J]
  Real Kinetic{ 0.0 };           // the kinetic part of it [J]
  Real EndKinetic{ 0.0 };
  Real EndEnergy{ 0.0 };
  Real Gain{ 0.0 };            // of energy beyond the loads' work [J]
  Real Correction{ 0.0 };      // of the last iteration, the largest of the links [rad]
  Real LargestRotation{ 0.0 }; // in the sub-step, the largest of the links [rad]

  LITTORAL_INLINE const LinkBody<Real>* ParentBody(std::size_t i) const
  {
    return this->Parents[i] < 0 ? nullptr : &this->Bodies[this->Parents[i]];
  }
  LITTORAL_INLINE Link* ParentOf(std::size_t i) const
  {
    return this->Parents[i] < 0 ? nullptr : &this->Links[this->Parents[i]];
  }

  /// Energy at the start, and the first sub-steps by the fastest link.
  LITTORAL_INLINE void StartSubsteps()
  {
    Real fastest(0.0);
    for (std::size_t i = 0; this->IsImplicit && i < this->Count; ++i)
    {
      const Link& link = this->Links[i];
      const Real kinetic = this->Dynamics.KineticEnergy(this->Bodies[i], link.StartPose);
      this->Kinetic += kinetic;
      this->Energy += kinetic + this->Dynamics.SpringEnergy(this->Bodies[i], link.Start);
      fastest = Max(fastest, glm::dot(link.StartPose.Spin, link.StartPose.Spin));
    }
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      this->Size[lane] = TicksPerStep;
      double turn = this->Step * std::sqrt(fastest.Values[lane]);
      for (; turn > SubstepRotation && this->Size[lane] > 1; turn *= 0.5)
      {
        this->Size[lane] /= 2;
      }
    }
  }

  /// The middle of the sub-step, by iteration.
  LITTORAL_INLINE void FindMiddle()
  {
    Real isOpen(1.0);
    bool isAnyOpen = true;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      this->Dynamics.StartLink(this->Links[i]);
    }
    for (int iteration = 1; isAnyOpen && iteration <= (this->IsImplicit ? MaximumIterations : 1); ++iteration)
    {
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        this->Dynamics.InitializeLink(this->Bodies[i], this->ParentBody(i), this->ParentOf(i), this->Links[i]);
      }
      for (std::size_t i = this->Count; i-- > 0;)
      {
        this->Dynamics.SolveJoint(this->Bodies[i], this->Links[i]);
        if (Link* parent = this->ParentOf(i))
        {
          this->Dynamics.PropagateToParent(this->Links[i], *parent);
        }
      }
      Real worst(0.0);
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        worst = Max(worst, this->Dynamics.IntegrateLink(isOpen, this->ParentOf(i), this->Links[i]));
      }
      this->Correction = SelectLess(Real(0.5), isOpen, worst, this->Correction);
      isAnyOpen = false;
      for (std::size_t lane = 0; lane < Lanes; ++lane)
      {
        const bool isEnough = iteration >= MinimumIterations && this->Correction.Values[lane] <= ConvergedCorrection;
        isOpen.Values[lane] = isEnough ? 0.0 : isOpen.Values[lane];
        isAnyOpen = isAnyOpen || (isOpen.Values[lane] > 0.5 && this->Done[lane] < TicksPerStep);
      }
    }
  }

  /// States, poses and energy at the end of the sub-step.
  LITTORAL_INLINE void FindEnd()
  {
    this->LargestRotation = Real(0.0);
    this->EndKinetic = Real(0.0);
    Real springs(0.0);
    Real work(0.0);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      Link& link = this->Links[i];
      this->Dynamics.FinishLink(this->Bodies[i], this->ParentBody(i), this->ParentOf(i), link);
      if (this->IsImplicit)
      {
        this->LargestRotation = Max(this->LargestRotation, glm::dot(link.Spin, link.Spin));
        this->EndKinetic += this->Dynamics.KineticEnergy(this->Bodies[i], link.EndPose);
        springs += this->Dynamics.SpringEnergy(this->Bodies[i], link.End);
        work += this->Dynamics.LoadWork(link);
      }
    }
    this->LargestRotation = Real(2.0) * this->Dynamics.Half * Sqrt(this->LargestRotation);
    this->EndEnergy = this->EndKinetic + springs;
    const Real rounding = Real(1e-11) * (this->EndEnergy + Abs(work));
    this->Gain = this->EndEnergy - this->Energy - work - rounding;
  }

  /// Accepts the sub-step in lanes where it is good, and halves it in others.
  LITTORAL_INLINE void AcceptSubsteps()
  {
    Real isTaken(0.0);
    Real factor(1.0);
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      int& size = this->Size[lane];
      int& done = this->Done[lane];
      if (done == TicksPerStep)
      {
        continue;
      }
      const double gain = this->Gain.Values[lane];
      const double kinetic = this->EndKinetic.Values[lane];
      const double turned = this->LargestRotation.Values[lane];
      const double correction = this->Correction.Values[lane];
      const bool isBalanced =
        turned <= 0.1 * SubstepRotation || gain <= MaximumEnergyError * (kinetic + this->Kinetic.Values[lane]);
      const bool isGood = turned <= 1.5 * SubstepRotation && correction <= MaximumCorrection && isBalanced;
      if (this->IsImplicit && !isGood && size > 1)
      {
        size /= 2;
        continue;
      }
      if (this->IsImplicit && gain > 0.0)
      {
        factor.Values[lane] = kinetic > gain ? std::sqrt(1.0 - gain / kinetic) : 0.0;
      }
      isTaken.Values[lane] = 1.0;
      done += size;
      const bool isEasy = turned <= 0.4 * SubstepRotation && correction <= 0.1 * MaximumCorrection &&
        gain <= 0.1 * MaximumEnergyError * kinetic;
      size = isEasy && done % (2 * size) == 0 && done < TicksPerStep ? 2 * size : size;
    }
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      Link& link = this->Links[i];
      link.Start.Shape = Select(isTaken, link.End.Shape, link.Start.Shape);
      link.Start.Rate = Select(isTaken, factor * link.End.Rate, link.Start.Rate);
      link.StartPose.Foot = Select(isTaken, link.EndPose.Foot, link.StartPose.Foot);
      link.StartPose.Axis = Select(isTaken, link.EndPose.Axis, link.StartPose.Axis);
      link.StartPose.Velocity = Select(isTaken, factor * link.EndPose.Velocity, link.StartPose.Velocity);
      link.StartPose.Spin = Select(isTaken, factor * link.EndPose.Spin, link.StartPose.Spin);
      link.StartPose.Rotation = Select(isTaken, link.EndPose.Rotation, link.StartPose.Rotation);
    }
    const Real kinetic = factor * factor * this->EndKinetic;
    this->Energy = SelectLess(Real(0.5), isTaken, this->EndEnergy - this->EndKinetic + kinetic, this->Energy);
    this->Kinetic = SelectLess(Real(0.5), isTaken, kinetic, this->Kinetic);
  }
};

template <std::size_t... Lane>
constexpr std::array<std::size_t, sizeof...(Lane)> Numbered(std::index_sequence<Lane...> /*lanes*/)
{
  return { Lane... };
}

/// The water at a link, a lane each.
template <typename Real>
LITTORAL_INLINE WaterOf<Real> WaterAt(const WaterAtLink* water)
{
  constexpr auto at = Numbered(std::make_index_sequence<Real::Count>());
  WaterOf<Real> all;
  all.Velocity = GatherVector(water, at, &WaterAtLink::Velocity);
  all.Acceleration = GatherVector(water, at, &WaterAtLink::Acceleration);
  all.Displacement = GatherVector(water, at, &WaterAtLink::Displacement);
  return all;
}

/// A batch and what is known of it at the beginning of a step, which it then has at the end.
struct StepTask
{
  const SeaweedOptions& Options;
  double Step;
  const LinkBatch& Batch;
  const BatchBodies& Bodies;
  const WaterAtLink* Water;
  LinkState* States;
  LinkPose* Poses;
};

template <std::size_t Lanes>
LITTORAL_INLINE void StepLanes(const StepTask& task)
{
  using Real = SimdDoubles<Lanes>;
  const LinkBatch& batch = task.Batch;
  LinkState* states = task.States;
  LinkPose* poses = task.Poses;
  static thread_local std::vector<LinkDynamics<Real>> kept;
  kept.resize(std::max(kept.size(), batch.Links));
  LinkDynamics<Real>* links = kept.data();
  std::array<std::size_t, Lanes> at;
  std::copy_n(batch.First.begin(), Lanes, at.begin());
  for (std::size_t i = 0; i < batch.Links; ++i)
  {
    links[i].Start.Shape = GatherVector(states, at, &LinkState::Shape);
    links[i].Start.Rate = GatherVector(states, at, &LinkState::Rate);
    links[i].StartPose.Rotation = GatherRotation(poses, at, &LinkPose::Rotation);
    links[i].StartPose.Foot = GatherVector(poses, at, &LinkPose::Foot);
    links[i].StartPose.Axis = GatherVector(poses, at, &LinkPose::Axis);
    links[i].StartPose.Velocity = GatherVector(poses, at, &LinkPose::Velocity);
    links[i].StartPose.Spin = GatherVector(poses, at, &LinkPose::Spin);
    links[i].Water = WaterAt<Real>(task.Water + Lanes * i);
    for (std::size_t& one : at)
    {
      ++one;
    }
  }
  const LinkBody<Real>* bodies = &std::get<std::vector<LinkBody<Real>>>(task.Bodies.Bodies)[batch.Bodies];
  const int* parents = &task.Bodies.Parents[batch.Bodies];
  BatchMarch<Real>(task.Options, task.Step, batch.Links, links, bodies, parents).Run();
  for (std::size_t i = 0; i < batch.Links; ++i)
  {
    for (std::size_t lane = 0; lane < batch.Trees; ++lane)
    {
      LinkState& state = states[batch.First[lane] + i];
      LinkPose& pose = poses[batch.First[lane] + i];
      state.Shape = LaneOf(links[i].Start.Shape, lane);
      state.Rate = LaneOf(links[i].Start.Rate, lane);
      pose.Rotation = LaneOf(links[i].StartPose.Rotation, lane);
      pose.Foot = LaneOf(links[i].StartPose.Foot, lane);
      pose.Axis = LaneOf(links[i].StartPose.Axis, lane);
      pose.Velocity = LaneOf(links[i].StartPose.Velocity, lane);
      pose.Spin = LaneOf(links[i].StartPose.Spin, lane);
    }
  }
}

// As many lanes as a register has: GCC splits wider packs less well than it keeps those of one register.
#if LITTORAL_HAS_SIMD_VERSIONS
LITTORAL_AVX512_VERSION std::size_t LanesHere()
{
  return 8;
}

LITTORAL_AVX512_VERSION void StepHere(const StepTask& task)
{
  StepLanes<8>(task);
}

LITTORAL_AVX2_VERSION std::size_t LanesHere()
{
  return 4;
}

LITTORAL_AVX2_VERSION void StepHere(const StepTask& task)
{
  StepLanes<4>(task);
}
#endif

LITTORAL_ANY_VERSION std::size_t LanesHere()
{
  return 2;
}

LITTORAL_ANY_VERSION void StepHere(const StepTask& task)
{
  StepLanes<2>(task);
}

}

//----------------------------------------------------------------------------
std::size_t LanesOfStep()
{
  return LanesHere();
}

//----------------------------------------------------------------------------
void SeaweedMotion::Step(
  double step, const LinkBatch& batch, const WaterAtLink* water, LinkState* states, LinkPose* poses) const
{
  StepHere({ this->Options, step, batch, *this->Bodies, water, states, poses });
}

}
