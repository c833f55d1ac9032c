// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/CylindricalProjection.h"

#include "Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace littoral
{

namespace
{

constexpr int RaysAlongEdge = 2; ///< of a texel

/// The outermost hit of a ray so far.
struct Hit
{
  float Radius = 0.0F; ///< 0: none
  Color Seen{ 0, 0, 0 };
};

using TCoord = std::array<double, 2>;

/// A corner of a triangle, seen from the axis.
struct Corner
{
  Vector3 Place; ///< relative to the foot of the axis [m]
  Color Tint;
  TCoord At;
};

class Caster
{
public:
  Caster(const CrownVolume& crown, int columns, int rows)
    : Crown(crown)
    , Columns(columns * RaysAlongEdge)
    , Rows(rows * RaysAlongEdge)
    , Hits(static_cast<std::size_t>(this->Columns) * this->Rows)
    , Directions(this->Columns)
  {
    for (int column = 0; column < this->Columns; ++column)
    {
      const double angle = TwoPi * (column + 0.5) / this->Columns;
      this->Directions[column] = { std::cos(angle), std::sin(angle), 0.0 };
    }
  }

  void Cast(const TexturedMesh& textured, const Poll& poll)
  {
    SteppedPoll steps(poll, 256);
    const PlantMesh& mesh = textured.Mesh;
    const auto cornerOf = [&](int index) {
      const int point = mesh.Corners[index];
      return Corner{ mesh.Points[point] - this->Crown.Foot, mesh.Colors[point],
        textured.Texture ? mesh.TCoords[point] : TCoord{ 0.0, 0.0 } };
    };
    for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
    {
      steps.Step();
      const int first = mesh.Offsets[polygon];
      for (int second = first + 1; second + 1 < mesh.Offsets[polygon + 1]; ++second)
      {
        this->CastAt({ cornerOf(first), cornerOf(second), cornerOf(second + 1) }, textured.Texture);
      }
    }
  }

  TextureImage Picture(const Poll& poll) const
  {
    TextureImage picture(this->Columns / RaysAlongEdge, this->Rows / RaysAlongEdge);
    for (int row = 0; row < picture.Rows; ++row)
    {
      poll();
      for (int column = 0; column < picture.Columns; ++column)
      {
        picture.At(column, row) = this->TexelAt(column, row);
      }
    }
    return picture;
  }

private:
  CrownVolume Crown;
  int Columns;
  int Rows;
  std::vector<Hit> Hits;
  std::vector<Vector3> Directions;

  /// First and last ray column that may meet a triangle; the last may be beyond the end and wraps around.
  std::array<int, 2> ColumnsOf(const std::array<Corner, 3>& triangle) const
  {
    double angles[3];
    for (int i = 0; i < 3; ++i)
    {
      angles[i] = std::atan2(triangle[i].Place.y, triangle[i].Place.x);
    }
    double low = angles[0];
    double high = angles[0];
    for (int i = 1; i < 3; ++i)
    {
      const double angle = angles[0] + std::remainder(angles[i] - angles[0], TwoPi);
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
    if (high - low > 0.5 * Pi) // near the axis, or around it
    {
      return { 0, this->Columns - 1 };
    }
    const double perRadian = this->Columns / TwoPi;
    return { static_cast<int>(std::floor(low * perRadian - 0.5)), static_cast<int>(std::ceil(high * perRadian - 0.5)) };
  }

  void CastAt(const std::array<Corner, 3>& triangle, const TextureImage* texture)
  {
    const Vector3 edge1 = triangle[1].Place - triangle[0].Place;
    const Vector3 edge2 = triangle[2].Place - triangle[0].Place;
    const Vector3 normal = glm::cross(edge1, edge2);
    const auto [low, high] = std::minmax({ triangle[0].Place.z, triangle[1].Place.z, triangle[2].Place.z });
    const double perMetre = this->Rows / this->Crown.Height;
    const int firstRow = std::max(0, static_cast<int>(std::floor(low * perMetre - 0.5)));
    const int lastRow = std::min(this->Rows - 1, static_cast<int>(std::ceil(high * perMetre - 0.5)));
    const auto [firstColumn, lastColumn] = this->ColumnsOf(triangle);
    const double area = glm::dot(normal, normal);
    for (int row = firstRow; row <= lastRow; ++row)
    {
      const Vector3 onAxis{ 0.0, 0.0, (row + 0.5) / perMetre };
      const double height = glm::dot(normal, triangle[0].Place - onAxis);
      for (int wrapped = firstColumn; wrapped <= lastColumn; ++wrapped)
      {
        const int column = ((wrapped % this->Columns) + this->Columns) % this->Columns;
        const double slant = glm::dot(normal, this->Directions[column]);
        if (slant == 0.0)
        {
          continue;
        }
        const double radius = height / slant;
        Hit& hit = this->Hits[static_cast<std::size_t>(row) * this->Columns + column];
        if (!(radius > hit.Radius))
        {
          continue;
        }
        const Vector3 inside = onAxis + radius * this->Directions[column] - triangle[0].Place;
        const double b = glm::dot(glm::cross(inside, edge2), normal) / area;
        const double c = glm::dot(glm::cross(edge1, inside), normal) / area;
        if (b >= 0.0 && c >= 0.0 && b + c <= 1.0)
        {
          Shade(triangle, { 1.0 - b - c, b, c }, texture, radius, hit);
        }
      }
    }
  }

  static void Shade(const std::array<Corner, 3>& triangle, const std::array<double, 3>& weights,
    const TextureImage* texture, double radius, Hit& hit)
  {
    Texel texel{ 255, 255, 255, 255 };
    if (texture)
    {
      double at[2] = { 0.0, 0.0 };
      for (int i = 0; i < 3; ++i)
      {
        at[0] += weights[i] * triangle[i].At[0];
        at[1] += weights[i] * triangle[i].At[1];
      }
      texel = texture->At(std::clamp(static_cast<int>(at[0] * texture->Columns), 0, texture->Columns - 1),
        std::clamp(static_cast<int>(at[1] * texture->Rows), 0, texture->Rows - 1));
    }
    if (texel[3] < 128)
    {
      return;
    }
    hit.Radius = static_cast<float>(radius);
    for (int channel = 0; channel < 3; ++channel)
    {
      double value = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        value += weights[i] * triangle[i].Tint[channel];
      }
      hit.Seen[channel] = static_cast<unsigned char>(std::clamp(value * texel[channel] / 255.0 + 0.5, 0.0, 255.0));
    }
  }

  Texel TexelAt(int column, int row) const
  {
    int sums[3] = { 0, 0, 0 };
    int hits = 0;
    for (int ray = 0; ray < RaysAlongEdge * RaysAlongEdge; ++ray)
    {
      const std::size_t ofRow = static_cast<std::size_t>(row) * RaysAlongEdge + ray / RaysAlongEdge;
      const Hit& hit = this->Hits[ofRow * this->Columns + column * RaysAlongEdge + ray % RaysAlongEdge];
      if (hit.Radius > 0.0F)
      {
        ++hits;
        for (int channel = 0; channel < 3; ++channel)
        {
          sums[channel] += hit.Seen[channel];
        }
      }
    }
    Texel texel{ 0, 0, 0, static_cast<unsigned char>(255 * hits / (RaysAlongEdge * RaysAlongEdge)) };
    for (int channel = 0; channel < 3 && hits > 0; ++channel)
    {
      texel[channel] = static_cast<unsigned char>(sums[channel] / hits);
    }
    return texel;
  }
};

/// Gives transparent texels the color of their neighbourhood, so that a renderer's interpolation finds no dark rim.
void SpreadColors(TextureImage& picture)
{
  int sums[3] = { 0, 0, 0 };
  int count = 0;
  for (const Texel& texel : picture.Texels)
  {
    if (texel[3] > 0)
    {
      ++count;
      for (int channel = 0; channel < 3; ++channel)
      {
        sums[channel] += texel[channel];
      }
    }
  }
  for (Texel& texel : picture.Texels)
  {
    for (int channel = 0; channel < 3 && texel[3] == 0 && count > 0; ++channel)
    {
      texel[channel] = static_cast<unsigned char>(sums[channel] / count);
    }
  }
}

}

TextureImage CylindricalProjection(
  const TexturedMesh& leaves, const CrownVolume& crown, int columns, int rows, const Poll& poll)
{
  Caster caster(crown, columns, rows);
  caster.Cast(leaves, poll);
  TextureImage picture = caster.Picture(poll);
  SpreadColors(picture);
  return picture;
}

}
