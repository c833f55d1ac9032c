// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plants/PlantPicture.h"

#include "Numerics/SimdClones.h"

#include <algorithm>
#include <cmath>

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

/// The nearest hit of a sample.
struct Sample
{
  float Depth = 0.0f;
  int Mesh = -1; ///< -1: none
  int Corner[3]{};
  float Weights[3]{};
};

/// Triangle as samples need it: p = a + v (b - a) + w (c - a).
struct Triangle
{
  Projected Origin;    ///< a
  float V[2];          ///< gradients of v
  float W[2];          ///< and w
  float Depth[2];      ///< of b and c against a
  float Texel[3][2]{}; ///< of a, and of b and c against it
};

/// Samples beside each other: v and w, and whether they are in a triangle.
struct TestedSamples
{
  float V[Lanes];
  float W[Lanes];
  int IsInside[Lanes];
};

LITTORAL_SIMD_CLONES
void TestSamples(const Triangle& triangle, int row, int column, TestedSamples& samples)
{
  const float y = static_cast<float>(row) + 0.5f - triangle.Origin.Y;
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const float x = static_cast<float>(column + lane) + 0.5f - triangle.Origin.X;
    const float v = x * triangle.V[0] + y * triangle.V[1];
    const float w = x * triangle.W[0] + y * triangle.W[1];
    samples.V[lane] = v;
    samples.W[lane] = w;
    samples.IsInside[lane] =
      static_cast<int>(v >= 0.0f) & static_cast<int>(w >= 0.0f) & static_cast<int>(v + w <= 1.0f);
  }
}

