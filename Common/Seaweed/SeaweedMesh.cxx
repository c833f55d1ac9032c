// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Seaweed/SeaweedMesh.h"

#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"
#include "Plants/BranchSkin.h"
#include "Plants/LeafCards.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace littoral
{

namespace
{

constexpr int Haptera = 14;
constexpr int SegmentsOfHapteron = 4;
constexpr int SidesOfFloat = 6;
constexpr int RingsOfFloat = 4;
constexpr double RowsOfWave = 5.0;
constexpr double TipOfStrap = 0.02; // the last row of a leaf that ends bluntly, as part of its length
constexpr int SidesOfLow = 4;
constexpr int CornersOfLow = 16;

Color Scaled(const Color& color, double gain, double warm = 0.0)
{
  const double gains[3] = { gain * (1.0 + warm), gain, gain * (1.0 - warm) };
  Color scaled{};
  for (int channel = 0; channel < 3; ++channel)
  {
    scaled[channel] = static_cast<unsigned char>(std::lround(std::clamp(gains[channel] * color[channel], 0.0, 255.0)));
  }
  return scaled;
}

void AddJoint(PlantMesh& mesh, int own, int other, double weightOfOther)
{
  mesh.JointIds.push_back({ own, other, own, own });
  mesh.JointWeights.push_back({ 1.0 - weightOfOther, weightOfOther, 0.0, 0.0 });
}

/// The curve of a blade: through its nodes, smooth, with the direction of its width.
class BladeCurve
{
public:
  BladeCurve(const Seaweed& seaweed, const SeaweedBlade& blade)
  {
    const SkeletonBranch& branch = seaweed.Wood.Branches[blade.Branch];
    this->First = branch.First + blade.FirstStep;
    this->FirstOfBranch = branch.First;
    for (int node = this->First; node < branch.First + branch.Count; ++node)
    {
      this->Nodes.push_back(seaweed.Wood.Nodes[node].Position);
      this->Sides.push_back(seaweed.Segments[node].Across);
    }
    this->Steps = BladeSteps(this->NumberOfSegments());
    for (std::size_t node = this->Sides.size() - 2; node >= 1; --node)
    {
      this->Sides[node] = Normalised(this->Sides[node] + this->Sides[node - 1]);
    }
  }

  int NumberOfSegments() const { return static_cast<int>(this->Nodes.size()) - 1; }

  /// Position at a part of the length (Catmull-Rom).
  Vector3 At(double part) const
  {
    double t = 0.0;
    const int i = this->SegmentAt(part, t);
    const Vector3 &a = this->Nodes[i], &b = this->Nodes[i + 1];
    const Vector3 before = i > 0 ? this->Nodes[i - 1] : 2.0 * a - b;
    const Vector3 after = i + 2 <= this->NumberOfSegments() ? this->Nodes[i + 2] : 2.0 * b - a;
    return 0.5 *
      (2.0 * a + t * (b - before) + t * t * (2.0 * before - 5.0 * a + 4.0 * b - after) +
        t * t * t * (3.0 * a - before - 3.0 * b + after));
  }

  /// Along the width, at a right angle to a direction.
  Vector3 SideAt(double part, const Vector3& along) const
  {
    double t = 0.0;
    const int i = this->SegmentAt(part, t);
    const Vector3 side = glm::mix(this->Sides[i], this->Sides[i + 1], t);
    const Vector3 flat = side - glm::dot(side, along) * along;
    return glm::length(flat) > 1e-6 ? glm::normalize(flat) : Perpendicular(along);
  }

  Vector3 DirectionAt(double part) const
  {
    const double step = 0.02 / this->NumberOfSegments();
    return Normalised(this->At(std::min(1.0, part + step)) - this->At(std::max(0.0, part - step)));
  }

  void AddJointAt(PlantMesh& mesh, double part) const
  {
    double t = 0.0;
    const int i = this->SegmentAt(part, t);
    const int own = this->First + i;
    const bool below = t < 0.5 && own > this->FirstOfBranch;
    const bool above = t > 0.5 && i + 1 < this->NumberOfSegments();
    const int other = below ? own - 1 : above ? own + 1 : own;
    AddJoint(mesh, own, other, below || above ? std::abs(t - 0.5) : 0.0);
  }

private:
  int First = 0;
  int FirstOfBranch = 0;
  std::vector<Vector3> Nodes;
  std::vector<Vector3> Sides;
  std::vector<double> Steps; // where segments begin and end, as parts of the length

  int SegmentAt(double part, double& within) const
  {
    const double place = std::clamp(part, 0.0, 1.0);
    const auto after = std::upper_bound(this->Steps.begin() + 1, this->Steps.end() - 1, place);
    const auto segment = static_cast<int>(after - this->Steps.begin()) - 1;
    within = (place - this->Steps[segment]) / (this->Steps[segment + 1] - this->Steps[segment]);
    return segment;
  }
};

/// Length of the waves of an edge, as part of the width.
double WaveOfWidth(SeaweedForm form)
{
  return form == SeaweedForm::Tuft ? 0.85 : 1.5;
}

/// The color of a blade at a part of its length and a distance from its middle, 1 at the edge. Without its waves it is
/// darker all over, by as much as their slopes are on the average.
Color ColorOfBlade(const SeaweedBlade& blade, SeaweedForm form, double part, double across, bool hasWaves)
{
  const double foot = std::exp(-5.0 * part);
  const double slopes = hasWaves ? 0.0 : blade.Ruffle / blade.Width;
  if (form == SeaweedForm::Meadow)
  {
    return Scaled(blade.Tint, 1.0 - slopes - 0.25 * foot + 0.15 * part, 0.18 * std::pow(part, 4.0));
  }
  const double thin = across * across; // light comes through the edge
  return Scaled(blade.Tint, (0.84 + 0.22 * thin) * (1.0 - 0.2 * foot - slopes) + 0.06 * part, 0.05 * thin);
}

class RibbonMaker
{
public:
  RibbonMaker(const Seaweed& seaweed, const RibbonOptions& options)
    : Weed(seaweed)
    , Options(options)
  {
  }

  PlantMesh Run()
  {
    for (const SeaweedBlade& blade : this->Weed.Blades)
    {
      this->AddBlade(blade);
    }
    return std::move(this->Mesh);
  }

private:
  const Seaweed& Weed;
  const RibbonOptions& Options;
  PlantMesh Mesh;

  /// Offset of a place of a ruffled blade from its mean plane [m].
  double Wave(const SeaweedBlade& blade, double part, double across) const
  {
    const double waves = blade.Length / (WaveOfWidth(this->Weed.Parameters.Form) * blade.Width);
    const double side = across > 0.0 ? 1.0 : -1.0;
    const double phase = TwoPi * part * waves * (1.0 + 0.06 * side) + (2.0 + side) * blade.Phase +
      1.8 * std::sin(TwoPi * 1.7 * part + (2.0 - side) * blade.Phase);
    const double fade = std::min({ 1.0, 5.0 * part, 6.0 * (1.0 - part) });
    const double uneven = 0.7 + 0.3 * std::sin(TwoPi * (2.3 + 0.9 * side) * part + 3.0 * blade.Phase);
    return blade.Ruffle * fade * uneven * std::pow(std::abs(across), 1.6) * std::sin(phase);
  }

  /// Rows of vertices along a blade, as parts of its length.
  std::vector<double> RowsOf(const SeaweedBlade& blade, int segments) const
  {
    const SeaweedForm form = this->Weed.Parameters.Form;
    double count = std::max(1.0, std::ceil(this->Options.RowsOfSegment * segments));
    if (this->Options.HasRuffles && blade.Ruffle > 0.0)
    {
      count = std::max(count, std::ceil(RowsOfWave * blade.Length / (WaveOfWidth(form) * blade.Width)));
    }
    count = std::min<double>(count, this->Options.MaximumRows);
    std::vector<double> rows;
    for (int row = 0; row <= static_cast<int>(count); ++row)
    {
      const bool isTip = row == static_cast<int>(count);
      if (isTip && form == SeaweedForm::Meadow && TipOfStrap * count < 1.0)
      {
        rows.push_back(1.0 - TipOfStrap);
      }
      rows.push_back(row / count);
    }
    return rows;
  }

  void AddBlade(const SeaweedBlade& blade)
  {
    const BladeCurve curve(this->Weed, blade);
    const bool ruffled = this->Options.HasRuffles && blade.Ruffle > 0.0;
    const std::vector<double> parts = this->RowsOf(blade, curve.NumberOfSegments());
    const int rows = static_cast<int>(parts.size()) - 1;
    const int columns = !ruffled ? 2 : this->Weed.Parameters.Form == SeaweedForm::Tuft ? 5 : 3;
    const int first = static_cast<int>(this->Mesh.Points.size());
    for (const double part : parts)
    {
      const Vector3 middle = curve.At(part);
      const Vector3 along = curve.DirectionAt(part);
      const Vector3 side = curve.SideAt(part, along);
      const Vector3 facing = glm::cross(along, side);
      const double half = 0.5 * blade.Width * BladeProfile(this->Weed.Parameters.Form, part);
      for (int column = 0; column < columns; ++column)
      {
        const double across = 2.0 * column / (columns - 1) - 1.0;
        const double wave = ruffled ? this->Wave(blade, part, across) : 0.0;
        this->Mesh.Points.push_back(middle + across * half * side + wave * facing);
        this->Mesh.TCoords.push_back({ 0.5 + 0.5 * across, part });
        this->Mesh.Colors.push_back(
          ColorOfBlade(blade, this->Weed.Parameters.Form, part, std::abs(across), this->Options.HasRuffles));
        if (this->Options.HasJoints)
        {
          curve.AddJointAt(this->Mesh, part);
        }
      }
    }
    this->AddNormals(first, rows, columns);
    for (int row = 0; row < rows; ++row)
    {
      for (int column = 0; column + 1 < columns; ++column)
      {
        const int corner = first + row * columns + column;
        this->Mesh.AddPolygon(std::array<int, 4>{ corner, corner + 1, corner + columns + 1, corner + columns });
      }
    }
  }

  void AddNormals(int first, int rows, int columns)
  {
    const auto at = [&](int row, int column) { return this->Mesh.Points[first + row * columns + column]; };
    for (int row = 0; row <= rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        const Vector3 along = at(std::min(row + 1, rows), column) - at(std::max(row - 1, 0), column);
        const Vector3 across = at(row, std::min(column + 1, columns - 1)) - at(row, std::max(column - 1, 0));
        this->Mesh.Normals.push_back(Normalised(glm::cross(across, along)));
      }
    }
  }
};

/// Round parts of a seaweed, as branches of their own that remember the joints they follow.
struct RoundParts
{
  Skeleton Wood;
  std::vector<int> Joints; // of each node
};

RoundParts RoundPartsOf(const Seaweed& seaweed, int step)
{
  RoundParts parts;
  for (const SkeletonBranch& branch : seaweed.Wood.Branches)
  {
    int end = branch.First;
    while (end + 1 < branch.First + branch.Count &&
      (seaweed.Segments[end].Tissue == SeaweedTissue::Stipe || seaweed.Segments[end].Tissue == SeaweedTissue::Holdfast))
    {
      ++end;
    }
    for (int node = branch.First; node <= end && end > branch.First;)
    {
      const Vector3& position = seaweed.Wood.Nodes[node].Position;
      // The end of a stipe is as thick as its last segment, not as flat as the blade that starts there.
      const double radius = EquivalentRadius(seaweed.Segments[std::min(node, end - 1)]);
      if (node == branch.First)
      {
        parts.Wood.StartBranch(-1, position, radius);
      }
      else
      {
        parts.Wood.Grow(position, radius);
      }
      parts.Joints.push_back(std::min(node, end - 1));
      node = node < end ? std::min(node + step, end) : end + 1;
    }
  }
  return parts;
}

PlantMesh RoundSkin(const Seaweed& seaweed, int step, int sides)
{
  const RoundParts parts = RoundPartsOf(seaweed, step);
  BranchSkinOptions options;
  options.MaximumSides = sides;
  options.BarkLength = 0.2;
  options.Bark = seaweed.Parameters.Stipe;
  PlantMesh mesh = SkinOf(parts.Wood, options);
  for (auto& joints : mesh.JointIds)
  {
    for (int& joint : joints)
    {
      joint = parts.Joints[joint];
    }
  }
  return mesh;
}

void Append(PlantMesh& mesh, const PlantMesh& other)
{
  const int first = static_cast<int>(mesh.Points.size());
  const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  add(mesh.Points, other.Points);
  add(mesh.Normals, other.Normals);
  add(mesh.TCoords, other.TCoords);
  add(mesh.Colors, other.Colors);
  add(mesh.JointIds, other.JointIds);
  add(mesh.JointWeights, other.JointWeights);
  for (int polygon = 0; polygon < other.NumberOfPolygons(); ++polygon)
  {
    std::vector<int> corners(
      other.Corners.begin() + other.Offsets[polygon], other.Corners.begin() + other.Offsets[polygon + 1]);
    for (int& corner : corners)
    {
      corner += first;
    }
    mesh.AddPolygon(corners);
  }
}

/// The fingers that grip the rock: from the top of the holdfast outwards and down. They follow its node.
PlantMesh HapteraOf(const Seaweed& seaweed)
{
  const SeaweedParameters& p = seaweed.Parameters;
  const RandomStream random(p.Seed, RandomPurpose::SeaweedFronds);
  const double top = seaweed.Wood.Nodes[1].Position.z;
  Skeleton fingers;
  for (int finger = 0; finger < Haptera; ++finger)
  {
    const auto draws = random.UniformPair(static_cast<std::uint64_t>(finger), 40);
    const double azimuth = TwoPi * (finger + 0.7 * draws[0]) / Haptera;
    const double reach = p.HoldfastRadius * (0.6 + 0.4 * draws[1]);
    const double thick = 0.09 * p.HoldfastRadius;
    for (int step = 0; step <= SegmentsOfHapteron; ++step)
    {
      const double part = static_cast<double>(step) / SegmentsOfHapteron;
      const double bend = azimuth + 0.8 * (draws[0] - 0.5) * part;
      const double out = 0.15 * p.HoldfastRadius + (reach - 0.15 * p.HoldfastRadius) * part;
      const Vector3 place{ out * std::cos(bend), out * std::sin(bend), top * 0.9 * (1.0 - part * part) };
      const double radius = thick * (1.0 - 0.6 * part);
      if (step == 0)
      {
        fingers.StartBranch(-1, place, radius);
      }
      else
      {
        fingers.Grow(place, radius);
      }
    }
  }
  BranchSkinOptions options;
  options.MaximumSides = 6;
  options.BarkLength = 0.2;
  options.Bark = Scaled(p.Stipe, 0.85);
  PlantMesh mesh = SkinOf(fingers, options);
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    mesh.JointIds[vertex] = { 0, 0, 0, 0 };
    mesh.JointWeights[vertex] = { 1.0, 0.0, 0.0, 0.0 };
  }
  return mesh;
}

