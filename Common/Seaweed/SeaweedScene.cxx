// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedScene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace littoral
{

namespace
{

constexpr std::size_t LinksAtOnce = 256;
constexpr std::size_t PosesAtOnce = 8192;

/// (u . grad) u of water that waves strain [m/s2], with the numbers of OrbitRequest::VelocityGradient.
Vector3 ConvectiveAcceleration(const Vector3& u, const float* g)
{
  return { u.x * g[0] + u.y * g[1] + u.z * g[3], u.x * g[1] + u.y * g[2] + u.z * g[4],
    u.x * g[3] + u.y * g[4] - u.z * (g[0] + g[2]) };
}

/// Links stay near their places: the water is that which passes there.
WaveOrbitOptions FlowAtPlaces()
{
  WaveOrbitOptions options;
  options.Bound.Motion = BoundMotion::Places;
  return options;
}

/// Shares of links in a plant in view by the least detailed level in which they move.
std::array<double, 3> ByLevel(const SeaweedLevelShares& shares)
{
  return { shares.Near, shares.Far, 1.0 };
}

}

//----------------------------------------------------------------------------
SeaweedScene::SeaweedScene(
  const TimeGrid& grid, std::vector<CurrentSeries> currents, bool isPhysical, ParallelFor parallel)
  : Physical(isPhysical)
  , Parallel(std::move(parallel))
  , Marching(grid, MaximumCheckpoints)
{
  this->Currents.Series = std::move(currents);
}

//----------------------------------------------------------------------------
std::string SeaweedScene::SetPlants(Skeleton rest, const std::vector<SeaweedSegment>& segments, const int* plantIds,
  const SeaweedOptions& options, SeaState sea)
{
  for (const SkeletonNode& node : rest.Nodes)
  {
    if (node.Position.z > options.SeaLevel)
    {
      return "the plants reach " + std::to_string(node.Position.z - options.SeaLevel) +
        " m above the sea (SeaLevel of the sea state is " + std::to_string(options.SeaLevel) +
        " m); place them in deeper water.";
    }
  }
  this->Options = options;
  this->Sea = std::move(sea);
  this->UngradedCauchy = UngradedCauchyNumber(rest, segments);
  this->Motion = std::make_unique<SeaweedMotion>(LinksOf(rest, segments, options), options);
  this->Stand = SeaweedStand(std::move(rest), this->Motion->GetLinks(), plantIds);
  this->MakeBatchRanges();
  this->TrainSums.clear();
  this->AreLooksFound = false;
  this->Plants.clear();
  this->Marching.Begin(this->Motion->AtRest());
  this->PoseAll();
  return {};
}

//----------------------------------------------------------------------------
void SeaweedScene::MakeBatchRanges()
{
  const std::vector<LinkBatch>& batches = this->Motion->GetBatches();
  this->BatchRanges.clear();
  std::size_t links = LinksAtOnce;
  for (std::size_t batch = 0; batch < batches.size(); ++batch)
  {
    if (links >= LinksAtOnce)
    {
      this->BatchRanges.push_back({ batch, batch });
      links = 0;
    }
    this->BatchRanges.back().End = batch + 1;
    links += batches[batch].PaddedLinks();
  }
}

//----------------------------------------------------------------------------
/// Finds the poses of the state that marches.
void SeaweedScene::PoseAll()
{
  const std::vector<StandPlant>& plants = this->Stand.GetPlants();
  this->Poses.resize(this->GetNumberOfLinks());
  this->Parallel(plants.size(), [&](std::size_t begin, std::size_t end) {
    if (begin < end)
    {
      this->Motion->Pose(
        this->Marching.State().data(), plants[begin].FirstLink, plants[end - 1].EndLink, this->Poses.data());
    }
  });
}

//----------------------------------------------------------------------------
void SeaweedScene::SetGoal(double time)
{
  if (this->Marching.SetGoal(time))
  {
    this->PoseAll();
  }
}

//----------------------------------------------------------------------------
/// The moment whose loads are those of a step of a length [s], or of a picture, and moments before and after it,
/// between which the water is accelerated: the ends of the step.
std::vector<StepMoment> SeaweedScene::MomentsOf(double length) const
{
  const double share = this->GetGrid().ShareOf(length);
  const long long step = this->GetStep();
  return { { step, (this->Physical ? 0.5 : 1.0) * share }, { step, 0.0 }, { step, this->Physical ? share : 1.0 } };
}

std::vector<StepMoment> SeaweedScene::NextMoments() const
{
  if (!this->IsAtGoal())
  {
    return this->MomentsOf(this->GetGrid().Step);
  }
  std::vector<StepMoment> moments = this->MomentsOf(this->GetGoal().Remainder);
  if (this->NeedsMotion && this->Physical)
  {
    const std::vector<StepMoment> whole = this->MomentsOf(this->GetGrid().Step);
    moments.insert(moments.end(), whole.begin(), whole.end());
  }
  return moments;
}

StepCurrents SeaweedScene::CurrentsOver(double length) const
{
  return this->Currents.At(this->GetGrid(), this->MomentsOf(length));
}

//----------------------------------------------------------------------------
void SeaweedScene::Advance()
{
  const TimeGrid& grid = this->GetGrid();
  const long long step = this->GetStep();
  this->StepAll(grid.TimeOf(step), grid.Step, this->CurrentsOver(grid.Step), this->Marching.State(), this->Poses);
  this->Marching.Reach(step + 1);
}

//----------------------------------------------------------------------------
void SeaweedScene::StepAll(double time, double step, const StepCurrents& currents, std::vector<LinkState>& states,
  std::vector<LinkPose>& poses) const
{
  const WaveOrbits orbits(this->Sea, FlowAtPlaces(), time + 0.5 * step);
  this->Parallel(this->BatchRanges.size(), [&](std::size_t begin, std::size_t end) {
    Work work;
    for (std::size_t index = begin; index < end; ++index)
    {
      this->StepBatches(this->BatchRanges[index], step, orbits, currents, states, poses, work);
    }
  });
}

//----------------------------------------------------------------------------
void SeaweedScene::StepBatches(const BatchRange& range, double step, const WaveOrbits& orbits,
  const StepCurrents& currents, std::vector<LinkState>& states, std::vector<LinkPose>& poses, Work& work) const
{
  // Loads are those of the middle of the step, where links come by then; explicit Euler: where they are.
  const bool isImplicit = this->Options.Integrator == SeaweedIntegrator::Implicit;
  const double ahead = isImplicit ? 0.5 * step : 0.0;
  const std::vector<LinkBatch>& batches = this->Motion->GetBatches();
  std::vector<Vector3>& middles = work.Middles;
  middles.clear();
  for (std::size_t batch = range.First; batch < range.End; ++batch)
  {
    const std::size_t first = middles.size();
    middles.resize(first + batches[batch].PaddedLinks());
    this->Motion->Middles(batches[batch], poses.data(), &middles[first], ahead);
  }
  this->WaterAt(orbits, currents, work);
  const WaterAtLink* own = work.Water.data();
  for (std::size_t batch = range.First; batch < range.End; ++batch)
  {
    this->Motion->Step(step, batches[batch], own, states.data(), poses.data());
    own += batches[batch].PaddedLinks();
  }
}

//----------------------------------------------------------------------------
/// The water at the middles of links [m], with weights of the wave trains; none: all of all.
void SeaweedScene::WaterAt(const WaveOrbits& orbits, const StepCurrents& currents, Work& work) const
{
  const std::vector<Vector3>& middles = work.Middles;
  std::vector<WaterAtLink>& water = work.Water;
  const std::size_t count = middles.size();
  water.assign(count, WaterAtLink());
  work.Centers.resize(3 * count);
  work.First.assign(3 * count, 0.0f);
  work.Second.assign(3 * count, 0.0f);
  for (std::size_t i = 0; i < count; ++i)
  {
    water[i].Velocity = currents.Velocity(middles[i], 0);
    for (int axis = 0; axis < 3; ++axis)
    {
      work.Centers[3 * i + axis] = static_cast<float>(middles[i][axis]);
    }
  }
  const bool isDirect = this->Options.Load == SeaweedLoad::Direct;
  OrbitRequest<float> request;
  request.Shares = work.Shares.empty() ? nullptr : work.Shares.data();
  request.ShareSets = work.Shares.empty() ? nullptr : work.ShareSets.data();
  request.Centers = work.Centers.data();
  request.Velocity = isDirect ? nullptr : work.First.data();
  request.Acceleration = isDirect && !this->Physical ? nullptr : work.Second.data();
  request.Displacement = isDirect && !this->Physical ? work.Second.data() : nullptr;
  work.Gradient.assign(isDirect ? 0 : 5 * count, 0.0f);
  request.VelocityGradient = isDirect ? nullptr : work.Gradient.data();
  if (!this->Sea.Trains.empty() && count > 0)
  {
    orbits.Evaluate(request, 0, count);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector3 other(work.Second[3 * i], work.Second[3 * i + 1], work.Second[3 * i + 2]);
    WaterAtLink& one = water[i];
    one.Velocity += Vector3(work.First[3 * i], work.First[3 * i + 1], work.First[3 * i + 2]);
    (request.Displacement ? one.Displacement : one.Acceleration) = other;
    if (!isDirect)
    {
      one.Acceleration += ConvectiveAcceleration(one.Velocity, &work.Gradient[5 * i]);
      one.Acceleration += currents.Acceleration(middles[i], one.Velocity);
    }
  }
}

//----------------------------------------------------------------------------
/// Finds what wave trains move at the tops of plants. It takes as long as to move some segments, once.
void SeaweedScene::FindTrainSums()
{
  const std::vector<StandPlant>& plants = this->Stand.GetPlants();
  const std::size_t trains = this->Sea.Trains.size();
  this->TrainSums.resize(plants.size() * trains);
  this->TrainSpeeds.resize(plants.size());
  this->Parallel(plants.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t plant = begin; plant < end; ++plant)
    {
      const double top = std::min(0.0, plants[plant].Middle.z + plants[plant].Reach - this->Sea.SeaLevel);
      const std::vector<double> sums = littoral::TrainSums(this->Sea, top);
      std::copy(sums.begin(), sums.end(), this->TrainSums.begin() + static_cast<std::ptrdiff_t>(plant * trains));
      this->TrainSpeeds[plant] = TrainSpeed(this->Sea, top);
    }
  });
}

