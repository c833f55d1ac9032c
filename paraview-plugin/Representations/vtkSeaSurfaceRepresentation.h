// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSeaSurfaceRepresentation
 * @brief   a sea state as the surface of the sea
 *
 * The disk that vtkSeaSurfaceFilter makes of a table of wave trains, at the time of the view. What is near the eye is
 * shown too: the clipping planes of the view are set for both.
 */
#ifndef vtkSeaSurfaceRepresentation_h
#define vtkSeaSurfaceRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkFilteredSurfaceRepresentation.h"

class LITTORALREPRESENTATIONS_EXPORT vtkSeaSurfaceRepresentation : public vtkFilteredSurfaceRepresentation
{
public:
  static vtkSeaSurfaceRepresentation* New();
  vtkTypeMacro(vtkSeaSurfaceRepresentation, vtkFilteredSurfaceRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSeaSurfaceRepresentation();
  ~vtkSeaSurfaceRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkSeaSurfaceRepresentation(const vtkSeaSurfaceRepresentation&) = delete;
  void operator=(const vtkSeaSurfaceRepresentation&) = delete;
};

#endif
