// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PlantScatter.h"

#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Numerics/RandomStream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <sstream>
#include <type_traits>

namespace littoral
{

namespace
{

/// Normal deviates are cut here, so that no plant is a dwarf or a giant.
constexpr double MaximumDeviate = 2.0;
/// Keeps the smallest plant above a tenth of its prototype.
constexpr double MaximumVariation = 0.45;
/// The shift of a color from blue to red, as part of that of its brightness.
constexpr double WarmthPart = 0.6;

std::array<double, 2> CutNormalPair(int seed, RandomPurpose purpose, long long site)
{
  std::array<double, 2> pair = RandomStream(seed, purpose).NormalPair(static_cast<std::uint64_t>(site), 0);
  for (double& deviate : pair)
  {
    deviate = std::clamp(deviate, -MaximumDeviate, MaximumDeviate);
  }
  return pair;
}

double Uniform(int seed, RandomPurpose purpose, long long site)
{
  return RandomStream(seed, purpose).UniformPair(static_cast<std::uint64_t>(site), 0)[0];
}

/// A place of a plant that is wider by a factor.
Vector3 Wide(const Vector3& place, double girth)
{
  return { girth * place.x, girth * place.y, place.z };
}

/// Normal of a widened surface: n = (n_x / g, n_y / g, n_z), of the length it had.
Vector3 WideNormal(const Vector3& normal, double girth)
{
  if (girth == 1.0)
  {
    return normal;
  }
  const Vector3 across(normal.x, normal.y, girth * normal.z);
  const double length = glm::length(across);
  return length > 0.0 ? across * (glm::length(normal) / length) : normal;
}

/// Places by their indices.
class PlaceSet
{
public:
  explicit PlaceSet(std::size_t places)
    : Words((places + Bits - 1) / Bits, 0)
  {
  }

  void Add(std::size_t place) { this->Words[place / Bits] |= std::uint64_t{ 1 } << (place % Bits); }

