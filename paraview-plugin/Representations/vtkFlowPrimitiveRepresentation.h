// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlowPrimitiveRepresentation
 * @brief   flow primitives as arrows and rings
 *
 * What vtkFlowArrowFilter draws of the data.
 */
#ifndef vtkFlowPrimitiveRepresentation_h
#define vtkFlowPrimitiveRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkFilteredSurfaceRepresentation.h"

class LITTORALREPRESENTATIONS_EXPORT vtkFlowPrimitiveRepresentation : public vtkFilteredSurfaceRepresentation
{
public:
  static vtkFlowPrimitiveRepresentation* New();
  vtkTypeMacro(vtkFlowPrimitiveRepresentation, vtkFilteredSurfaceRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkFlowPrimitiveRepresentation();
  ~vtkFlowPrimitiveRepresentation() override;

private:
  vtkFlowPrimitiveRepresentation(const vtkFlowPrimitiveRepresentation&) = delete;
  void operator=(const vtkFlowPrimitiveRepresentation&) = delete;
};

#endif