/// A pear on the segment that starts at a node.
void AddFloat(PlantMesh& mesh, const Seaweed& seaweed, int node)
{
  const Vector3& foot = seaweed.Wood.Nodes[node].Position;
  const Vector3 step = seaweed.Wood.Nodes[node + 1].Position - foot;
  const Vector3 axis = glm::normalize(step);
  const Vector3 side = Perpendicular(axis);
  const Vector3 other = glm::cross(axis, side);
  const double length = glm::length(step);
  const double thick = EquivalentRadius(seaweed.Segments[node]);
  const Color color = Scaled(seaweed.Parameters.Blade, 0.95, 0.02);
  const int first = static_cast<int>(mesh.Points.size());
  const auto add = [&](double part, double radius, double angle, double u) {
    const Vector3 normal = std::cos(angle) * side + std::sin(angle) * other;
    mesh.Points.push_back(foot + part * length * axis + radius * normal);
    mesh.Normals.push_back(Normalised(normal + 1.2 * (part - 0.55) * axis));
    mesh.TCoords.push_back({ u, part });
    mesh.Colors.push_back(color);
    AddJoint(mesh, node, node, 0.0);
  };
  for (int ring = 0; ring < RingsOfFloat; ++ring)
  {
    const double part = (ring + 0.3) / (RingsOfFloat - 0.4);
    const double radius = thick * std::max(0.12, std::pow(std::sin(Pi * std::pow(part, 1.3)), 0.8));
    for (int corner = 0; corner <= SidesOfFloat; ++corner)
    {
      const double u = static_cast<double>(corner) / SidesOfFloat;
      add(part, radius, TwoPi * (corner % SidesOfFloat) / SidesOfFloat, u);
    }
  }
  add(0.0, 0.0, 0.0, 0.5);
  add(1.0, 0.0, 0.0, 0.5);
  const int ends = first + RingsOfFloat * (SidesOfFloat + 1);
  for (int corner = 0; corner < SidesOfFloat; ++corner)
  {
    mesh.AddPolygon(std::array<int, 3>{ ends, first + corner + 1, first + corner });
    for (int ring = 0; ring + 1 < RingsOfFloat; ++ring)
    {
      const int low = first + ring * (SidesOfFloat + 1) + corner;
      const int high = low + SidesOfFloat + 1;
      mesh.AddPolygon(std::array<int, 4>{ low, low + 1, high + 1, high });
    }
    const int last = first + (RingsOfFloat - 1) * (SidesOfFloat + 1) + corner;
    mesh.AddPolygon(std::array<int, 3>{ last, last + 1, ends + 1 });
  }
}

