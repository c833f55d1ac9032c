// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Particles/SuspendedParticles.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"
#include "Numerics/SmoothStep.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace littoral
{

namespace
{

/// Particles of a box that have numbers of their own.
constexpr int BoxBits = 40;
/// Standard deviation of the brightness of particles.
constexpr double TintSpread = 0.12;

std::uint64_t ObjectOf(int boxId, long long index)
{
  return (static_cast<std::uint64_t>(boxId) << BoxBits) + static_cast<std::uint64_t>(index);
}

/// Light and opacity at a place of a picture.
struct Shade
{
  double Light = 0.9;
  double Opacity = 0.0;
};

/// Smooth noise without random numbers: pictures are the same everywhere and always.
double Waviness(double x, double y)
{
  return 0.5 * std::sin(5.1 * x + 1.3 * std::sin(3.7 * y)) + 0.3 * std::sin(11.3 * y - 2.1 * x + 0.7) +
    0.2 * std::sin(19.7 * x + 17.1 * y + 2.0);
}

Shade DiatomAt(double x, double y)
{
  const double r = std::hypot(x, y);
  const double angle = std::atan2(y, x);
  const double rays = 0.5 + 0.5 * std::cos(36.0 * angle);
  const double rings = 0.5 + 0.5 * std::cos(30.0 * r);
  const double shell = SmoothStep(0.80, 0.86, r) * (1.0 - SmoothStep(0.90, 0.95, r));
  const double pores = rays * rings * SmoothStep(0.25, 0.4, r);
  const double heart = 1.0 - SmoothStep(0.12, 0.22, r);
  const double inside = 1.0 - SmoothStep(0.90, 0.95, r);
  return { std::min(1.0, 0.62 + 0.3 * shell + 0.3 * heart + 0.14 * pores),
    inside * std::min(1.0, 0.5 + 0.5 * shell + 0.3 * heart + 0.3 * pores) };
}

Shade FlakeAt(double x, double y)
{
  const double r = std::hypot(x, y);
  const double angle = std::atan2(y, x);
  const double edge =
    0.66 + 0.12 * std::sin(3.0 * angle + 0.6) + 0.09 * std::sin(7.0 * angle + 2.0) + 0.05 * std::sin(13.0 * angle);
  const double lumps = Waviness(1.4 * x, 1.4 * y);
  const double body = 1.0 - SmoothStep(0.45 * edge, 1.25 * edge, r + 0.16 * lumps);
  return { std::clamp(0.86 + 0.16 * lumps, 0.0, 1.0), std::clamp(0.95 * body, 0.0, 1.0) };
}

Shade GrainAt(double x, double y)
{
  // A stone with flat faces: the nearest of a few planes is seen.
  constexpr int Faces = 7;
  double distance = -1e9;
  double light = 0.0;
  for (int face = 0; face < Faces; ++face)
  {
    const double angle = TwoPi * (face + 0.35 * std::sin(2.7 * face)) / Faces;
    const double reach = 0.74 + 0.1 * std::sin(4.1 * face + 1.0);
    const double side = std::cos(angle) * x + std::sin(angle) * y - reach;
    if (side > distance)
    {
      distance = side;
      light = 0.72 + 0.26 * std::cos(angle - 2.2);
    }
  }
  const double table = 1.0 - SmoothStep(-0.34, -0.30, distance);
  const double grey = (1.0 - table) * light + table * (0.9 + 0.05 * Waviness(2.0 * x, 2.0 * y));
  return { std::clamp(grey, 0.0, 1.0), 1.0 - SmoothStep(-0.03, 0.03, distance) };
}

/// Opacity of a stroke along a curve y = c (x - x0)^2 + y0 between two x.
double Stroke(double x, double y, double from, double to, double y0, double bend, double width)
{
  const double u = std::clamp(x, from, to);
  const double line = y0 + bend * (u - from) * (u - from);
  return 1.0 - SmoothStep(0.6 * width, 1.6 * width, std::hypot(x - u, y - line));
}

Shade CopepodAt(double x, double y)
{
  const double along = (x + 0.05) / 0.52;
  const double half = std::abs(along) < 1.0 ? 0.29 * std::sqrt(1.0 - along * along) * (1.0 + 0.25 * along) : 0.0;
  const double body = 1.0 - SmoothStep(half - 0.03, half + 0.02, std::abs(y));
  const double rings = 0.5 + 0.5 * std::cos(34.0 * x);
  const double gut = 1.0 - SmoothStep(0.03, 0.09, std::abs(y) + 0.15 * std::abs(x));
  double thin = Stroke(x, y, -0.9, -0.5, 0.0, 0.0, 0.035);
  for (const double side : { -1.0, 1.0 })
  {
    thin = std::max(thin, Stroke(-x + 0.1, side * y, -0.32, 0.72, 0.16, 0.68, 0.016)); // antennae, swept back
    thin = std::max(thin, Stroke(x + 0.95, side * y, -0.02, 0.12, 0.14, -8.0, 0.018)); // tail
  }
  const double opacity = std::max((half > 0.0 ? body : 0.0) * (0.72 + 0.16 * rings), 0.85 * thin);
  return { std::clamp(0.95 - 0.3 * gut * body + 0.05 * rings, 0.0, 1.0), std::clamp(opacity, 0.0, 1.0) };
}

/// Row of a kind: its name and its picture over -1 to 1.
struct KindRow
{
  const char* Name;
  Shade (*At)(double x, double y);
};

/// Rows in the order of the enumeration.
constexpr KindRow Kinds[] = {
  { "Diatom", DiatomAt },
  { "Flake", FlakeAt },
  { "Grain", GrainAt },
  { "Copepod", CopepodAt },
};
static_assert(std::size(Kinds) == ParticleKinds, "a row a kind");

/// A kind of particles in a scene, between two heights as parts of the depth, 0 at the bed and 1 at the surface.
struct Layer
{
  const char* Name;
  double Bottom;
  double Top;
  ParticleKind Kind;
  double Diameter; ///< [m]
  double Amount;   ///< [1/m3]
  double Color[3];
};

struct SceneRow
{
  const char* Name;
  std::vector<Layer> Layers;
};

/// Rows in the order of the enumeration.
const std::vector<SceneRow>& Scenes()
{
  using K = ParticleKind;
  static const std::vector<SceneRow> rows = {
    // name, bottom, top, kind, diameter, amount, color
    { "CoastalSea",
      {
        { "Phytoplankton", 0.6, 1.0, K::Diatom, 0.006, 4.0, { 0.62, 0.74, 0.36 } },
        { "Zooplankton", 0.35, 0.9, K::Copepod, 0.012, 0.6, { 0.93, 0.72, 0.55 } },
        { "MarineSnow", 0.0, 1.0, K::Flake, 0.008, 2.0, { 0.90, 0.90, 0.84 } },
        { "Minerals", 0.0, 0.2, K::Grain, 0.004, 8.0, { 0.72, 0.60, 0.43 } },
      } },
    { "OpenOcean",
      {
        { "DeepPhytoplankton", 0.4, 0.7, K::Diatom, 0.004, 1.0, { 0.55, 0.70, 0.45 } },
        { "Zooplankton", 0.0, 0.6, K::Copepod, 0.010, 0.2, { 0.90, 0.75, 0.65 } },
        { "MarineSnow", 0.0, 1.0, K::Flake, 0.006, 1.5, { 0.88, 0.92, 0.95 } },
      } },
    { "PlanktonBloom",
      {
        { "Phytoplankton", 0.66, 1.0, K::Diatom, 0.006, 18.0, { 0.55, 0.76, 0.26 } },
        { "Zooplankton", 0.4, 1.0, K::Copepod, 0.012, 1.5, { 0.95, 0.70, 0.50 } },
        { "MarineSnow", 0.0, 0.8, K::Flake, 0.010, 3.0, { 0.82, 0.85, 0.66 } },
      } },
    { "StormyBed",
      {
        { "Sand", 0.0, 0.12, K::Grain, 0.003, 60.0, { 0.78, 0.66, 0.46 } },
        { "Silt", 0.0, 0.5, K::Grain, 0.002, 14.0, { 0.62, 0.52, 0.39 } },
        { "MarineSnow", 0.1, 1.0, K::Flake, 0.008, 2.0, { 0.80, 0.76, 0.66 } },
      } },
  };
  return rows;
}

/// The first scene is 1: 0 is the user's own boxes.
const SceneRow& RowOf(ParticleScene scene)
{
  return Scenes()[static_cast<std::size_t>(scene) - 1];
}

}

const char* ParticleKindName(ParticleKind kind)
{
  return Kinds[static_cast<int>(kind)].Name;
}

const char* ParticleSceneName(ParticleScene scene)
{
  return RowOf(scene).Name;
}

std::string WhyInvalid(const ParticleBox& box, int index)
{
  const bool upright =
    box.Lower.x < box.Upper.x && box.Lower.y < box.Upper.y && box.Lower.z < box.Upper.z; // false for NaN
  const std::string name = "box " + std::to_string(index);
  ParameterCheck check;
  check.Require(upright && IsSensible(box.Lower) && IsSensible(box.Upper),
    name + " has bounds that are not finite and increasing.");
  check.Choice(name + ": kind", static_cast<int>(box.Kind), ParticleKinds);
  check.Positive(name + ": diameter", box.Diameter, "m", 10.0);
  check.NotNegative(name + ": amount", box.Amount);
  check.Color(name + ": color", box.Color);
  return check.Reason();
}

double NumberIn(const ParticleBox& box, bool amountIsCount)
{
  const Vector3 size = box.Upper - box.Lower;
  return std::floor(amountIsCount ? box.Amount + 0.5 : box.Amount * size.x * size.y * size.z + 0.5);
}

std::vector<ParticleBox> BoxesOf(ParticleScene scene, const Vector3& lower, const Vector3& upper)
{
  std::vector<ParticleBox> boxes;
  const double depth = upper.z - lower.z;
  for (const Layer& layer : RowOf(scene).Layers)
  {
    const Vector3 from(lower.x, lower.y, lower.z + layer.Bottom * depth);
    const Vector3 to(upper.x, upper.y, lower.z + layer.Top * depth);
    boxes.push_back({ layer.Name, from, to, layer.Kind, layer.Diameter, layer.Amount,
      { layer.Color[0], layer.Color[1], layer.Color[2] } });
  }
  return boxes;
}

SuspendedParticle ParticleOf(const ParticleBox& box, int boxId, long long index, double sizeSpread, int seed)
{
  const std::uint64_t object = ObjectOf(boxId, index);
  const RandomStream places(seed, RandomPurpose::ParticlePositions);
  const auto [x, y] = places.UniformPair(object, 0);
  const auto [z, unused] = places.UniformPair(object, 1);
  const auto [size, tint] = RandomStream(seed, RandomPurpose::ParticleSizes).NormalPair(object, 0);
  SuspendedParticle particle;
  particle.Place = box.Lower + Vector3(x, y, z) * (box.Upper - box.Lower);
  // Lognormal: sizeSpread is the standard deviation of ln R
  particle.Radius = 0.5 * box.Diameter * std::exp(sizeSpread * std::clamp(size, -3.0, 3.0));
  const double light = 1.0 + TintSpread * std::clamp(tint, -2.5, 2.5);
  for (int channel = 0; channel < 3; ++channel)
  {
    const double value = std::clamp(255.0 * light * box.Color[channel], 0.0, 255.0);
    particle.Color[channel] = static_cast<unsigned char>(std::lround(value));
  }
  return particle;
}

PictureAxes OrientationOf(int boxId, long long index, int seed)
{
  // A uniform point of the sphere of quaternions (Shoemake).
  const std::uint64_t object = ObjectOf(boxId, index);
  const RandomStream turns(seed, RandomPurpose::ParticleOrientations);
  const auto [share, first] = turns.UniformPair(object, 0);
  const auto [second, unused] = turns.UniformPair(object, 1);
  const double small = std::sqrt(1.0 - share);
  const double large = std::sqrt(share);
  const double x = small * std::sin(TwoPi * first);
  const double y = small * std::cos(TwoPi * first);
  const double z = large * std::sin(TwoPi * second);
  const double w = large * std::cos(TwoPi * second);
  return { { 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y) },
    { 2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x) } };
}

