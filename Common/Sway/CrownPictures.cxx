// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sway/CrownPictures.h"

#include "Plants/CylindricalProjection.h"
#include "Sway/PlantMotion.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// The envelope's picture in the size of the settings; white where it has none.
TextureImage StillPicture(const TextureImage& from, const SwaySettings& settings)
{
  TextureImage picture(settings.TextureSize[0], settings.TextureSize[1]);
  for (int row = 0; row < picture.Rows; ++row)
  {
    for (int column = 0; column < picture.Columns; ++column)
    {
      picture.At(column, row) = from.Texels.empty()
        ? Texel{ 255, 255, 255, 255 }
        : from.At(column * from.Columns / picture.Columns, row * from.Rows / picture.Rows);
    }
  }
  return picture;
}

/// Displacements by the joints at a time [s], as seen from the trunk.
std::vector<JointChange> ChangesAt(const SwaySpecies& species, double time, PlantSway& sway, int modes)
{
  const PlantMotion motion(species.Rest, modes);
  std::vector<Vector3> amplitudes(motion.GetNumberOfBranches() * static_cast<std::size_t>(modes));
  sway.Amplitudes(time, amplitudes.data());
  std::fill_n(amplitudes.begin(), modes, Vector3(0.0)); // of the trunk, along with which the eye goes
  std::vector<JointPose> poses(species.Rest.Nodes.size());
  motion.Pose(amplitudes.data(), poses.data());
  std::vector<JointChange> changes;
  for (std::size_t node = 0; node < poses.size(); ++node)
  {
    changes.push_back(ChangeOf(poses[node], species.Rest.Nodes[node].Position));
  }
  return changes;
}

/// The leaves of a prototype.
std::vector<FlutteringLeaf> FlutteringLeaves(const SwaySpecies& species, const LeafFlutter& flutter)
{
  std::vector<FlutteringLeaf> leaves;
  for (const LeafCorners& leaf : species.Leaves)
  {
    leaves.push_back(flutter.Leaf(leaf.Corners, 0, leaves.size()));
  }
  return leaves;
}

/// Moves the leaves' points to a time [s].
void MoveLeaves(const SwaySpecies& species, const CrownModel& crown, double time, PlantSway& sway,
  const SwaySettings& settings, const LeafFlutter& flutter, std::vector<FlutteringLeaf>& leaves, PlantMesh& mesh)
{
  const std::vector<JointChange> changes = ChangesAt(species, time, sway, settings.Options.NumberOfModes);
  std::vector<float> points(3 * mesh.Points.size());
  MoveSkin(crown.LeafSkin, crown.LeafBinding, changes.data(), 0, mesh.Points.size(), points.data(), nullptr);
  const LeafWind wind = LeafWindOf(sway.Wind(time), settings.Leaves);
  TurnLeaves(flutter, flutter.MomentOf(time), &wind, 0, leaves.size(), leaves.data(), points.data(), nullptr);
  for (std::size_t point = 0; point < mesh.Points.size(); ++point)
  {
    mesh.Points[point] = { points[3 * point], points[3 * point + 1], points[3 * point + 2] };
  }
}

}

std::vector<TextureImage> CrownPictures(const SwaySpecies& species, const CrownModel& crown, const FrozenWind& wind,
  const Vector3& middle, const SwaySettings& settings)
{
  std::vector<TextureImage> pictures;
  if (!crown.Volume || species.Rest.Nodes.empty() || species.Leaves.empty())
  {
    pictures.assign(static_cast<std::size_t>(settings.Pictures), StillPicture(crown.StillPicture, settings));
    return pictures;
  }
  const SwayOptions options = settings.With(species.Wood);
  PlantSway sway(BeamsOf(species.Rest, species.LeafAreas, options), options, wind.GetTimes(), middle, wind.Over(0.0));
  const TextureImage* texture = crown.LeafTexture.Texels.empty() ? nullptr : &crown.LeafTexture;
  const LeafFlutter flutter(settings.Leaves);
  std::vector<FlutteringLeaf> fluttering = FlutteringLeaves(species, flutter);
  PlantMesh leaves = crown.Leaves;
  for (int picture = 0; picture < settings.Pictures; ++picture)
  {
    if (settings.Pictures > 1)
    {
      const double time = picture / (settings.Pictures * species.SwingFrequency);
      MoveLeaves(species, crown, time, sway, settings, flutter, fluttering, leaves);
    }
    pictures.push_back(
      CylindricalProjection({ leaves, texture }, *crown.Volume, settings.TextureSize[0], settings.TextureSize[1]));
  }
  return pictures;
}

int CrownPictureAt(double time, double frequency, double period, int pictures)
{
  const double swings = std::max(1.0, std::round(period * frequency));
  const double phase = swings * time / period;
  return std::min(pictures - 1, static_cast<int>(pictures * (phase - std::floor(phase))));
}

}