/// A polygon of a mesh, for the lowest level.
struct Facet
{
  Vector3 Middle{ 0.0, 0.0, 0.0 };
  double Area = 0.0; // that may be seen [m2]
  double Low = 0.0;  // lowest and highest corner [m]
  double High = 0.0;
  Color Tint{ 0, 0, 0 };
};

/// Adds the polygons of a mesh, of which this part can be seen at once: half where it is closed.
void AddFacets(const PlantMesh& mesh, double seen, std::vector<Facet>& facets)
{
  for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
  {
    const int begin = mesh.Offsets[polygon];
    const int end = mesh.Offsets[polygon + 1];
    const Vector3& origin = mesh.Points[mesh.Corners[begin]];
    Facet facet;
    facet.Low = facet.High = origin.z;
    facet.Tint = mesh.Colors[mesh.Corners[begin]];
    for (int corner = begin; corner < end; ++corner)
    {
      const Vector3& point = mesh.Points[mesh.Corners[corner]];
      facet.Middle += point / static_cast<double>(end - begin);
      facet.Low = std::min(facet.Low, point.z);
      facet.High = std::max(facet.High, point.z);
    }
    facet.Area = 0.5 * seen * glm::length(AreaVector(mesh, polygon));
    facets.push_back(facet);
  }
}