  /// Calls a task with each place that was added, in increasing order.
  template <typename Task>
  void ForEach(const Task& task) const
  {
    for (std::size_t word = 0; word < this->Words.size(); ++word)
    {
      std::size_t place = word * Bits;
      for (std::uint64_t rest = this->Words[word]; rest != 0; rest >>= 1, ++place)
      {
        if ((rest & 1) != 0)
        {
          task(place);
        }
      }
    }
  }

private:
  static constexpr std::size_t Bits = 64;
  std::vector<std::uint64_t> Words;
};

/// Whether a foot below a box of crowns may be as near as a limit of sight, where there is one: its distance is at
/// least that over the ground, a little less for rounding.
bool MayBeNear(const Box& box, const View& view, double limit)
{
  constexpr double rounding = 1e-6;
  if (!(limit > 0.0) || view.IsParallel)
  {
    return true;
  }
  const double across = std::max({ 0.0, box.Low.x - view.Point.x, view.Point.x - box.High.x });
  const double along = std::max({ 0.0, box.Low.y - view.Point.y, view.Point.y - box.High.y });
  return std::hypot(across, along) * (1.0 - rounding) <= limit;
}

PlantLevel LevelAt(double distance, const PlantViewOptions& options)
{
  if (!options.UseLevels || distance <= options.NearDistance)
  {
    return PlantLevel::High;
  }
  return distance <= options.FarDistance ? PlantLevel::Medium : PlantLevel::Low;
}

}

std::string WhyInvalid(const ScatterOptions& options)
{
  ParameterCheck check;
  for (std::size_t species = 0; species < options.Weights.size(); ++species)
  {
    check.NotNegative("Weight " + std::to_string(species), options.Weights[species]);
  }
  check.Require(std::accumulate(options.Weights.begin(), options.Weights.end(), 0.0) > 0.0,
    "The Weights of all prototypes are 0; at least one must be positive.");
  check.Range("ScaleVariation", options.ScaleVariation, 0.0, MaximumVariation);
  check.Range("TintVariation", options.TintVariation, 0.0, MaximumVariation);
  return check.Reason();
}

PlantDraws::PlantDraws(const ScatterOptions& options)
  : Options(options)
  , Shares(options.Weights.size())
{
  // Divided by the largest first, so that no sum is infinite.
  const double largest = *std::max_element(options.Weights.begin(), options.Weights.end());
  double sum = 0.0;
  for (std::size_t species = 0; species < this->Shares.size(); ++species)
  {
    sum += options.Weights[species] / largest;
    this->Shares[species] = sum;
  }
  for (double& share : this->Shares)
  {
    share /= sum;
  }
}

int PlantDraws::Species(long long site) const
{
  const double drawn = Uniform(this->Options.Seed, RandomPurpose::PlantSpecies, site);
  return static_cast<int>(std::upper_bound(this->Shares.begin(), this->Shares.end(), drawn) - this->Shares.begin());
}

double PlantDraws::Scale(long long site) const
{
  return 1.0 + this->Options.ScaleVariation * CutNormalPair(this->Options.Seed, RandomPurpose::PlantScale, site)[0];
}

double PlantDraws::Azimuth(long long site) const
{
  return 2.0 * Pi * Uniform(this->Options.Seed, RandomPurpose::PlantAzimuth, site);
}

std::array<float, 3> PlantDraws::Tint(long long site) const
{
  const auto [light, warmth] = CutNormalPair(this->Options.Seed, RandomPurpose::PlantTint, site);
  const double brightness = 1.0 + this->Options.TintVariation * light;
  const double shift = WarmthPart * this->Options.TintVariation * warmth;
  return { static_cast<float>(brightness * (1.0 + shift)), static_cast<float>(brightness),
    static_cast<float>(brightness * (1.0 - shift)) };
}

GroundPoint GroundGaps::Add(const Vector3& foot)
{
  const GroundPoint ground = this->Terrain.At(foot.x, foot.y);
  ++this->Sites;
  if (!ground.IsCovered || !std::isfinite(ground.Height))
  {
    this->First = this->Outside + this->Holes == 0 ? foot : this->First;
    ++(ground.IsCovered ? this->Holes : this->Outside);
  }
  return ground;
}

std::string GroundGaps::Reason() const
{
  if (!this->AreThere())
  {
    return "";
  }
  std::ostringstream text;
  text << "of " << this->Sites << " sites, " << this->Outside << " lie outside of the Terrain and " << this->Holes
       << " where it has no height; the first at (" << this->First.x << ", " << this->First.y << ", " << this->First.z
       << ").";
  return text.str();
}

void GroundGaps::Complete(const WorkShare& share)
{
  const auto rows = share.Gather({ static_cast<double>(this->Sites), static_cast<double>(this->Outside),
    static_cast<double>(this->Holes), this->First.x, this->First.y, this->First.z });
  this->Sites = this->Outside = this->Holes = 0;
  for (const std::vector<double>& row : rows)
  {
    this->First = !this->AreThere() ? Vector3(row[3], row[4], row[5]) : this->First;
    this->Sites += static_cast<std::size_t>(row[0]);
    this->Outside += static_cast<std::size_t>(row[1]);
    this->Holes += static_cast<std::size_t>(row[2]);
  }
}

std::string PutOnGround(
  const HeightGrid& terrain, const GroundLimits& limits, std::vector<PlantPlace>& places, const WorkShare& share)
{
  std::size_t kept = 0;
  GroundGaps gaps(terrain);
  for (const PlantPlace& place : places)
  {
    const GroundPoint ground = gaps.Add(place.Foot);
    if (std::isfinite(ground.Height) && ground.IsCovered &&
      (limits.Slope >= 0.5 * Pi || ground.Slope <= limits.Slope) && ground.Height >= limits.LowestHeight &&
      ground.Height <= limits.HighestHeight)
    {
      places[kept] = place;
      places[kept++].Foot.z = ground.Height;
    }
  }
  gaps.Complete(share);
  places.resize(gaps.AreThere() ? places.size() : kept);
  return gaps.Reason();
}

void DealPlaces(
  const CellGrid& grid, const std::vector<int>& firstCells, const WorkShare& share, std::vector<PlantPlace>& places)
{
  static_assert(std::is_trivially_copyable_v<PlantPlace> && sizeof(PlantPlace) % sizeof(float) == 0);
  constexpr std::size_t length = sizeof(PlantPlace) / sizeof(float);
  if (share.Ranks < 2)
  {
    return;
  }
  SingleRows sent(share.Ranks);
  std::size_t kept = 0;
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    const PlantPlace& place = places[n];
    const auto behind = std::upper_bound(firstCells.begin(), firstCells.end(), grid.CellAt(place.Foot));
    const auto part = static_cast<std::size_t>(behind - firstCells.begin()) - 1;
    if (part == share.Rank)
    {
      if (kept < n)
      {
        places[kept] = place;
      }
      ++kept;
      continue;
    }
    sent[part].resize(sent[part].size() + length);
    std::memcpy(sent[part].data() + sent[part].size() - length, &place, sizeof(PlantPlace));
  }
  places.resize(kept);
  SingleRows received;
  share.Deal(sent, received);
  std::vector<PlantPlace> before;
  for (std::size_t from = 0; from < share.Ranks; ++from)
  {
    std::vector<PlantPlace>& to = from < share.Rank ? before : places;
    const std::size_t first = to.size();
    to.resize(first + received[from].size() / length);
    std::memcpy(static_cast<void*>(to.data() + first), received[from].data(), (to.size() - first) * sizeof(PlantPlace));
  }
  places.insert(places.begin(), before.begin(), before.end());
}

