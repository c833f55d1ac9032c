// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPinnedArray_h
#define LittoralPinnedArray_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkDataArray;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexBufferObject;

namespace littoral
{

/**
 * An array of the vertices that a mapper of VTK sends, where it need not be copied: a processor that draws reads the
 * memory of the array itself, if OpenGL has GL_AMD_pinned_memory. The cache of the window holds the array as long as
 * its buffer is there.
 */
class PinnedArray
{
public:
  /// Whether a window draws from the memory of arrays.
  static bool IsPossible(vtkOpenGLRenderWindow* window);

  /// Has a buffer that was filled with an array read the array itself, so that its copy goes; false where it cannot.
  static bool ReadBy(vtkOpenGLBufferObject* buffer, vtkDataArray* array);

  /// The buffer of an array of float in the cache of a window, which reads its memory, so that VTK sends no copy; null
  /// for other arrays. It goes with the last mapper that has it.
  vtkSmartPointer<vtkOpenGLVertexBufferObject> Pin(vtkDataArray* array, vtkOpenGLRenderWindow* window);

  /// Whether a buffer reads an array that has other memory by now.
  bool HasMoved(vtkDataArray* array, vtkOpenGLVertexBufferObject* buffer) const;

private:
  const void* Memory = nullptr;
  vtkIdType Size = 0;
  vtkMTimeType Time = 0; ///< of the buffer
};

}

#endif
