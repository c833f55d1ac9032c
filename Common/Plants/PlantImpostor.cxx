// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PlantImpostor.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace littoral
{

namespace
{

constexpr int Margin = 2;           ///< transparent texels around a picture, so that neighbours do not mix
constexpr float Smoothing = 0.4f;   ///< share of its neighbourhood in the coverage of a texel
constexpr int Spread = 4;           ///< texels by which colors reach into what is transparent
constexpr double LargestMean = 0.5; ///< of the texels, smaller where some are more than twice as bright as the mean
constexpr double Lift = 0.5;        ///< of cards' normals, as of those of leaves

double ElevationOf(int view)
{
  const int ring = view / ImpostorAzimuths;
  return 0.5 * Pi * ring / ImpostorElevations;
}

double AzimuthOf(int view)
{
  return TwoPi * (view % ImpostorAzimuths) / ImpostorAzimuths;
}

/// The frame of a view whose rectangle, without its margin, is the cylinder's outline.
PictureFrame FrameOf(const PlantExtent& extent, double azimuth, double elevation)
{
  const double margin = ImpostorSize / (ImpostorSize - 2.0 * Margin);
  PictureFrame frame = FrameTowards({ 0.0, 0.0, 0.5 * (extent.Low + extent.High) }, azimuth, elevation);
  frame.HalfWidth = margin * extent.Radius;
  // h(e) = H / 2 cos e + R |sin e|
  frame.HalfHeight =
    margin * (0.5 * (extent.High - extent.Low) * std::cos(elevation) + extent.Radius * std::abs(std::sin(elevation)));
  return frame;
}

/// The view whose direction is nearest to a unit vector.
int NearestView(const Vector3& towards)
{
  int nearest = 0;
  double largest = -2.0;
  for (int view = 0; view < ImpostorViews; ++view)
  {
    const double cosine = glm::dot(towards, FrameTowards({}, AzimuthOf(view), ElevationOf(view)).Towards);
    if (cosine > largest)
    {
      largest = cosine;
      nearest = view;
    }
  }
  return nearest;
}

/// Coverage of a picture with that of its neighbours, so that its steps are small: a share of (1 2 1) / 4 in both
/// directions.
std::vector<float> Smoothed(const std::vector<SeenTexel>& picture)
{
  constexpr int n = ImpostorSize;
  std::vector<float> covered(picture.size());
  std::transform(
    picture.begin(), picture.end(), covered.begin(), [](const SeenTexel& texel) { return texel.Coverage; });
  std::vector<float> smooth(picture.size(), 0.0f);
  for (int row = 1; row + 1 < n; ++row)
  {
    std::array<float, n> sums{};
    for (int other = 0; other < 9; ++other)
    {
      const int i = other / 3 - 1;
      const int j = other % 3 - 1;
      const float weight = (i == 0 ? 2.0f : 1.0f) * (j == 0 ? 2.0f : 1.0f) / 16.0f;
      const float* beside = &covered[static_cast<std::size_t>(row + i) * n];
      for (int column = 1; column + 1 < n; ++column)
      {
        sums[column] += weight * beside[column + j];
      }
    }
    for (int column = 1; column + 1 < n; ++column)
    {
      const std::size_t at = static_cast<std::size_t>(row) * n + column;
      smooth[at] = (1.0f - Smoothing) * covered[at] + Smoothing * sums[column];
    }
  }
  return smooth;
}

/// Marks of an array, and those of what lies a step before and after.
std::vector<char> Widened(const std::vector<char>& marks, std::size_t step)
{
  std::vector<char> wide = marks;
  const auto join = [](char a, char b) { return static_cast<char>(a | b); };
  const auto later = static_cast<std::ptrdiff_t>(step);
  std::transform(marks.begin() + later, marks.end(), wide.begin(), wide.begin(), join);
  std::transform(marks.begin(), marks.end() - later, wide.begin() + later, wide.begin() + later, join);
  return wide;
}

/// Marks of a picture's texels where one of the nine around, itself among them, is marked; over the edges too, where it
/// marks a few more.
std::vector<char> Around(const std::vector<char>& marks)
{
  return Widened(Widened(marks, 1), ImpostorSize);
}

/// The smooth coverage from which on as many texels lie as the picture covers.
float ThresholdOf(const std::vector<SeenTexel>& picture, std::vector<float> smooth)
{
  double covered = 0.0;
  for (const SeenTexel& texel : picture)
  {
    covered += texel.Coverage;
  }
  const auto count = std::min(smooth.size() - 1, static_cast<std::size_t>(std::lround(covered)));
  const auto next = smooth.begin() + static_cast<std::ptrdiff_t>(count);
  std::nth_element(smooth.begin(), next, smooth.end(), std::greater<>());
  const float above = count > 0 ? *std::min_element(smooth.begin(), next) : *next;
  return std::max(1e-3f, 0.5f * (above + *next));
}

/// Bytes in numbers that doubles hold, six each.
class PackedBytes
{
public:
  explicit PackedBytes(std::vector<double>& numbers)
    : Numbers(numbers)
  {
  }

  void Add(unsigned char byte)
  {
    if (this->Count++ % BytesOfNumber == 0)
    {
      this->Numbers.push_back(0.0);
      this->Place = 1.0;
    }
    this->Numbers.back() += this->Place * byte;
    this->Place *= 256.0;
  }

  unsigned char Next()
  {
    const auto number = static_cast<std::uint64_t>(this->Numbers[this->Count / BytesOfNumber]);
    return static_cast<unsigned char>(number >> (8 * (this->Count++ % BytesOfNumber)));
  }

private:
  static constexpr std::size_t BytesOfNumber = 6;
  std::vector<double>& Numbers;
  std::size_t Count = 0;
  double Place = 1.0;
};

/// Draws all views into an atlas.
class ImpostorMaker
{
public:
  ImpostorMaker(const std::vector<DrawnMesh>& meshes, const PlantExtent& extent, const ParallelFor& parallel,
    const WorkShare& share)
    : Pictures(ImpostorViews)
  {
    this->Result.Shape.Extent = extent;
    NumberRows sums(ImpostorViews); // coverage, colors, and the largest of these
    parallel(share.OwnOf(ImpostorViews), [&](std::size_t begin, std::size_t end) {
      for (std::size_t own = begin; own < end; ++own)
      {
        const std::size_t view = share.RowOf(own);
        this->Pictures[view] = PictureOf(meshes, this->FrameOfView(view), ImpostorSize, ImpostorSize);
        sums[view] = SumsOf(this->Pictures[view]);
      }
    });
    share.Complete(sums);
    double coverage = 0.0;
    for (std::size_t view = 0; view < ImpostorViews; ++view)
    {
      const PictureFrame frame = this->FrameOfView(view);
      coverage += sums[view][0];
      this->Result.Shape.Areas[view] =
        sums[view][0] * 4.0 * frame.HalfWidth * frame.HalfHeight / (ImpostorSize * ImpostorSize);
    }
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      double sum = 0.0;
      double brightest = 1.0f / 255.0f;
      for (const std::vector<double>& ofView : sums)
      {
        sum += ofView[1 + channel];
        brightest = std::max(brightest, ofView[4 + channel]);
      }
      const double mean = coverage > 0.0 ? sum / coverage : 0.0;
      this->Result.Mean[channel] = static_cast<unsigned char>(std::clamp(std::lround(255.0 * mean), 1L, 255L));
      this->Result.TextureMean[channel] =
        static_cast<float>(std::min(LargestMean, this->Result.Mean[channel] / (255.0 * brightest)));
    }
  }

  PlantImpostor Run(const ParallelFor& parallel, const WorkShare& share)
  {
    const int side = ImpostorSide * ImpostorSize;
    this->Result.Pictures = TextureImage(side, side);
    this->Result.Normals.resize(this->Result.Pictures.Texels.size());
    parallel(share.OwnOf(ImpostorViews), [&](std::size_t begin, std::size_t end) {
      for (std::size_t own = begin; own < end; ++own)
      {
        this->Write(static_cast<int>(share.RowOf(own)));
      }
    });
    if (share.Ranks > 1)
    {
      this->Exchange(share);
    }
    return std::move(this->Result);
  }

private:
  std::vector<std::vector<SeenTexel>> Pictures; ///< the own ones
  PlantImpostor Result;

  static std::vector<double> SumsOf(const std::vector<SeenTexel>& picture)
  {
    PictureSum sum;
    sum.Add(picture);
    std::vector<double> sums{ sum.Coverage, sum.Color[0], sum.Color[1], sum.Color[2], 0.0, 0.0, 0.0 };
    for (const SeenTexel& texel : picture)
    {
      for (std::size_t channel = 0; channel < 3; ++channel)
      {
        sums[4 + channel] = std::max(sums[4 + channel], static_cast<double>(texel.Color[channel]));
      }
    }
    return sums;
  }

  /// Calls a task with the texels of a view and their normals.
  template <typename Task>
  void ForTexels(std::size_t view, const Task& task)
  {
    const std::size_t columns = ImpostorSide * ImpostorSize;
    const std::size_t first = view / ImpostorSide * ImpostorSize * columns + view % ImpostorSide * ImpostorSize;
    for (std::size_t row = 0; row < ImpostorSize; ++row)
    {
      for (std::size_t at = first + row * columns; at < first + row * columns + ImpostorSize; ++at)
      {
        task(this->Result.Pictures.Texels[at], this->Result.Normals[at]);
      }
    }
  }

  /// Gets the views of the other processes.
  void Exchange(const WorkShare& share)
  {
    NumberRows rows(ImpostorViews);
    for (std::size_t own = 0; own < share.OwnOf(ImpostorViews); ++own)
    {
      PackedBytes bytes(rows[share.RowOf(own)]);
      this->ForTexels(share.RowOf(own), [&bytes](const Texel& texel, const Color& normal) {
        std::for_each(texel.begin(), texel.end(), [&bytes](unsigned char part) { bytes.Add(part); });
        std::for_each(normal.begin(), normal.end(), [&bytes](unsigned char part) { bytes.Add(part); });
      });
    }
    share.Complete(rows);
    for (std::size_t view = 0; view < ImpostorViews; ++view)
    {
      PackedBytes bytes(rows[view]);
      this->ForTexels(view, [&bytes](Texel& texel, Color& normal) {
        std::generate(texel.begin(), texel.end(), [&bytes] { return bytes.Next(); });
        std::generate(normal.begin(), normal.end(), [&bytes] { return bytes.Next(); });
      });
    }
  }

  PictureFrame FrameOfView(std::size_t view) const
  {
    return FrameOf(this->Result.Shape.Extent, AzimuthOf(static_cast<int>(view)), ElevationOf(static_cast<int>(view)));
  }

  /// Colors and normals of what is covered reach into what is not, so that interpolation finds no rim. Texels that no
  /// round reaches have the mean color and face the eye.
  static void SpreadOut(std::vector<SeenTexel>& picture, std::vector<char>& known)
  {
    constexpr int n = ImpostorSize;
    for (int round = 0; round < Spread; ++round)
    {
      const std::vector<char> before = known;
      const std::vector<char> reached = Around(before);
      for (int at = 0; at < n * n; ++at)
      {
        if (before[at] || !reached[at])
        {
          continue;
        }
        SeenTexel sum;
        int count = 0;
        for (int other = 0; other < 9; ++other)
        {
          const int row = at / n + other / 3 - 1;
          const int column = at % n + other % 3 - 1;
          if (row >= 0 && row < n && column >= 0 && column < n && before[row * n + column])
          {
            const SeenTexel& from = picture[row * n + column];
            ++count;
            sum.Normal += from.Normal;
            std::transform(from.Color.begin(), from.Color.end(), sum.Color.begin(), sum.Color.begin(), std::plus<>());
          }
        }
        if (count > 0)
        {
          known[at] = 1;
          picture[at].Normal = sum.Normal;
          std::transform(sum.Color.begin(), sum.Color.end(), picture[at].Color.begin(),
            [count](float part) { return part / static_cast<float>(count); });
        }
      }
    }
  }

  /// Brightness of a picture over that of its texels that pass the alpha test: thin twigs are lost.
  static ColorSum GainsOf(const std::vector<SeenTexel>& picture, const std::vector<float>& smooth, float threshold)
  {
    PictureSum all;
    all.Add(picture);
    PictureSum seen;
    for (std::size_t at = 0; at < picture.size(); ++at)
    {
      if (smooth[at] >= threshold && picture[at].Coverage > 0.0f)
      {
        seen.Coverage += 1.0;
        std::transform(
          seen.Color.begin(), seen.Color.end(), picture[at].Color.begin(), seen.Color.begin(), std::plus<>());
      }
    }
    ColorSum gains{ 1.0f, 1.0f, 1.0f };
    for (int channel = 0; channel < 3 && seen.Color[channel] > 0.0; ++channel)
    {
      gains[channel] = static_cast<float>(all.Color[channel] / all.Coverage * seen.Coverage / seen.Color[channel]);
    }
    return gains;
  }

  /// A part of a texel that is brighter than the mean by a factor.
  unsigned char TexelPart(int channel, double relative) const
  {
    const double value = 255.0 * this->Result.TextureMean[channel] * relative;
    return static_cast<unsigned char>(std::lround(std::min(255.0, value)));
  }

  void Write(int view)
  {
    std::vector<SeenTexel>& picture = this->Pictures[view];
    const std::vector<float> smooth = Smoothed(picture);
    const float threshold = ThresholdOf(picture, smooth);
    const ColorSum gains = GainsOf(picture, smooth, threshold);
    std::vector<char> known(picture.size());
    std::transform(picture.begin(), picture.end(), known.begin(), [](const SeenTexel& t) { return t.Coverage > 0.0f; });
    SpreadOut(picture, known);
    const Texel unseen{ this->TexelPart(0, 1.0), this->TexelPart(1, 1.0), this->TexelPart(2, 1.0), 0 };
    const int corner[2] = { view % ImpostorSide * ImpostorSize, view / ImpostorSide * ImpostorSize };
    for (int at = 0; at < ImpostorSize * ImpostorSize; ++at)
    {
      const SeenTexel& seen = picture[at];
      const int column = corner[0] + at % ImpostorSize;
      const int row = corner[1] + at / ImpostorSize;
      Texel& texel = this->Result.Pictures.At(column, row);
      Color& normal = this->Result.Normals[static_cast<std::size_t>(row) * this->Result.Pictures.Columns + column];
      texel = unseen;
      normal = { 128, 128, 255 }; // towards the eye
      const Vector3 facing = known[at] ? Normalised(seen.Normal) : Vector3(0.0);
      for (int channel = 0; channel < 3 && known[at]; ++channel)
      {
        texel[channel] =
          this->TexelPart(channel, 255.0 * gains[channel] * seen.Color[channel] / this->Result.Mean[channel]);
        normal[channel] = static_cast<unsigned char>(std::lround(127.5 * (1.0 + facing[channel])));
      }
      // The threshold becomes a half.
      if (smooth[at] > 0.0f)
      {
        texel[3] = static_cast<unsigned char>(std::lround(std::min(255.0f, 127.5f * smooth[at] / threshold)));
      }
    }
  }
};

/// The covered area at the elevation of a ring of views, between two azimuths [m2].
double AreaAround(const ImpostorShape& shape, int ring, double azimuth)
{
  if (ring >= ImpostorElevations)
  {
    return shape.Areas[ImpostorViews - 1];
  }
  const double step = azimuth * ImpostorAzimuths / TwoPi;
  const double low = std::floor(step);
  const auto area = [&](int number) {
    return shape.Areas[ring * ImpostorAzimuths + (number % ImpostorAzimuths + ImpostorAzimuths) % ImpostorAzimuths];
  };
  return area(static_cast<int>(low)) + (step - low) * (area(static_cast<int>(low) + 1) - area(static_cast<int>(low)));
}

/// The covered area at an azimuth, between two elevations [m2].
double AreaAlong(const ImpostorShape& shape, double azimuth, double elevation)
{
  const double step = 0.5 * Pi / ImpostorElevations;
  const int low = std::min(static_cast<int>(elevation / step), ImpostorElevations - 1);
  const auto square = [](double x) { return x * x; };
  const double s[2] = { square(std::sin(low * step)), square(std::sin((low + 1) * step)) };
  const double a[2] = { square(AreaAround(shape, low, azimuth)), square(AreaAround(shape, low + 1, azimuth)) };
  // Of an ellipsoid A^2 = a cos^2 e + b sin^2 e, linear in sin^2 e.
  return std::sqrt(a[0] + (a[1] - a[0]) * (square(std::sin(elevation)) - s[0]) / (s[1] - s[0]));
}

/// Ratio of an area to that of a picture, within limits.
double Ratio(double area, double ofPicture)
{
  return ofPicture > 0.0 ? std::clamp(area / ofPicture, 0.5, 2.0) : 1.0;
}

ImpostorCard CardIn(const PictureFrame& frame, int view)
{
  ImpostorCard card;
  card.View = view;
  const double sides[4][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } };
  for (int corner = 0; corner < 4; ++corner)
  {
    const Vector3 across = sides[corner][0] * frame.Right;
    const Vector3 up = sides[corner][1] * frame.Up;
    card.Corners[corner] = frame.Center + frame.HalfWidth * across + frame.HalfHeight * up;
    card.Normals[corner] = Normalised(frame.Towards + 0.5 * (across + up) + Vector3(0.0, 0.0, Lift));
  }
  return card;
}

