// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NearestPixels.h"

#include "OpenGL.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkTextureObject.h"

#include <algorithm>
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

}

//----------------------------------------------------------------------------
void TakeNearestPixels(vtkTextureObject* picture, vtkMultiProcessController* processes)
{
  const auto width = static_cast<int>(picture->GetWidth());
  const auto height = static_cast<int>(picture->GetHeight());
  const auto count = static_cast<std::size_t>(width) * height;
  std::vector<float> own(4 * count);
  std::vector<float> all(4 * count);
  picture->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, own.data());
  const std::vector<float> ways = WaysOf(own);
  std::vector<float> nearest(count);
  processes->AllReduce(ways.data(), nearest.data(), static_cast<vtkIdType>(count), vtkCommunicator::MIN_OP);
  for (std::size_t k = 0; k < count; ++k)
  {
    if (ways[k] > nearest[k] || ways[k] == Nowhere)
    {
      std::fill_n(&own[4 * k], 4, Nothing);
    }
  }
  processes->AllReduce(own.data(), all.data(), static_cast<vtkIdType>(4 * count), vtkCommunicator::MAX_OP);
  std::replace(all.begin(), all.end(), Nothing, 0.0F);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, all.data());
  picture->Deactivate();
}

}