//----------------------------------------------------------------------------
/// Adds weights of wave trains, none where all count: what they leave out moves the water at the plant's top by
/// PixelError at most. The number of trains that count.
std::int64_t SeaweedScene::AddSharesFor(std::size_t plant, std::vector<float>& shares) const
{
  const std::size_t trains = this->Sea.Trains.size();
  const double maximum = this->Plants[plant].Look.WaterError;
  if (!this->Levels.UseLevels || !(this->Levels.PixelError > 0.0))
  {
    return static_cast<std::int64_t>(trains);
  }
  shares.resize(shares.size() + trains, 1.0f);
  float* own = shares.data() + shares.size() - trains;
  if (!(maximum > 0.0))
  {
    return static_cast<std::int64_t>(trains);
  }
  FindTrainShares(this->TrainSums.data() + plant * trains, trains, maximum, own);
  return std::count_if(own, own + trains, [](float share) { return share > 0.0f; });
}

//----------------------------------------------------------------------------
/// A procedural link in a level. Each level has loads of its own, by how its own segments lean: limp blades turn over
/// where what they grow on turns by little, and would do so within a step of the camera.
LinkState SeaweedScene::ProceduralIn(int level, std::size_t link, const WaterAtLink& water, const LinkPose* poses) const
{
  return level <= this->Stand.LastLevelOf(link) ? this->Motion->Procedural(water, link, poses)
                                                : this->Motion->RestOf(link);
}

