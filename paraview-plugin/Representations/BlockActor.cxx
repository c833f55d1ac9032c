// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockActor.h"
#include "CompositeMapper.h"

#include "BlockMapper.h"
#include "InstanceMapper.h"
#include "vtkImpostorMapper.h"
#include "vtkLandscapePass.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUniforms.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <string>

namespace littoral
{
namespace
{

constexpr const char* TextureName = "Texture";
constexpr const char* SizeName = "TextureSize";
constexpr const char* MeanName = "TextureMean";
constexpr const char* NormalsName = "NormalTexture";

/// The name by which VTK's mappers declare a texture of normals, and multiply no color with it.
constexpr const char* NormalsUniform = "normalTex";

// Places in VTK's fragment shader of the texture, the normal and the light. The light comes between the others.
constexpr const char* ColorStep = "//VTK::TCoord::Impl";
constexpr const char* NormalStep = "//VTK::Normal::Impl";
constexpr const char* LightStep = "//VTK::Light::Impl";

/// Cut-out: alpha >= 0.5, before the light is computed for nothing.
constexpr const char* CutOutCode = "  if (texture(actortexture, tcoordVCVSOutput).a < 0.5) discard;\n"
                                   "//VTK::Light::Impl\n";

/// c = c_surface texel / mean.
constexpr const char* ColorCode = "//VTK::TCoord::Impl\n"
                                  "  gl_FragData[0] = vec4(gl_FragData[0].rgb / textureMean, 1.0);\n";

/// Leaves let light through: their normal is the same on both sides, while VTK turns it to the viewer.
constexpr const char* BothSidesCode = "//VTK::Normal::Impl\n"
                                      "  if (!gl_FrontFacing) normalVCVSOutput = -normalVCVSOutput;\n";

/// The frame of the texture in view coordinates, from the derivatives of position and texture coordinates in the image:
/// t = dp/du, b = dp/dv, n = t x b towards the viewer.
constexpr const char* NormalCode =
  "//VTK::Normal::Impl\n"
  "  vec2 uvX = dFdx(tcoordVCVSOutput.st), uvY = dFdy(tcoordVCVSOutput.st);\n"
  "  vec3 pX = dFdx(vertexVC.xyz), pY = dFdy(vertexVC.xyz);\n"
  "  vec3 alongU = normalize((pX * uvY.t - pY * uvX.t) * (uvX.s * uvY.t - uvX.t * uvY.s));\n"
  "  vec3 alongV = normalize((pY * uvX.s - pX * uvY.s) * (uvX.s * uvY.t - uvX.t * uvY.s));\n"
  "  vec3 towards = normalize(cross(pX, pY));\n"
  "  towards = towards.z < 0.0 ? -towards : towards;\n"
  "  vec3 inTexture = texture(normalTex, tcoordVCVSOutput).xyz * 2.0 - 1.0;\n"
  "  normalVCVSOutput = normalize(inTexture.x * alongU + inTexture.y * alongV + inTexture.z * towards);\n";

vtkDataArray* FieldOf(vtkDataObject* block, const char* name)
{
  vtkFieldData* fields = block ? block->GetFieldData() : nullptr;
  return fields ? fields->GetArray(name) : nullptr;
}

/// Columns and rows; 0 0 if an array does not tell them.
std::array<int, 2> SizeOf(vtkDataArray* size)
{
  if (!size || size->GetNumberOfValues() != 2)
  {
    return { 0, 0 };
  }
  const double columns = size->GetVariantValue(0).ToDouble();
  const double rows = size->GetVariantValue(1).ToDouble();
  constexpr double most = 65536.0;
  return columns >= 1.0 && columns <= most && rows >= 1.0 && rows <= most
    ? std::array<int, 2>{ static_cast<int>(columns), static_cast<int>(rows) }
    : std::array<int, 2>{ 0, 0 };
}

/// Whether an array is a picture of as many texels as its size says.
bool IsPicture(vtkDataArray* texels, vtkDataArray* size, int components)
{
  const auto [columns, rows] = SizeOf(size);
  return vtkUnsignedCharArray::SafeDownCast(texels) && texels->GetNumberOfComponents() == components && columns > 0 &&
    texels->GetNumberOfTuples() == static_cast<vtkIdType>(columns) * rows;
}

/// Whether a tree's mapper would draw its only leaf by nothing but the actor's property and arrays that it has.
bool IsDrawnAlone(const PartOfTree& part, vtkMapper* like)
{
  const vtkCompositeDataDisplayAttributes* attributes = part.Attributes;
  int association = 0;
  return part.Block && CompositeMapper::SafeDownCast(like) && !attributes->HasBlockColors() &&
    !attributes->HasBlockOpacities() && !attributes->HasBlockMaterials() && !attributes->HasBlockPickabilities() &&
    like->GetScalarMode() != VTK_SCALAR_MODE_USE_FIELD_DATA &&
    (!like->GetScalarVisibility() ||
      vtkMapper::GetAbstractScalars(part.Block, like->GetScalarMode(), like->GetArrayAccessMode(), like->GetArrayId(),
        like->GetArrayName(), association));
}

/// Whether fields have all arrays of others, but for those that ParaView adds anew.
bool HaveAll(vtkFieldData* fields, vtkFieldData* others)
{
  for (int k = 0; k < others->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = others->GetAbstractArray(k);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (name.rfind("vtk", 0) != 0 && fields->GetAbstractArray(name.c_str()) != array)
    {
      return false;
    }
  }
  return true;
}

/// Whether blocks have the same points, polygons and arrays.
bool LooksLike(vtkPolyData* a, vtkPolyData* b)
{
  const auto haveSame = [](vtkFieldData* one, vtkFieldData* other) {
    return HaveAll(one, other) && HaveAll(other, one);
  };
  return a->GetPoints()->GetData() == b->GetPoints()->GetData() && a->GetPolys() == b->GetPolys() &&
    haveSame(a->GetPointData(), b->GetPointData()) && haveSame(a->GetCellData(), b->GetCellData()) &&
    haveSame(a->GetFieldData(), b->GetFieldData());
}

/// Selection, and the arrays that tell of what is picked.
void TakeSelection(BlockMapper* mapper, CompositeMapper* like)
{
  mapper->SetSelection(like->GetSelection());
  mapper->SetPointIdArrayName(like->GetPointIdArrayName());
  mapper->SetCellIdArrayName(like->GetCellIdArrayName());
  mapper->SetProcessIdArrayName(like->GetProcessIdArrayName());
}

/// Whether the only leaf of a tree is visible: as the last block on the way to it says.
bool IsVisible(vtkDataObject* node, const vtkCompositeDataDisplayAttributes* attributes, bool isVisible = true)
{
  if (attributes->HasBlockVisibility(node))
  {
    isVisible = attributes->GetBlockVisibility(node);
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(node);
  if (!tree)
  {
    return isVisible;
  }
  // Branches without leaves come to nothing.
  bool isAny = false;
  for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
  {
    isAny = isAny || IsVisible(child, attributes, isVisible);
  }
  return isAny;
}

}

//----------------------------------------------------------------------------
BlockActor::Picture::Picture()
{
  this->Texture->InterpolateOn();
  this->Texture->MipmapOff(); // merged plants share one texture, whose levels mix the outlines of leaves of two species
  this->Texture->RepeatOff();
  this->Texture->EdgeClampOn();
}

//----------------------------------------------------------------------------
void BlockActor::Picture::Show(vtkDataArray* texels, vtkDataArray* size)
{
  if (this->Texels == texels && this->Time == texels->GetMTime())
  {
    return;
  }
  this->Texels = texels;
  this->Time = texels->GetMTime();
  const auto [columns, rows] = SizeOf(size);
  vtkNew<vtkImageData> image;
  image->SetDimensions(columns, rows, 1);
  image->GetPointData()->SetScalars(texels);
  this->Texture->SetInputData(image);
}

//----------------------------------------------------------------------------
BlockActor::BlockActor()
{
  this->Hide();
  this->Actor->SetUserMatrix(this->Matrix);
  this->Actor->SetPropertyKeys(this->Keys);
}

//----------------------------------------------------------------------------
BlockActor::~BlockActor() = default;

//----------------------------------------------------------------------------
bool BlockActor::IsTextured(vtkDataObject* block)
{
  return IsPicture(FieldOf(block, TextureName), FieldOf(block, SizeName), 4);
}

//----------------------------------------------------------------------------
void BlockActor::Draw(const PartOfTree& part, vtkActor* like, vtkMapper* mapper, bool isLit)
{
  const bool isAlone = !part.Prototype && IsDrawnAlone(part, mapper);
  if (!part.Plant.empty())
  {
    this->TakeImpostors(part, like, mapper, isLit);
  }
  else if (part.Prototype)
  {
    this->TakeInstances(part, mapper);
  }
  else if (isAlone)
  {
    this->TakeBlock(part, mapper);
  }
  else
  {
    this->TakeMapper(part, mapper);
  }
  vtkNew<vtkMatrix4x4> matrix;
  like->GetMatrix(matrix);
  if (!std::equal(matrix->GetData(), matrix->GetData() + 16, this->Matrix->GetData()))
  {
    this->Matrix->DeepCopy(matrix); // a change is one for who draws maps of shadows
  }
  if (this->GivenProperty != like->GetProperty() || this->PropertyTime != like->GetProperty()->GetMTime())
  {
    this->GivenProperty = like->GetProperty();
    this->PropertyTime = like->GetProperty()->GetMTime();
    this->Actor->GetProperty()->DeepCopy(like->GetProperty());
  }
  this->TakeKeys(like->GetPropertyKeys(), part.Plant.empty() ? part.Transmittance : 0.0, part.IsBark);
  if (part.InCoarseMaps)
  {
    this->Keys->Set(vtkLandscapePass::COARSE_SHAPE(), static_cast<vtkIdType>(part.InCoarseMaps->Shape));
  }
  this->Actor->SetPickable(like->GetPickable() && !part.Prototype);
  this->Actor->SetVisibility(!isAlone || IsVisible(part.Tree, part.Attributes));
  vtkProperty* property = like->GetProperty();
  const bool hasNormals = isLit && property->GetLighting() && property->GetRepresentation() == VTK_SURFACE;
  this->TakeTexture(part.Plant.empty() ? part.Textured : nullptr, like->GetShaderProperty(), hasNormals);
}

//----------------------------------------------------------------------------
void BlockActor::Hide()
{
  this->Actor->VisibilityOff();
  this->Actor->SetMapper(nullptr);
  this->Mapper = nullptr;
  this->MapperTime = 0;
}

//----------------------------------------------------------------------------
vtkProp* BlockActor::GetProp()
{
  return this->Actor;
}

//----------------------------------------------------------------------------
void BlockActor::TakeMapper(const PartOfTree& part, vtkMapper* like)
{
  if (!this->Mapper || !this->Mapper->IsA(like->GetClassName()))
  {
    this->Mapper = vtkSmartPointer<vtkMapper>::Take(like->NewInstance());
    this->Actor->SetMapper(this->Mapper);
    this->MapperTime = 0;
  }
  this->Mapper->SetSelection(like->GetSelection());
  const vtkMTimeType time = std::max(like->GetMTime(), part.Attributes->GetMTime());
  if (this->MapperTime == time && this->Mapper->GetInputDataObject(0, 0) == part.Tree)
  {
    return;
  }
  this->MapperTime = time;
  this->Mapper->ShallowCopy(like);
  this->Mapper->SetSelection(like->GetSelection());
  auto* own = CompositeMapper::SafeDownCast(this->Mapper);
  auto* other = CompositeMapper::SafeDownCast(like);
  if (own && other)
  {
    own->SetCompositeDataDisplayAttributes(part.Attributes);
    own->SetVBOShiftScaleMethod(other->GetVBOShiftScaleMethod());
  }
  this->Mapper->SetInputDataObject(part.Tree);
}

//----------------------------------------------------------------------------
void BlockActor::TakeBlock(const PartOfTree& part, vtkMapper* like)
{
  auto* mapper = BlockMapper::SafeDownCast(this->Mapper);
  auto* other = CompositeMapper::SafeDownCast(like);
  // What is in the graphics' memory is not shifted anew; pictures are as the first mapper of a view shifts them.
  const auto shift = part.IsPictured && mapper ? mapper->GetVBOShiftScaleMethod() : other->GetVBOShiftScaleMethod();
  if (!mapper || mapper->GetVBOShiftScaleMethod() != shift)
  {
    const auto made = vtkSmartPointer<BlockMapper>::New();
    vtkLandscapePass::MapWaterArrays(made); // composite mappers have no such arrays
    this->MapperTime = 0;
    this->Mapper = mapper = made;
    this->Actor->SetMapper(mapper);
  }
  mapper->SetTextured(part.Textured != nullptr);
  mapper->vtkMapper::ShallowCopy(like); // its input is another one
  mapper->SetVBOShiftScaleMethod(shift);
  mapper->SetSeamlessU(other->GetSeamlessU());
  mapper->SetSeamlessV(other->GetSeamlessV());
  // Each mapper of a view has a selection of its own, and pictures, which have none, would be taken anew for another.
  if (!part.IsPictured)
  {
    TakeSelection(mapper, other);
  }
  mapper->SetBlockIndex(part.BlockIndex);
  if (mapper->GetInputDataObject(0, 0) != part.Block)
  {
    mapper->SetInputData(part.Block);
  }
}

//----------------------------------------------------------------------------
void BlockActor::TakeInstances(const PartOfTree& part, vtkMapper* like)
{
  auto* mapper = InstanceMapper::SafeDownCast(this->Mapper);
  if (!mapper)
  {
    const auto made = vtkSmartPointer<InstanceMapper>::New();
    this->MapperTime = 0;
    this->Mapper = mapper = made;
    this->Actor->SetMapper(mapper);
  }
  mapper->SetTextured(part.Textured != nullptr);
  mapper->vtkMapper::ShallowCopy(like); // its input is another one
  mapper->SetInputData(part.Prototype);
  mapper->SetInstances(part.Instances, part.InCoarseMaps);
  mapper->SetFadeRange(part.FadeRange[0], part.FadeRange[1]);
}

//----------------------------------------------------------------------------
/// Pictures are taken anew only of other arrays: the blocks themselves are new whenever a plant changes its level.
void BlockActor::TakeImpostors(const PartOfTree& part, vtkActor* like, vtkMapper* mapper, bool isLit)
{
  auto* own = vtkImpostorMapper::SafeDownCast(this->Mapper);
  if (!own)
  {
    const auto made = vtkSmartPointer<vtkImpostorMapper>::New();
    made->SetFrames(7); // a second or two of software rendering for the plants of a forest
    this->Mapper = own = made;
    this->Actor->SetMapper(own);
    this->Plant.clear();
  }
  const auto isSame = [](const PlantPart& a, const PlantPart& b) {
    return LooksLike(a.Block, b.Block) && a.Transmittance == b.Transmittance;
  };
  if (!std::equal(this->Plant.begin(), this->Plant.end(), part.Plant.begin(), part.Plant.end(), isSame))
  {
    this->Plant = part.Plant;
    own->RemoveAllParts();
    this->PlantActors.clear();
    for (std::size_t k = 0; k < this->Plant.size(); ++k)
    {
      this->PlantActors.push_back(std::make_unique<BlockActor>());
      own->AddPart(this->PlantActors.back()->Actor);
    }
  }
  vtkNew<vtkActor> atOrigin;
  atOrigin->SetProperty(like->GetProperty());
  for (std::size_t k = 0; k < this->Plant.size(); ++k)
  {
    PartOfTree block;
    block.Tree = block.Block = this->Plant[k].Block;
    block.Textured = IsTextured(block.Block) ? block.Tree : nullptr;
    block.Attributes = vtkSmartPointer<vtkCompositeDataDisplayAttributes>::New();
    block.Transmittance = this->Plant[k].Transmittance;
    block.IsPictured = true;
    this->PlantActors[k]->Draw(block, atOrigin, mapper, isLit);
  }
  own->SetFadeRange(part.FadeRange[0], part.FadeRange[1]);
  if (own->GetInput() != part.Places)
  {
    own->SetInputData(part.Places);
  }
}

//----------------------------------------------------------------------------
void BlockActor::TakeTexture(vtkDataObject* block, vtkShaderProperty* given, bool isLit)
{
  const bool hasNormals = block && IsPicture(FieldOf(block, NormalsName), FieldOf(block, SizeName), 3);
  const Shading textured = !isLit ? Shading::Unlit : hasNormals ? Shading::TextureWithNormals : Shading::Texture;
  this->SetShading(block ? textured : Shading::Plain, given);
  this->Actor->SetForceOpaque(block != nullptr);
  this->Actor->SetTexture(block ? this->Colors.Texture.Get() : nullptr);
  if (block)
  {
    this->Colors.Show(FieldOf(block, TextureName), FieldOf(block, SizeName));
    this->TakeMean(block);
  }
  const bool isRough = hasNormals && isLit;
  if (isRough)
  {
    this->Normals.Show(FieldOf(block, NormalsName), FieldOf(block, SizeName));
  }
  vtkProperty* property = this->Actor->GetProperty();
  if (isRough && !property->GetTexture(NormalsUniform))
  {
    property->SetTexture(NormalsUniform, this->Normals.Texture);
  }
  else if (!isRough && property->GetTexture(NormalsUniform) == this->Normals.Texture)
  {
    property->RemoveTexture(NormalsUniform);
  }
}

//----------------------------------------------------------------------------
/// Any change of the replacements builds the shader anew. VTK keeps one replacement a step: where a user gives one for
/// a step of ours, ours takes the place of what is replaced in it, and without that the user's alone holds.
void BlockActor::SetShading(Shading shading, vtkShaderProperty* given)
{
  const vtkMTimeType time = given->GetNumberOfShaderReplacements() > 0 ? given->GetShaderMTime() : 0;
  if (this->Shaded == shading && this->GivenTime == time)
  {
    return;
  }
  this->Shaded = shading;
  this->GivenTime = time;
  std::map<std::string, std::string> own; // code by step
  if (shading != Shading::Plain)
  {
    own = { { LightStep, CutOutCode }, { ColorStep, ColorCode } };
  }
  if (shading == Shading::Texture || shading == Shading::TextureWithNormals)
  {
    own[NormalStep] = shading == Shading::TextureWithNormals ? NormalCode : BothSidesCode;
  }
  vtkShaderProperty* shader = this->Actor->GetShaderProperty();
  shader->ClearAllShaderReplacements();
  for (const auto& [step, code] : own)
  {
    shader->AddFragmentShaderReplacement(step, true, code, false);
  }
  for (int k = 0; k < given->GetNumberOfShaderReplacements(); ++k)
  {
    std::string name, code;
    bool isFirst = false, isAll = false;
    given->GetNthShaderReplacement(k, name, isFirst, code, isAll);
    const std::string stage = given->GetNthShaderReplacementTypeAsString(k);
    if (stage == "Vertex")
    {
      shader->AddVertexShaderReplacement(name, isFirst, code, isAll);
    }
    else if (stage == "Fragment")
    {
      const auto ours = own.find(name);
      const std::size_t place = code.find(name);
      if (isFirst && ours != own.end() && place != std::string::npos)
      {
        code.replace(place, name.size(), ours->second);
      }
      shader->AddFragmentShaderReplacement(name, isFirst, code, isAll);
    }
    else if (stage == "Geometry")
    {
      shader->AddGeometryShaderReplacement(name, isFirst, code, isAll);
    }
  }
}

//----------------------------------------------------------------------------
/// Keys are of this actor alone: passes that draw it leave theirs in them.
void BlockActor::TakeKeys(vtkInformation* given, double transmittance, bool isBark)
{
  this->Keys->Copy(given);
  if (transmittance > 0.0)
  {
    this->Keys->Set(vtkLandscapePass::TRANSMITTANCE(), transmittance);
  }
  if (isBark && vtkLandscapePass::GetMaterial(this->Actor) == vtkLandscapePass::Surface)
  {
    this->Keys->Set(vtkLandscapePass::MATERIAL(), vtkLandscapePass::Bark);
  }
}

//----------------------------------------------------------------------------
void BlockActor::TakeMean(vtkDataObject* block)
{
  vtkDataArray* given = FieldOf(block, MeanName);
  std::array<float, 3> mean{ 1.0F, 1.0F, 1.0F };
  for (int part = 0; given && given->GetNumberOfValues() == 3 && part < 3; ++part)
  {
    mean[part] = std::max(static_cast<float>(given->GetVariantValue(part).ToDouble()), 1.0F / 255.0F);
  }
  this->Actor->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniform3f("textureMean", mean.data());
}

}