/// Makes four upright polygons of the four sides of a plant.
class LowMaker
{
public:
  explicit LowMaker(const PlantPrototype& prototype)
  {
    AddFacets(prototype.Skin, 0.5, this->Facets);
    AddFacets(prototype.Leaves, 1.0, this->Facets);
  }

  PlantMesh Run()
  {
    for (int side = 0; side < SidesOfLow; ++side)
    {
      const double azimuth = TwoPi * (side + 0.25) / SidesOfLow; // none is seen edge on from north or east
      this->AddSide({ std::cos(azimuth), std::sin(azimuth), 0.0 });
    }
    return std::move(this->Mesh);
  }

private:
  std::vector<Facet> Facets;
  PlantMesh Mesh;

  /// The facets on a side; all, a part of each, where there are none.
  std::vector<Facet> FacetsOf(const Vector3& outward) const
  {
    std::vector<Facet> own;
    for (const Facet& facet : this->Facets)
    {
      const double away = std::hypot(facet.Middle.x, facet.Middle.y);
      if (glm::dot(facet.Middle, outward) > std::cos(Pi / SidesOfLow) * away)
      {
        own.push_back(facet);
      }
    }
    if (own.empty())
    {
      own = this->Facets;
      for (Facet& facet : own)
      {
        facet.Area /= SidesOfLow;
      }
    }
    return own;
  }

