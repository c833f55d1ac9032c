// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBlockActor_h
#define LittoralBlockActor_h

#include "Instances.h"

#include "vtkDataObject.h"   // for the block
#include "vtkNew.h"          // for what is drawn
#include "vtkSmartPointer.h" // for the mapper

#include <array>
#include <memory>
#include <vector>

class vtkActor;
class vtkCompositeDataDisplayAttributes;
class vtkDataArray;
class vtkInformation;
class vtkMapper;
class vtkMatrix4x4;
class vtkProp;
class vtkProperty;
class vtkShaderProperty;
class vtkTexture;

namespace littoral
{

/// A block of a plant, and the light that comes through it.
struct PlantPart
{
  vtkSmartPointer<vtkPolyData> Block;
  double Transmittance;
};

/// Leaves of a tree of blocks, in a tree of the same branches, so that they keep their indices.
struct PartOfTree
{
  vtkSmartPointer<vtkDataObject> Textured; ///< the only leaf, if it carries a texture; else null
  vtkSmartPointer<vtkDataObject> Tree;
  vtkSmartPointer<vtkCompositeDataDisplayAttributes> Attributes; ///< of its blocks
  vtkSmartPointer<vtkPolyData> Block;                            ///< the only leaf, if it is a surface; else null
  unsigned int BlockIndex = 0;                                   ///< of the only leaf in the tree
  vtkSmartPointer<vtkPolyData> Prototype;                        ///< drawn in place of the tree where it has instances
  std::shared_ptr<const InstanceBatch> Instances;
  std::shared_ptr<const InstanceBatch> InCoarseMaps; ///< of depths; null: the same
  std::vector<PlantPart> Plant;                ///< drawn in place of the prototype by pictures of it, if there is one
  vtkSmartPointer<vtkPolyData> Places;         ///< of such plants
  std::array<double, 2> FadeRange{ 0.0, 0.0 }; ///< distances between which such plants appear, and others disappear
  double Transmittance = 0.0;                  ///< of the light on the far side of surfaces (vtkLandscapePass)
  bool IsBark = false;                         ///< its material
  bool IsPictured = false;                     ///< whether it is seen in pictures of a plant alone
};

/**
 * The actor of a block that carries a texture, of a prototype at its instances, or of all blocks that are neither.
 *
 * A texture is field data of its block: `Texture`, RGBA texels in rows from the bottom, and `TextureSize`, columns and
 * rows. A fragment has the color of the surface times the texel, divided by `TextureMean`, 3 numbers above 0 to 1, if
 * the block has one: so the points have the colors of the block as it is without a texture. Fragments with an alpha
 * below 0.5 are discarded; the others are opaque and need no sorting. `NormalTexture`, RGB texels of the same size,
 * holds normals in the frame of the texture: along u, along v and towards the viewer, -1 to 1 as 0 to 255.
 */
class BlockActor
{
public:
  BlockActor();
  ~BlockActor();
  BlockActor(const BlockActor&) = delete;
  BlockActor& operator=(const BlockActor&) = delete;

  /// Whether a block carries a texture, of as many texels as it says.
  static bool IsTextured(vtkDataObject* block);

  /// Draws blocks as an actor with its mapper would, in a view with lights or without. Where nothing changed, nothing
  /// is modified: what follows from it, such as maps of shadows, is kept.
  void Draw(const PartOfTree& part, vtkActor* like, vtkMapper* mapper, bool isLit);

  /// Draws nothing, and keeps nothing.
  void Hide();

  vtkProp* GetProp();

private:
  enum class Shading
  {
    Plain,
    Unlit, ///< texture without lights, for which VTK makes no normals
    Texture,
    TextureWithNormals
  };

  /// A texture and the texels that it shows.
  struct Picture
  {
    vtkNew<vtkTexture> Texture;
    vtkSmartPointer<vtkDataArray> Texels;
    vtkMTimeType Time = 0;

    Picture();
    void Show(vtkDataArray* texels, vtkDataArray* size);
  };

  void TakeMapper(const PartOfTree& part, vtkMapper* like);
  void TakeBlock(const PartOfTree& part, vtkMapper* like);
  void TakeInstances(const PartOfTree& part, vtkMapper* like);
  void TakeImpostors(const PartOfTree& part, vtkActor* like, vtkMapper* mapper, bool isLit);
  void TakeTexture(vtkDataObject* block, vtkShaderProperty* given, bool isLit);
  void TakeKeys(vtkInformation* given, double transmittance, bool isBark);
  void SetShading(Shading shading, vtkShaderProperty* given);
  void TakeMean(vtkDataObject* block);

  vtkNew<vtkActor> Actor;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkNew<vtkInformation> Keys;
  vtkSmartPointer<vtkMapper> Mapper;
  std::vector<PlantPart> Plant;                         ///< of the impostors
  std::vector<std::unique_ptr<BlockActor>> PlantActors; ///< of its parts
  Picture Colors;
  Picture Normals;
  Shading Shaded = Shading::Plain;
  vtkProperty* GivenProperty = nullptr; ///< copied last, at its time
  vtkMTimeType PropertyTime = 0;
  vtkMTimeType MapperTime = 0; ///< of what the mapper of a tree was copied from
  vtkMTimeType GivenTime = 0;  ///< of the replacements in the shader that a user gave
};

}

#endif
