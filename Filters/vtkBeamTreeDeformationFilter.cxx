// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBeamTreeDeformationFilter.h"

#include "BeamResponse.h"
#include "LeafMotion.h"
#include "LittoralPipeline.h"
#include "LittoralPlants.h"
#include "PlantMotion.h"
#include "PlantSway.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkBeamTreeDeformationFilter);

namespace
{

using littoral::Vector3;

constexpr int LeafGrain = 1024; // leaves a task

/// A plant of the skeleton: its trunk and all that grows on it, which follow each other.
struct OnePlant
{
  int FirstNode = 0;
  littoral::Skeleton Rest;
  std::unique_ptr<littoral::PlantMotion> Motion;
  std::unique_ptr<littoral::PlantSway> Sway;
  std::vector<Vector3> Wind; // at the plant's middle, over the period
};

/// A leaf: corners in the block, the first of them the foot, the third the tip.
struct OneLeaf
{
  std::array<int, 4> Corners;
  int Plant;
};

vtkFloatArray* FloatPoints(vtkPolyData* data)
{
  return data && data->GetPoints() ? vtkFloatArray::SafeDownCast(data->GetPoints()->GetData()) : nullptr;
}

vtkPolyData* PartOf(vtkMultiBlockDataSet* high, const char* name)
{
  return vtkPolyData::SafeDownCast(littoral::FindBlock(high, name));
}

/// The skeleton of a block, all plants in one. The reason why there is none, or nothing.
std::string ReadSkeleton(vtkPolyData* block, littoral::Skeleton& skeleton)
{
  auto* parents = vtkIntArray::SafeDownCast(block->GetPointData()->GetArray(littoral::plant::ParentId));
  auto* radii = vtkFloatArray::SafeDownCast(block->GetPointData()->GetArray(littoral::plant::Radius));
  if (!parents || !radii)
  {
    return "High/Skeleton of the plants has no point arrays ParentId (int) and Radius (float).";
  }
  const vtkIdType nodes = block->GetNumberOfPoints();
  skeleton.Nodes.resize(static_cast<std::size_t>(nodes));
  for (vtkIdType node = 0; node < nodes; ++node)
  {
    littoral::SkeletonNode& to = skeleton.Nodes[static_cast<std::size_t>(node)];
    block->GetPoint(node, &to.Position.x);
    to.Parent = parents->GetValue(node);
    to.Radius = radii->GetValue(node);
    to.Branch = -1;
  }
  vtkNew<vtkIdList> line;
  for (vtkIdType cell = 0; cell < block->GetNumberOfLines(); ++cell)
  {
    block->GetLines()->GetCellAtId(cell, line);
    littoral::SkeletonBranch branch{ line->GetNumberOfIds() > 0 ? static_cast<int>(line->GetId(0)) : 0,
      static_cast<int>(line->GetNumberOfIds()), 0 };
    for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i)
    {
      skeleton.Nodes[static_cast<std::size_t>(line->GetId(i))].Branch = static_cast<int>(cell);
    }
    if (branch.Count > 0)
    {
      const int parent = skeleton.Nodes[static_cast<std::size_t>(branch.First)].Parent;
      const int below = parent >= 0 && parent < branch.First ? skeleton.Nodes[parent].Branch : -1;
      branch.Order = below >= 0 && below < static_cast<int>(cell) ? skeleton.Branches[below].Order + 1 : 0;
    }
    skeleton.Branches.push_back(branch);
  }
  const std::string reason = littoral::WhyInvalid(skeleton);
  return reason.empty() ? reason : "High/Skeleton of the plants is none: " + reason;
}

/// Cuts a skeleton at its trunks.
std::string CutIntoPlants(const littoral::Skeleton& all, std::vector<OnePlant>& plants)
{
  for (const littoral::SkeletonBranch& branch : all.Branches)
  {
    if (all.Nodes[branch.First].Parent < 0)
    {
      plants.emplace_back();
      plants.back().FirstNode = branch.First;
    }
    OnePlant& plant = plants.back();
    const int index = static_cast<int>(plant.Rest.Branches.size());
    plant.Rest.Branches.push_back({ branch.First - plant.FirstNode, branch.Count, branch.Order });
    for (int node = branch.First; node < branch.First + branch.Count; ++node)
    {
      littoral::SkeletonNode own = all.Nodes[node];
      own.Branch = index;
      if (own.Parent >= 0 && own.Parent < plant.FirstNode)
      {
        return "High/Skeleton of the plants has branches that do not follow their own trunk.";
      }
      own.Parent = own.Parent < 0 ? -1 : own.Parent - plant.FirstNode;
      plant.Rest.Nodes.push_back(own);
    }
  }
  return {};
}

