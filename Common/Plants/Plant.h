// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlant_h
#define LittoralPlant_h

#include "Plants/PlantMesh.h"
#include "Plants/Skeleton.h"

#include <cstdint>
#include <vector>

namespace littoral
{

class RandomStream;

/// The form of the volume that bounds a crown.
enum class CrownShape
{
  Cone = 0,
  Ellipsoid = 1,
};

/// The volume that bounds the leaves of a plant; its axis is upright.
struct CrownVolume
{
  CrownShape Shape = CrownShape::Ellipsoid;
  Vector3 Foot{ 0.0, 0.0, 0.0 }; ///< the lowest point on the axis [m]
  double Height = 1.0;           ///< above the foot [m]
  double Radius = 1.0;           ///< largest [m]; of a cone at the foot, of an ellipsoid at mid-height
};

/// Relative depth of a position [m] in the volume: 1 on the axis (ellipsoid: at mid-height), 0 on the surface, negative
/// outside.
double Depth(const CrownVolume& crown, const Vector3& position);

/// The outward direction of the volume's level surface at a position [m].
Vector3 Outward(const CrownVolume& crown, const Vector3& position);

/// The normal of a leaf for light: the way it faces, drawn towards the outside of its crown, so that a crown has a
/// bright and a dark side, and lifted, since lower leaves are lit through the crown and from the ground as well.
Vector3 LitNormal(const CrownVolume& crown, const Vector3& position, const Vector3& facing);

/// The smallest volume of a shape, about the mean of the positions, that holds all of them.
CrownVolume VolumeAround(const std::vector<Vector3>& positions, CrownShape shape);

/// The form of a leaf's outline.
enum class LeafForm
{
  Blade = 0,  ///< of a broad-leaved tree
  Needle = 1, ///< a tuft of needles
  Spray = 2,  ///< a twig with some blades
};

/// A leaf, or a tuft of leaves, as a particle.
struct LeafParticle
{
  Vector3 Position{ 0.0, 0.0, 0.0 }; ///< of its foot [m]
  Vector3 Axis{ 0.0, 0.0, 1.0 };     ///< from foot to tip, of unit length
  Vector3 Facing{ 1.0, 0.0, 0.0 };   ///< at a right angle to the leaf, of unit length
  Vector3 Normal{ 0.0, 0.0, 1.0 };   ///< for light, of unit length
  double Size = 0.1;                 ///< from foot to tip [m]
  double Width = 0.7;                ///< as part of Size
  Color Tint{ 0, 0, 0 };
  int Node = 0; ///< of the skeleton that carries it
};

/// A plant as a generator grows it.
struct Plant
{
  Skeleton Wood;
  std::vector<LeafParticle> Leaves;
  LeafForm Form = LeafForm::Blade;
  CrownVolume Crown;
  Color Leaf{ 112, 146, 60 }; ///< in the light
  Color Bark{ 105, 88, 70 };
};

/// Brightness of leaves and variation of their colors.
struct LeafLight
{
  double OfLeaf[2] = { 0.0, 0.0 }; ///< normal deviates of the leaf
  double OfTwig[2] = { 0.0, 0.0 }; ///< and of the twig that it grows on
};

/// The color of a leaf at a place in a crown: darker within and below (Reeves and Blau's
/// probabilistic shading, but for the sun, which is the renderer's), with a scatter from leaf to leaf and twig to twig.
Color TintOf(const Color& leaf, const CrownVolume& crown, const Vector3& position, const LeafLight& light);

/// Axis, facing, normal and tint of a leaf, whose position and node are there, as is the plant's crown: it points along
/// its twig and out of the crown and faces outward. Random numbers are the stream's for the index of the leaf (draws 3,
/// 5, 6, 7) and of the twig (draw 4).
void FinishLeaf(
  LeafParticle& leaf, const Plant& plant, const RandomStream& random, std::uint64_t index, std::uint64_t twig);

}

#endif
