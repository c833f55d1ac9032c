// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMChartDisplayProxy
 * @brief   a source of tables that are first shown as charts ready to print
 *
 * See littoral::ChartDisplay for the hints.
 */
#ifndef vtkSMChartDisplayProxy_h
#define vtkSMChartDisplayProxy_h

#include "LittoralClientProxiesModule.h" // for export macro
#include "vtkSMSourceProxy.h"

#include <memory> // for the display

namespace littoral
{
class ChartDisplay;
}

class LITTORALCLIENTPROXIES_EXPORT vtkSMChartDisplayProxy : public vtkSMSourceProxy
{
public:
  static vtkSMChartDisplayProxy* New();
  vtkTypeMacro(vtkSMChartDisplayProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMChartDisplayProxy();
  ~vtkSMChartDisplayProxy() override;

private:
  vtkSMChartDisplayProxy(const vtkSMChartDisplayProxy&) = delete;
  void operator=(const vtkSMChartDisplayProxy&) = delete;

  std::unique_ptr<littoral::ChartDisplay> Display;
};

#endif
