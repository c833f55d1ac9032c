// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedPlant.h"
#include "Seaweed/SegmentAngles.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Seaweed/SeaweedGrowth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

/// The mean length of the segments of a tissue in a branch [m].
double MeanLengthOf(const Skeleton& skeleton, const std::vector<SeaweedSegment>& segments, const SkeletonBranch& branch,
  SeaweedTissue tissue)
{
  double length = 0.0;
  int count = 0;
  for (int node = branch.First; node < branch.First + branch.Count - 1; ++node)
  {
    if (segments[node].Tissue == tissue)
    {
      length += glm::distance(skeleton.Nodes[node].Position, skeleton.Nodes[node + 1].Position);
      ++count;
    }
  }
  return length / std::max(1, count);
}

/// A link from a node to the next, without its joint.
SeaweedLink BodyOf(const Skeleton& skeleton, int node, const SeaweedSegment& segment, const SeaweedOptions& options)
{
  SeaweedLink link;
  const Vector3 along = skeleton.Nodes[node + 1].Position - skeleton.Nodes[node].Position;
  const double area = SectionArea(segment);
  link.Node = node;
  link.Foot = skeleton.Nodes[node].Position;
  link.Length = glm::length(along);
  link.Axis = along / link.Length;
  const Vector3 across = segment.Across - glm::dot(segment.Across, link.Axis) * link.Axis;
  link.Side = glm::length(across) > 1e-3 ? glm::normalize(across) : Perpendicular(link.Axis);
  const bool floats = options.Load == SeaweedLoad::Morison;
  const double w2 = segment.Width * segment.Width;
  const double t2 = segment.Thickness * segment.Thickness;
  link.Mass = SegmentMass(segment, link.Length);
  link.WaterMass = options.WaterDensity * area * link.Length;
  // Added mass of an ellipse: C rho pi/4 w2 normal to its face, C rho pi/4 t2 along it, C rho pi/128 (w2 - t2)2 in a
  // turn about its middle; none along the segment.
  const double water = floats ? options.AddedMassCoefficient * options.WaterDensity * 0.25 * Pi * link.Length : 0.0;
  link.FaceMass = water * w2;
  link.EdgeMass = water * t2;
  link.AxialInertia = link.Mass * (w2 + t2) / 16.0 + water * (w2 - t2) * (w2 - t2) / 32.0;
  link.Buoyancy = floats ? NetBuoyancy(segment, link.Length, options.WaterDensity) : 0.0;
  link.Weight = floats ? SegmentMass(segment, link.Length) * Gravity : 0.0;
  // Drag coefficient of a plate, of which what is round has half (1.95 and about 1)
  const double drag = segment.Tissue == SeaweedTissue::Blade ? link.Length : 0.5 * link.Length;
  link.FrontalArea = drag * segment.Width;
  link.EdgeFrontalArea = drag * segment.Thickness;
  link.WettedArea = Pi * 0.5 * (segment.Width + segment.Thickness) * link.Length;
  return link;
}

}

std::string WhyInvalid(const SeaweedOptions& options)
{
  ParameterCheck check;
  check.Range("WaterDensity", options.WaterDensity, 1.0, 1e5, "kg/m3");
  check.Range("SeaLevel", options.SeaLevel, -1e9, 1e9, "m");
  check.Range("DragCoefficient", options.DragCoefficient, 0.0, 100.0);
  check.Range("FrictionCoefficient", options.FrictionCoefficient, 0.0, 100.0);
  check.Range("AddedMassCoefficient", options.AddedMassCoefficient, 0.0, 100.0);
  check.Range("DampingFactor", options.DampingFactor, 0.0, 1e3);
  check.Range("ForceFactor", options.ForceFactor, 0.0, 1e6);
  check.Range("LeverArm", options.LeverArm, 0.0, 1.0);
  check.Range("MaximumAngle", options.MaximumAngle, 0.0, Pi, "rad");
  return check.Reason();
}

