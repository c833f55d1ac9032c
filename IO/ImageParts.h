// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralImageParts_h
#define LittoralImageParts_h

// The image that a writer writes, which it has part by part, so that it need never be whole in memory.

#include <array>
#include <functional>

class vtkAlgorithm;
class vtkImageData;

namespace littoral
{

struct ImageParts
{
  using Extent = std::array<int, 6>;

  Extent Whole{};
  /// An image that holds at least an extent. Throws Aborted where the input fails, which has told why.
  std::function<vtkImageData*(const Extent&)> Get;
};

/// An image in memory as its only part. Throws InvalidInput where it is null.
ImageParts PartsOf(vtkImageData* image);

/// The input of a writer, which is updated for each part. Throws InvalidInput where there is none, or no image.
ImageParts PartsOfInput(vtkAlgorithm* writer);

}

#endif