/// A frozen field and how it is carried along.
struct FrozenWind
{
  vtkImageData* Image = nullptr;
  vtkDataArray* Velocity = nullptr;
  int Size[3] = { 1, 1, 1 };
  double Step = 1.0; // [s]

  /// The reason why there is no wind, or nothing.
  std::string Read(vtkImageData* image)
  {
    this->Image = image;
    this->Velocity = image->GetPointData()->GetArray("Velocity");
    if (!this->Velocity || this->Velocity->GetNumberOfComponents() != 3)
    {
      return "The wind has no point array Velocity of three components.";
    }
    image->GetDimensions(this->Size);
    vtkDataArray* speed = image->GetFieldData()->GetArray("ConvectionSpeed");
    const double convection = speed && speed->GetNumberOfTuples() > 0 ? speed->GetTuple1(0) : 0.0;
    if (!(convection > 0.0) || !vtkMath::IsFinite(convection))
    {
      return "The wind has no field data ConvectionSpeed that is positive.";
    }
    this->Step = image->GetSpacing()[0] / convection;
    if (this->Size[0] < 4 || !(this->Step > 0.0))
    {
      return "The wind has fewer than four samples along x.";
    }
    vtkDataArray* period = image->GetFieldData()->GetArray("Period");
    const double own = this->Size[0] * this->Step;
    if (period && period->GetNumberOfTuples() > 0 && !(std::abs(period->GetTuple1(0) - own) < 1e-3 * own))
    {
      return "Period of the wind is not the length of its image over ConvectionSpeed.";
    }
    for (int component = 0; component < 3; ++component)
    {
      double range[2];
      this->Velocity->GetRange(range, component);
      bool finite = vtkMath::IsFinite(range[0]) && vtkMath::IsFinite(range[1]);
      for (vtkIdType i = 0; finite && i < this->Velocity->GetNumberOfTuples(); ++i)
      {
        finite = vtkMath::IsFinite(this->Velocity->GetComponent(i, component));
      }
      if (!finite)
      {
        return "Velocity of the wind has values that are not finite.";
      }
    }
    return {};
  }

  /// Continuous indices of a place; false where the field does not reach. Below its lowest layer it does.
  bool Locate(const Vector3& place, double index[3]) const
  {
    this->Image->TransformPhysicalPointToContinuousIndex(&place.x, index);
    const int* extent = this->Image->GetExtent();
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] -= extent[2 * axis];
    }
    constexpr double Slack = 1e-6;
    const bool inside =
      index[1] >= -Slack && index[1] <= this->Size[1] - 1 + Slack && index[2] <= this->Size[2] - 1 + Slack;
    index[1] = std::clamp(index[1], 0.0, this->Size[1] - 1.0);
    index[2] = std::clamp(index[2], 0.0, this->Size[2] - 1.0);
    return inside;
  }

  /// The wind at a place at the times of all samples: the field goes along x by one sample a step.
  void Sample(const Vector3& place, std::vector<Vector3>& series) const
  {
    double index[3];
    this->Locate(place, index);
    const int n = this->Size[0];
    std::vector<Vector3> line(static_cast<std::size_t>(n), Vector3(0.0));
    for (int corner = 0; corner < 4; ++corner)
    {
      const int j = std::min(static_cast<int>(index[1]) + corner % 2, this->Size[1] - 1);
      const int k = std::min(static_cast<int>(index[2]) + corner / 2, this->Size[2] - 1);
      const double fj = index[1] - static_cast<int>(index[1]);
      const double fk = index[2] - static_cast<int>(index[2]);
      const double weight = (corner % 2 ? fj : 1.0 - fj) * (corner / 2 ? fk : 1.0 - fk);
      for (int i = 0; weight > 0.0 && i < n; ++i)
      {
        double value[3];
        this->Velocity->GetTuple(
          i + static_cast<vtkIdType>(n) * (j + static_cast<vtkIdType>(this->Size[1]) * k), value);
        line[i] += weight * Vector3(value[0], value[1], value[2]);
      }
    }
    series.resize(line.size());
    const double begin = std::floor(index[0]);
    const double part = index[0] - begin;
    const int first = static_cast<int>(begin - n * std::floor(begin / n));
    for (int k = 0; k < n; ++k)
    {
      const int i = ((first - k) % n + n) % n;
      series[k] = (1.0 - part) * line[i] + part * line[(i + 1) % n];
    }
  }
};