//----------------------------------------------------------------------------
/// Shows a procedural link between its states in the levels; where one level is all, its poses are those shown.
void SeaweedScene::ShowLink(std::size_t link, const WaterAtLink& water, const SeaweedLevelShares& shares)
{
  const double near = shares.Near;
  const double far = shares.Far;
  LinkPose* shown = this->Shown.data();
  const std::array<bool, 3> isUsed{ near > 0.0, near < 1.0 && far > 0.0, near < 1.0 && far < 1.0 };
  if (std::count(isUsed.begin(), isUsed.end(), true) == 1)
  {
    const auto level = static_cast<int>(std::find(isUsed.begin(), isUsed.end(), true) - isUsed.begin());
    level <= this->Stand.LastLevelOf(link)
      ? this->Motion->PoseOne(this->Motion->Procedural(water, link, shown), link, shown)
      : this->Motion->PoseAtRest(link, shown);
    return;
  }
  std::array<LinkState, 3> states;
  for (int level = 0; level < 3; ++level)
  {
    if (isUsed[level])
    {
      LinkPose* poses = this->LevelPoses[level].data();
      states[level] = this->ProceduralIn(level, link, water, poses);
      this->Motion->PoseOne(states[level], link, poses);
    }
  }
  this->Motion->PoseOne(
    this->Motion->Mixed(this->Motion->Mixed(states[2], states[1], far), states[0], near), link, shown);
}