void DropOutside(const GroundLimits& limits, std::vector<PlantPlace>& places)
{
  places.erase(std::remove_if(places.begin(), places.end(),
                 [&](const PlantPlace& place) {
                   return place.Foot.z < limits.LowestHeight || place.Foot.z > limits.HighestHeight;
                 }),
    places.end());
}

Box BoxOf(const PlantPlace& place, const PlantExtent& extent)
{
  const double radius = place.Scale * place.WidthScale * extent.Radius;
  return { place.Foot + Vector3(-radius, -radius, place.Scale * extent.Low),
    place.Foot + Vector3(radius, radius, place.Scale * extent.High) };
}

ImpostorCard FacingCard(const ImpostorShape& shape, const PlantPlace& place, const View& view)
{
  const double c = std::cos(place.Azimuth);
  const double s = std::sin(place.Azimuth);
  const Vector3 middle(0.0, 0.0, 0.5 * (shape.Extent.Low + shape.Extent.High));
  const Vector3 towards =
    view.IsParallel ? -Normalised(view.Direction) : Normalised(view.Point - place.Foot - place.Scale * middle);
  const auto turned = [&](const Vector3& v) { return Vector3(c * v.x - s * v.y, s * v.x + c * v.y, v.z); };
  const double girth = place.WidthScale;
  const Vector3 own(c * towards.x + s * towards.y, c * towards.y - s * towards.x, girth * towards.z);
  ImpostorCard card = CardTowards(shape, girth == 1.0 ? own : Normalised(own));
  for (int corner = 0; corner < 4; ++corner)
  {
    card.Corners[corner] = place.Foot + place.Scale * turned(Wide(card.Corners[corner], girth));
    card.Normals[corner] = turned(WideNormal(card.Normals[corner], girth));
  }
  return card;
}

