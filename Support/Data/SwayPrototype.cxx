// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SwayPrototype.h"

#include "Numerics/Constants.h"
#include "Plants/CylindricalProjection.h"
#include "Sway/PlantMotion.h"
#include "Sway/TrunkSkin.h"

#include <algorithm>

namespace littoral
{

SwayOptions SwaySettings::With(const WoodParameters& wood) const
{
  SwayOptions options = this->Options;
  options.Wood = wood;
  return options;
}

std::string SwayPrototype::Read(vtkMultiBlockDataSet* plant, const SwaySettings& settings)
{
  vtkPolyData* bones = PlantPartOf(plant, plant::High, plant::Skeleton);
  this->ReadCrown(PlantPartOf(plant, plant::Medium, plant::Crown));
  this->Wood = settings.Options.Wood;
  if (!bones || bones->GetNumberOfPoints() == 0)
  {
    return {};
  }
  std::string reason = ReadSkeleton(bones, this->Rest);
  this->Leaves = PlantPartOf(plant, plant::High, plant::Leaves);
  if (reason.empty() && this->Leaves)
  {
    reason = WhyBadSkin(this->Leaves, plant::Leaves, this->Rest.Nodes.size());
  }
  if (reason.empty() && settings.WoodFromPlants && ReadWood(plant, this->Wood))
  {
    reason = WhyInvalid(this->Wood);
  }
  if (!reason.empty())
  {
    return reason;
  }
  this->Corners = ReadLeaves(this->Leaves);
  this->LeafAreas.assign(this->Rest.Nodes.size(), 0.0);
  for (const LeafCorners& leaf : this->Corners)
  {
    this->LeafAreas[leaf.Node] += leaf.Area;
  }
  this->Trunk = MeasureTrunk(this->Rest, FedLeafAreas(this->Rest, this->LeafAreas, settings.Options.LeafAreaRatio));
  this->TrunkRest = TrunkAlone(this->Rest);
  const BranchBeam trunk = TrunkBeam(this->Trunk, 1.0, 0.0, settings.With(this->Wood));
  this->SwingFrequency = trunk.Modes.front().Frequency / TwoPi;
  return {};
}

void SwayPrototype::ReadCrown(vtkPolyData* crown)
{
  vtkDataArray* places = crown ? crown->GetPointData()->GetTCoords() : nullptr;
  if (!places || crown->GetNumberOfPoints() == 0)
  {
    return;
  }
  this->Envelope = crown;
  for (vtkIdType point = 0; point < crown->GetNumberOfPoints(); ++point)
  {
    this->CrownTCoords.push_back({ places->GetComponent(point, 0), places->GetComponent(point, 1) });
  }
  double bounds[6];
  crown->GetBounds(bounds);
  crown->GetPoint(0, &this->Crown.Foot.x); // on the axis
  this->Crown.Foot.z = bounds[4];
  this->Crown.Height = std::max(1e-6, bounds[5] - bounds[4]);
}

std::vector<float> SwayPrototype::LeavesAt(double time, PlantSway& sway, const SwaySettings& settings) const
{
  const PlantMotion motion(this->Rest, settings.Options.NumberOfModes); // the trunk stands
  std::vector<Vector3> amplitudes(motion.GetNumberOfBranches() * static_cast<std::size_t>(motion.GetNumberOfModes()));
  sway.Amplitudes(time, amplitudes.data());
  std::fill_n(amplitudes.begin(), motion.GetNumberOfModes(), Vector3(0.0)); // the eye goes with the trunk
  std::vector<JointPose> poses(this->Rest.Nodes.size());
  motion.Pose(amplitudes.data(), poses.data());
  std::vector<JointChange> changes;
  for (std::size_t node = 0; node < poses.size(); ++node)
  {
    changes.push_back(ChangeOf(poses[node], this->Rest.Nodes[node].Position));
  }
  vtkPointData* arrays = this->Leaves->GetPointData();
  const RestSkin<float> skin{ FloatPointsOf(this->Leaves)->GetPointer(0), nullptr,
    vtkIntArray::SafeDownCast(arrays->GetArray(plant::JointIds))->GetPointer(0),
    vtkFloatArray::SafeDownCast(arrays->GetArray(plant::JointWeights))->GetPointer(0) };
  const std::size_t count = static_cast<std::size_t>(this->Leaves->GetNumberOfPoints());
  std::vector<float> points(3 * count);
  MoveSkin(skin, changes.data(), 0, count, points.data(), nullptr);
  const Vector3 wind = sway.Wind(time);
  const LeafFlutter flutter(settings.Leaves);
  for (std::size_t leaf = 0; leaf < this->Corners.size(); ++leaf)
  {
    TurnLeaf(this->Corners[leaf].Corners, wind, flutter.At(leaf, time), settings.Leaves, points.data(), nullptr);
  }
  return points;
}

/// The picture that the crown came with; white where it has none.
TextureImage SwayPrototype::StillPicture(const SwaySettings& settings) const
{
  const TextureImage own = this->Envelope ? ReadTexture(this->Envelope) : TextureImage();
  TextureImage picture(settings.PictureSize[0], settings.PictureSize[1]);
  for (int row = 0; row < picture.Rows; ++row)
  {
    for (int column = 0; column < picture.Columns; ++column)
    {
      picture.At(column, row) = own.Texels.empty()
        ? Texel{ 255, 255, 255, 255 }
        : own.At(column * own.Columns / picture.Columns, row * own.Rows / picture.Rows);
    }
  }
  return picture;
}

std::vector<TextureImage> SwayPrototype::Pictures(const WindImage& wind, const SwaySettings& settings) const
{
  std::vector<TextureImage> pictures;
  if (!this->Envelope || this->Rest.Nodes.empty() || this->Corners.empty())
  {
    pictures.assign(static_cast<std::size_t>(settings.Pictures), this->StillPicture(settings));
    return pictures;
  }
  const SwayOptions options = settings.With(this->Wood);
  int node = 0;
  const Vector3 middle = wind.Middle(this->Rest.Along(0, 0.75, node).z);
  PlantSway sway(BeamsOf(this->Rest, this->LeafAreas, options), options, wind.Times(), middle,
    [&](const Vector3& place, double first, std::size_t count, Vector3* velocities) {
      wind.Sample(place, first, count, velocities);
    });
  PlantMesh mesh = ReadMesh(this->Leaves);
  const TextureImage leaf = ReadTexture(this->Leaves);
  for (int picture = 0; picture < settings.Pictures; ++picture)
  {
    if (settings.Pictures > 1)
    {
      const std::vector<float> points =
        this->LeavesAt(picture / (settings.Pictures * this->SwingFrequency), sway, settings);
      for (std::size_t point = 0; point < mesh.Points.size(); ++point)
      {
        mesh.Points[point] = { points[3 * point], points[3 * point + 1], points[3 * point + 2] };
      }
    }
    pictures.push_back(CylindricalProjection(
      { mesh, leaf.Texels.empty() ? nullptr : &leaf }, this->Crown, settings.PictureSize[0], settings.PictureSize[1]));
  }
  return pictures;
}

}
