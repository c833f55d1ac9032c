// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearestPixels.h"

#include "OpenGL.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

namespace littoral
{

namespace
{

constexpr float Nowhere = 2e9F;   // a distance beyond that of the sky
constexpr float Nothing = -1e30F; // below all numbers of pixels

/// Distances of pixels.
std::vector<float> WaysOf(const std::vector<float>& pixels)
{
  std::vector<float> ways(pixels.size() / 4);
  for (std::size_t k = 0; k < ways.size(); ++k)
  {
    ways[k] = pixels[4 * k + 3] > 0.0F ? pixels[4 * k + 3] : Nowhere;
  }
  return ways;
}

/// What pixels have in a picture, so many numbers each.
template <class Number>
std::vector<Number> NumbersOf(vtkTextureObject* picture, unsigned int format, unsigned int type, int parts)
{
  std::vector<Number> numbers(static_cast<std::size_t>(parts) * picture->GetWidth() * picture->GetHeight());
  picture->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, format, type, numbers.data());
  picture->Deactivate();
  return numbers;
}

void WriteNumbers(vtkTextureObject* picture, unsigned int format, unsigned int type, const void* numbers)
{
  picture->Activate();
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<int>(picture->GetWidth()), static_cast<int>(picture->GetHeight()),
    format, type, numbers);
  picture->Deactivate();
}

/// Pixels where a process has something nearer than the far plane.
std::vector<std::size_t> PixelsWith(vtkTextureObject* depth, vtkMultiProcessController* processes)
{
  const std::vector<float> depths = NumbersOf<float>(depth, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
  std::vector<unsigned char> own(depths.size());
  std::vector<unsigned char> all(depths.size());
  std::transform(depths.begin(), depths.end(), own.begin(), [](float z) { return z < 1.0F ? 1 : 0; });
  processes->AllReduce(own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
  std::vector<std::size_t> pixels;
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    if (all[k] > 0)
    {
      pixels.push_back(k);
    }
  }
  return pixels;
}

/// Pixels that processes share, and which of them have the nearest surface in this one.
struct SharedPixels
{
  std::vector<std::size_t> Pixels;
  std::vector<bool> AreNearest;
  vtkMultiProcessController* Processes;
};

/// The least depths that processes have at shared pixels, of which the nearest are told.
std::vector<float> TakeLeast(SharedPixels& shared, const std::vector<float>& depths)
{
  std::vector<float> own;
  std::transform(shared.Pixels.begin(), shared.Pixels.end(), std::back_inserter(own),
    [&depths](std::size_t pixel) { return depths[pixel]; });
  std::vector<float> least(own.size());
  shared.Processes->AllReduce(own.data(), least.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MIN_OP);
  shared.AreNearest.resize(own.size());
  std::transform(own.begin(), own.end(), least.begin(), shared.AreNearest.begin(), std::less_equal<>());
  return least;
}

/// Writes what the nearest have in a picture to another one.
template <class Number>
void WriteNearest(const SharedPixels& shared, vtkTextureObject* from, vtkTextureObject* to, unsigned int type)
{
  constexpr int parts = 4;
  std::vector<Number> numbers = NumbersOf<Number>(from, GL_RGBA, type, parts);
  std::vector<Number> own(parts * shared.Pixels.size(), std::numeric_limits<Number>::lowest());
  std::vector<Number> all(own.size());
  for (std::size_t k = 0; k < shared.Pixels.size(); ++k)
  {
    if (shared.AreNearest[k])
    {
      std::copy_n(&numbers[parts * shared.Pixels[k]], parts, &own[parts * k]);
    }
  }
  shared.Processes->AllReduce(own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
  for (std::size_t k = 0; k < shared.Pixels.size(); ++k)
  {
    std::copy_n(&all[parts * k], parts, &numbers[parts * shared.Pixels[k]]);
  }
  WriteNumbers(to, GL_RGBA, type, numbers.data());
}

}

//----------------------------------------------------------------------------
void TakeNearestPixels(vtkTextureObject* picture, vtkMultiProcessController* processes)
{
  std::vector<float> own = NumbersOf<float>(picture, GL_RGBA, GL_FLOAT, 4);
  std::vector<float> all(own.size());
  const std::vector<float> ways = WaysOf(own);
  std::vector<float> nearest(ways.size());
  processes->AllReduce(ways.data(), nearest.data(), static_cast<vtkIdType>(ways.size()), vtkCommunicator::MIN_OP);
  for (std::size_t k = 0; k < ways.size(); ++k)
  {
    if (ways[k] > nearest[k] || ways[k] == Nowhere)
    {
      std::fill_n(&own[4 * k], 4, Nothing);
    }
  }
  processes->AllReduce(own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
  std::replace(all.begin(), all.end(), Nothing, 0.0F);
  WriteNumbers(picture, GL_RGBA, GL_FLOAT, all.data());
}

//----------------------------------------------------------------------------
void TakeNearestColors(vtkTextureObject* picture, vtkTextureObject* depth, vtkMultiProcessController* processes)
{
  const std::vector<float> depths = NumbersOf<float>(depth, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
  SharedPixels shared{ std::vector<std::size_t>(depths.size()), {}, processes };
  std::iota(shared.Pixels.begin(), shared.Pixels.end(), std::size_t{ 0 });
  TakeLeast(shared, depths);
  WriteNearest<unsigned char>(shared, picture, picture, GL_UNSIGNED_BYTE);
}

//----------------------------------------------------------------------------
void TakeNearestBelow(vtkTextureObject* depthOfWater, const SurfacePictures& own, const SurfacePictures& nearest,
  vtkMultiProcessController* processes)
{
  SharedPixels shared{ PixelsWith(depthOfWater, processes), {}, processes };
  if (shared.Pixels.empty())
  {
    return;
  }
  std::vector<float> numbers = NumbersOf<float>(own.Depth, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
  const std::vector<float> least = TakeLeast(shared, numbers);
  for (std::size_t k = 0; k < least.size(); ++k)
  {
    numbers[shared.Pixels[k]] = least[k];
  }
  WriteNumbers(nearest.Depth, GL_DEPTH_COMPONENT, GL_FLOAT, numbers.data());
  WriteNearest<unsigned char>(shared, own.Albedo, nearest.Albedo, GL_UNSIGNED_BYTE);
  WriteNearest<float>(shared, own.Surface, nearest.Surface, GL_FLOAT);
}

}
