// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainReliefRepresentation
 * @brief   an image of elevations as relief
 *
 * The surface z = elevation [m], with the array that vtkTerrainLevelOfDetailFilter takes (`Elevation`, else the active
 * scalars), its normals, and the colors of the ground as `RGB` where the image has none of this name.
 */
#ifndef vtkTerrainReliefRepresentation_h
#define vtkTerrainReliefRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkFilteredSurfaceRepresentation.h"

class LITTORALREPRESENTATIONS_EXPORT vtkTerrainReliefRepresentation : public vtkFilteredSurfaceRepresentation
{
public:
  static vtkTerrainReliefRepresentation* New();
  vtkTypeMacro(vtkTerrainReliefRepresentation, vtkFilteredSurfaceRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkTerrainReliefRepresentation();
  ~vtkTerrainReliefRepresentation() override;

private:
  vtkTerrainReliefRepresentation(const vtkTerrainReliefRepresentation&) = delete;
  void operator=(const vtkTerrainReliefRepresentation&) = delete;
};

#endif
