// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Currents/FlowPrimitives.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterTraits.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

/// (1 - exp(-x))/x, 1 at 0. Beyond 40 the exponential is less than the last digit of 1.
double CoreShare(double x)
{
  if (x > 40.0)
  {
    return 1.0 / x;
  }
  return x > 1e-8 ? -std::expm1(-x) / x : 1.0 - 0.5 * x;
}

bool IsBox(const Box& box)
{
  return IsFinite(box.Low) && IsFinite(box.High) && box.Low.x <= box.High.x && box.Low.y <= box.High.y &&
    box.Low.z <= box.High.z;
}

bool HasEnd(const FlowPrimitive& primitive)
{
  return primitive.InfluenceRadius > 0.0 || primitive.InfluenceMargin > 0.0;
}

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Images of an endless source on each side between two walls.
constexpr int SourceImages = 3;
/// Images of an endless vortex on each side between two walls, and the depths at which each has ended.
constexpr int VortexImages = 6;
/// Core of the vertical vortex that makes up for the far circulation of these [depths].
constexpr double FarCore = 3.0;
/// Images of what ends, on each side: a reach beyond this many depths leaves out images that hardly matter.
constexpr int MostImages = 64;

/// An axis whose slope is less than this is level.
constexpr double LevelAxis = 1e-9;

}

/// A mirror about a level, or a shift: a height z becomes Sign z + Offset.
struct FlowField::Reflection
{
  double Sign;
  double Offset;

  bool IsMirror() const { return this->Sign < 0.0; }
  bool IsNone() const { return this->Sign > 0.0 && this->Offset == 0.0; }
  Vector3 operator()(const Vector3& place) const { return { place.x, place.y, this->Sign * place.z + this->Offset }; }
  Box operator()(const Box& box) const
  {
    const Vector3 low = (*this)(box.Low);
    const Vector3 high = (*this)(box.High);
    return { glm::min(low, high), glm::max(low, high) };
  }
};

/// The row of a type. Its velocity is a case of Local::Flow, the innermost loop of all currents.
struct FlowField::Row
{
  FlowTraits Traits;
  double StrengthDivisor; ///< strength over the factor of the velocity
  bool IsWholeWater;      ///< whether it is the same everywhere unless it ends
  /// Whether walls make no images of it; null: they always do.
  bool (*NeedsNoImages)(const Local&);
  /// Cuts off what is beyond the walls; false if nothing is left. Null: there is nothing to cut.
  bool (*Clip)(Local&, const WaterLayer&);
  /// Makes the copy of a flow its image; null: it needs no more than another center.
  void (*Mirror)(Local&, const Reflection&);
  /// Adds the endless images between two walls; null: those within reach are added one by one.
  void (FlowField::*AddEndless)(const Local&, const WaterLayer&);
};

/// Rows in the order of the enumeration.
const FlowField::Row FlowField::Rows[NumberOfFlowTypes] = {
  // name, axis, core, point, captures, solenoidal; divisor, whole water, images
  { { "Uniform", true, false, false, false, true }, 1.0, true, IsLevelUniform, nullptr, MirrorUniform, nullptr },
  { { "Source", false, true, true, false, false }, 4.0 * Pi, false, nullptr, nullptr, nullptr,
    &FlowField::AddSourceStack },
  { { "Sink", false, true, true, true, false }, -4.0 * Pi, false, nullptr, nullptr, nullptr,
    &FlowField::AddSourceStack },
  { { "Vortex", true, true, false, false, true }, TwoPi, false, IsUprightVortex, ClipVortex, MirrorVortex,
    &FlowField::AddVortexChain },
};

const FlowTraits& TraitsOf(FlowType type)
{
  return FlowField::Rows[static_cast<int>(type)].Traits;
}

bool FlowField::IsLevelUniform(const Local& local)
{
  return local.Axis.z == 0.0;
}

/// The horizontal part goes through no wall: images are of the vertical part alone.
void FlowField::MirrorUniform(Local& image, const Reflection& reflection)
{
  if (!reflection.IsNone())
  {
    image.Factor = reflection.Sign * image.Factor * image.Axis.z;
    image.Axis = Vector3(0.0, 0.0, 1.0);
  }
}

