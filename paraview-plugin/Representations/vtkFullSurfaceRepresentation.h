// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFullSurfaceRepresentation
 * @brief   a surface that is not decimated while the camera moves
 *
 * Interactive pictures of a large scene show what a representation offers as its level of detail. Here it is the
 * surface itself: data that follow the camera have levels of detail of their own, and a new surface is shown in the
 * frame in which it was made, with rendering on the client and on a server. (The property SuppressLOD of
 * vtkGeometryRepresentation offers nothing, so that a surface which changes between two interactive pictures vanishes.)
 */
#ifndef vtkFullSurfaceRepresentation_h
#define vtkFullSurfaceRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkGeometryRepresentationWithFaces.h"

class LITTORALREPRESENTATIONS_EXPORT vtkFullSurfaceRepresentation : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkFullSurfaceRepresentation* New();
  vtkTypeMacro(vtkFullSurfaceRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(vtkInformationRequestKey* request, vtkInformation* in, vtkInformation* out) override;

  /// Ignored: the level of detail is the surface.
  void SetSuppressLOD(bool) override {}

protected:
  vtkFullSurfaceRepresentation();
  ~vtkFullSurfaceRepresentation() override;

private:
  vtkFullSurfaceRepresentation(const vtkFullSurfaceRepresentation&) = delete;
  void operator=(const vtkFullSurfaceRepresentation&) = delete;
};

#endif
