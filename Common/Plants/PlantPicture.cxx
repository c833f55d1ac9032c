// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PlantPicture.h"

#include "Numerics/SimdClones.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

// Before the loop over lanes, which GCC would else take apart before it makes vectors of it.
#if defined(__GNUC__) && !defined(__clang__)
#define LITTORAL_LANES _Pragma("GCC unroll 1")
#else
#define LITTORAL_LANES
#endif

namespace littoral
{

namespace
{

/// A vertex in units of samples; the depth grows towards the eye [m].
struct Projected
{
  float X;
  float Y;
  float Depth;
};

/// Samples of a row that are tested together, as vectors of the processor.
constexpr int Lanes = 8;

/// Triangle as samples need it: p = a + v (b - a) + w (c - a).
struct Triangle
{
  Projected Origin;    ///< a
  float V[2];          ///< gradients of v
  float W[2];          ///< and w
  float Depth[2];      ///< of b and c against a
  float Texel[3][2]{}; ///< of a, and of b and c against it
};

/// The samples in the box around a triangle: rows and columns, the last ones included.
struct SampleBox
{
  int FirstRow;
  int LastRow;
  int FirstColumn;
  int LastColumn;
};

/// Samples that a triangle hits, and that are nearer than what is there.
struct NearerSamples
{
  std::vector<int> At; ///< index into the samples
  std::vector<float> V;
  std::vector<float> W;
  std::vector<float> Depth;
  std::vector<int> IsOpaque;

  void Reserve(std::size_t count)
  {
    if (this->At.size() < count)
    {
      this->At.resize(count);
      this->V.resize(count);
      this->W.resize(count);
      this->Depth.resize(count);
      this->IsOpaque.resize(count);
    }
  }
};

/// Samples beside each other, and whether a triangle hits them nearer than what is there.
struct TestedSamples
{
  float V[Lanes];
  float W[Lanes];
  float Depth[Lanes];
  int IsNearer[Lanes];
};

/// Whether any is.
LITTORAL_INLINE bool TestLanes(
  const Triangle& triangle, int column, float y, const float* depths, TestedSamples& tested)
{
  int any = 0;
  LITTORAL_LANES
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const float x = static_cast<float>(column + lane) + 0.5f - triangle.Origin.X;
    const float v = x * triangle.V[0] + y * triangle.V[1];
    const float w = x * triangle.W[0] + y * triangle.W[1];
    const float depth = triangle.Origin.Depth + v * triangle.Depth[0] + w * triangle.Depth[1];
    tested.V[lane] = v;
    tested.W[lane] = w;
    tested.Depth[lane] = depth;
    tested.IsNearer[lane] = static_cast<int>(v >= 0.0f) & static_cast<int>(w >= 0.0f) &
      static_cast<int>(v + w <= 1.0f) & static_cast<int>(depth > depths[lane]);
    any |= tested.IsNearer[lane];
  }
  return any != 0;
}

/// Finds the samples of a box that a triangle hits, nearer than `depths`, which lie row by row; their number.
LITTORAL_SIMD_CLONES
int TestSamples(const Triangle& ofMesh, const SampleBox& box, const float* depths, int columns, NearerSamples& nearer)
{
  const Triangle triangle = ofMesh; // which nothing else writes
  TestedSamples tested;
  int found = 0;
  for (int row = box.FirstRow; row <= box.LastRow; ++row)
  {
    const float y = static_cast<float>(row) + 0.5f - triangle.Origin.Y;
    for (int column = box.FirstColumn; column <= box.LastColumn; column += Lanes)
    {
      const int first = row * columns + column;
      if (!TestLanes(triangle, column, y, depths + first, tested))
      {
        continue;
      }
      for (int lane = 0; lane < std::min(Lanes, box.LastColumn - column + 1); ++lane)
      {
        nearer.At[found] = first + lane;
        nearer.V[found] = tested.V[lane];
        nearer.W[found] = tested.W[lane];
        nearer.Depth[found] = tested.Depth[lane];
        found += tested.IsNearer[lane];
      }
    }
  }
  return found;
}

/// Marks the samples where the alpha between the four next texels passes the test, as of a renderer that interpolates.
LITTORAL_SIMD_CLONES
void TestOpacity(const TextureImage& texture, const Triangle& triangle, int count, NearerSamples& nearer)
{
  const unsigned char* alphas = texture.Texels.front().data() + 3;
  const int lastColumn = texture.Columns - 1;
  const int lastRow = texture.Rows - 1;
  for (int n = 0; n < count; ++n)
  {
    const float v = nearer.V[n];
    const float w = nearer.W[n];
    const auto along = [&](int axis, int last) {
      const float at = triangle.Texel[0][axis] + v * triangle.Texel[1][axis] + w * triangle.Texel[2][axis] - 0.5f;
      return std::clamp(at, 0.0f, static_cast<float>(last));
    };
    const float x = along(0, lastColumn);
    const float y = along(1, lastRow);
    const int left = static_cast<int>(x);
    const int low = static_cast<int>(y);
    const int right = std::min(left + 1, lastColumn);
    const int high = std::min(low + 1, lastRow);
    const auto alpha = [&](int column, int row) {
      return static_cast<float>(alphas[4 * (row * texture.Columns + column)]);
    };
    const float part = x - static_cast<float>(left);
    const float below = alpha(left, low) + part * (alpha(right, low) - alpha(left, low));
    const float above = alpha(left, high) + part * (alpha(right, high) - alpha(left, high));
    nearer.IsOpaque[n] = static_cast<int>(below + (y - static_cast<float>(low)) * (above - below) >= 127.5f);
  }
}

class Rasterizer
{
  /// The nearest hit of a sample.
  struct Sample
  {
    int Triangle = -1; ///< -1: none
    float V = 0.0f;
    float W = 0.0f;
  };

