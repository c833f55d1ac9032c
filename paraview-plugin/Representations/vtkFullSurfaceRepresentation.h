// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFullSurfaceRepresentation
 * @brief   a surface with the textures of its blocks, not decimated while the camera moves
 *
 * Each block that carries a texture as field data (littoral::BlockActor) is drawn with it; ParaView 5.11 has one
 * texture for all blocks. Visibility, color and opacity of blocks, selection and picking are those of a surface. Blocks
 * that points place as instances (littoral::InstancedBlocks), such as those of vtkPlantScatterFilter, are drawn at each
 * point, and cannot be picked.
 *
 * Interactive pictures of a large scene show what a representation offers as its level of detail. Here it is the
 * surface itself: data that follow the camera have levels of detail of their own, and a new surface is shown in the
 * frame in which it was made, with rendering on the client and on a server. (The property SuppressLOD of
 * vtkGeometryRepresentation offers nothing, so that a surface which changes between two interactive pictures vanishes.)
 *
 * What ParaView does anew for each frame of moving data is spared. Bounds are those of the points, where
 * vtkGeometryRepresentation looks for the points that cells use; and where all blocks are polygonal data without
 * strips and ghost cells, cells and points are not given the numbers of those they came from, which are their own, and
 * keep the numbers of their blocks (littoral::BlockSurfaces). Where a block is textured, only arrays that have changed
 * are sent to the graphics (littoral::BlockMapper).
 */
#ifndef vtkFullSurfaceRepresentation_h
#define vtkFullSurfaceRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkGeometryRepresentationWithFaces.h"

#include <memory> // for the textured blocks

namespace littoral
{
class TexturedBlocks;
}

class LITTORALREPRESENTATIONS_EXPORT vtkFullSurfaceRepresentation : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkFullSurfaceRepresentation* New();
  vtkTypeMacro(vtkFullSurfaceRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* in, vtkInformation* out) override;

  void SetVisibility(bool isVisible) override;

  /// Ignored: the level of detail is the surface.
  void SetSuppressLOD(bool) override {}

protected:
  vtkFullSurfaceRepresentation();
  ~vtkFullSurfaceRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  int RequestData(vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /// Whether an opacity is below 1. Colors and textures count as opaque: ParaView 5.11 takes direct colors for
  /// translucent, and redistributes all data among its ranks for each picture, which ends it in interactive ones.
  bool NeedsOrderedCompositing() override;

private:
  vtkFullSurfaceRepresentation(const vtkFullSurfaceRepresentation&) = delete;
  void operator=(const vtkFullSurfaceRepresentation&) = delete;

  void DrawTextures(bool attributesChanged);
  void TakeBoundsOfPoints();

  std::unique_ptr<littoral::TexturedBlocks> Textured;
  int Material = 0; ///< vtkLandscapePass::Surface
};

#endif
