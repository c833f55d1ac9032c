// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SeaweedForest.h"

#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

namespace littoral
{

namespace
{

constexpr std::size_t LinksAtOnce = 256;
constexpr std::size_t PosesAtOnce = 8192;
constexpr std::size_t MostCheckpoints = 16;

double SmoothStep(double x)
{
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// 1 up to a distance, 0 beyond the band that follows.
double ShareOf(double distance, double end, double band)
{
  return band > 0.0 ? 1.0 - SmoothStep((distance - end) / band) : (distance <= end ? 1.0 : 0.0);
}

}

//----------------------------------------------------------------------------
std::string SeaweedForest::Read(vtkMultiBlockDataSet* plants, const SeaweedOptions& options)
{
  this->Options = options;
  vtkPolyData* bones = PlantPartOf(plants, plant::High, plant::Skeleton);
  if (!bones)
  {
    return "the plants have no block High/Skeleton.";
  }
  if (bones->GetNumberOfPoints() == 0)
  {
    this->Motion = std::make_unique<SeaweedMotion>(std::vector<SeaweedLink>(), options);
    return {};
  }
  const double bytes = 2000.0 * static_cast<double>(bones->GetNumberOfPoints());
  if (bytes > AvailableMemory())
  {
    return "the plants need " + std::to_string(static_cast<long long>(bytes / 1e6)) + " MB to move; take fewer.";
  }
  std::string reason = this->ReadPlants(bones);
  reason = reason.empty() ? this->ReadSkins(plants) : reason;
  if (reason.empty())
  {
    this->MakeBatches();
    this->Reset();
  }
  return reason;
}

//----------------------------------------------------------------------------
std::string SeaweedForest::ReadPlants(vtkPolyData* bones)
{
  std::vector<SeaweedSegment> segments;
  std::string reason = ReadSkeleton(bones, this->Rest);
  reason = reason.empty() ? ReadSegments(bones, segments) : reason;
  if (!reason.empty())
  {
    return reason;
  }
  for (const SkeletonNode& node : this->Rest.Nodes)
  {
    if (node.Position.z > this->Options.SeaLevel)
    {
      return "the plants reach " + std::to_string(node.Position.z - this->Options.SeaLevel) +
        " m above the sea (SeaLevel of the sea state is " + std::to_string(this->Options.SeaLevel) +
        " m); place them in deeper water.";
    }
  }
  const std::vector<SeaweedLink> links = LinksOf(this->Rest, segments, this->Options);
  this->Motion = std::make_unique<SeaweedMotion>(links, this->Options);
  this->UngradedCauchy = UngradedCauchyNumber(this->Rest, segments);
  this->LinkOfNode.assign(this->Rest.Nodes.size(), -1);
  for (std::size_t link = 0; link < links.size(); ++link)
  {
    this->LinkOfNode[links[link].Node] = static_cast<int>(link);
  }
  for (const SkeletonBranch& branch : this->Rest.Branches)
  {
    const int tip = branch.First + branch.Count - 1;
    this->LinkOfNode[tip] = this->LinkOfNode[tip - 1];
    for (int node = branch.First; node < tip; ++node)
    {
      if (this->LinkOfNode[node] >= 0)
      {
        this->OrderInBranch.push_back(node - branch.First);
        this->LinksOfBranch.push_back(branch.Count - 1);
      }
    }
  }
  // Plants of a scattered forest by their PlantId, else all is one.
  auto* ids = vtkIntArray::SafeDownCast(bones->GetPointData()->GetArray(plant::PlantId));
  constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
  std::size_t begun = None; // the plant of the id at hand, once it has a link
  for (std::size_t node = 0; node < this->Rest.Nodes.size(); ++node)
  {
    const auto id = static_cast<vtkIdType>(node);
    begun = node > 0 && ids && ids->GetValue(id) != ids->GetValue(id - 1) ? None : begun;
    const int link = this->LinkOfNode[node];
    if (link >= 0)
    {
      if (begun == None)
      {
        begun = this->Plants.size();
        this->Plants.push_back({ static_cast<std::size_t>(link), 0, Vector3(0.0), 0.0, 0.0f });
      }
      this->Plants.back().EndLink = static_cast<std::size_t>(link) + 1;
    }
    // A holdfast goes with the plant that comes next; where none does, with any, for it never moves.
    this->PlantOfNode.push_back(begun != None ? begun : this->Plants.size());
  }
  for (std::size_t& plant : this->PlantOfNode)
  {
    plant = std::min(plant, this->Plants.size() - 1);
  }
  for (Plant& one : this->Plants)
  {
    Vector3 low(1e300);
    Vector3 high(-1e300);
    double reach = 0.0;
    std::vector<double> lengths(one.EndLink - one.FirstLink, 0.0);
    for (std::size_t link = one.FirstLink; link < one.EndLink; ++link)
    {
      const SeaweedLink& own = links[link];
      const Vector3 end = own.Foot + own.Length * own.Axis;
      low = glm::min(low, glm::min(own.Foot, end));
      high = glm::max(high, glm::max(own.Foot, end));
      const double below = own.Parent < 0 ? 0.0 : lengths[own.Parent - one.FirstLink];
      lengths[link - one.FirstLink] = below + own.Length;
      reach = std::max(reach, below + own.Length);
    }
    one.Middle = 0.5 * (low + high);
    one.Reach = reach + 0.5 * glm::distance(low, high);
  }
  return {};
}

//----------------------------------------------------------------------------
std::string SeaweedForest::ReadSkins(vtkMultiBlockDataSet* plants)
{
  for (const char* name : { plant::Skin, plant::Leaves })
  {
    vtkPolyData* block = PlantPartOf(plants, plant::High, name);
    if (!block || block->GetNumberOfPoints() == 0)
    {
      continue;
    }
    const std::string reason = WhyBadSkin(block, name, this->Rest.Nodes.size());
    if (!reason.empty())
    {
      return reason;
    }
    Skin skin{ name, block, {}, {} };
    auto* ids = vtkIntArray::SafeDownCast(block->GetPointData()->GetArray(plant::JointIds));
    for (vtkIdType vertex = 0; vertex < block->GetNumberOfPoints(); ++vertex)
    {
      const std::size_t plant = this->PlantOfNode[ids->GetValue(4 * vertex)];
      if (skin.Runs.empty() || skin.Runs.back().Plant != plant)
      {
        skin.Runs.push_back({ vertex, vertex, plant });
      }
      skin.Runs.back().End = vertex + 1;
    }
    std::stable_sort(skin.Runs.begin(), skin.Runs.end(), [](const Run& a, const Run& b) { return a.Plant < b.Plant; });
    for (std::size_t plant = 0; plant <= this->Plants.size(); ++plant)
    {
      const auto first = std::lower_bound(
        skin.Runs.begin(), skin.Runs.end(), plant, [](const Run& run, std::size_t own) { return run.Plant < own; });
      skin.FirstRun.push_back(static_cast<std::size_t>(first - skin.Runs.begin()));
    }
    this->Skins.push_back(std::move(skin));
  }
  return {};
}

//----------------------------------------------------------------------------
void SeaweedForest::MakeBatches()
{
  const std::vector<SeaweedBunch>& bunches = this->Motion->GetBunches();
  this->Batches.clear();
  std::size_t links = LinksAtOnce;
  for (std::size_t bunch = 0; bunch < bunches.size(); ++bunch)
  {
    if (links >= LinksAtOnce)
    {
      this->Batches.push_back({ bunch, bunch });
      links = 0;
    }
    this->Batches.back().End = bunch + 1;
    links += bunches[bunch].LanedLinks();
  }
}

//----------------------------------------------------------------------------
void SeaweedForest::Reset()
{
  this->Now = this->Motion->AtRest();
  this->NowPoses.resize(this->Now.size());
  this->Motion->Pose(this->Now.data(), 0, this->Now.size(), this->NowPoses.data());
  this->NowStep = 0;
  this->Checkpoints.clear();
  this->Stride = 1;
}

void SeaweedForest::Resume(long long step)
{
  const auto after = this->Checkpoints.upper_bound(step);
  const long long kept = after == this->Checkpoints.begin() ? 0 : std::prev(after)->first;
  if (this->NowStep <= step && this->NowStep >= kept)
  {
    return;
  }
  this->Now = kept == 0 ? this->Motion->AtRest() : std::prev(after)->second;
  this->NowStep = kept;
  SmpFor(this->Plants.size(), [&](std::size_t begin, std::size_t end) {
    this->Motion->Pose(
      this->Now.data(), this->Plants[begin].FirstLink, this->Plants[end - 1].EndLink, this->NowPoses.data());
  });
}

//----------------------------------------------------------------------------
/// The water at places. Shares of the trains; none: all of all.
void SeaweedForest::WaterAt(const WaveOrbits& orbits, const StepCurrents& currents, const std::vector<Vector3>& middles,
  const std::vector<float>& shares, std::vector<WaterAtLink>& water) const
{
  const std::size_t count = middles.size();
  water.assign(count, WaterAtLink());
  std::vector<float> places(3 * count);
  std::vector<float> first(3 * count, 0.0f);
  std::vector<float> second(3 * count, 0.0f);
  for (std::size_t i = 0; i < count; ++i)
  {
    water[i].Velocity = currents.Velocity(middles[i], 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      places[3 * i + axis] = static_cast<float>(middles[i][axis]);
    }
  }
  if (this->Sea.Trains.empty() || count == 0)
  {
    return;
  }
  OrbitRequest<float> request;
  const bool isDirect = this->Options.Load == SeaweedLoad::Direct;
  request.Shares = shares.empty() ? nullptr : shares.data();
  request.Centers = places.data();
  request.Velocity = isDirect ? nullptr : first.data();
  request.Acceleration = isDirect && !this->IsPhysical ? nullptr : second.data();
  request.Displacement = isDirect && !this->IsPhysical ? second.data() : nullptr;
  orbits.Evaluate(request, 0, count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector3 other(second[3 * i], second[3 * i + 1], second[3 * i + 2]);
    WaterAtLink& one = water[i];
    one.Velocity += Vector3(first[3 * i], first[3 * i + 1], first[3 * i + 2]);
    (request.Displacement ? one.Displacement : one.Acceleration) = other;
  }
}

//----------------------------------------------------------------------------
void SeaweedForest::StepAll(double time, double step, const StepCurrents& currents, std::vector<LinkState>& states,
  std::vector<LinkPose>& poses) const
{
  // Loads are those of the middle of the step, where links come by then; explicit Euler: where they are.
  const bool isImplicit = this->Options.Integrator == SeaweedIntegrator::Implicit;
  const double ahead = isImplicit ? 0.5 * step : 0.0;
  const WaveOrbits orbits(this->Sea, WaveOrbitOptions(), time + 0.5 * step);
  const std::vector<SeaweedBunch>& bunches = this->Motion->GetBunches();
  SmpFor(this->Batches.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Vector3> middles;
    std::vector<WaterAtLink> water;
    for (std::size_t index = begin; index < end; ++index)
    {
      const Batch& batch = this->Batches[index];
      middles.clear();
      for (std::size_t bunch = batch.First; bunch < batch.End; ++bunch)
      {
        middles.resize(middles.size() + bunches[bunch].LanedLinks());
        this->Motion->Middles(
          bunches[bunch], poses.data(), &middles[middles.size() - bunches[bunch].LanedLinks()], ahead);
      }
      this->WaterAt(orbits, currents, middles, {}, water);
      const WaterAtLink* own = water.data();
      for (std::size_t bunch = batch.First; bunch < batch.End; ++bunch)
      {
        this->Motion->Step(step, bunches[bunch], own, states.data(), poses.data());
        own += bunches[bunch].LanedLinks();
      }
    }
  });
}

//----------------------------------------------------------------------------
void SeaweedForest::Advance(double time, double step, const StepCurrents& currents)
{
  this->StepAll(time, step, currents, this->Now, this->NowPoses);
  ++this->NowStep;
  if (this->NowStep % this->Stride != 0)
  {
    return;
  }
  this->Checkpoints[this->NowStep] = this->Now;
  while (this->Checkpoints.size() > MostCheckpoints)
  {
    this->Stride *= 2;
    for (auto it = this->Checkpoints.begin(); it != this->Checkpoints.end();)
    {
      it = it->first % this->Stride == 0 ? std::next(it) : this->Checkpoints.erase(it);
    }
  }
}

//----------------------------------------------------------------------------
/// What parts of trains leave out at most a part of a pixel of the motion of the water at the plant's top, all
/// together.
///
/// Let r_n be the sum of the amplitudes of a train and all after it, by what may be left out. A train fades from r_n
/// 3/2 to 1/2: sum (1 - share_n) a_n is at most the integral of 1 - share over r, which is 1. A train that were there
/// or not would move the plant at once by what its joints make of the train, which is a multiple of its amplitude.
std::vector<float> SeaweedForest::TrainSharesFor(const Plant& plant, const SeaweedLevels& levels) const
{
  std::vector<float> shares(this->Sea.Trains.size(), 1.0f);
  const double distance = LevelDistance(levels.Seen, plant.Middle);
  const double pixel = 2.0 * distance * std::tan(0.5 * levels.Seen.Angle) / levels.Seen.Height;
  const double most = levels.PixelError * pixel;
  if (!levels.UseLevels || this->IsPhysical || !(most > 0.0))
  {
    return shares;
  }
  const double top = std::min(0.0, plant.Middle.z + plant.Reach - this->Sea.SeaLevel);
  double rest = 0.0;
  for (std::size_t n = shares.size(); n-- > 0 && rest <= 1.5 * most;)
  {
    rest += AxesAt(this->Sea.Trains[n], top, this->Sea.Depth).Horizontal;
    shares[n] = static_cast<float>(SmoothStep(rest / most - 0.5));
  }
  return shares;
}

//----------------------------------------------------------------------------
/// In which a link moves, of 0 near, 1 middle, 2 far.
int SeaweedForest::LastLevelOf(std::size_t link) const
{
  const int order = this->OrderInBranch[link];
  return order == 0 ? 2 : (order < (this->LinksOfBranch[link] + 1) / 2 ? 1 : 0);
}

//----------------------------------------------------------------------------
/// A procedural link between its states in the levels. Each level has loads of its own, by how its own segments lean:
/// limp blades turn over where what they grow on turns by little, and would do so within a step of the camera.
LinkState SeaweedForest::ProceduralState(std::size_t link, const WaterAtLink& water, double near, double far)
{
  const std::array<bool, 3> isUsed{ near > 0.0, near < 1.0 && far > 0.0, near < 1.0 && far < 1.0 };
  const int last = this->LastLevelOf(link);
  std::array<LinkState, 3> states;
  for (int level = 0; level < 3; ++level)
  {
    if (isUsed[level])
    {
      LinkPose* poses = this->LevelPoses[level].data();
      states[level] = level <= last ? this->Motion->Procedural(water, link, poses) : this->Motion->RestOf(link);
      this->Motion->PoseOne(states[level], link, poses);
    }
  }
  return this->Motion->Mixed(this->Motion->Mixed(states[2], states[1], far), states[0], near);
}

//----------------------------------------------------------------------------
void SeaweedForest::ShowPlant(Plant& plant, const WaveOrbits& orbits, const StepCurrents& currents,
  const SeaweedLevels& levels, const ViewFrustum* view, const std::vector<LinkState>& states, SeaweedCounters& counters)
{
  double near = 1.0;
  double far = 1.0;
  if (view)
  {
    const double distance = LevelDistance(levels.Seen, plant.Middle);
    // What reaches far sweeps over more pixels.
    const double band = levels.BlendDistance > 0.0 ? std::max(levels.BlendDistance, plant.Reach) : 0.0;
    near = ShareOf(distance, levels.NearDistance, band);
    far = ShareOf(distance, levels.FarDistance, band);
  }
  const bool isSeen = !view || view->MayShow(plant.Middle, plant.Reach);
  plant.Rigid = static_cast<float>(1.0 - near);
  counters.Shown += isSeen ? 1 : 0;
  const auto shareOf = [&](std::size_t link) {
    const std::array<double, 3> shares{ near, far, 1.0 };
    return isSeen ? shares[this->LastLevelOf(link)] : 0.0;
  };
  // Procedural loads are those at the places of rest.
  std::vector<Vector3> middles;
  std::vector<WaterAtLink> water;
  for (std::size_t link = plant.FirstLink; link < plant.EndLink; ++link)
  {
    if (!this->IsPhysical && shareOf(link) > 0.0)
    {
      const SeaweedLink& one = this->Motion->GetLinks()[link];
      middles.push_back(one.Foot + 0.5 * one.Length * one.Axis);
    }
  }
  const std::vector<float> shares = this->TrainSharesFor(plant, levels);
  this->WaterAt(orbits, currents, middles, shares, water);
  const auto trains = std::count_if(shares.begin(), shares.end(), [](float share) { return share > 0.0f; });
  counters.TrainEvaluations += static_cast<std::int64_t>(middles.size()) * trains;
  auto nextWater = water.begin();
  for (std::size_t link = plant.FirstLink; link < plant.EndLink; ++link)
  {
    LinkState state = this->Motion->RestOf(link);
    const double share = shareOf(link);
    if (this->IsPhysical)
    {
      state = this->Motion->Mixed(state, states[link], share);
    }
    else if (isSeen)
    {
      state = this->ProceduralState(link, share > 0.0 ? *nextWater++ : WaterAtLink(), near, far);
    }
    counters.Segments += share > 0.0 ? 1 : 0;
    this->Motion->PoseOne(state, link, this->Shown.data());
  }
}

//----------------------------------------------------------------------------
SeaweedCounters SeaweedForest::Show(double time, double rest, const StepCurrents& currents, const SeaweedLevels& levels)
{
  this->Velocities.clear();
  this->Accelerations.clear();
  this->Shown.resize(this->Motion->GetLinks().size());
  for (std::vector<LinkPose>& poses : this->LevelPoses)
  {
    poses.resize(this->IsPhysical ? 0 : this->Shown.size());
  }
  std::vector<LinkState> partly;
  if (this->IsPhysical && rest > 0.0)
  {
    partly = this->Now;
    std::vector<LinkPose> poses = this->NowPoses;
    this->StepAll(time - rest, rest, currents, partly, poses);
  }
  const std::vector<LinkState>& states = partly.empty() ? this->Now : partly;
  const WaveOrbits orbits(this->Sea, WaveOrbitOptions(), time);
  std::unique_ptr<ViewFrustum> view;
  if (levels.UseLevels)
  {
    view = std::make_unique<ViewFrustum>(levels.Seen);
  }
  std::vector<SeaweedCounters> counters(this->Plants.size());
  // What has been moved by its equations needs to be posed only: some 30 ns a link.
  const std::size_t links = std::max<std::size_t>(1, this->Motion->GetLinks().size());
  const std::size_t length = this->IsPhysical ? this->Plants.size() * PosesAtOnce / links : 0;
  SmpForRanges(this->Plants.size(), length, [&](std::size_t begin, std::size_t end) {
    for (std::size_t plant = begin; plant < end; ++plant)
    {
      this->ShowPlant(this->Plants[plant], orbits, currents, levels, view.get(), states, counters[plant]);
    }
  });
  SeaweedCounters sum;
  for (const SeaweedCounters& one : counters)
  {
    sum.Shown += one.Shown;
    sum.Segments += one.Segments;
    sum.TrainEvaluations += one.TrainEvaluations;
  }
  return sum;
}

//----------------------------------------------------------------------------
/// Places of the nodes [m], or their velocities [m/s].
std::vector<Vector3> SeaweedForest::NodesAt(const std::vector<LinkPose>& poses, bool velocities) const
{
  std::vector<Vector3> nodes(this->Rest.Nodes.size());
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    const Vector3 rest = this->Rest.Nodes[node].Position;
    const int link = this->LinkOfNode[node];
    if (link < 0)
    {
      nodes[node] = velocities ? Vector3(0.0) : rest;
      continue;
    }
    const LinkPose& pose = poses[link];
    const Vector3 foot = this->Motion->GetLinks()[link].Foot;
    const Vector3 arm = rest - foot;
    const Vector3 moved = rest + (pose.Foot - foot) + TurnedBy(pose.Turn, arm);
    nodes[node] = velocities ? pose.Velocity + glm::cross(pose.Spin, moved - pose.Foot) : moved;
  }
  return nodes;
}