TextureImage ParticlePicture(ParticleKind kind)
{
  constexpr int Samples = 3; // along an edge of a texel
  TextureImage picture(ParticlePictureSize, ParticlePictureSize);
  for (int row = 0; row < ParticlePictureSize; ++row)
  {
    for (int column = 0; column < ParticlePictureSize; ++column)
    {
      double light = 0.0;
      double opacity = 0.0;
      double plain = 0.0;
      for (int sample = 0; sample < Samples * Samples; ++sample)
      {
        const int across = sample % Samples;
        const int down = sample / Samples;
        const double x = 2.0 * (column + (across + 0.5) / Samples) / ParticlePictureSize - 1.0;
        const double y = 2.0 * (row + (down + 0.5) / Samples) / ParticlePictureSize - 1.0;
        const Shade shade = Kinds[static_cast<int>(kind)].At(x, y);
        const double seen = shade.Opacity * (1.0 - SmoothStep(0.9, 0.98, std::max(std::abs(x), std::abs(y))));
        light += shade.Light * seen;
        opacity += seen;
        plain += shade.Light;
      }
      constexpr double All = Samples * Samples;
      const double lit = opacity > 0.0 ? light / opacity : plain / All;
      const auto grey = static_cast<unsigned char>(std::lround(255.0 * std::clamp(lit, 0.0, 1.0)));
      const auto alpha = static_cast<unsigned char>(std::lround(255.0 * std::clamp(opacity / All, 0.0, 1.0)));
      picture.At(column, row) = { grey, grey, grey, alpha };
    }
  }
  return picture;
}

}
