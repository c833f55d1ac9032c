// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMLandscapeProxy
 * @brief   a small pipeline behind one menu entry that is first shown in its own colors
 *
 * See littoral::NaturalDisplay for how, and for the hint that says more.
 */
#ifndef vtkSMLandscapeProxy_h
#define vtkSMLandscapeProxy_h

#include "LittoralClientProxiesModule.h" // for export macro
#include "vtkSMCompoundSourceProxy.h"

#include <memory> // for the display

namespace littoral
{
class NaturalDisplay;
}

class LITTORALCLIENTPROXIES_EXPORT vtkSMLandscapeProxy : public vtkSMCompoundSourceProxy
{
public:
  static vtkSMLandscapeProxy* New();
  vtkTypeMacro(vtkSMLandscapeProxy, vtkSMCompoundSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

  /**
   * Takes times from the pipeline inside, also for the animation. ParaView's time keeper leaves out the producers of
   * what it adds, and of a compound proxy these are, by their parent, itself.
   */
  void UpdatePipelineInformation() override;

protected:
  vtkSMLandscapeProxy();
  ~vtkSMLandscapeProxy() override;

private:
  vtkSMLandscapeProxy(const vtkSMLandscapeProxy&) = delete;
  void operator=(const vtkSMLandscapeProxy&) = delete;

  std::unique_ptr<littoral::NaturalDisplay> Display;
};

#endif