void AddCard(const ImpostorCard& card, const Color& color, PlantMesh& mesh)
{
  const int first = static_cast<int>(mesh.Points.size());
  const auto tcoords = CardTCoords(card.View);
  mesh.Points.insert(mesh.Points.end(), card.Corners.begin(), card.Corners.end());
  mesh.Normals.insert(mesh.Normals.end(), card.Normals.begin(), card.Normals.end());
  mesh.TCoords.insert(mesh.TCoords.end(), tcoords.begin(), tcoords.end());
  mesh.Colors.insert(mesh.Colors.end(), 4, color);
  mesh.AddPolygon(std::array<int, 4>{ first, first + 1, first + 2, first + 3 });
}

}

PlantImpostor ImpostorOf(
  const std::vector<DrawnMesh>& meshes, const PlantExtent& extent, const ParallelFor& parallel, const WorkShare& share)
{
  return ImpostorMaker(meshes, extent, parallel, share).Run(parallel, share);
}

ImpostorCard CardTowards(const ImpostorShape& shape, const Vector3& towards)
{
  const int view = NearestView(towards);
  const double elevation = std::asin(std::clamp(std::abs(towards.z), 0.0, 1.0));
  PictureFrame frame = FrameOf(shape.Extent, AzimuthOf(view), ElevationOf(view));
  frame.Towards = towards;
  if (view + 1 < ImpostorViews)
  {
    const double azimuth = std::atan2(towards.y, towards.x);
    frame.HalfWidth *= Ratio(AreaAround(shape, view / ImpostorAzimuths, azimuth), shape.Areas[view]);
    frame.Right = { -std::sin(azimuth), std::cos(azimuth), 0.0 };
  }
  else
  {
    // Near the vertical the azimuth of the eye says little: the picture keeps the plant's own directions.
    frame.Right = Normalised(frame.Right - glm::dot(frame.Right, towards) * towards);
  }
  frame.HalfHeight *= Ratio(AreaAlong(shape, AzimuthOf(view), elevation), shape.Areas[view]);
  frame.Up = glm::cross(towards, frame.Right);
  return CardIn(frame, view);
}

std::array<std::array<double, 2>, 4> CardTCoords(int view)
{
  const int column = view % ImpostorSide;
  const int row = view / ImpostorSide;
  const double low[2] = { static_cast<double>(column) / ImpostorSide, static_cast<double>(row) / ImpostorSide };
  const double high[2] = { low[0] + 1.0 / ImpostorSide, low[1] + 1.0 / ImpostorSide };
  return { { { low[0], low[1] }, { high[0], low[1] }, { high[0], high[1] }, { low[0], high[1] } } };
}

PlantMesh CrossedCards(const PlantImpostor& impostor)
{
  PlantMesh mesh;
  for (int view = 0; view < ImpostorAzimuths / 2; ++view)
  {
    AddCard(CardIn(FrameOf(impostor.Shape.Extent, AzimuthOf(view), 0.0), view), impostor.Mean, mesh);
  }
  AddCard(CardIn(FrameOf(impostor.Shape.Extent, 0.0, 0.5 * Pi), ImpostorViews - 1), impostor.Mean, mesh);
  return mesh;
}

}