bool FlowField::IsUprightVortex(const Local& local)
{
  return local.Axis.x == 0.0 && local.Axis.y == 0.0;
}

/// Keeps the part of the axis that is in the water.
bool FlowField::ClipVortex(Local& local, const WaterLayer& layer)
{
  if (std::abs(local.Axis.z) < LevelAxis)
  {
    local.Axis = Normalised({ local.Axis.x, local.Axis.y, 0.0 });
    if (!layer.Holds(local.Center.z))
    {
      return false;
    }
  }
  const double low = local.Axis.z != 0.0 ? (layer.Bed - local.Center.z) / local.Axis.z : -Infinity;
  const double high = local.Axis.z != 0.0 ? (layer.Surface - local.Center.z) / local.Axis.z : Infinity;
  local.First = std::min(low, high);
  local.Last = std::max(low, high);
  local.IsPart = std::isfinite(low) || std::isfinite(high);
  return true;
}

/// Turns the other way about the mirrored axis: the same along that axis turned round.
void FlowField::MirrorVortex(Local& image, const Reflection& reflection)
{
  if (reflection.IsMirror())
  {
    image.Axis = Vector3(-image.Axis.x, -image.Axis.y, image.Axis.z);
    const double first = image.First;
    image.First = -image.Last;
    image.Last = -first;
  }
}

/// The reflections that the walls make of what is in the water, the water itself first; between two walls as many on
/// each side.
std::vector<FlowField::Reflection> FlowField::ReflectionsOf(const WaterLayer& layer, int maximumImages)
{
  std::vector<Reflection> reflections{ { 1.0, 0.0 } };
  if (!layer.HasWalls())
  {
    return reflections;
  }
  if (!(layer.HasBed() && layer.HasSurface()))
  {
    reflections.push_back({ -1.0, 2.0 * (layer.HasBed() ? layer.Bed : layer.Surface) });
    return reflections;
  }
  for (int n = 1; n <= maximumImages; ++n)
  {
    // The layer that is n depths away, below and above.
    for (const int away : { -n, n })
    {
      const double even = away * layer.Depth();
      const double odd = layer.Bed + layer.Surface + even;
      reflections.push_back(n % 2 == 0 ? Reflection{ 1.0, even } : Reflection{ -1.0, odd });
    }
  }
  return reflections;
}

namespace
{

/// A box outside of which there is no flow: the common part of that about the sphere and that about the influence box.
Box ReachOf(const FlowPrimitive& primitive)
{
  const double margin = primitive.InfluenceMargin;
  const double radius = primitive.InfluenceRadius;
  const Box box{ primitive.InfluenceBox.Low - margin, primitive.InfluenceBox.High + margin };
  const Box ball{ primitive.Center - radius, primitive.Center + radius };
  if (radius == 0.0 || margin == 0.0)
  {
    return margin == 0.0 ? ball : box;
  }
  const Vector3 low = glm::max(box.Low, ball.Low);
  return { low, glm::max(low, glm::min(box.High, ball.High)) }; // a point of no flow if they do not meet
}

}

std::string WhyInvalid(const FlowPrimitive& primitive)
{
  ParameterCheck check;
  check.Choice("FlowType", static_cast<int>(primitive.Type), NumberOfFlowTypes);
  if (!check.IsGood())
  {
    return check.Reason();
  }
  const auto isLength = [](double value) { return value >= 0.0 && IsSensible(value); };
  const FlowTraits& traits = TraitsOf(primitive.Type);
  check.Finite("Strength", primitive.Strength);
  check.Require(IsSensible(primitive.Center), "Center must be finite, and below 1e15 m.");
  check.Require(!traits.HasAxis || (IsSensible(primitive.Axis) && glm::length(primitive.Axis) > 0.0),
    "Axis must be finite and not of length 0.");
  if (traits.HasCore)
  {
    check.Positive("CoreRadius", primitive.CoreRadius, "m");
  }
  // What does not count is still written into the output.
  check.Finite("CoreRadius", primitive.CoreRadius, "m");
  check.Require(IsSensible(primitive.Axis), "Axis must be finite.");
  constexpr const char* wanted = "positive and finite, or 0 for none";
  check.Require(isLength(primitive.InfluenceRadius), "InfluenceRadius", primitive.InfluenceRadius, "m", wanted);
  check.Require(isLength(primitive.InfluenceMargin), "InfluenceMargin", primitive.InfluenceMargin, "m", wanted);
  check.Require(!(primitive.InfluenceMargin > 0.0) || IsBox(primitive.InfluenceBox),
    "InfluenceBox must be finite, with lower ends that are not above the upper ones.");
  return check.Reason();
}

