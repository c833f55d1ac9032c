// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSurfacePass_h
#define LittoralSurfacePass_h

#include "vtkOpenGLRenderPass.h"

namespace littoral
{

/**
 * Lets the shaders of surfaces write what is needed to light them, not their look: the color without light, and normal,
 * material and distance. Where a texture is more than half transparent there is no surface.
 *
 * Output 0: albedo as the display's code, and 1, or the stretch of a surface of water, or from 0.5 to 1 how far the
 * normals of an impostor's fragment agree (ImpostorQuads). Output 1: the view's normal on
 * an octahedron unfolded to a square (two numbers from -1 to 1), transmittance of the surface from 0 to 1 or one of the
 * numbers below, and w of the clip coordinates.
 */
class SurfacePass : public vtkOpenGLRenderPass
{
public:
  static SurfacePass* New();
  vtkTypeMacro(SurfacePass, vtkOpenGLRenderPass);

  static constexpr double Ground = 2.0;
  static constexpr double Cover = 3.0;
  static constexpr double Water = 4.0;
  static constexpr double River = 5.0;
  static constexpr double Bark = -0.25;
  static constexpr double Unlit = -1.0;
  static constexpr double Nothing = -2.0; ///< where there is no surface

  /// Transmittance of a prop, or Unlit where lights do not change its color: with ambient light alone.
  static double TransmittanceOf(vtkProp* prop);
  /// Whether sun and sky light a prop: one with Lighting, and with a color map if these are lit.
  static bool IsLit(vtkProp* prop, bool lightsColorMaps);

  /// Whether surfaces with a color map are lit by sun and sky, not by the renderer's lights; default on.
  vtkSetMacro(LightsColorMaps, bool);
  vtkGetMacro(LightsColorMaps, bool);
  vtkMTimeType GetShaderStageMTime() override { return this->GetMTime(); }

  /// Between them, the props of a state are drawn by their shaders of this pass.
  void Begin(const vtkRenderState* state);
  void End(const vtkRenderState* state);
  void Render(const vtkRenderState*) override {}

protected:
  SurfacePass() = default;
  ~SurfacePass() override = default;

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(
    vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject* VAO) override;

private:
  SurfacePass(const SurfacePass&) = delete;
  void operator=(const SurfacePass&) = delete;

  bool LightsColorMaps = true;
};

}

#endif