  struct DrawnTriangle
  {
    int Mesh;
    std::array<int, 3> Corners;
  };

public:
  Rasterizer(const PictureFrame& frame, int columns, int rows, bool isOutline = false)
    : Frame(frame)
    , IsOutline(isOutline)
    , Columns(columns * PictureSamples)
    , Rows(rows * PictureSamples)
    , Samples(static_cast<std::size_t>(this->Columns) * this->Rows)
    , Depths(this->Samples.size() + Lanes, -std::numeric_limits<float>::infinity())
  {
  }

  double CountCovered() const
  {
    const auto covered =
      std::count_if(this->Samples.begin(), this->Samples.end(), [](const Sample& s) { return s.Triangle >= 0; });
    return static_cast<double>(covered) / (PictureSamples * PictureSamples);
  }

  void Draw(const DrawnMesh& drawn, int index)
  {
    const PlantMesh& mesh = drawn.Mesh;
    this->Project(mesh);
    for (int polygon = 0; polygon < mesh.NumberOfPolygons(); ++polygon)
    {
      const int first = mesh.Offsets[polygon];
      for (int second = first + 1; second + 1 < mesh.Offsets[polygon + 1]; ++second)
      {
        this->DrawTriangle(drawn, index, { mesh.Corners[first], mesh.Corners[second], mesh.Corners[second + 1] });
      }
    }
  }

  std::vector<SeenTexel> Resolve(const std::vector<DrawnMesh>& meshes) const
  {
    const int columns = this->Columns / PictureSamples;
    std::vector<SeenTexel> picture(this->Samples.size() / (PictureSamples * PictureSamples));
    const Sample* sample = this->Samples.data();
    for (int row = 0; row < this->Rows; ++row)
    {
      SeenTexel* texels = &picture[static_cast<std::size_t>(row / PictureSamples) * columns];
      for (int column = 0; column < this->Columns; ++column, ++sample)
      {
        if (sample->Triangle >= 0)
        {
          const DrawnTriangle& triangle = this->Triangles[sample->Triangle];
          const std::array<float, 3> weights{ 1.0f - sample->V - sample->W, sample->V, sample->W };
          this->Shade(meshes[triangle.Mesh], triangle.Corners, weights, texels[column / PictureSamples]);
        }
      }
    }
    for (SeenTexel& texel : picture)
    {
      if (texel.Coverage == 0.0f)
      {
        continue;
      }
      const float hits = texel.Coverage;
      for (float& part : texel.Color)
      {
        part /= 255.0f * hits;
      }
      texel.Normal /= static_cast<double>(hits);
      texel.Coverage /= PictureSamples * PictureSamples;
    }
    return picture;
  }

private:
  PictureFrame Frame;
  bool IsOutline; ///< any hit of a sample does, the first one
  int Columns;
  int Rows;
  std::vector<Sample> Samples;
  std::vector<float> Depths; ///< of the samples; lanes reach over the end
  std::vector<DrawnTriangle> Triangles;
  NearerSamples Nearer; ///< of one triangle
  std::vector<Projected> Vertices;