//----------------------------------------------------------------------------
void SeaweedForest::FindMotion(double time, double rest, double step, const StepCurrents& currents)
{
  if (this->IsPhysical)
  {
    std::vector<LinkState> states = this->Now;
    std::vector<LinkPose> poses = this->NowPoses;
    const std::vector<Vector3> before = this->NodesAt(poses, true);
    this->StepAll(time - rest, step, currents, states, poses);
    const std::vector<Vector3> after = this->NodesAt(poses, true);
    for (std::size_t node = 0; node < after.size(); ++node)
    {
      const Vector3 acceleration = (after[node] - before[node]) / step;
      this->Velocities.push_back(before[node] + rest * acceleration);
      this->Accelerations.push_back(acceleration);
    }
    return;
  }
  const std::vector<LinkPose> shown = this->Shown;
  std::vector<Vector3> places[3];
  for (int moment = 0; moment < 3; ++moment)
  {
    this->Show(time + (moment - 1) * step, 0.0, currents, SeaweedLevels());
    places[moment] = this->NodesAt(this->Shown, false);
  }
  this->Shown = shown;
  for (std::size_t node = 0; node < places[0].size(); ++node)
  {
    this->Velocities.push_back((places[2][node] - places[0][node]) / (2.0 * step));
    this->Accelerations.push_back((places[2][node] - 2.0 * places[1][node] + places[0][node]) / (step * step));
  }
}