//----------------------------------------------------------------------------
/// Shows a plant between rest and its state, by weights of its links' levels.
SeaweedCounters SeaweedScene::ShowPhysical(
  std::size_t index, const std::array<double, 3>& shares, const Picture& picture)
{
  const StandPlant& plant = this->Stand.GetPlants()[index];
  SeaweedCounters counters;
  if (shares.front() >= 1.0)
  {
    std::copy(picture.Poses.begin() + plant.FirstLink, picture.Poses.begin() + plant.EndLink,
      this->Shown.begin() + plant.FirstLink);
    counters.Segments = static_cast<std::int64_t>(plant.EndLink - plant.FirstLink);
    return counters;
  }
  for (std::size_t link = plant.FirstLink; link < plant.EndLink; ++link)
  {
    const double share = shares[this->Stand.LastLevelOf(link)];
    if (this->IsPosed(index, link))
    {
      const LinkState state = this->Motion->Mixed(this->Motion->RestOf(link), picture.States[link], share);
      this->Motion->PoseOne(state, link, this->Shown.data());
    }
    counters.Segments += share > 0.0 ? 1 : 0;
  }
  return counters;
}

//----------------------------------------------------------------------------
/// Adds a procedural plant to those whose water is found at one go.
SeaweedCounters SeaweedScene::AddMoving(std::size_t index, Work& work) const
{
  const StandPlant& plant = this->Stand.GetPlants()[index];
  const std::array<double, 3> byLevel = ByLevel(this->Plants[index].Look.Shares);
  SeaweedCounters counters;
  counters.Plants = 1;
  for (std::size_t link = plant.FirstLink; link < plant.EndLink; ++link)
  {
    if (byLevel[this->Stand.LastLevelOf(link)] > 0.0)
    {
      // Loads are those at the positions at rest.
      const SeaweedLink& own = this->Motion->GetLinks()[link];
      work.Middles.push_back(own.Foot + 0.5 * own.Length * own.Axis);
      work.ShareSets.push_back(static_cast<int>(work.Plants.size()));
      ++counters.Segments;
    }
  }
  counters.TrainEvaluations = counters.Segments * this->AddSharesFor(index, work.Shares);
  work.Plants.push_back(index);
  return counters;
}

