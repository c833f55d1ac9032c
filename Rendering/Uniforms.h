// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Numbers of GLM as uniforms of VTK's programs, in single precision; names that a program does not use are passed
/// over.
#ifndef LittoralUniforms_h
#define LittoralUniforms_h

#include "vtkMatrix4x4.h"
#include "vtkShaderProgram.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace littoral
{

/// Length after which the noise of LandscapeNoise.glsl repeats itself, so that places far from the origin keep their
/// single precision [m].
constexpr double NoisePeriod = 4096.0;

inline void SetUniform(vtkShaderProgram* program, const char* name, int value)
{
  program->SetUniformi(name, value);
}

inline void SetUniform(vtkShaderProgram* program, const char* name, double value)
{
  program->SetUniformf(name, static_cast<float>(value));
}

inline void SetUniform(vtkShaderProgram* program, const char* name, const glm::dvec2& value)
{
  const glm::vec2 v(value);
  const float numbers[2] = { v.x, v.y };
  program->SetUniform2f(name, numbers);
}

inline void SetUniform(vtkShaderProgram* program, const char* name, const glm::dvec3& value)
{
  const glm::vec3 v(value);
  const float numbers[3] = { v.x, v.y, v.z };
  program->SetUniform3f(name, numbers);
}

inline void SetUniform(vtkShaderProgram* program, const char* name, const glm::dvec4& value)
{
  const glm::vec4 v(value);
  const float numbers[4] = { v.x, v.y, v.z, v.w };
  program->SetUniform4f(name, numbers);
}

inline void SetUniform(vtkShaderProgram* program, const char* name, const glm::dmat3& value)
{
  glm::mat3 m(value);
  program->SetUniformMatrix3x3(name, &m[0][0]);
}

inline void SetUniform(vtkShaderProgram* program, const char* name, const glm::dmat4& value)
{
  glm::mat4 m(value);
  program->SetUniformMatrix4x4(name, &m[0][0]);
}

/// A matrix of VTK, whose elements are by row and column.
inline glm::dmat4 MatrixOf(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

}

#endif