//----------------------------------------------------------------------------
/// Turns of links as their skins show them; none: as they are. With the paper's joint the azimuth of a segment in line
/// with its parent spins by any push; skins bend without that twist.
std::vector<glm::dquat> SeaweedForest::TurnsOfSkins() const
{
  std::vector<glm::dquat> turns;
  if (this->Options.Joint == SeaweedJoint::Tilting && this->IsPhysical)
  {
    for (std::size_t link = 0; link < this->Shown.size(); ++link)
    {
      const SeaweedLink& own = this->Motion->GetLinks()[link];
      const glm::dquat below = own.Parent < 0 ? NoTurn<double>() : turns[own.Parent];
      turns.push_back(RotationBetween(Rotated(below, own.Axis), this->Shown[link].Axis) * below);
    }
  }
  return turns;
}

//----------------------------------------------------------------------------
/// What the nodes of a plant do to skins.
void SeaweedForest::FindChanges(
  const Plant& plant, const std::vector<glm::dquat>& turns, std::vector<JointChange>& changes) const
{
  for (std::size_t link = plant.FirstLink; link < plant.EndLink; ++link)
  {
    const SeaweedLink& own = this->Motion->GetLinks()[link];
    LinkPose pose = this->Shown[link];
    pose.Turn = turns.empty() ? pose.Turn : turns[link];
    const auto node = static_cast<std::size_t>(own.Node);
    changes[node] = ChangeOf(own, pose);
    if (this->LinkOfNode[node + 1] == static_cast<int>(link)) // a tip
    {
      changes[node + 1] = changes[node];
    }
  }
}