FlowField::FlowField(const std::vector<FlowPrimitive>& primitives, const WaterLayer& layer)
  : Count(primitives.size())
{
  const auto inverseSquare = [](double length) { return length > 0.0 ? 1.0 / (length * length) : 0.0; };
  for (const FlowPrimitive& primitive : primitives)
  {
    const Row& row = Rows[static_cast<int>(primitive.Type)];
    const Vector3 axis = Normalised(primitive.Axis);
    if (row.IsWholeWater && !HasEnd(primitive))
    {
      const Vector3 flow = primitive.Strength * axis;
      this->Everywhere += layer.HasWalls() ? Vector3(flow.x, flow.y, 0.0) : flow;
      continue;
    }
    if (row.Traits.IsPoint && !layer.Holds(primitive.Center.z))
    {
      continue;
    }
    const double core = primitive.CoreRadius * primitive.CoreRadius;
    if (row.Traits.Captures)
    {
      this->Sinks.push_back({ primitive.Center, core });
    }
    const Local local{ primitive.Type, primitive.Center, axis, primitive.Strength / row.StrengthDivisor, core,
      1.0 / core, inverseSquare(primitive.InfluenceRadius), primitive.InfluenceBox,
      inverseSquare(primitive.InfluenceMargin) };
    if (layer.HasWalls())
    {
      this->AddBetweenWalls(local, primitive, layer);
    }
    else
    {
      this->Add(local, primitive);
    }
  }
  this->Cells = BoxCells(this->Reaches);
  const auto isLimitedSource = [](const Local& local) {
    return (local.Type == FlowType::Source || local.Type == FlowType::Sink) && local.InverseMargin > 0.0 &&
      local.InverseInfluence == 0.0;
  };
  if (std::all_of(this->Ending.begin(), this->Ending.end(), isLimitedSource))
  {
    for (const Local& local : this->Ending)
    {
      this->Limited.Add({ local.Center, local.Factor, local.CoreSquared, local.Whole, local.InverseMargin });
    }
  }
}

void FlowField::Add(const Local& local, const FlowPrimitive& primitive)
{
  if (HasEnd(primitive))
  {
    this->Ending.push_back(local);
    this->Reaches.push_back(ReachOf(primitive));
  }
  else
  {
    this->Around.push_back(local);
  }
}

void FlowField::AddBetweenWalls(const Local& local, const FlowPrimitive& primitive, const WaterLayer& layer)
{
  const Row& row = Rows[static_cast<int>(primitive.Type)];
  if (row.NeedsNoImages && row.NeedsNoImages(local))
  {
    this->Add(local, primitive);
    return;
  }
  Local own = local;
  if (row.Clip && !row.Clip(own, layer))
  {
    return;
  }
  if (row.AddEndless && !HasEnd(primitive) && layer.HasBed() && layer.HasSurface())
  {
    (this->*row.AddEndless)(own, layer);
    return;
  }
  this->AddImages(own, primitive, layer);
}

void FlowField::AddImages(const Local& local, const FlowPrimitive& primitive, const WaterLayer& layer)
{
  const bool isEndless = !HasEnd(primitive);
  const auto reaches = [&](const Box& box) { return box.High.z >= layer.Bed && box.Low.z <= layer.Surface; };
  if (!isEndless && !reaches(ReachOf(primitive)))
  {
    return; // it flows beyond the walls alone
  }
  for (const Reflection& reflection : ReflectionsOf(layer, MostImages))
  {
    const Local image = Reflected(local, reflection);
    const Box reach = isEndless ? Box{} : reflection(ReachOf(primitive));
    if (isEndless)
    {
      this->Around.push_back(image);
    }
    else if (reaches(reach))
    {
      this->Ending.push_back(image);
      this->Reaches.push_back(reach);
    }
  }
}