class Rasterizer
{
public:
  Rasterizer(const PictureFrame& frame, int columns, int rows)
    : Frame(frame)
    , Columns(columns * PictureSamples)
    , Rows(rows * PictureSamples)
    , Samples(static_cast<std::size_t>(this->Columns) * this->Rows)
  {
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
        if (sample->Mesh >= 0)
        {
          this->Shade(meshes[sample->Mesh], *sample, texels[column / PictureSamples]);
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
  int Columns;
  int Rows;
  std::vector<Sample> Samples;
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

  Triangle MakeTriangle(const DrawnMesh& drawn, const std::array<int, 3>& corners, float area) const
  {
    const Projected& a = this->Vertices[corners[0]];
    const Projected& b = this->Vertices[corners[1]];
    const Projected& c = this->Vertices[corners[2]];
    Triangle triangle{ a, { (c.Y - a.Y) / area, (a.X - c.X) / area }, { (a.Y - b.Y) / area, (b.X - a.X) / area },
      { b.Depth - a.Depth, c.Depth - a.Depth } };
    for (int axis = 0; axis < 2 && drawn.Texture; ++axis)
    {
      const auto size = static_cast<float>(axis == 0 ? drawn.Texture->Columns : drawn.Texture->Rows);
      for (int corner = 0; corner < 3; ++corner)
      {
        triangle.Texel[corner][axis] = size * static_cast<float>(drawn.Mesh.TCoords[corners[corner]][axis]) -
          (corner > 0 ? triangle.Texel[0][axis] : 0.0f);
      }
    }
    return triangle;
  }

  void DrawTriangle(const DrawnMesh& drawn, int index, const std::array<int, 3>& corners)
  {
    const Projected& a = this->Vertices[corners[0]];
    const Projected& b = this->Vertices[corners[1]];
    const Projected& c = this->Vertices[corners[2]];
    // Samples are in the middles of their cells.
    const auto first = [](float low) { return std::max(0, static_cast<int>(std::ceil(low - 0.5f))); };
    const auto last = [](float high, int count) {
      return std::min(count - 1, static_cast<int>(std::floor(high - 0.5f)));
    };
    const int firstRow = first(std::min({ a.Y, b.Y, c.Y }));
    const int lastRow = last(std::max({ a.Y, b.Y, c.Y }), this->Rows);
    const int firstColumn = first(std::min({ a.X, b.X, c.X }));
    const int lastColumn = last(std::max({ a.X, b.X, c.X }), this->Columns);
    const float area = (b.X - a.X) * (c.Y - a.Y) - (c.X - a.X) * (b.Y - a.Y);
    if (area == 0.0f || firstRow > lastRow || firstColumn > lastColumn)
    {
      return;
    }
    const Triangle triangle = this->MakeTriangle(drawn, corners, area);
    TestedSamples samples;
    for (int row = firstRow; row <= lastRow; ++row)
    {
      for (int column = firstColumn; column <= lastColumn; column += Lanes)
      {
        TestSamples(triangle, row, column, samples);
        for (int lane = 0; lane < std::min(Lanes, lastColumn - column + 1); ++lane)
        {
          if (samples.IsInside[lane])
          {
            Sample& sample = this->Samples[static_cast<std::size_t>(row) * this->Columns + column + lane];
            DrawSample(drawn, index, corners, triangle, samples.V[lane], samples.W[lane], sample);
          }
        }
      }
    }
  }

  /// Draws a sample that is nearer than what is there.
  static void DrawSample(const DrawnMesh& drawn, int index, const std::array<int, 3>& corners, const Triangle& triangle,
    float v, float w, Sample& sample)
  {
    const float depth = triangle.Origin.Depth + v * triangle.Depth[0] + w * triangle.Depth[1];
    if ((sample.Mesh < 0 || depth > sample.Depth) && IsOpaque(drawn.Texture, triangle, v, w))
    {
      sample = { depth, index, { corners[0], corners[1], corners[2] }, { 1.0f - v - w, v, w } };
    }
  }

  /// Whether the alpha between the four next texels passes the test, as of a renderer that interpolates.
  static bool IsOpaque(const TextureImage* texture, const Triangle& triangle, float v, float w)
  {
    if (!texture)
    {
      return true;
    }
    int low[2];
    int high[2];
    float part[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      const int last = (axis == 0 ? texture->Columns : texture->Rows) - 1;
      const float along = triangle.Texel[0][axis] + v * triangle.Texel[1][axis] + w * triangle.Texel[2][axis] - 0.5f;
      const float held = std::clamp(along, 0.0f, static_cast<float>(last));
      low[axis] = static_cast<int>(held);
      high[axis] = std::min(low[axis] + 1, last);
      part[axis] = held - static_cast<float>(low[axis]);
    }
    const auto alpha = [&](int column, int row) { return static_cast<float>(texture->At(column, row)[3]); };
    const float below = alpha(low[0], low[1]) + part[0] * (alpha(high[0], low[1]) - alpha(low[0], low[1]));
    const float above = alpha(low[0], high[1]) + part[0] * (alpha(high[0], high[1]) - alpha(low[0], high[1]));
    return below + part[1] * (above - below) >= 127.5f;
  }

  static const Texel& TexelAt(const DrawnMesh& drawn, const int* corners, const float* weights)
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
  void Shade(const DrawnMesh& drawn, const Sample& sample, SeenTexel& texel) const
  {
    ColorSum color{ 0.0f, 0.0f, 0.0f };
    Vector3 normal(0.0);
    for (int i = 0; i < 3; ++i)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        color[channel] += sample.Weights[i] * static_cast<float>(drawn.Mesh.Colors[sample.Corner[i]][channel]);
      }
      normal += static_cast<double>(sample.Weights[i]) * drawn.Mesh.Normals[sample.Corner[i]];
    }
    for (int channel = 0; channel < 3; ++channel)
    {
      const float factor = drawn.Texture ? static_cast<float>(TexelAt(drawn, sample.Corner, sample.Weights)[channel]) /
          255.0f / drawn.TextureMean[channel]
                                         : 1.0f;
      texel.Color[channel] += std::min(255.0f, factor * color[channel]);
    }
    texel.Coverage += 1.0f;
    texel.Normal += Vector3(
      glm::dot(normal, this->Frame.Right), glm::dot(normal, this->Frame.Up), glm::dot(normal, this->Frame.Towards));
  }
};

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
