// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGlassPass_h
#define LittoralGlassPass_h

#include "vtkOpenGLRenderPass.h"

namespace littoral
{

class Lighting;

/// Lets the shaders of translucent surfaces light them, which are blended where they are drawn.
class GlassPass : public vtkOpenGLRenderPass
{
public:
  static GlassPass* New();
  vtkTypeMacro(GlassPass, vtkOpenGLRenderPass);

  /// Between them, the props of a state are drawn in a light by their shaders of this pass.
  void Begin(const vtkRenderState* state, const Lighting& light);
  void End(const vtkRenderState* state);
  void Render(const vtkRenderState*) override {}

protected:
  GlassPass() = default;
  ~GlassPass() override = default;

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(
    vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject* VAO) override;

private:
  GlassPass(const GlassPass&) = delete;
  void operator=(const GlassPass&) = delete;

  const Lighting* Light = nullptr;
};

}

#endif
