// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMPresetProxy
 * @brief   a source whose properties show the numbers of its preset
 *
 * Unless the property Preset is Custom, the source takes its numbers from the preset and ignores the properties that
 * Custom uses. This proxy sets these to the numbers of the preset at each update, so that the panel, Python and state
 * files tell what is grown, and Custom continues from the last preset. It needs no window.
 */
#ifndef vtkSMPresetProxy_h
#define vtkSMPresetProxy_h

#include "LittoralClientProxiesModule.h" // for export macro
#include "vtkSMNaturalDisplayProxy.h"

class LITTORALCLIENTPROXIES_EXPORT vtkSMPresetProxy : public vtkSMNaturalDisplayProxy
{
public:
  static vtkSMPresetProxy* New();
  vtkTypeMacro(vtkSMPresetProxy, vtkSMNaturalDisplayProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMPresetProxy();
  ~vtkSMPresetProxy() override;

private:
  vtkSMPresetProxy(const vtkSMPresetProxy&) = delete;
  void operator=(const vtkSMPresetProxy&) = delete;

  void ShowPreset();
};

#endif
