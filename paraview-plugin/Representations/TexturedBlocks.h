// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTexturedBlocks_h
#define LittoralTexturedBlocks_h

#include "BlockActor.h"

#include "vtkWeakPointer.h" // for the view

#include <functional>
#include <memory>
#include <vector>

class vtkPVDataRepresentation;
class vtkPVRenderView;

namespace littoral
{

/// Blocks in a view, each texture with an actor of its own, where some of them carry one.
class TexturedBlocks
{
public:
  /// Copies what a user chose for blocks, such as their visibility, to a tree of them.
  using TakeAttributes = std::function<void(vtkCompositeDataDisplayAttributes*, vtkDataObject*)>;

  /// The view that shows the blocks of a representation; null: none.
  void SetView(vtkPVRenderView* view, vtkPVDataRepresentation* representation);

  /// Draws data of which a block is textured, or large, as an actor with its mapper would. False if there is no such
  /// block.
  bool Draw(vtkDataObject* data, vtkActor* like, vtkMapper* mapper, bool attributesChanged, const TakeAttributes& take);

  /// Draws nothing.
  void Hide();

private:
  void Split(vtkDataObject* data, bool isDraped);
  void AddActor();

  vtkWeakPointer<vtkPVRenderView> View;
  vtkPVDataRepresentation* Representation = nullptr;
  std::vector<std::unique_ptr<BlockActor>> Actors; ///< as many as were ever needed
  std::vector<PartOfTree> Parts;                   ///< none without textures
  vtkSmartPointer<vtkDataObject> Data;             ///< data that were split
  vtkMTimeType DataTime = 0;
  bool IsDraped = false; ///< whether they had a picture of the user's
};

}

#endif
