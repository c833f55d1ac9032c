// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMNaturalDisplayProxy
 * @brief   a source that is first shown in its own colors
 *
 * See littoral::NaturalDisplay for how, and for the hint that says more. Outputs that are tables may have charts.
 *
 * Its panel has the properties in the order of their groups, after those without one: inherited properties, such as the
 * view, would come first.
 */
#ifndef vtkSMNaturalDisplayProxy_h
#define vtkSMNaturalDisplayProxy_h

#include "LittoralClientProxiesModule.h" // for export macro
#include "vtkSMChartDisplayProxy.h"
#include "vtkSmartPointer.h" // for the scene

#include <memory> // for the display

namespace littoral
{
class NaturalDisplay;
}

class LITTORALCLIENTPROXIES_EXPORT vtkSMNaturalDisplayProxy : public vtkSMChartDisplayProxy
{
public:
  static vtkSMNaturalDisplayProxy* New();
  vtkTypeMacro(vtkSMNaturalDisplayProxy, vtkSMChartDisplayProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

  /// Takes the state of undo and redo.
  void LoadState(const vtkSMMessage* message, vtkSMProxyLocator* locator) override;

  /**
   * Attributes that take the place of the hint NaturalDisplay of the type, for a part of a scene.
   */
  void SetLook(vtkPVXMLElement* look);

protected:
  vtkSMNaturalDisplayProxy();
  ~vtkSMNaturalDisplayProxy() override;

  void CreateVTKObjects() override;
  int CreateSubProxiesAndProperties(vtkSMSessionProxyManager* manager, vtkPVXMLElement* element) override;

private:
  vtkSMNaturalDisplayProxy(const vtkSMNaturalDisplayProxy&) = delete;
  void operator=(const vtkSMNaturalDisplayProxy&) = delete;

  std::unique_ptr<littoral::NaturalDisplay> Display;
  vtkSmartPointer<vtkPVXMLElement> Scene; ///< scene that begins with this source, if any
};

#endif