//----------------------------------------------------------------------------
/// Shows the procedural plants that were added.
void SeaweedScene::ShowMoving(const Moment& moment, Work& work)
{
  this->WaterAt(moment.Orbits, moment.Currents, work);
  auto next = work.Water.begin();
  for (const std::size_t index : work.Plants)
  {
    const StandPlant& plant = this->Stand.GetPlants()[index];
    const SeaweedLevelShares& shares = this->Plants[index].Look.Shares;
    const std::array<double, 3> byLevel = ByLevel(shares);
    for (std::size_t link = plant.FirstLink; link < plant.EndLink; ++link)
    {
      if (this->IsPosed(index, link))
      {
        const bool moves = byLevel[this->Stand.LastLevelOf(link)] > 0.0;
        this->ShowLink(link, moves ? *next++ : WaterAtLink(), shares);
      }
    }
  }
  work.Middles.clear();
  work.Shares.clear();
  work.ShareSets.clear();
  work.Plants.clear();
}

//----------------------------------------------------------------------------
/// Whether a link needs a pose of its own: in far plants those that carriers carry need none.
bool SeaweedScene::IsPosed(std::size_t plant, std::size_t link) const
{
  return !this->IsFar(plant) || this->NeedsJoints || this->Stand.IsBelowCarrier(link);
}

//----------------------------------------------------------------------------
void SeaweedScene::ShowAtRest(std::size_t index)
{
  const StandPlant& plant = this->Stand.GetPlants()[index];
  for (std::size_t link = plant.FirstLink; link < plant.EndLink; ++link)
  {
    if (this->IsPosed(index, link))
    {
      this->Motion->PoseAtRest(link, this->Shown.data());
    }
  }
}

//----------------------------------------------------------------------------
/// Shows a plant; a procedural one by ShowMoving().
SeaweedCounters SeaweedScene::ShowPlant(std::size_t index, const Picture& picture, Work& work)
{
  const PlantLook& look = this->Plants[index].Look;
  if (!look.IsSeen)
  {
    this->ShowAtRest(index);
    return {};
  }
  if (!this->Physical)
  {
    return this->AddMoving(index, work);
  }
  SeaweedCounters counters = this->ShowPhysical(index, ByLevel(look.Shares), picture);
  counters.Plants = 1;
  return counters;
}

//----------------------------------------------------------------------------
/// The look of a plant in levels. All that are not seen look alike, wherever the camera is.
SeaweedScene::PlantLook SeaweedScene::LookOf(
  std::size_t index, const SeaweedLevels& levels, const ViewFrustum& frustum, bool mayBeHeld) const
{
  const StandPlant& plant = this->Stand.GetPlants()[index];
  PlantLook look;
  look.IsSeen = frustum.MayShow(plant.Middle, plant.Reach);
  if (!look.IsSeen)
  {
    look.Shares = { 0.0, 0.0 };
    return look;
  }
  const double distance = LevelDistance(levels.Seen, plant.Middle);
  look.Shares = LevelSharesAt(levels, distance, plant.Reach);
  if (!this->Physical)
  {
    look.WaterError = ErrorOfWater(levels, distance);
    look.Held = mayBeHeld ? StepsHeld(look.WaterError, this->TrainSpeeds[index], this->GetGrid().Step) : 0;
  }
  return look;
}

//----------------------------------------------------------------------------
/// Finds how plants are to be shown; those that look otherwise than before are to be shown anew.
void SeaweedScene::FindLooks(const SeaweedLevels& levels)
{
  const std::size_t plants = this->Stand.GetPlants().size();
  const bool isKnown = this->AreLooksFound && this->HadJoints == this->NeedsJoints;
  this->StandsStill = isKnown && AreTheSame(this->Levels, levels);
  if (this->StandsStill)
  {
    return;
  }
  this->Levels = levels;
  this->HadJoints = this->NeedsJoints;
  this->Plants.resize(plants);
  if (levels.UseLevels && !this->Physical && this->TrainSums.empty())
  {
    this->FindTrainSums();
  }
  const std::unique_ptr<ViewFrustum> frustum = levels.UseLevels ? std::make_unique<ViewFrustum>(levels.Seen) : nullptr;
  const bool mayBeHeld = this->Currents.AreSteady();
  ForRanges(this->Parallel, plants, PosesAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t plant = begin; plant < end; ++plant)
    {
      const PlantLook look = frustum ? this->LookOf(plant, levels, *frustum, mayBeHeld) : PlantLook();
      ShownPlant& shown = this->Plants[plant];
      shown.Time = isKnown && look == shown.Look ? shown.Time : std::numeric_limits<double>::quiet_NaN();
      shown.Look = look;
    }
  });
  this->AreLooksFound = true;
}

