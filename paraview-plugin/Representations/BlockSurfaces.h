// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralBlockSurfaces_h
#define LittoralBlockSurfaces_h

#include "vtkPVGeometryFilter.h"
#include "vtkSmartPointer.h" // for what is kept

#include <map>

class vtkDataArray;

namespace littoral
{

/// Whether the surface of data has their cells and points, in their order.
bool IsItsOwnSurface(vtkDataObject* data);

/**
 * ParaView's geometry filter, which passes blocks that are their own surface with the numbers of blocks that it gave
 * them before.
 *
 * ParaView 5.11 writes the number of its block to each point and cell, anew for each block of data that have changed,
 * and then looks for the range of these numbers. Here an array of them is kept while there are as many points or cells,
 * in a byte each up to number 255.
 */
class BlockSurfaces : public vtkPVGeometryFilter
{
public:
  static BlockSurfaces* New();
  vtkTypeMacro(BlockSurfaces, vtkPVGeometryFilter);

protected:
  BlockSurfaces() = default;
  ~BlockSurfaces() override = default;

  int RequestDataObjectTree(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  BlockSurfaces(const BlockSurfaces&) = delete;
  void operator=(const BlockSurfaces&) = delete;

  /// The numbers of the points and of the cells of a block.
  struct Numbers
  {
    vtkSmartPointer<vtkDataArray> OfPoints, OfCells;
  };
  std::map<unsigned int, Numbers> Kept; ///< numbers by the index of the block in its tree
};

}

#endif