/// Where in time a series is read.
double RequestedTime(vtkInformation* output)
{
  return output->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
    ? output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
    : 0.0;
}

/// The joints and weights of a block; the reason why they are bad, or nothing.
std::string CheckSkin(vtkPolyData* block, const char* name, int joints)
{
  auto* ids = vtkIntArray::SafeDownCast(block->GetPointData()->GetArray(littoral::plant::JointIds));
  auto* weights = vtkFloatArray::SafeDownCast(block->GetPointData()->GetArray(littoral::plant::JointWeights));
  const bool four = ids && weights && ids->GetNumberOfComponents() == 4 && weights->GetNumberOfComponents() == 4;
  if (block->GetNumberOfPoints() > 0 &&
    (!four || !FloatPoints(block) || !vtkFloatArray::SafeDownCast(block->GetPointData()->GetNormals())))
  {
    return std::string("High/") + name +
      " of the plants has no points, normals, JointIds[4] and JointWeights[4] of int and float.";
  }
  for (vtkIdType i = 0; four && i < ids->GetNumberOfValues(); ++i)
  {
    if (ids->GetValue(i) < 0 || ids->GetValue(i) >= joints)
    {
      return std::string("JointIds of High/") + name + " of the plants point to no node of Skeleton.";
    }
  }
  return {};
}

}

//----------------------------------------------------------------------------
struct vtkBeamTreeDeformationFilter::Forest
{
  vtkSmartPointer<vtkMultiBlockDataSet> Plants; // held, so that no other object gets its address
  vtkSmartPointer<vtkImageData> Wind;
  vtkMTimeType Times[3] = { 0, 0, 0 };
  double Step = 1.0;
  littoral::Skeleton Rest;
  std::vector<OnePlant> Each;
  std::vector<OneLeaf> Leaves;
};

//----------------------------------------------------------------------------
vtkBeamTreeDeformationFilter::vtkBeamTreeDeformationFilter()
  : NumberOfModes(1)
  , Response(0)
  , DragCoefficient(1.1)
  , DragLaw(0)
  , Gravity(false)
  , YoungModulus(9e9)
  , WoodDensity(900.0)
  , Damping(0.08)
  , LeafFlutter(1.0)
  , Seed(1)
{
  this->SetNumberOfInputPorts(2);
}

//----------------------------------------------------------------------------
vtkBeamTreeDeformationFilter::~vtkBeamTreeDeformationFilter() = default;

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkMultiBlockDataSet" : "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Times are those of the wind; of a wind that does not tell them, all.
  vtkInformation* wind = inputVector[1]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  output->CopyEntry(wind, vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  output->CopyEntry(wind, vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  if (!output->Has(vtkStreamingDemandDrivenPipeline::TIME_RANGE()))
  {
    double range[2] = { 0.0, 600.0 };
    auto* image = vtkImageData::SafeDownCast(wind->Get(vtkDataObject::DATA_OBJECT()));
    vtkDataArray* period = image ? image->GetFieldData()->GetArray("Period") : nullptr;
    if (period && period->GetNumberOfTuples() > 0 && period->GetTuple1(0) > 0.0)
    {
      range[1] = period->GetTuple1(0);
    }
    output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* wind = inputVector[1]->GetInformationObject(0);
  littoral::RequestAll(wind);
  wind->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), wind->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
  wind->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), 0.0);
  return 1;
}

