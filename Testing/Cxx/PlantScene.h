// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlantScene_h
#define PlantScene_h

// Pictures of plants for regression tests.

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkUniforms.h"

#include <cstring>

/// A renderer with sun, sky and a pale background.
class PlantScene
{
public:
  PlantScene()
  {
    this->Renderer->SetBackground(0.78, 0.85, 0.92);
    this->Renderer->AutomaticLightCreationOff();
    this->AddLight(-0.7, -0.5, 0.6, 1.1);
    this->AddLight(0.0, 0.0, 1.0, 0.5);
    this->AddLight(0.8, -0.6, 0.1, 0.4);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(400, 160);
    this->Window->AddRenderer(this->Renderer);
    this->Interactor->SetRenderWindow(this->Window);
  }

  /// Adds all polygons below a data object, moved by x; a texture goes on all of them and replaces their colors where
  /// it is asked to; or the polygons are cut out where it is transparent.
  void Add(vtkDataObject* data, double x, vtkImageData* texture = nullptr, bool replaces = false, bool cutsOut = false)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
      {
        this->Add(blocks->GetBlock(index), x, texture, replaces, cutsOut);
      }
      return;
    }
    auto* polygons = vtkPolyData::SafeDownCast(data);
    if (!polygons || polygons->GetNumberOfPolys() == 0)
    {
      return;
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(polygons);
    mapper->SetScalarVisibility(!replaces);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(x, 0.0, 0.0);
    actor->GetProperty()->SetSpecular(0.0);
    actor->GetProperty()->SetAmbient(0.25);
    if (texture)
    {
      vtkNew<vtkTexture> picture;
      picture->SetInputData(texture);
      picture->InterpolateOn();
      picture->SetMipmap(cutsOut && IsOpaqueOnAverage(texture));
      picture->SetMaximumAnisotropicFiltering(1.0f);
      actor->SetTexture(picture);
    }
    if (cutsOut)
    {
      actor->ForceOpaqueOn();
      actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::TCoord::Impl", true,
        "//VTK::TCoord::Impl\n  if (gl_FragData[0].a < 0.5) discard;\n  gl_FragData[0].a = 1.0;\n", false);
    }
    this->Renderer->AddActor(actor);
  }

  /// Whether the mean of a picture is not cut out: it may have mip levels.
  static bool IsOpaqueOnAverage(vtkImageData* picture)
  {
    vtkDataArray* texels = picture->GetPointData()->GetScalars();
    double sum = 0.0;
    for (vtkIdType texel = 0; texel < texels->GetNumberOfTuples(); ++texel)
    {
      sum += texels->GetComponent(texel, 3);
    }
    return sum > 0.5 * 255.0 * static_cast<double>(texels->GetNumberOfTuples());
  }

  /// Adds all polygons below a data object with the textures that they carry: RGB * texel / TextureMean, cut out at an
  /// alpha of a half, lit by NormalTexture where there is one.
  void AddAsCarried(vtkDataObject* data, double x = 0.0)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int index = 0; index < blocks->GetNumberOfBlocks(); ++index)
      {
        this->AddAsCarried(blocks->GetBlock(index), x);
      }
      return;
    }
    auto* polygons = vtkPolyData::SafeDownCast(data);
    if (!polygons || polygons->GetNumberOfPolys() == 0)
    {
      return;
    }
    vtkDataArray* texels = polygons->GetFieldData()->GetArray("Texture");
    if (!texels)
    {
      this->Add(polygons, x);
      return;
    }
    this->Add(polygons, x, this->PictureOf(polygons, "Texture"), false, true);
    vtkActor* actor = this->Renderer->GetActors()->GetLastActor();
    vtkShaderProperty* shader = actor->GetShaderProperty();
    float mean[3] = { 1.0f, 1.0f, 1.0f };
    vtkDataArray* given = polygons->GetFieldData()->GetArray("TextureMean");
    for (int channel = 0; given && channel < 3; ++channel)
    {
      mean[channel] = static_cast<float>(given->GetComponent(0, channel));
    }
    shader->GetFragmentCustomUniforms()->SetUniform3f("textureMean", mean);
    shader->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0].rgb /= textureMean;\n", false);
    const bool hasNormals = polygons->GetFieldData()->HasArray("NormalTexture");
    if (hasNormals)
    {
      vtkNew<vtkTexture> normals;
      normals->SetInputData(this->PictureOf(polygons, "NormalTexture"));
      normals->InterpolateOn();
      actor->GetProperty()->SetTexture("normalTex", normals);
    }
    shader->AddFragmentShaderReplacement("//VTK::Normal::Impl", true,
      hasNormals ? "//VTK::Normal::Impl\n"
                   "  vec2 s = dFdx(tcoordVCVSOutput.st), t = dFdy(tcoordVCVSOutput.st);\n"
                   "  vec3 p = dFdx(vertexVC.xyz), q = dFdy(vertexVC.xyz);\n"
                   "  float turn = sign(s.x * t.y - s.y * t.x);\n"
                   "  vec3 n = texture(normalTex, tcoordVCVSOutput.st).xyz * 2.0 - 1.0;\n"
                   "  normalVCVSOutput = normalize(n.x * normalize(turn * (p * t.y - q * s.y)) +\n"
                   "    n.y * normalize(turn * (q * s.x - p * t.x)) + n.z * normalize(cross(p, q)));\n"
                 : "//VTK::Normal::Impl\n  if (gl_FrontFacing == false) normalVCVSOutput = -normalVCVSOutput;\n",
      false);
  }

  /// Draws from a point towards another and compares with the baseline.
  int Compare(int argc, char* argv[], const double eye[3], const double focus[3], double angle)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye);
    camera->SetFocalPoint(focus);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(angle);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    const int result = vtkRegressionTestImage(this->Window.Get());
    if (result == vtkRegressionTester::DO_INTERACTOR)
    {
      this->Interactor->Start();
    }
    return result == vtkRegressionTester::FAILED ? 1 : 0;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;

private:
  /// A texture that a block carries.
  static vtkSmartPointer<vtkImageData> PictureOf(vtkPolyData* block, const char* name)
  {
    vtkDataArray* size = block->GetFieldData()->GetArray("TextureSize");
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(static_cast<int>(size->GetTuple1(0)), static_cast<int>(size->GetTuple1(1)), 1);
    image->GetPointData()->SetScalars(block->GetFieldData()->GetArray(name));
    return image;
  }

  void AddLight(double x, double y, double z, double intensity)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(1000.0 * x, 1000.0 * y, 1000.0 * z);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetIntensity(intensity);
    this->Renderer->AddLight(light);
  }
};

/// The block at a path such as "High/Leaves"; null if there is none.
inline vtkDataObject* BlockAt(vtkDataObject* data, const char* path)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  const char* slash = std::strchr(path, '/');
  const std::size_t length = slash ? static_cast<std::size_t>(slash - path) : std::strlen(path);
  for (unsigned int index = 0; blocks && index < blocks->GetNumberOfBlocks(); ++index)
  {
    const char* name = blocks->GetMetaData(index)->Get(vtkCompositeDataSet::NAME());
    if (name && std::strlen(name) == length && std::strncmp(name, path, length) == 0)
    {
      return slash ? BlockAt(blocks->GetBlock(index), slash + 1) : blocks->GetBlock(index);
    }
  }
  return nullptr;
}

#endif