void FlowField::AddSourceStack(const Local& local, const WaterLayer& layer)
{
  // The sum over all n of f(z - 2 n h) is the integral over dn and, on each side, the difference between the images up
  // to N and the integral up to N + 1/2, with (f(N + 1) - f(N))/24 as the next term: Euler and Maclaurin.
  const double depth = layer.Depth();
  const double end = (2.0 * SourceImages + 1.0) * depth;
  Column column{ local.Center.x, local.Center.y, local.Factor / (2.0 * depth), local.CoreSquared, {}, {} };
  int sequence = 0;
  for (const Reflection& first : { Reflection{ 1.0, 0.0 }, Reflection{ -1.0, 2.0 * layer.Bed } })
  {
    for (int n = -SourceImages - 1; n <= SourceImages + 1; ++n)
    {
      const int beyond = std::abs(n) - SourceImages;
      const double weight = beyond < 0 ? 1.0 : beyond == 0 ? 23.0 / 24.0 : 1.0 / 24.0;
      Local image = Reflected(local, { first.Sign, first.Offset + 2.0 * n * depth });
      image.Factor *= weight;
      this->Around.push_back(image);
    }
    const double middle = first(local.Center).z;
    column.Lows[sequence] = middle - end;
    column.Highs[sequence++] = middle + end;
  }
  this->Columns.push_back(column);
}

void FlowField::AddVortexChain(const Local& local, const WaterLayer& layer)
{
  const double depth = layer.Depth();
  Local part = local;
  part.IsPart = true;
  part.InverseFade = 1.0 / (VortexImages * depth * VortexImages * depth);
  for (const Reflection& reflection : ReflectionsOf(layer, VortexImages))
  {
    this->Around.push_back(Reflected(part, reflection));
  }
  if (local.Axis.z == 0.0)
  {
    return; // images cancel far away
  }
  Local far = local;
  far.IsPart = false;
  far.Center += 0.5 * (local.First + local.Last) * local.Axis;
  const double halfLength = 0.5 * (local.Last - local.First) * std::hypot(local.Axis.x, local.Axis.y);
  far.CoreSquared = FarCore * FarCore * depth * depth + halfLength * halfLength;
  far.InverseCore = 1.0 / far.CoreSquared;
  far.Axis = Vector3(0.0, 0.0, std::copysign(1.0, local.Axis.z));
  this->Around.push_back(far);
}

FlowField::Local FlowField::Reflected(const Local& local, const Reflection& reflection)
{
  Local image = local;
  image.Center = reflection(local.Center);
  image.Whole = reflection(local.Whole);
  if (const auto mirror = Rows[static_cast<int>(local.Type)].Mirror)
  {
    mirror(image, reflection);
  }
  return image;
}

inline double FlowField::Local::PartShare(double q2, double s) const
{
  double share = 1.0;
  if (this->InverseFade > 0.0)
  {
    const double beyond = std::max(0.0, std::max(this->First - s, s - this->Last));
    const double inside = 1.0 - (q2 + beyond * beyond) * this->InverseFade;
    if (inside <= 0.0)
    {
      return 0.0;
    }
    share = inside * inside;
  }
  // Biot and Savart, a straight piece of a vortex: (cos theta_1 - cos theta_2) / 2, of the angles of its ends
  const double softened = q2 + this->CoreSquared;
  const auto cosine = [softened](double t) {
    return std::isfinite(t) ? t / std::sqrt(softened + t * t) : std::copysign(1.0, t);
  };
  return 0.5 * share * (cosine(s - this->First) - cosine(s - this->Last));
}