  /// The mean color around a height.
  static Color ColorAt(const std::vector<Facet>& facets, double height, double reach)
  {
    double sums[3] = { 0.0, 0.0, 0.0 };
    double weights = 0.0;
    for (const Facet& facet : facets)
    {
      const double off = (facet.Middle.z - height) / reach;
      const double weight = facet.Area * std::exp(-off * off);
      weights += weight;
      for (int channel = 0; channel < 3; ++channel)
      {
        sums[channel] += weight * facet.Tint[channel];
      }
    }
    Color color = facets.front().Tint;
    for (int channel = 0; channel < 3 && weights > 0.0; ++channel)
    {
      color[channel] = static_cast<unsigned char>(std::lround(sums[channel] / weights));
    }
    return color;
  }

  /// An ellipse, sheared to lean as the side does: convex, so that any renderer fills it.
  void AddSide(const Vector3& outward)
  {
    const std::vector<Facet> facets = this->FacetsOf(outward);
    double low = facets.front().Low;
    double high = facets.front().High;
    double area = 0.0;
    Vector3 mean(0.0); // of place, height and the square of height
    double product = 0.0;
    for (const Facet& facet : facets)
    {
      const double place = glm::dot(facet.Middle, outward);
      const double height = facet.Middle.z;
      low = std::min(low, facet.Low);
      high = std::max(high, facet.High);
      area += facet.Area;
      mean += facet.Area * Vector3(place, height, height * height);
      product += facet.Area * place * height;
    }
    mean /= area;
    const double spread = mean.z - mean.y * mean.y;
    const double lean = spread > 0.0 ? (product / area - mean.x * mean.y) / spread : 0.0;
    double reach = 0.0;
    for (const Facet& facet : facets)
    {
      reach = std::max(reach, std::abs(glm::dot(facet.Middle, outward) - mean.x - lean * (facet.Middle.z - mean.y)));
    }
    const double tall = 0.5 * (high - low);
    const double half = std::clamp(area / (Pi * tall), 1e-3 * tall, std::max(reach, 2e-3 * tall));
    std::vector<int> corners;
    for (int corner = 0; corner < CornersOfLow; ++corner)
    {
      const double angle = TwoPi * corner / CornersOfLow;
      const double height = low + tall * (1.0 - std::cos(angle));
      const double place = mean.x + lean * (height - mean.y) + half * std::sin(angle);
      corners.push_back(static_cast<int>(this->Mesh.Points.size()));
      this->Mesh.Points.emplace_back(place * outward + Vector3(0.0, 0.0, height));
      this->Mesh.Normals.push_back({ outward.y, -outward.x, 0.0 });
      this->Mesh.Colors.push_back(ColorAt(facets, height, 0.25 * tall));
    }
    this->Mesh.AddPolygon(corners);
  }
};