//----------------------------------------------------------------------------
std::string vtkBeamTreeDeformationFilter::Prepare(vtkMultiBlockDataSet* plants, vtkImageData* image)
{
  this->Kept = std::make_unique<Forest>();
  Forest& forest = *this->Kept;
  littoral::SwayOptions options;
  options.NumberOfModes = this->NumberOfModes;
  options.Response = static_cast<littoral::SwayResponse>(this->Response);
  options.Load.DragCoefficient = this->DragCoefficient;
  options.Load.Law = static_cast<littoral::DragLaw>(this->DragLaw);
  options.Gravity = this->Gravity;
  options.Wood = { this->YoungModulus, this->WoodDensity, this->Damping };

  auto* high = vtkMultiBlockDataSet::SafeDownCast(littoral::FindBlock(plants, littoral::plant::High));
  vtkPolyData* bones = PartOf(high, littoral::plant::Skeleton);
  if (!bones)
  {
    return "The plants have no block High/Skeleton.";
  }
  if (bones->GetNumberOfPoints() == 0)
  {
    return {};
  }
  FrozenWind wind;
  std::string reason = ReadSkeleton(bones, forest.Rest);
  reason = reason.empty() ? CutIntoPlants(forest.Rest, forest.Each) : reason;
  for (const char* name : { littoral::plant::Skin, littoral::plant::Leaves })
  {
    vtkPolyData* part = PartOf(high, name);
    reason = reason.empty() && part ? CheckSkin(part, name, static_cast<int>(forest.Rest.Nodes.size())) : reason;
  }
  reason = reason.empty() ? wind.Read(image) : reason;
  if (!reason.empty())
  {
    return reason;
  }
  forest.Step = wind.Step;

  std::vector<int> plantOf(forest.Rest.Nodes.size());
  for (std::size_t plant = 0; plant < forest.Each.size(); ++plant)
  {
    const std::size_t first = static_cast<std::size_t>(forest.Each[plant].FirstNode);
    std::fill_n(plantOf.begin() + first, forest.Each[plant].Rest.Nodes.size(), static_cast<int>(plant));
  }
  std::vector<double> areas(forest.Rest.Nodes.size(), 0.0);
  if (vtkPolyData* leaves = PartOf(high, littoral::plant::Leaves))
  {
    auto* ids = vtkIntArray::SafeDownCast(leaves->GetPointData()->GetArray(littoral::plant::JointIds));
    vtkNew<vtkIdList> cell;
    for (vtkIdType leaf = 0; leaf < leaves->GetNumberOfPolys(); ++leaf)
    {
      leaves->GetPolys()->GetCellAtId(leaf, cell);
      if (cell->GetNumberOfIds() != 4)
      {
        continue;
      }
      Vector3 corners[4];
      OneLeaf one{};
      for (int i = 0; i < 4; ++i)
      {
        one.Corners[i] = static_cast<int>(cell->GetId(i));
        leaves->GetPoint(cell->GetId(i), &corners[i].x);
      }
      const int node = ids->GetValue(4 * one.Corners[0]);
      one.Plant = plantOf[node];
      areas[node] += 0.5 * glm::length(glm::cross(corners[2] - corners[0], corners[3] - corners[1]));
      forest.Leaves.push_back(one);
    }
  }

  double bytes = 0.0;
  for (const OnePlant& plant : forest.Each)
  {
    bytes += littoral::PlantSway::TableBytes(plant.Rest.Branches.size(), options, wind.Size[0]);
  }
  if (bytes > littoral::AvailableMemory())
  {
    return "The plants need " + std::to_string(static_cast<long long>(bytes / 1e6)) +
      " MB for their responses; take fewer modes, Response Interpolated or a shorter wind.";
  }
  for (OnePlant& plant : forest.Each)
  {
    const Vector3 foot = plant.Rest.Nodes[0].Position;
    const std::size_t first = static_cast<std::size_t>(plant.FirstNode);
    const std::vector<double> own(areas.begin() + first, areas.begin() + first + plant.Rest.Nodes.size());
    const std::vector<littoral::BranchBeam> beams = littoral::BeamsOf(plant.Rest, own, options);
    // The middle of the trunk's upper half is about that of the crown.
    int node = 0;
    const Vector3 middle = plant.Rest.Along(0, 0.75, node);
    const auto windAt = [&](const Vector3& place, std::vector<Vector3>& series) {
      wind.Sample(place - Vector3(0.0, 0.0, foot.z), series);
    };
    double index[3];
    if (!wind.Locate(middle - Vector3(0.0, 0.0, foot.z), index))
    {
      return "The wind does not reach all plants; its grid must span them across the wind and in height.";
    }
    windAt(middle, plant.Wind);
    plant.Motion = std::make_unique<littoral::PlantMotion>(plant.Rest, options.NumberOfModes);
    plant.Sway = std::make_unique<littoral::PlantSway>(beams, options, wind.Step, middle, windAt, littoral::SmpFor);
  }
  return {};
}

