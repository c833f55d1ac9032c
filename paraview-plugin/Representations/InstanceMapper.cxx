// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InstanceMapper.h"
#include "InstanceCulling.h"
#include "vtkLandscapePass.h"

#if __has_include("vtk_glad.h") // VTK 9.4 and later
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <string>
#include <utility>

namespace littoral
{
namespace
{

// v + 2 q x (q x v + w v), of a quaternion q, w.
constexpr const char* Declarations = R"(
in vec4 instancePlace; // and scale
in vec4 instanceTurn;
in vec4 instanceTint; // and how wide, beside the scale
uniform vec2 instanceFade; // distances [m]
uniform vec3 instanceEye;
flat out float instanceFadedVSOutput;
vec3 instanceTurned(vec3 v)
{
  vec3 q = instanceTurn.xyz;
  return v + 2.0 * cross(q, cross(q, v) + instanceTurn.w * v);
}
)";

constexpr const char* Begin = R"(
  vec4 instanceMC = vec4(instancePlace.xyz + instancePlace.w * instanceTurned(vec3(instanceTint.ww, 1.0) * vertexMC.xyz), 1.0);
  float instanceFar = distance(instanceEye, instancePlace.xyz);
  instanceFadedVSOutput = instanceFade.y > 0.0
    ? clamp((instanceFar - instanceFade.x) / max(instanceFade.y - instanceFade.x, 1e-6), 0.0, 1.0) : 0.0;
#define vertexMC instanceMC
#define normalMC instanceTurned(normalMC / vec3(instanceTint.ww, 1.0))
#define scalarColor min(vec4(1.0), vec4(instanceTint.rgb, 1.0) * scalarColor)
)";

// The pattern is that of impostors.
constexpr const char* Faded = R"(
  float instancePattern = fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)));
  if (instanceFadedVSOutput > fract(52.9829189 * instancePattern)) discard;
)";

/// Inserts declarations before the function main of a shader, and code at its beginning.
void InsertInMain(vtkShader* shader, const char* declarations, const char* code)
{
  std::string source = shader->GetSource();
  const std::size_t main = source.find("void main");
  const std::size_t body = source.find('{', main);
  if (body != std::string::npos)
  {
    source.insert(body + 1, code);
    source.insert(main, declarations);
  }
  shader->SetSource(source);
}

}

vtkStandardNewMacro(InstanceMapper);

//----------------------------------------------------------------------------
InstanceMapper::InstanceMapper()
{
  this->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

//----------------------------------------------------------------------------
InstanceMapper::~InstanceMapper() = default;

//----------------------------------------------------------------------------
void InstanceMapper::SetInstances(
  const std::shared_ptr<const InstanceBatch>& batch, const std::shared_ptr<const InstanceBatch>& inCoarseMaps)
{
  if (this->Batch != batch || this->InCoarseMaps != inCoarseMaps)
  {
    this->Batch = batch;
    this->InCoarseMaps = inCoarseMaps;
    this->IsUploaded = false;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
void InstanceMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffer->ReleaseGraphicsResources();
  this->IsUploaded = false;
  this->Superclass::ReleaseGraphicsResources(window);
}

//----------------------------------------------------------------------------
void InstanceMapper::ComputeBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->Batch && this->Batch->Bounds.IsValid())
  {
    this->Batch->Bounds.GetBounds(this->Bounds);
  }
}

//----------------------------------------------------------------------------
/// Takes the instances that the camera may show, and tells whether there are any.
bool InstanceMapper::TakeShown(vtkRenderer* renderer, vtkActor* actor)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkInformation* map = camera->GetInformation();
  vtkNew<vtkMatrix4x4> toClip;
  vtkMatrix4x4::Multiply4x4(camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0),
    actor->GetMatrix(), toClip);
  const bool isCoarse = map && map->Has(vtkLandscapePass::COARSE_MAP());
  const auto& batch = isCoarse && this->InCoarseMaps ? this->InCoarseMaps : this->Batch;
  std::vector<float> shown = batch ? InstancesInSight(*batch, toClip) : std::vector<float>();
  if (shown != this->Shown)
  {
    this->Shown = std::move(shown);
    this->IsUploaded = false;
  }
  return !this->Shown.empty();
}

//----------------------------------------------------------------------------
void InstanceMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  vtkOpenGLHelper& triangles = this->Primitives[PrimitiveTris];
  if (triangles.IBO->IndexCount == 0 || !this->TakeShown(renderer, actor))
  {
    return;
  }
  this->DrawingVertices = false;
  this->UpdateShaders(triangles, renderer, actor);
  if (!triangles.Program)
  {
    return;
  }
  this->BindAttributes(triangles);
  const auto count = static_cast<GLsizei>(this->Shown.size() / InstanceBatch::Numbers);
  triangles.IBO->Bind();
  glDrawElementsInstanced(this->GetOpenGLMode(actor->GetProperty()->GetRepresentation(), PrimitiveTris),
    static_cast<GLsizei>(triangles.IBO->IndexCount), GL_UNSIGNED_INT, nullptr, count);
  triangles.IBO->Release();
}

//----------------------------------------------------------------------------
void InstanceMapper::BindAttributes(vtkOpenGLHelper& triangles)
{
  if (!this->IsUploaded)
  {
    this->Buffer->Upload(this->Shown, vtkOpenGLBufferObject::ArrayBuffer);
    this->IsUploaded = true;
  }
  constexpr int four = 4 * sizeof(float);
  int offset = 0;
  triangles.VAO->Bind();
  for (const char* name : { "instancePlace", "instanceTurn", "instanceTint" })
  {
    triangles.VAO->AddAttributeArrayWithDivisor(triangles.Program, this->Buffer, name, offset,
      InstanceBatch::Numbers * sizeof(float), VTK_FLOAT, 4, false, 1, false);
    offset += four;
  }
}

//----------------------------------------------------------------------------
void InstanceMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  InsertInMain(shaders[vtkShader::Vertex], Declarations, Begin);
  InsertInMain(shaders[vtkShader::Fragment], "flat in float instanceFadedVSOutput;\n", Faded);
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
}

//----------------------------------------------------------------------------
void InstanceMapper::SetFadeRange(double from, double to)
{
  this->FadeRange[0] = static_cast<float>(from);
  this->FadeRange[1] = static_cast<float>(to);
}

//----------------------------------------------------------------------------
void InstanceMapper::SetMapperShaderParameters(vtkOpenGLHelper& triangles, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(triangles, renderer, actor);
  const float none[2] = { 0.0F, 0.0F };
  const bool isParallel = renderer->GetActiveCamera()->GetParallelProjection();
  triangles.Program->SetUniform2f("instanceFade", isParallel ? none : this->FadeRange);
  double place[4] = { 0.0, 0.0, 0.0, 1.0 };
  renderer->GetActiveCamera()->GetPosition(place);
  vtkNew<vtkMatrix4x4> toOwn;
  vtkMatrix4x4::Invert(actor->GetMatrix(), toOwn);
  toOwn->MultiplyPoint(place, place);
  const float eye[3] = { static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2]) };
  triangles.Program->SetUniform3f("instanceEye", eye);
}

}