//----------------------------------------------------------------------------
void SeaweedForest::MoveRun(
  const Run& run, const RestSkin<float>& rest, const std::vector<JointChange>& changes, float* p, float* n) const
{
  const float rigid = this->Plants[run.Plant].Rigid;
  const auto first = static_cast<std::size_t>(run.First);
  const auto last = static_cast<std::size_t>(run.End);
  if (rigid <= 0.0f)
  {
    MoveSkin(rest, changes.data(), first, last, p, n);
    return;
  }
  // Beyond NearDistance a vertex follows its nearest segment alone.
  std::vector<float> stiff(rest.JointWeights + 4 * first, rest.JointWeights + 4 * last);
  for (std::size_t vertex = 0; vertex < last - first; ++vertex)
  {
    float* weight = &stiff[4 * vertex];
    const auto most = std::max_element(weight, weight + 4) - weight;
    for (int i = 0; i < 4; ++i)
    {
      weight[i] += rigid * ((i == most ? 1.0f : 0.0f) - weight[i]);
    }
  }
  RestSkin<float> own = rest;
  own.JointWeights = stiff.data() - 4 * first;
  MoveSkin(own, changes.data(), first, last, p, n);
}

//----------------------------------------------------------------------------
/// Replaces the skins among the blocks. All of a plant is done by one thread, at one go.
void SeaweedForest::MoveSkins(vtkMultiBlockDataSet* blocks) const
{
  struct Moved
  {
    RestSkin<float> Rest;
    vtkSmartPointer<vtkFloatArray> Points;
    vtkSmartPointer<vtkFloatArray> Normals;
    std::array<TupleRanges, 2> Ranges; // of both, found while the numbers are at hand
  };
  std::vector<Moved> moved(this->Skins.size());
  for (std::size_t skin = 0; skin < moved.size(); ++skin)
  {
    vtkPolyData* rest = this->Skins[skin].Rest;
    vtkPointData* arrays = rest->GetPointData();
    auto* normals = vtkFloatArray::SafeDownCast(arrays->GetNormals());
    auto* ids = vtkIntArray::SafeDownCast(arrays->GetArray(plant::JointIds));
    auto* weights = vtkFloatArray::SafeDownCast(arrays->GetArray(plant::JointWeights));
    moved[skin].Rest = { FloatPointsOf(rest)->GetPointer(0), normals->GetPointer(0), ids->GetPointer(0),
      weights->GetPointer(0) };
    moved[skin].Points = FloatsLike(FloatPointsOf(rest));
    moved[skin].Normals = FloatsLike(normals);
  }
  const std::vector<glm::dquat> turns = this->TurnsOfSkins();
  std::vector<JointChange> changes(this->Rest.Nodes.size());
  std::mutex adding;
  SmpFor(this->Plants.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<std::array<TupleRanges, 2>> parts(moved.size());
    for (std::size_t plant = begin; plant < end; ++plant)
    {
      this->FindChanges(this->Plants[plant], turns, changes);
      for (std::size_t skin = 0; skin < moved.size(); ++skin)
      {
        const Skin& own = this->Skins[skin];
        float* p = moved[skin].Points->GetPointer(0);
        float* n = moved[skin].Normals->GetPointer(0);
        for (std::size_t run = own.FirstRun[plant]; run < own.FirstRun[plant + 1]; ++run)
        {
          const vtkIdType first = 3 * own.Runs[run].First;
          const vtkIdType last = 3 * own.Runs[run].End;
          this->MoveRun(own.Runs[run], moved[skin].Rest, changes, p, n);
          parts[skin][0].AddTuples(p + first, p + last, 3);
          parts[skin][1].AddTuples(n + first, n + last, 3);
        }
      }
    }
    const std::lock_guard<std::mutex> lock(adding);
    for (std::size_t skin = 0; skin < moved.size(); ++skin)
    {
      moved[skin].Ranges[0].Add(parts[skin][0]);
      moved[skin].Ranges[1].Add(parts[skin][1]);
    }
  });
  for (std::size_t skin = 0; skin < moved.size(); ++skin)
  {
    vtkNew<vtkPoints> places;
    places->SetData(moved[skin].Points);
    KeepRanges(moved[skin].Points.Get(), moved[skin].Ranges[0]);
    KeepRanges(moved[skin].Normals.Get(), moved[skin].Ranges[1]);
    vtkNew<vtkPolyData> block;
    block->ShallowCopy(this->Skins[skin].Rest);
    block->SetPoints(places);
    block->GetPointData()->SetNormals(moved[skin].Normals);
    ReplaceBlock(blocks, this->Skins[skin].Name, block);
  }
}

//----------------------------------------------------------------------------
void SeaweedForest::Write(vtkMultiBlockDataSet* plants, vtkMultiBlockDataSet* output) const
{
  if (this->Rest.Nodes.empty())
  {
    return;
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->ShallowCopy(FindBlock(plants, plant::High));
  this->MoveSkins(blocks);
  vtkPolyData* bones = PlantPartOf(plants, plant::High, plant::Skeleton);
  vtkNew<vtkPolyData> bent;
  bent->ShallowCopy(bones);
  vtkNew<vtkPoints> points;
  points->SetDataType(bones->GetPoints()->GetDataType());
  points->SetNumberOfPoints(bones->GetNumberOfPoints());
  const std::vector<Vector3> nodes = this->NodesAt(this->Shown, false);
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    points->SetPoint(static_cast<vtkIdType>(node), &nodes[node].x);
  }
  bent->SetPoints(points);
  if (!this->Velocities.empty())
  {
    bent->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("Velocity", 3, this->Velocities));
    bent->GetPointData()->AddArray(ArrayOf<vtkFloatArray>("Acceleration", 3, this->Accelerations));
  }
  ReplaceBlock(blocks, plant::Skeleton, bent);
  ReplaceBlock(output, plant::High, blocks);
}

}