std::vector<SeaweedLink> LinksOf(
  const Skeleton& skeleton, const std::vector<SeaweedSegment>& segments, const SeaweedOptions& options)
{
  std::vector<SeaweedLink> links;
  std::vector<double> ratios;
  std::vector<int> linkOfNode(skeleton.Nodes.size(), -1);
  const std::vector<SegmentAngles> angles = AnglesOf(skeleton);
  for (const SkeletonBranch& branch : skeleton.Branches)
  {
    for (int node = branch.First; node < branch.First + branch.Count - 1; ++node)
    {
      const SeaweedSegment& segment = segments[node];
      if (segment.Tissue == SeaweedTissue::Holdfast)
      {
        continue; // ground to what grows on it
      }
      SeaweedLink link = BodyOf(skeleton, node, segment, options);
      const int parent = skeleton.Nodes[node].Parent;
      link.Parent = parent < 0 ? -1 : linkOfNode[parent];
      link.IsFirst = node == branch.First || link.Parent < 0;
      link.MeanLength = MeanLengthOf(skeleton, segments, branch, segment.Tissue);
      link.Bed = link.Parent < 0 ? link.Foot.z : links[link.Parent].Bed;
      link.Theta = angles[node].Theta;
      link.Phi = angles[node].Phi;
      // Two halves in series: K = 2 K_1 K_2 / (K_1 + K_2); at the foot of a branch half a segment, 2 K
      const double own = JointStiffness(segment, link.Length);
      link.Stiffness = 2.0 * own;
      if (!link.IsFirst)
      {
        const double below = JointStiffness(segments[parent], links.back().Length);
        link.Stiffness = own + below > 0.0 ? 2.0 * own * below / (own + below) : 0.0;
      }
      linkOfNode[node] = static_cast<int>(links.size());
      links.push_back(link);
      ratios.push_back(options.DampingFactor * segment.DampingRatio);
    }
    // What grows on a tip grows on the segment that ends there.
    linkOfNode[branch.First + branch.Count - 1] = linkOfNode[branch.First + branch.Count - 2];
  }
  SetDamping(links, ratios);
  return links;
}

double ResolvedCauchyNumber(double length, double firstLink)
{
  return std::pow(0.52 * length / firstLink, 3);
}

double UngradedCauchyNumber(const Skeleton& skeleton, const std::vector<SeaweedSegment>& segments)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SkeletonBranch& branch : skeleton.Branches)
  {
    const int tip = branch.First + branch.Count - 1;
    int foot = branch.First;
    while (foot < tip && segments[foot].Tissue != SeaweedTissue::Blade)
    {
      ++foot;
    }
    double length = 0.0;
    double first = 0.0;
    for (int node = tip - 1; node >= foot; --node)
    {
      first = glm::distance(skeleton.Nodes[node].Position, skeleton.Nodes[node + 1].Position);
      length += first;
    }
    if (foot < tip && first > 2.0 * BladeSteps(tip - foot)[1] * length)
    {
      least = std::min(least, ResolvedCauchyNumber(length, first));
    }
  }
  return least;
}

void SetDamping(std::vector<SeaweedLink>& links, const std::vector<double>& ratios)
{
  // Mass, first and second moment of all beyond a joint about its foot, and the lift of all beyond.
  struct Beyond
  {
    double Mass = 0.0;
    Vector3 First{ 0.0 };
    double Second = 0.0;
    double Lift = 0.0;
    double LiftArm = 0.0;
  };
  std::vector<Beyond> sums(links.size());
  for (std::size_t i = links.size(); i-- > 0;)
  {
    SeaweedLink& link = links[i];
    Beyond& sum = sums[i];
    const double l = link.Length;
    const double mass = link.Mass + link.FaceMass;
    sum.Mass += mass;
    sum.First += 0.5 * mass * l * link.Axis;
    sum.Second += mass * l * l / 3.0;
    sum.Lift += link.Buoyancy;
    sum.LiftArm += 0.5 * l * link.Buoyancy;
    // d = 2 zeta (K I)^(1/2)
    link.Damping = 2.0 * ratios[i] * std::sqrt(link.Stiffness * sum.Second);
    link.BuoyancyStiffness = std::max(0.0, sum.LiftArm);
    if (link.Parent >= 0)
    {
      Beyond& below = sums[link.Parent];
      const Vector3 arm = link.Foot - links[link.Parent].Foot;
      below.Mass += sum.Mass;
      below.First += sum.First + sum.Mass * arm;
      // Parallel axes, arm r: I + 2 r . S + M r^2
      below.Second += sum.Second + 2.0 * glm::dot(arm, sum.First) + sum.Mass * glm::dot(arm, arm);
      below.Lift += sum.Lift;
      below.LiftArm += glm::length(arm) * sum.Lift;
    }
  }
}

double ExplicitLimit(const std::vector<SeaweedLink>& links)
{
  double limit = std::numeric_limits<double>::infinity();
  const bool isChain = links.size() > 1;
  for (const SeaweedLink& link : links)
  {
    const double inertia = (link.Mass + link.EdgeMass) * link.Length * link.Length / 3.0; // the least
    const double frequency = std::sqrt(link.Stiffness / inertia);
    if (frequency <= 0.0)
    {
      continue;
    }
    const double ratio = link.Damping / (2.0 * frequency * inertia);
    // Explicit Euler: h <= 2 zeta / w, overdamped 2 / (w (zeta + (zeta^2 - 1)^(1/2)))
    const double own =
      ratio < 1.0 ? 2.0 * ratio / frequency : 2.0 / (frequency * (ratio + std::sqrt(ratio * ratio - 1.0)));
    limit = std::min(limit, isChain ? 0.5 * own : own); // the highest mode of a long chain has twice the frequency
  }
  return limit;
}

}