/// Shade of a blade at a place across (-1 to 1) and along (0 to 1).
double ShadeOfBlade(SeaweedForm form, double across, double along)
{
  const double x = std::abs(across);
  switch (form)
  {
    case SeaweedForm::Tuft:
    {
      // A dark band along the middle with a row of dimples on both sides.
      const double band = std::exp(-std::pow(x / 0.22, 4.0));
      const double row = std::exp(-std::pow((x - 0.4) / 0.16, 2.0));
      const double dimples = std::sin(TwoPi * (15.0 * along + 0.25 * across + (across > 0.0 ? 0.5 : 0.0)));
      return 0.9 - 0.12 * band + 0.1 * row * dimples;
    }
    case SeaweedForm::Canopy:
      // Wrinkles that run lengthwise and join.
      return 0.88 + 0.09 * std::sin(13.0 * across + 2.5 * std::sin(11.0 * along) + 1.3 * std::sin(29.0 * along));
    default:
      // Veins.
      return 0.9 + 0.06 * std::cos(5.0 * Pi * across);
  }
}

}

PlantMesh RibbonsOf(const Seaweed& seaweed, const RibbonOptions& options)
{
  return RibbonMaker(seaweed, options).Run();
}

PlantMesh StipesOf(const Seaweed& seaweed)
{
  PlantMesh mesh = RoundSkin(seaweed, 1, 8);
  if (seaweed.Parameters.Form != SeaweedForm::Meadow)
  {
    Append(mesh, HapteraOf(seaweed));
  }
  for (int node = 0; node + 1 < static_cast<int>(seaweed.Segments.size()); ++node)
  {
    const SkeletonBranch& branch = seaweed.Wood.Branches[seaweed.Wood.Nodes[node].Branch];
    const bool startsSegment = node + 1 < branch.First + branch.Count;
    if (startsSegment && seaweed.Segments[node].Tissue == SeaweedTissue::Float)
    {
      AddFloat(mesh, seaweed, node);
    }
  }
  TurnNormalsToFronts(mesh); // of floats
  return mesh;
}