//----------------------------------------------------------------------------
/// The plants that are to be shown anew at a time, by the steps at which held ones move; all others after these.
std::map<long long, SeaweedScene::Moment> SeaweedScene::MomentsToShow(double time, const StepCurrents& currents)
{
  constexpr long long now = std::numeric_limits<long long>::max();
  const TimeGrid& grid = this->GetGrid();
  const double steps = (time - grid.Start) / grid.Step;
  const auto last = static_cast<long long>(std::floor(TimeGrid::WholeWithin(steps, std::abs(steps))));
  std::map<long long, Moment> moments;
  for (std::size_t plant = 0; plant < this->Plants.size(); ++plant)
  {
    ShownPlant& shown = this->Plants[plant];
    const PlantLook& look = shown.Look;
    const long long step = look.Held > 0 ? StepOfHeld(last, look.Held, plant) : now;
    // The time does not matter at rest.
    const double moved = !look.IsSeen ? 0.0 : (look.Held > 0 ? grid.TimeOf(step) : time);
    if (shown.Time == moved)
    {
      continue;
    }
    shown.Time = moved;
    shown.Changed = this->ShowNumber;
    auto moment = moments.find(step);
    if (moment == moments.end())
    {
      const std::vector<StepMoment> ends{ { step, 0.0 }, { step, 0.0 }, { step, 1.0 } };
      Moment made{ WaveOrbits(this->Sea, FlowAtPlaces(), step == now ? time : grid.TimeOf(step)),
        step == now ? currents : this->Currents.At(grid, ends), {} };
      moment = moments.emplace(step, std::move(made)).first;
    }
    moment->second.Plants.push_back(plant);
  }
  return moments;
}

//----------------------------------------------------------------------------
/// Shows plants, those of a moment side by side.
void SeaweedScene::ShowPlants(const std::map<long long, Moment>& moments, const Picture& picture)
{
  std::vector<std::pair<const Moment*, std::size_t>> plants;
  for (const auto& [step, moment] : moments)
  {
    for (const std::size_t plant : moment.Plants)
    {
      plants.emplace_back(&moment, plant);
    }
  }
  // What has been moved by its equations needs to be posed only: some 30 ns a link.
  const std::size_t links = std::max<std::size_t>(1, this->GetNumberOfLinks());
  const std::size_t atOnce = this->Plants.size() * (this->Physical ? PosesAtOnce : LinksAtOnce) / links;
  ForRanges(this->Parallel, plants.size(), atOnce, [&](std::size_t begin, std::size_t end) {
    Work work;
    for (std::size_t next = begin; next < end; ++next)
    {
      const auto [moment, plant] = plants[next];
      this->Plants[plant].Counters = this->ShowPlant(plant, picture, work);
      if (next + 1 == end || plants[next + 1].first != moment)
      {
        this->ShowMoving(*moment, work);
      }
    }
  });
}

//----------------------------------------------------------------------------
/// Shows plants as they look at a time; what is shown so already stays.
void SeaweedScene::ShowAt(double time, double remainder, const StepCurrents& currents)
{
  std::vector<LinkState> partly;
  std::vector<LinkPose> partlyPoses;
  if (this->Physical && remainder > 0.0)
  {
    partly = this->Marching.State();
    partlyPoses = this->Poses;
    this->StepAll(time - remainder, remainder, currents, partly, partlyPoses);
  }
  const Picture picture{ partly.empty() ? this->Marching.State() : partly, partly.empty() ? this->Poses : partlyPoses };
  this->ShowPlants(this->MomentsToShow(time, currents), picture);
}

