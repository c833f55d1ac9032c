// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PinnedArray.h"
#include "OpenGL.h"
#include "vtkLandscapePass.h"

#include "vtkFloatArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectCache.h"

#include <cstring>

namespace littoral
{

namespace
{

/// GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD, which not all headers have.
constexpr GLenum ExternalMemory = 0x9160;

/// Notes in a buffer what it tells of the array in it, as VTK does when it sends one.
class Notes : public vtkOpenGLVertexBufferObject
{
public:
  static void Write(vtkDataArray* array, vtkOpenGLVertexBufferObject* buffer)
  {
    const auto components = static_cast<unsigned int>(array->GetNumberOfComponents());
    buffer->*& Notes::NumberOfComponents = components;
    buffer->*& Notes::NumberOfTuples = static_cast<unsigned int>(array->GetNumberOfTuples());
    buffer->*& Notes::Dirty = false;
    buffer->SetStride(components * static_cast<unsigned int>(sizeof(float)));
    (buffer->*&Notes::UploadTime).Modified();
  }
};

}

//----------------------------------------------------------------------------
bool PinnedArray::IsPossible(vtkOpenGLRenderWindow* window)
{
  if (!vtkLandscapePass::IsDrawnBySoftware(window))
  {
    return false; // a card would fetch each vertex from afar
  }
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint index = 0; index < count; ++index)
  {
    const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(index)));
    if (name && std::strcmp(name, "GL_AMD_pinned_memory") == 0)
    {
      return true;
    }
  }
  return false;
}

//----------------------------------------------------------------------------
bool PinnedArray::ReadBy(vtkOpenGLBufferObject* buffer, vtkDataArray* array)
{
  while (glGetError() != GL_NO_ERROR) // of others
  {
  }
  const vtkIdType bytes = array->GetNumberOfValues() * array->GetDataTypeSize();
  glBindBuffer(ExternalMemory, static_cast<GLuint>(buffer->GetHandle()));
  glBufferData(ExternalMemory, static_cast<GLsizeiptr>(bytes), array->GetVoidPointer(0), GL_STATIC_DRAW);
  glBindBuffer(ExternalMemory, 0);
  return glGetError() == GL_NO_ERROR;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkOpenGLVertexBufferObject> PinnedArray::Pin(vtkDataArray* array, vtkOpenGLRenderWindow* window)
{
  auto* numbers = vtkFloatArray::SafeDownCast(array);
  if (!numbers || numbers->GetNumberOfTuples() == 0)
  {
    return nullptr;
  }
  auto buffer = vtkSmartPointer<vtkOpenGLVertexBufferObject>::Take(window->GetVBOCache()->GetVBO(numbers, VTK_FLOAT));
  const bool isPinned = buffer->GetUploadTime() == this->Time && numbers->GetMTime() < this->Time;
  if (isPinned && !this->HasMoved(numbers, buffer))
  {
    return buffer;
  }
  this->Memory = numbers->GetPointer(0);
  this->Size = numbers->GetNumberOfValues();
  buffer->GenerateBuffer(vtkOpenGLBufferObject::ArrayBuffer);
  if (!ReadBy(buffer, numbers))
  {
    this->Time = 0;
    return nullptr;
  }
  Notes::Write(numbers, buffer);
  this->Time = buffer->GetUploadTime();
  return buffer;
}

//----------------------------------------------------------------------------
bool PinnedArray::HasMoved(vtkDataArray* array, vtkOpenGLVertexBufferObject* buffer) const
{
  return array && buffer && this->Time > 0 && buffer->GetUploadTime() == this->Time &&
    (array->GetNumberOfValues() != this->Size || array->GetVoidPointer(0) != this->Memory);
}

}