TextureImage BladePicture(SeaweedForm form, const Color& color, int columns, int rows)
{
  TextureImage picture(columns, rows);
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const double shade = ShadeOfBlade(form, 2.0 * (column + 0.5) / columns - 1.0, (row + 0.5) / rows);
      const Color texel = Scaled(color, shade);
      picture.At(column, row) = { texel[0], texel[1], texel[2], 255 };
    }
  }
  return picture;
}

PlantPrototype LevelsOf(const Seaweed& seaweed, const PlantLevelOptions& options)
{
  const SeaweedParameters& p = seaweed.Parameters;
  PlantPrototype prototype;
  prototype.Wood = seaweed.Wood;
  prototype.Segments = seaweed.Segments;
  prototype.Skin = StipesOf(seaweed);
  prototype.Leaves = RibbonsOf(seaweed, {});
  prototype.LeafTexture = BladePicture(p.Form, { 255, 255, 255 }, LeafPictureSize, LeafPictureSize);
  prototype.Trunk = RoundSkin(seaweed, 2, 3);
  prototype.Trunk.JointIds.clear();
  prototype.Trunk.JointWeights.clear();
  RibbonOptions coarse;
  coarse.HasRuffles = false;
  coarse.HasJoints = false;
  coarse.RowsOfSegment = 0.75;
  prototype.Crown = RibbonsOf(seaweed, coarse);
  prototype.CrownTexture = BladePicture(p.Form, p.Blade, options.TextureColumns, options.TextureRows);
  prototype.CrownTextureMean = MeanOf(prototype.CrownTexture);
  prototype.Low = LowMaker(prototype).Run();
  return prototype;
}

}
