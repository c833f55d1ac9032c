// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportPlantBlocks_h
#define LittoralSupportPlantBlocks_h

// Plants between the numerics and VTK: the one place that knows names and types of their blocks and arrays. Private:
// never installed, never wrapped.

#include "Data/Arrays.h"
#include "Data/Blocks.h"
#include "Plants/PlantPrototype.h"
#include "Plants/StandBinding.h"
#include "Plants/WoodParameters.h"
#include "Sway/LeafMotion.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;

namespace littoral
{

/// Names of blocks and arrays.
namespace plant
{
constexpr const char* High = "High";
constexpr const char* Medium = "Medium";
constexpr const char* Low = "Low";
constexpr const char* Skeleton = "Skeleton";
constexpr const char* Skin = "Skin";
constexpr const char* Leaves = "Leaves";
constexpr const char* Trunk = "Trunk";
constexpr const char* Crown = "Crown";
constexpr const char* RGB = "RGB";
constexpr const char* JointIds = "JointIds";
constexpr const char* JointWeights = "JointWeights";
constexpr const char* ParentId = "ParentId";
constexpr const char* Radius = "Radius";
constexpr const char* BranchId = "BranchId";
constexpr const char* Order = "Order";
constexpr const char* Texture = "Texture";
constexpr const char* TextureSize = "TextureSize";
constexpr const char* TextureMean = "TextureMean";
constexpr const char* NormalTexture = "NormalTexture";
constexpr const char* Envelope = "Envelope";
constexpr const char* ImpostorExtent = "ImpostorExtent";
constexpr const char* ImpostorAreas = "ImpostorAreas";
constexpr const char* PlantId = "PlantId";
constexpr const char* Wood = "Wood";
}

/// A color with parts from 0 to 1 as bytes.
Color ColorOf(const double from[3]);

// Plants to blocks.

/// Polygons with all that the mesh says of its vertices.
vtkSmartPointer<vtkPolyData> PolyDataOf(const PlantMesh& mesh);

/// A polyline a branch.
vtkSmartPointer<vtkPolyData> PolyDataOf(const Skeleton& skeleton, const Color& bark);

/// High {Skeleton, Skin, Leaves}, Medium {Trunk, Crown} and Low.
void CopyToBlocks(const PlantPrototype& prototype, vtkMultiBlockDataSet* blocks);

/// A texture as field data of the block that it belongs to.
void AttachTexture(vtkDataObject* block, const TextureImage& texture);

/// The mean color of a texture, by which a renderer divides.
void AttachTextureMean(vtkDataObject* block, const ColorSum& mean);

/// Normals of the texels of a texture, as bytes.
void AttachNormalTexture(vtkDataObject* block, const std::vector<Color>& normals);

/// A texture as an image, for vtkTexture.
void CopyToImage(const TextureImage& texture, vtkImageData* image);

// Blocks to plants, which must have the form that PlantForm.h checks.

/// A part of a level; null where there is none.
vtkPolyData* PlantPartOf(vtkMultiBlockDataSet* plants, const char* level, const char* part);

/// The points of a block in single precision; null where it has others or none.
vtkFloatArray* FloatPointsOf(vtkPolyData* block);

/// The skeleton of a block, all plants in one. Throws InvalidInput if there is none.
Skeleton ReadSkeleton(vtkPolyData* block);

/// Throws InvalidInput if points or normals of a skin or of leaves are not of single precision.
void RequireRest(vtkPolyData* block, const char* name);

/// Throws InvalidInput if these or the joints of a skin or of leaves are bad.
void RequireSkin(vtkPolyData* block, const char* name, std::size_t joints);

/// The normals of a block in single precision; null where it has others or none.
vtkFloatArray* FindNormals(vtkPolyData* block);

/// The skin of a block, which is good; valid as long as the block.
RestSkin ReadSkin(vtkPolyData* block);

/// The joints that it follows.
SkinBinding ReadBinding(vtkPolyData* block);

/// The four joints of each of its vertices.
const int* ReadJointIds(vtkPolyData* block);

/// The four weights of each of its vertices.
const float* ReadJointWeights(vtkPolyData* block);

/// The plants of points; null if they do not tell. Throws InvalidInput if they do so in another form.
vtkIntArray* FindPlantIds(vtkPolyData* block);

/// The leaves of a block, whose skin is good.
std::vector<LeafCorners> ReadLeaves(vtkPolyData* block);

/// The leaves of a block whose vertices follow joints by a binding.
std::vector<LeafCorners> ReadLeaves(vtkPolyData* block, const StandBinding& binding);

/// The wood that a plant says it is of, as field data `Wood`; false where it does not.
bool ReadWood(vtkDataObject* plant, WoodParameters& wood);

/// Columns and rows as an array tells them; 0 0 if it does not.
std::array<int, 2> ReadTextureSize(vtkDataArray* size);

/// Columns and rows of the picture that a block carries; 0 0 if it has none.
std::array<int, 2> ReadTextureSize(vtkPolyData* block);

/// The picture that a block carries; empty if it has none.
TextureImage ReadTexture(vtkPolyData* block);

/// The mean color of the picture that a block carries; white if it tells none.
ColorSum ReadTextureMean(vtkPolyData* block);

/// Whether the crown of the level Medium is an envelope with a cylindrical projection.
bool IsEnvelope(vtkPolyData* crown);

/// The impostor of a block of the level Low; without pictures if it carries none.
PlantImpostor ReadImpostor(vtkPolyData* low);

/// Polygons with colors and texture coordinates.
PlantMesh ReadMesh(vtkPolyData* block);

}

#endif