//----------------------------------------------------------------------------
SeaweedCounters SeaweedScene::Show(const SeaweedLevels& levels)
{
  this->Velocities.clear();
  this->Accelerations.clear();
  this->Shown.resize(this->GetNumberOfLinks());
  for (std::vector<LinkPose>& poses : this->LevelPoses)
  {
    poses.resize(this->Physical ? 0 : this->Shown.size());
  }
  ++this->ShowNumber;
  this->FindLooks(levels);
  this->AreLooksFound = false; // until all is shown
  const StepGoal& goal = this->GetGoal();
  this->ShowAt(goal.Time, goal.Remainder, this->CurrentsOver(goal.Remainder));
  this->AreLooksFound = true;
  SeaweedCounters sum;
  for (const ShownPlant& plant : this->Plants)
  {
    sum.Plants += plant.Counters.Plants;
    sum.Segments += plant.Counters.Segments;
    sum.TrainEvaluations += plant.Counters.TrainEvaluations;
  }
  return sum;
}

//----------------------------------------------------------------------------
/// The place of a node that a link moves, its own or its carrier; -1: none does.
Vector3 SeaweedScene::NodeBy(int link, std::size_t node, const std::vector<LinkPose>& poses) const
{
  const Vector3 position = this->Stand.GetSkeleton().Nodes[node].Position;
  if (link < 0)
  {
    return position;
  }
  const LinkPose& pose = poses[link];
  const Vector3 foot = this->Motion->GetLinks()[link].Foot;
  return position + (pose.Foot - foot) + RotationOffset(pose.Rotation, position - foot);
}

Vector3 SeaweedScene::NodeAt(std::size_t node, const std::vector<LinkPose>& poses) const
{
  return this->NodeBy(this->Stand.LinkOf(node), node, poses);
}

Vector3 SeaweedScene::NodePosition(std::size_t node) const
{
  const int link = this->Stand.LinkOf(node);
  const bool isCarried = link >= 0 && this->IsFar(this->Stand.PlantOf(node));
  return this->NodeBy(isCarried ? static_cast<int>(this->Stand.CarrierOf(link)) : link, node, this->Shown);
}

std::vector<Vector3> SeaweedScene::NodePositions() const
{
  std::vector<Vector3> nodes(this->Stand.GetSkeleton().Nodes.size());
  this->Parallel(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      nodes[node] = this->NodePosition(node);
    }
  });
  return nodes;
}

//----------------------------------------------------------------------------
Vector3 SeaweedScene::NodeVelocity(std::size_t node, const std::vector<LinkPose>& poses) const
{
  const int link = this->Stand.LinkOf(node);
  if (link < 0)
  {
    return Vector3(0.0);
  }
  const LinkPose& pose = poses[link];
  return pose.Velocity + glm::cross(pose.Spin, this->NodeAt(node, poses) - pose.Foot);
}

//----------------------------------------------------------------------------
/// Velocities of the nodes [m/s].
std::vector<Vector3> SeaweedScene::VelocitiesIn(const std::vector<LinkPose>& poses) const
{
  std::vector<Vector3> nodes(this->Stand.GetSkeleton().Nodes.size());
  this->Parallel(nodes.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
    {
      nodes[node] = this->NodeVelocity(node, poses);
    }
  });
  return nodes;
}

//----------------------------------------------------------------------------
void SeaweedScene::FindMotion()
{
  this->Velocities.clear();
  this->Accelerations.clear();
  if (this->Physical)
  {
    this->FindPhysicalMotion();
  }
  else
  {
    this->FindProceduralMotion();
  }
}

