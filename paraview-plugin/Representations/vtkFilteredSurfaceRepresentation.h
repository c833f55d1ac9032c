// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFilteredSurfaceRepresentation
 * @brief   the surface that a filter makes of the data
 *
 * Data that are no surface, such as an image of elevations or a table of wave trains, are shown as what they describe:
 * subclasses choose the filter. It runs on the first rank, with all of the data, as the filters do that are chosen; its
 * arrays can color the surface. Where it knows times, the surface changes with the time of the view.
 */
#ifndef vtkFilteredSurfaceRepresentation_h
#define vtkFilteredSurfaceRepresentation_h

#include "LittoralRepresentationsModule.h" // for export macro
#include "vtkFullSurfaceRepresentation.h"
#include "vtkSmartPointer.h" // for the filter

class vtkAlgorithm;
class vtkTrivialProducer;

class LITTORALREPRESENTATIONS_EXPORT vtkFilteredSurfaceRepresentation : public vtkFullSurfaceRepresentation
{
public:
  vtkTypeMacro(vtkFilteredSurfaceRepresentation, vtkFullSurfaceRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using Superclass::GetInternalOutputPort;
  /// The filter in place of the data.
  vtkAlgorithmOutput* GetInternalOutputPort(int port, int connection) override;

protected:
  vtkFilteredSurfaceRepresentation();
  ~vtkFilteredSurfaceRepresentation() override;

  /// Sets the filter; for the constructor of a subclass.
  void SetFilter(vtkAlgorithm* filter);

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFilteredSurfaceRepresentation(const vtkFilteredSurfaceRepresentation&) = delete;
  void operator=(const vtkFilteredSurfaceRepresentation&) = delete;

  void UpdateFilter(vtkInformation* input);

  vtkSmartPointer<vtkAlgorithm> Filter;
  vtkSmartPointer<vtkTrivialProducer> Shown; ///< output of the filter, on the first rank
};

#endif