  void Project(const PlantMesh& mesh)
  {
    const double perMetre[2] = { 0.5 * this->Columns / this->Frame.HalfWidth,
      0.5 * this->Rows / this->Frame.HalfHeight };
    this->Vertices.clear();
    for (const Vector3& point : mesh.Points)
    {
      const Vector3 away = point - this->Frame.Center;
      this->Vertices.push_back(
        { static_cast<float>(0.5 * this->Columns + perMetre[0] * glm::dot(away, this->Frame.Right)),
          static_cast<float>(0.5 * this->Rows + perMetre[1] * glm::dot(away, this->Frame.Up)),
          static_cast<float>(glm::dot(away, this->Frame.Towards)) });
    }
  }

  static void SetTexels(const DrawnMesh& drawn, const std::array<int, 3>& corners, Triangle& triangle)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto size = static_cast<float>(axis == 0 ? drawn.Texture->Columns : drawn.Texture->Rows);
      for (int corner = 0; corner < 3; ++corner)
      {
        triangle.Texel[corner][axis] = size * static_cast<float>(drawn.Mesh.TCoords[corners[corner]][axis]) -
          (corner > 0 ? triangle.Texel[0][axis] : 0.0f);
      }
    }
  }

  void DrawTriangle(const DrawnMesh& drawn, int index, const std::array<int, 3>& corners)
  {
    const Projected& a = this->Vertices[corners[0]];
    const Projected& b = this->Vertices[corners[1]];
    const Projected& c = this->Vertices[corners[2]];
    // Samples are in the middles of their cells.
    const auto firstOf = [](float low) { return std::max(0, static_cast<int>(std::ceil(low - 0.5f))); };
    const auto lastOf = [](float high, int count) {
      return std::min(count - 1, static_cast<int>(std::floor(high - 0.5f)));
    };
    const int firstRow = firstOf(std::min({ a.Y, b.Y, c.Y }));
    const int lastRow = lastOf(std::max({ a.Y, b.Y, c.Y }), this->Rows);
    const int firstColumn = firstOf(std::min({ a.X, b.X, c.X }));
    const int lastColumn = lastOf(std::max({ a.X, b.X, c.X }), this->Columns);
    const float area = (b.X - a.X) * (c.Y - a.Y) - (c.X - a.X) * (b.Y - a.Y);
    if (area == 0.0f || firstRow > lastRow || firstColumn > lastColumn)
    {
      return;
    }
    Triangle triangle{ a, { (c.Y - a.Y) / area, (a.X - c.X) / area }, { (a.Y - b.Y) / area, (b.X - a.X) / area },
      { b.Depth - a.Depth, c.Depth - a.Depth } };
    const SampleBox box{ firstRow, lastRow, firstColumn, lastColumn };
    this->Nearer.Reserve(static_cast<std::size_t>(lastRow - firstRow + 1) * (lastColumn - firstColumn + 1) + Lanes);
    const int found = TestSamples(triangle, box, this->Depths.data(), this->Columns, this->Nearer);
    if (found == 0)
    {
      return;
    }
    if (drawn.Texture)
    {
      SetTexels(drawn, corners, triangle);
      TestOpacity(*drawn.Texture, triangle, found, this->Nearer);
    }
    const int number = static_cast<int>(this->Triangles.size());
    for (int n = 0; n < found; ++n)
    {
      if (!drawn.Texture || this->Nearer.IsOpaque[n])
      {
        const int at = this->Nearer.At[n];
        this->Depths[at] = this->IsOutline ? std::numeric_limits<float>::infinity() : this->Nearer.Depth[n];
        this->Samples[at] = { number, this->Nearer.V[n], this->Nearer.W[n] };
      }
    }
    this->Triangles.push_back({ index, corners });
  }

  static const Texel& TexelAt(
    const DrawnMesh& drawn, const std::array<int, 3>& corners, const std::array<float, 3>& weights)
  {
    double at[2] = { 0.0, 0.0 };
    for (int i = 0; i < 3; ++i)
    {
      at[0] += weights[i] * drawn.Mesh.TCoords[corners[i]][0];
      at[1] += weights[i] * drawn.Mesh.TCoords[corners[i]][1];
    }
    const TextureImage& texture = *drawn.Texture;
    return texture.At(std::clamp(static_cast<int>(at[0] * texture.Columns), 0, texture.Columns - 1),
      std::clamp(static_cast<int>(at[1] * texture.Rows), 0, texture.Rows - 1));
  }

  /// Adds a sample's color and normal to its texel.
  void Shade(const DrawnMesh& drawn, const std::array<int, 3>& corners, const std::array<float, 3>& weights,
    SeenTexel& texel) const
  {
    ColorSum color{ 0.0f, 0.0f, 0.0f };
    Vector3 normal(0.0);
    for (int i = 0; i < 3; ++i)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        color[channel] += weights[i] * static_cast<float>(drawn.Mesh.Colors[corners[i]][channel]);
      }
      normal += static_cast<double>(weights[i]) * drawn.Mesh.Normals[corners[i]];
    }
    const Texel shade = drawn.Texture ? TexelAt(drawn, corners, weights) : Texel{};
    for (int channel = 0; channel < 3; ++channel)
    {
      const float factor =
        drawn.Texture ? static_cast<float>(shade[channel]) / 255.0f / drawn.TextureMean[channel] : 1.0f;
      texel.Color[channel] += std::min(255.0f, factor * color[channel]);
    }
    texel.Coverage += 1.0f;
    texel.Normal += Vector3(
      glm::dot(normal, this->Frame.Right), glm::dot(normal, this->Frame.Up), glm::dot(normal, this->Frame.Towards));
  }
};

}