//----------------------------------------------------------------------------
/// Acceleration as the change of velocities over the whole step that the goal is in.
void SeaweedScene::FindPhysicalMotion()
{
  const StepGoal& goal = this->GetGoal();
  const double step = this->GetGrid().Step;
  std::vector<LinkState> states = this->Marching.State();
  std::vector<LinkPose> poses = this->Poses;
  const std::vector<Vector3> before = this->VelocitiesIn(poses);
  this->StepAll(goal.Time - goal.Remainder, step, this->CurrentsOver(step), states, poses);
  const std::vector<Vector3> after = this->VelocitiesIn(poses);
  for (std::size_t node = 0; node < after.size(); ++node)
  {
    const Vector3 acceleration = (after[node] - before[node]) / step;
    this->Velocities.push_back(before[node] + goal.Remainder * acceleration);
    this->Accelerations.push_back(acceleration);
  }
}

//----------------------------------------------------------------------------
/// Velocity and acceleration by central differences over two steps, in the currents of the goal.
void SeaweedScene::FindProceduralMotion()
{
  const StepGoal& goal = this->GetGoal();
  const double step = this->GetGrid().Step;
  const StepCurrents currents = this->CurrentsOver(goal.Remainder);
  const std::vector<LinkPose> shown = this->Shown;
  const std::vector<ShownPlant> plants = this->Plants;
  const SeaweedLevels levels = this->Levels;
  const bool standsStill = this->StandsStill;
  this->AreLooksFound = false; // until they are those of before
  this->FindLooks(SeaweedLevels());
  this->AreLooksFound = false;
  std::vector<Vector3> positions[3];
  for (int moment = 0; moment < 3; ++moment)
  {
    this->ShowAt(goal.Time + (moment - 1) * step, 0.0, currents);
    positions[moment] = this->NodePositions();
  }
  this->Shown = shown;
  this->Plants = plants;
  this->Levels = levels;
  this->StandsStill = standsStill;
  this->AreLooksFound = true;
  for (std::size_t node = 0; node < positions[0].size(); ++node)
  {
    this->Velocities.push_back((positions[2][node] - positions[0][node]) / (2.0 * step));
    this->Accelerations.push_back((positions[2][node] - 2.0 * positions[1][node] + positions[0][node]) / (step * step));
  }
}

//----------------------------------------------------------------------------
// Turns without the twist of the paper's joint, with which the azimuth of a segment in line with its parent spins by
// any load.
std::vector<glm::dquat> SeaweedScene::SkinRotations() const
{
  std::vector<glm::dquat> rotations;
  if (this->Options.Joint == SeaweedJoint::Tilting && this->Physical)
  {
    for (std::size_t link = 0; link < this->Shown.size(); ++link)
    {
      const SeaweedLink& own = this->Motion->GetLinks()[link];
      const glm::dquat below = own.Parent < 0 ? IdentityRotation<double>() : rotations[own.Parent];
      rotations.push_back(RotationBetween(Rotated(below, own.Axis), this->Shown[link].Axis) * below);
    }
  }
  return rotations;
}

//----------------------------------------------------------------------------
void SeaweedScene::FindChanges(
  std::size_t plant, const std::vector<glm::dquat>& rotations, std::vector<JointChange>& changes, bool ofCarriers) const
{
  const StandPlant& extent = this->Stand.GetPlants()[plant];
  for (std::size_t link = extent.FirstLink; link < extent.EndLink; ++link)
  {
    if (ofCarriers && this->Stand.CarrierOf(link) != link)
    {
      continue;
    }
    const SeaweedLink& own = this->Motion->GetLinks()[link];
    LinkPose pose = this->Shown[link];
    pose.Rotation = rotations.empty() ? pose.Rotation : rotations[link];
    const auto node = static_cast<std::size_t>(own.Node);
    changes[node] = ChangeOf(own, pose);
    if (this->Stand.LinkOf(node + 1) == static_cast<int>(link)) // a tip
    {
      changes[node + 1] = changes[node];
    }
  }
}

}