//----------------------------------------------------------------------------
int vtkBeamTreeDeformationFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* plants = vtkMultiBlockDataSet::GetData(inputVector[0]);
  auto* wind = vtkImageData::GetData(inputVector[1]);
  auto* output = vtkMultiBlockDataSet::GetData(outputVector);
  const double time = RequestedTime(outputVector->GetInformationObject(0));
  std::string reason;
  const auto check = [&](const char* name, double value, double low, double high) {
    if (reason.empty() && !(value >= low && value <= high))
    {
      reason = std::string(name) + " is " + std::to_string(value) + "; it must be from " + std::to_string(low) +
        " to " + std::to_string(high) + ".";
    }
  };
  check("NumberOfModes", this->NumberOfModes, 1, littoral::MostModes);
  check("Response", this->Response, 0, 1);
  check("DragCoefficient", this->DragCoefficient, 0.0, 10.0);
  check("DragLaw", this->DragLaw, 0, 1);
  check("LeafFlutter", this->LeafFlutter, 0.0, 2.0);
  check("UPDATE_TIME_STEP", time, -1e12, 1e12);
  if (reason.empty())
  {
    reason = littoral::WhyInvalid(littoral::WoodParameters{ this->YoungModulus, this->WoodDensity, this->Damping });
  }
  const vtkMTimeType times[3] = { this->GetMTime(), std::max(plants->GetMTime(), plants->GetUpdateTime()),
    std::max(wind->GetMTime(), wind->GetUpdateTime()) };
  if (reason.empty() &&
    (!this->Kept || this->Kept->Plants != plants || this->Kept->Wind != wind ||
      !std::equal(times, times + 3, this->Kept->Times)))
  {
    reason = this->Prepare(plants, wind);
    if (reason.empty())
    {
      this->Kept->Plants = plants;
      this->Kept->Wind = wind;
      std::copy(times, times + 3, this->Kept->Times);
    }
  }
  if (!reason.empty())
  {
    this->Kept.reset();
    vtkErrorMacro(<< reason);
    return 0;
  }
  const Forest& forest = *this->Kept;
  output->ShallowCopy(plants);
  if (forest.Each.empty())
  {
    return 1;
  }

  std::vector<littoral::JointPose> poses(forest.Rest.Nodes.size());
  std::vector<littoral::JointChange> changes(poses.size());
  std::vector<Vector3> winds(forest.Each.size());
  littoral::SmpFor(forest.Each.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Vector3> amplitudes;
    for (std::size_t i = begin; i < end; ++i)
    {
      const OnePlant& plant = forest.Each[i];
      amplitudes.resize(plant.Rest.Branches.size() * static_cast<std::size_t>(this->NumberOfModes));
      plant.Sway->Amplitudes(time, amplitudes.data());
      plant.Motion->Pose(amplitudes.data(), poses.data() + plant.FirstNode);
      winds[i] = littoral::SeriesPlace(time, forest.Step, plant.Wind.size()).Of(plant.Wind.data());
      for (std::size_t node = plant.FirstNode; node < plant.FirstNode + plant.Rest.Nodes.size(); ++node)
      {
        changes[node] = littoral::ChangeOf(poses[node], forest.Rest.Nodes[node].Position);
      }
    }
  });

  // New points and normals in copies of the parts; all else is shared with the input.
  auto* restHigh = vtkMultiBlockDataSet::SafeDownCast(littoral::FindBlock(plants, littoral::plant::High));
  vtkNew<vtkMultiBlockDataSet> high;
  high->ShallowCopy(restHigh);
  for (unsigned int block = 0; block < output->GetNumberOfBlocks(); ++block)
  {
    if (plants->GetBlock(block) == restHigh)
    {
      output->SetBlock(block, high);
    }
  }
  for (unsigned int block = 0; block < high->GetNumberOfBlocks(); ++block)
  {
    auto* rest = vtkPolyData::SafeDownCast(restHigh->GetBlock(block));
    if (!rest || !FloatPoints(rest))
    {
      continue;
    }
    vtkNew<vtkPolyData> moved;
    moved->ShallowCopy(rest);
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> places;
    places->DeepCopy(FloatPoints(rest));
    points->SetData(places);
    moved->SetPoints(points);
    high->SetBlock(block, moved);
    float* p = places->GetPointer(0);
    if (rest == PartOf(restHigh, littoral::plant::Skeleton))
    {
      for (std::size_t node = 0; node < poses.size(); ++node)
      {
        const Vector3 place = forest.Rest.Nodes[node].Position + poses[node].Shift;
        std::copy_n(&place.x, 3, p + 3 * node);
      }
      continue;
    }
    auto* ids = vtkIntArray::SafeDownCast(rest->GetPointData()->GetArray(littoral::plant::JointIds));
    auto* weights = vtkFloatArray::SafeDownCast(rest->GetPointData()->GetArray(littoral::plant::JointWeights));
    auto* restNormals = vtkFloatArray::SafeDownCast(rest->GetPointData()->GetNormals());
    vtkNew<vtkFloatArray> normals;
    normals->DeepCopy(restNormals);
    moved->GetPointData()->SetNormals(normals);
    float* n = normals->GetPointer(0);
    const littoral::RestSkin<float> skin{ FloatPoints(rest)->GetPointer(0), restNormals->GetPointer(0),
      ids->GetPointer(0), weights->GetPointer(0) };
    littoral::SmpFor(static_cast<std::size_t>(rest->GetNumberOfPoints()),
      [&](std::size_t begin, std::size_t end) { littoral::MoveSkin(skin, changes.data(), begin, end, p, n); });
    if (rest != PartOf(restHigh, littoral::plant::Leaves))
    {
      continue;
    }
    littoral::LeafMotionOptions leafOptions;
    leafOptions.LargestAlignment = std::min(1.0, leafOptions.LargestAlignment * this->LeafFlutter);
    leafOptions.FlutterAngle *= this->LeafFlutter;
    leafOptions.Period = forest.Step * static_cast<double>(forest.Each[0].Wind.size());
    leafOptions.Seed = this->Seed;
    const littoral::LeafFlutter flutter(leafOptions);
    vtkSMPTools::For(0, static_cast<vtkIdType>(forest.Leaves.size()), LeafGrain, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType leaf = begin; leaf < end; ++leaf)
      {
        const OneLeaf& one = forest.Leaves[static_cast<std::size_t>(leaf)];
        const auto corner = [&](int i) {
          const float* at = p + 3 * one.Corners[i];
          return Vector3(at[0], at[1], at[2]);
        };
        const Vector3 foot = corner(0);
        const Vector3 main = littoral::Normalised(corner(2) - foot);
        const Vector3 facing = littoral::Normalised(glm::cross(corner(2) - foot, corner(3) - corner(1)));
        const glm::dquat turn = littoral::LeafRotation(
          { main, facing }, winds[one.Plant], flutter.At(static_cast<std::uint64_t>(leaf), time), leafOptions);
        for (int i = 0; i < 4; ++i)
        {
          const Vector3 shift = littoral::TurnedBy(turn, corner(i) - foot);
          float* normal = n + 3 * one.Corners[i];
          const Vector3 tilt = littoral::TurnedBy(turn, Vector3(normal[0], normal[1], normal[2]));
          for (int axis = 0; axis < 3; ++axis)
          {
            p[3 * one.Corners[i] + axis] += static_cast<float>(shift[axis]);
            normal[axis] += static_cast<float>(tilt[axis]);
          }
        }
      }
    });
  }
  return 1;
}

//----------------------------------------------------------------------------
void vtkBeamTreeDeformationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfModes: " << this->NumberOfModes << "\n";
  os << indent << "Response: " << this->Response << "\n";
  os << indent << "DragCoefficient: " << this->DragCoefficient << "\n";
  os << indent << "DragLaw: " << this->DragLaw << "\n";
  os << indent << "Gravity: " << this->Gravity << "\n";
  os << indent << "YoungModulus: " << this->YoungModulus << "\n";
  os << indent << "WoodDensity: " << this->WoodDensity << "\n";
  os << indent << "Damping: " << this->Damping << "\n";
  os << indent << "LeafFlutter: " << this->LeafFlutter << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