std::vector<ShownPlant> ShownPlants(const std::vector<PlantPlace>& places, const SceneCells& cells,
  const std::vector<char>& cellsShown, const View& view, const PlantViewOptions& options)
{
  std::vector<ShownPlant> shown;
  const auto add = [&](std::size_t index) {
    const PlantPlace& place = places[index];
    if (!(options.VisibleDistance > 0.0 && SightDistance(view, place.Foot) > options.VisibleDistance))
    {
      shown.push_back({ static_cast<int>(index), LevelAt(LevelDistance(view, place.Foot), options) });
    }
  };
  if (!options.UseCulling)
  {
    shown.reserve(options.VisibleDistance > 0.0 ? 0 : places.size());
    for (std::size_t index = 0; index < places.size(); ++index)
    {
      add(index);
    }
    return shown;
  }
  // Cells put their plants into a set of bits, which has them in the order of the places.
  PlaceSet seen(places.size());
  std::size_t count = 0;
  const auto isNear = [&](const Box& box) { return MayBeNear(box, view, options.VisibleDistance); };
  cells.ForObjects(cellsShown, isNear, [&](const int* first, const int* end) {
    std::for_each(first, end, [&](int place) { seen.Add(static_cast<std::size_t>(place)); });
    count += static_cast<std::size_t>(end - first);
  });
  shown.reserve(count);
  seen.ForEach(add);
  return shown;
}

Skeleton Placed(const Skeleton& prototype, const PlantPlace& place)
{
  const double c = std::cos(place.Azimuth);
  const double s = std::sin(place.Azimuth);
  Skeleton placed = prototype;
  for (SkeletonNode& node : placed.Nodes)
  {
    const Vector3 p = Wide(node.Position, place.WidthScale);
    node.Position = place.Foot + place.Scale * Vector3(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
    node.Radius *= place.Scale * place.WidthScale;
  }
  return placed;
}

PlantPlacement::PlantPlacement(const PlantPlace& place)
  : Place(place)
  , Cosine(std::cos(place.Azimuth))
  , Sine(std::sin(place.Azimuth))
{
}

void PlantPlacement::Points(const float* from, std::size_t count, float* to) const
{
  const double c = this->Place.Scale * this->Place.WidthScale * this->Cosine;
  const double s = this->Place.Scale * this->Place.WidthScale * this->Sine;
  for (std::size_t i = 0; i < 3 * count; i += 3)
  {
    to[i] = static_cast<float>(this->Place.Foot.x + c * from[i] - s * from[i + 1]);
    to[i + 1] = static_cast<float>(this->Place.Foot.y + s * from[i] + c * from[i + 1]);
    to[i + 2] = static_cast<float>(this->Place.Foot.z + this->Place.Scale * from[i + 2]);
  }
}

void PlantPlacement::Directions(const float* from, std::size_t count, float* to) const
{
  const float c = static_cast<float>(this->Cosine);
  const float s = static_cast<float>(this->Sine);
  for (std::size_t i = 0; i < 3 * count; i += 3)
  {
    const float x = from[i];
    const float y = from[i + 1];
    to[i] = c * x - s * y;
    to[i + 1] = s * x + c * y;
    to[i + 2] = from[i + 2];
    if (this->Place.WidthScale != 1.0)
    {
      const Vector3 normal = WideNormal({ to[i], to[i + 1], to[i + 2] }, this->Place.WidthScale);
      to[i] = static_cast<float>(normal.x);
      to[i + 1] = static_cast<float>(normal.y);
      to[i + 2] = static_cast<float>(normal.z);
    }
  }
}

void PlantPlacement::Lengths(const float* from, std::size_t count, float* to) const
{
  const double scale = this->Place.Scale * this->Place.WidthScale;
  std::transform(from, from + count, to, [scale](float length) { return static_cast<float>(scale * length); });
}

void PlantPlacement::Colors(const unsigned char* from, std::size_t count, unsigned char* to) const
{
  const auto& tint = this->Place.Tint;
  for (std::size_t i = 0; i < 3 * count; i += 3)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      to[i + channel] = static_cast<unsigned char>(std::min(255.0f, tint[channel] * from[i + channel] + 0.5f));
    }
  }
}

}
