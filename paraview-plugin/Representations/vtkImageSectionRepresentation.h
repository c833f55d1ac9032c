// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImageSectionRepresentation
 * @brief   an image as sections through it
 *
 * What vtkImageSectionFilter cuts of an image.
 */
#ifndef vtkImageSectionRepresentation_h
#define vtkImageSectionRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkFilteredSurfaceRepresentation.h"

class LITTORALREPRESENTATIONS_EXPORT vtkImageSectionRepresentation : public vtkFilteredSurfaceRepresentation
{
public:
  static vtkImageSectionRepresentation* New();
  vtkTypeMacro(vtkImageSectionRepresentation, vtkFilteredSurfaceRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkImageSectionRepresentation();
  ~vtkImageSectionRepresentation() override;

private:
  vtkImageSectionRepresentation(const vtkImageSectionRepresentation&) = delete;
  void operator=(const vtkImageSectionRepresentation&) = delete;
};

#endif