inline Vector3 FlowField::Local::Flow(const Vector3& arm, double squaredArm, double factor) const
{
  switch (this->Type)
  {
    case FlowType::Uniform:
      return factor * this->Axis;
    case FlowType::Source:
    case FlowType::Sink:
    {
      // Q R / (4 pi (R^2 + e^2)^(3/2))
      const double softened = squaredArm + this->CoreSquared;
      return (factor / (softened * std::sqrt(softened))) * arm;
    }
    case FlowType::Vortex:
    {
      // Lamb and Oseen: Gamma / (2 pi q^2) (1 - exp(-q^2 / e^2)) n x R
      const Vector3 around = glm::cross(this->Axis, arm);
      const double q2 = glm::dot(around, around);
      const double part = this->IsPart ? this->PartShare(q2, glm::dot(this->Axis, arm)) : 1.0;
      return part != 0.0 ? (part * factor * this->InverseCore * CoreShare(q2 * this->InverseCore)) * around
                         : Vector3(0.0);
    }
  }
  return Vector3(0.0);
}

inline double FlowField::Local::Share(const Vector3& place, double squaredArm) const
{
  double share = 1.0;
  if (this->InverseMargin > 0.0)
  {
    // (1 - (d / margin)^2)^2 at a distance d from the box
    const Vector3 away = glm::max(glm::max(this->Whole.Low - place, place - this->Whole.High), 0.0);
    const double inside = std::max(0.0, 1.0 - glm::dot(away, away) * this->InverseMargin);
    share = inside * inside;
  }
  if (this->InverseInfluence > 0.0)
  {
    // (1 - (R / radius)^2)^2
    const double inside = std::max(0.0, 1.0 - squaredArm * this->InverseInfluence);
    share *= inside * inside;
  }
  return share;
}

inline Vector3 FlowField::Column::Flow(const Vector3& place) const
{
  const double x = place.x - this->X;
  const double y = place.y - this->Y;
  const double softened = x * x + y * y + this->CoreSquared;
  // Q / 2h per length of two axes but for [low, high]: Q / (8 pi h) times the integral of R / (R^2 + e^2)^(3/2)
  double across = 0.0;
  double up = 0.0;
  for (int sequence = 0; sequence < 2; ++sequence)
  {
    const double overLow = place.z - this->Lows[sequence];
    const double overHigh = place.z - this->Highs[sequence];
    const double nearLow = 1.0 / std::sqrt(softened + overLow * overLow);
    const double nearHigh = 1.0 / std::sqrt(softened + overHigh * overHigh);
    across += 2.0 - overLow * nearLow + overHigh * nearHigh;
    up += nearLow - nearHigh;
  }
  across *= this->Factor / softened;
  return { across * x, across * y, this->Factor * up };
}

Vector3 FlowField::Velocity(const Vector3& place) const
{
  Vector3 sum = this->Everywhere;
  for (const Local& local : this->Around)
  {
    const Vector3 arm = place - local.Center;
    sum += local.Flow(arm, glm::dot(arm, arm), local.Factor);
  }
  for (const Column& column : this->Columns)
  {
    sum += column.Flow(place);
  }
  if (this->Ending.empty())
  {
    return sum;
  }
  const BoxCells::List list = this->Cells.Near(place);
  if (this->Limited.Size() > 0)
  {
    this->Limited.AddFlow(list.begin(), list.end(), place, sum);
    return sum;
  }
  for (const int near : list)
  {
    const Local& local = this->Ending[near];
    const Vector3 arm = place - local.Center;
    const double squaredArm = glm::dot(arm, arm);
    const double share = local.Share(place, squaredArm);
    if (share > 0.0)
    {
      sum += local.Flow(arm, squaredArm, share * local.Factor);
    }
  }
  return sum;
}

bool FlowField::Capture(const Vector3& from, Vector3& to) const
{
  for (const Ball& sink : this->Sinks)
  {
    const Vector3 way = to - from;
    const double length = glm::dot(way, way);
    const double part = length > 0.0 ? std::clamp(glm::dot(sink.Center - from, way) / length, 0.0, 1.0) : 0.0;
    const Vector3 nearest = from + part * way;
    const Vector3 arm = nearest - sink.Center;
    if (glm::dot(arm, arm) <= sink.RadiusSquared)
    {
      to = nearest;
      return true;
    }
  }
  return false;
}

}
