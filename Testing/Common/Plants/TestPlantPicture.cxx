// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PlantPicture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace littoral;

namespace
{

constexpr int Size = 30; ///< columns and rows, whose samples are no multiple of a vector's lanes

/// A frame from 0 to Size in y and z that looks along x: a texel is a metre.
PictureFrame Frame()
{
  PictureFrame frame;
  frame.Center = { 0.0, 0.5 * Size, 0.5 * Size };
  frame.HalfWidth = frame.HalfHeight = 0.5 * Size;
  return frame;
}

struct Flat
{
  std::array<Vector3, 3> Corners;
  Color Tint;
};

PlantMesh MeshOf(const std::vector<Flat>& triangles)
{
  PlantMesh mesh;
  for (const Flat& triangle : triangles)
  {
    const int first = static_cast<int>(mesh.Points.size());
    for (const Vector3& corner : triangle.Corners)
    {
      mesh.Points.push_back(corner);
      mesh.Normals.push_back({ 1.0, 0.0, 0.0 });
      mesh.TCoords.push_back({ corner.y / Size, corner.z / Size });
      mesh.Colors.push_back(triangle.Tint);
    }
    mesh.AddPolygon(std::array<int, 3>{ first, first + 1, first + 2 });
  }
  return mesh;
}

/// Half of a square of two sides, or of all that is seen and more.
Flat Half(double depth, double side, const Color& tint)
{
  return { { Vector3(depth, 0.0, 0.0), Vector3(depth, 2.0 * side, 0.0), Vector3(depth, 0.0, 2.0 * side) }, tint };
}

double SumOf(const std::vector<SeenTexel>& picture)
{
  double sum = 0.0;
  for (const SeenTexel& texel : picture)
  {
    sum += texel.Coverage;
  }
  return sum;
}

/// The triangle that a ray along x meets first, counted from 0; -1: none.
int Nearest(const std::vector<Flat>& triangles, double y, double z)
{
  int nearest = -1;
  double largest = -1e30;
  for (std::size_t n = 0; n < triangles.size(); ++n)
  {
    const auto& [a, b, c] = triangles[n].Corners;
    const auto cross = [&](
                         const Vector3& p, const Vector3& q) { return (p.y - y) * (q.z - z) - (p.z - z) * (q.y - y); };
    const double parts[3] = { cross(b, c), cross(c, a), cross(a, b) };
    const double area = parts[0] + parts[1] + parts[2];
    if (std::all_of(parts, parts + 3, [&](double part) { return part / area >= 0.0; }))
    {
      const double x = (parts[0] * a.x + parts[1] * b.x + parts[2] * c.x) / area;
      nearest = x > largest ? static_cast<int>(n) : nearest;
      largest = std::max(largest, x);
    }
  }
  return nearest;
}

}

TEST(PlantPicture, FillsTheFrame)
{
  const PlantMesh mesh = MeshOf({ Half(0.0, 2.0 * Size, { 255, 51, 0 }) });
  for (const SeenTexel& texel : PictureOf({ { mesh } }, Frame(), Size, Size))
  {
    ASSERT_EQ(texel.Coverage, 1.0f);
    ASSERT_NEAR(texel.Color[0], 1.0, 1e-6);
    ASSERT_NEAR(texel.Color[1], 0.2, 1e-6);
    ASSERT_NEAR(texel.Normal.z, 1.0, 1e-6); // towards the eye
  }
}

TEST(PlantPicture, ShowsWhatARayMeetsFirst)
{
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> place(-0.1 * Size, 1.1 * Size);
  std::uniform_real_distribution<double> size(-0.2 * Size, 0.2 * Size);
  std::vector<Flat> triangles;
  for (int n = 0; n < 60; ++n)
  {
    const Vector3 corner(place(engine), place(engine), place(engine));
    const auto beside = [&] { return corner + Vector3(size(engine), size(engine), size(engine)); };
    triangles.push_back({ { corner, beside(), beside() }, { static_cast<unsigned char>(4 * n), 0, 0 } });
  }
  const PlantMesh mesh = MeshOf(triangles);
  const std::vector<SeenTexel> picture = PictureOf({ { mesh } }, Frame(), Size, Size);
  int other = 0;
  int covered = 0;
  for (int at = 0; at < Size * Size; ++at)
  {
    double hits = 0.0;
    double red = 0.0;
    for (int sample = 0; sample < PictureSamples * PictureSamples; ++sample)
    {
      const double y = at % Size + (sample % PictureSamples + 0.5) / PictureSamples;
      const double z = at / Size + (sample / PictureSamples + 0.5) / PictureSamples;
      const int seen = Nearest(triangles, y, z);
      hits += seen >= 0 ? 1.0 : 0.0;
      red += seen >= 0 ? triangles[seen].Tint[0] / 255.0 : 0.0;
    }
    covered += hits > 0.0 ? 1 : 0;
    const bool isSame = picture[at].Coverage == hits / (PictureSamples * PictureSamples) &&
      std::abs(picture[at].Color[0] * hits - red) < 1e-4;
    other += isSame ? 0 : 1;
  }
  EXPECT_EQ(CoverageOf({ { mesh } }, Frame(), Size, Size), SumOf(picture));
  EXPECT_GT(covered, Size * Size / 4);
  EXPECT_LE(other, 1); // a sample on an edge
}

TEST(PlantPicture, IsCutOutByTheTextureBetweenItsTexels)
{
  TextureImage texture(4, 1);
  for (int column = 0; column < 4; ++column)
  {
    // Between opacities of 0 and 170 the test passes from three quarters of the way on.
    texture.At(column, 0) = { 255, 255, 255, static_cast<unsigned char>(column == 0 ? 0 : column == 1 ? 170 : 255) };
  }
  const PlantMesh mesh = MeshOf({ Half(0.0, 2.0 * Size, { 255, 255, 255 }) });
  const double edge = Size * (0.125 + 0.25 * 127.5 / 170.0);
  const auto picture = PictureOf({ { mesh, &texture } }, Frame(), Size, Size);
  EXPECT_NEAR(SumOf(picture), Size * (Size - edge), 0.5 * Size / PictureSamples);
  EXPECT_EQ(picture[0].Coverage, 0.0f);
  EXPECT_EQ(CoverageOf({ { mesh, &texture } }, Frame(), Size, Size), SumOf(picture));
}