std::uint64_t KeyOf(const std::vector<DrawnMesh>& meshes)
{
  std::uint64_t key = 0;
  const auto add = [&key](const auto& list) {
    const std::string_view bytes(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(list[0]));
    key = key * 31 + std::hash<std::string_view>()(bytes);
  };
  for (const DrawnMesh& drawn : meshes)
  {
    add(drawn.Mesh.Points);
    add(drawn.Mesh.Normals);
    add(drawn.Mesh.TCoords);
    add(drawn.Mesh.Colors);
    add(drawn.Mesh.Corners);
    if (drawn.Texture)
    {
      add(drawn.Texture->Texels);
    }
  }
  return key | 1u;
}

PictureFrame FrameTowards(const Vector3& center, double azimuth, double elevation)
{
  PictureFrame frame;
  frame.Center = center;
  frame.Towards = { std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
    std::sin(elevation) };
  frame.Right = { -std::sin(azimuth), std::cos(azimuth), 0.0 };
  frame.Up = glm::cross(frame.Towards, frame.Right);
  return frame;
}

std::vector<SeenTexel> PictureOf(const std::vector<DrawnMesh>& meshes, const PictureFrame& frame, int columns, int rows)
{
  Rasterizer rasterizer(frame, columns, rows);
  for (std::size_t index = 0; index < meshes.size(); ++index)
  {
    rasterizer.Draw(meshes[index], static_cast<int>(index));
  }
  return rasterizer.Resolve(meshes);
}

double CoverageOf(const std::vector<DrawnMesh>& meshes, const PictureFrame& frame, int columns, int rows)
{
  Rasterizer rasterizer(frame, columns, rows, true);
  for (std::size_t index = 0; index < meshes.size(); ++index)
  {
    rasterizer.Draw(meshes[index], static_cast<int>(index));
  }
  return rasterizer.CountCovered();
}

void PictureSum::Add(const std::vector<SeenTexel>& picture)
{
  for (const SeenTexel& texel : picture)
  {
    this->Coverage += texel.Coverage;
    for (int channel = 0; channel < 3 && texel.Coverage > 0.0f; ++channel)
    {
      this->Color[channel] += texel.Coverage * texel.Color[channel];
    }
  }
}

}
