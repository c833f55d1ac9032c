// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImpostorQuads.h"

#include "ImpostorFragmentDec.h"
#include "ImpostorFragmentImpl.h"
#include "ImpostorVertexDec.h"
#include "ImpostorVertexImpl.h"
#include "OpenGL.h"
#include "Uniforms.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <string>
#include <utility>

namespace littoral
{

vtkStandardNewMacro(ImpostorQuads);

namespace
{

constexpr std::array<const char*, 3> InstanceAttributes = { "instancePlace", "instanceTurn", "instanceTint" };

}

//----------------------------------------------------------------------------
ImpostorQuads::ImpostorQuads()
{
  vtkNew<vtkPolyData> square;
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> cell;
  for (const auto& corner : { std::array<double, 2>{ -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } })
  {
    corners->InsertNextPoint(corner[0], corner[1], 0.0);
  }
  cell->InsertNextCell({ 0, 1, 2, 3 });
  square->SetPoints(corners);
  square->SetPolys(cell);
  this->SetInputData(square);
  this->ScalarVisibilityOff();
  this->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

//----------------------------------------------------------------------------
ImpostorQuads::~ImpostorQuads() = default;

//----------------------------------------------------------------------------
void ImpostorQuads::SetInstances(ImpostorInstances instances)
{
  this->Instances = std::move(instances);
  this->IsUploaded = false;
}

//----------------------------------------------------------------------------
void ImpostorQuads::SetAtlas(const ImpostorAtlas* atlas, const ImpostorAtlas::Sphere& around, int frames, int frameSize)
{
  this->Atlas = atlas;
  this->Around = around;
  this->Grid = { frames, frameSize };
}

//----------------------------------------------------------------------------
void ImpostorQuads::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Buffer->ReleaseGraphicsResources();
  this->IsUploaded = false;
  this->Superclass::ReleaseGraphicsResources(window);
}

//----------------------------------------------------------------------------
void ImpostorQuads::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  vtkOpenGLHelper& squares = this->Primitives[PrimitiveTris];
  if (!this->Atlas || this->Instances.Values.empty() || squares.IBO->IndexCount == 0)
  {
    return;
  }
  vtkTextureObject* const textures[] = { this->Atlas->GetColors(), this->Atlas->GetForms(), this->Atlas->GetLeaves() };
  for (vtkTextureObject* texture : textures)
  {
    texture->Activate();
  }
  this->DrawingVertices = false;
  this->UpdateShaders(squares, renderer, actor);
  if (squares.Program)
  {
    squares.IBO->Bind();
    this->HasInstancedArrays() ? this->DrawTogether(squares) : this->DrawEach(squares);
    squares.IBO->Release();
  }
  for (vtkTextureObject* texture : textures)
  {
    texture->Deactivate();
  }
}

//----------------------------------------------------------------------------
/// OpenGL 3.3, or an extension
bool ImpostorQuads::HasInstancedArrays()
{
  return glVertexAttribDivisor || glVertexAttribDivisorARB;
}

//----------------------------------------------------------------------------
void ImpostorQuads::DrawTogether(vtkOpenGLHelper& squares)
{
  this->BindAttributes(squares);
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(squares.IBO->IndexCount), GL_UNSIGNED_INT, nullptr,
    static_cast<GLsizei>(this->Instances.Values.size() / ImpostorInstances::Numbers));
}

//----------------------------------------------------------------------------
/// The same, one instance after the other.
void ImpostorQuads::DrawEach(vtkOpenGLHelper& squares)
{
  squares.VAO->Bind();
  const std::vector<float>& values = this->Instances.Values;
  for (std::size_t instance = 0; instance < values.size(); instance += ImpostorInstances::Numbers)
  {
    for (std::size_t k = 0; k < InstanceAttributes.size(); ++k)
    {
      const auto program = static_cast<GLuint>(squares.Program->GetHandle());
      const GLint place = glGetAttribLocation(program, InstanceAttributes[k]);
      glVertexAttrib4fv(static_cast<GLuint>(place), values.data() + instance + 4 * k);
    }
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(squares.IBO->IndexCount), GL_UNSIGNED_INT, nullptr);
  }
}

//----------------------------------------------------------------------------
void ImpostorQuads::BindAttributes(vtkOpenGLHelper& squares)
{
  if (!this->IsUploaded)
  {
    this->Buffer->Upload(this->Instances.Values, vtkOpenGLBufferObject::ArrayBuffer);
    this->IsUploaded = true;
  }
  int offset = 0;
  squares.VAO->Bind();
  for (const char* name : InstanceAttributes)
  {
    squares.VAO->AddAttributeArrayWithDivisor(squares.Program, this->Buffer, name, offset,
      ImpostorInstances::Numbers * sizeof(float), VTK_FLOAT, 4, false, 1, false);
    offset += 4 * sizeof(float);
  }
}

//----------------------------------------------------------------------------
void ImpostorQuads::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  const auto replace = [&](vtkShader::Type type, const char* tag, const std::string& code) {
    std::string source = shaders[type]->GetSource();
    vtkShaderProgram::Substitute(source, tag, code, false);
    shaders[type]->SetSource(source);
  };
  replace(vtkShader::Vertex, "//VTK::Normal::Dec", std::string(ImpostorVertexDec) + "//VTK::Normal::Dec");
  replace(vtkShader::Vertex, "//VTK::PositionVC::Impl",
    std::string(ImpostorVertexImpl) + "  vec4 impostorMC4 = vec4(impostorMC, 1.0);\n#define vertexMC impostorMC4\n");
  replace(vtkShader::Fragment, "//VTK::Normal::Dec", std::string(ImpostorFragmentDec) + "//VTK::Normal::Dec");
  replace(vtkShader::Fragment, "//VTK::Normal::Impl", ImpostorFragmentImpl);
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
}

//----------------------------------------------------------------------------
void ImpostorQuads::SetMapperShaderParameters(vtkOpenGLHelper& squares, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(squares, renderer, actor);
  vtkShaderProgram* program = squares.Program;
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 toWorld = glm::translate(MatrixOf(actor->GetMatrix()), this->Instances.Anchor);
  const glm::dmat4 toView = MatrixOf(camera->GetModelViewTransformMatrix()) * toWorld;
  const glm::dmat4 projection =
    MatrixOf(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  const glm::dmat4 fromView = glm::inverse(toView);
  int viewport[4];
  static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  SetUniform(program, "impostorToView", toView);
  SetUniform(program, "impostorToClip", projection);
  SetUniform(program, "impostorToNormal", glm::transpose(glm::dmat3(fromView)));
  SetUniform(program, "impostorEye", fromView[camera->GetParallelProjection() ? 2 : 3]);
  SetUniform(program, "impostorSphere", glm::dvec4(this->Around.Center, this->Around.Radius));
  SetUniform(program, "impostorGrid", this->Grid);
  SetUniform(program, "impostorPixel", 2.0 / (projection[1][1] * viewport[3]));
  SetUniform(program, "impostorFade", this->Fade);
  SetUniform(program, "impostorColors", this->Atlas->GetColors()->GetTextureUnit());
  SetUniform(program, "impostorForms", this->Atlas->GetForms()->GetTextureUnit());
  SetUniform(program, "impostorLeaves", this->Atlas->GetLeaves()->GetTextureUnit());
}

}
