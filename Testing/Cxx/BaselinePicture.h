// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BaselinePicture_h
#define BaselinePicture_h

#include "vtkNew.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"

/// Renders a window and compares it with the baseline of the test; with -I in the arguments it stays.
inline bool IsAsBaseline(vtkRenderWindow* window, int argc, char* argv[])
{
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  window->Render();
  const int result = vtkRegressionTestImage(window);
  if (result == vtkRegressionTester::DO_INTERACTOR)
  {
    interactor->Start();
  }
  return result != vtkRegressionTester::FAILED;
}

#endif
