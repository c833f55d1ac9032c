// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Light by vtkLandscapePass with OpenGL 3.2 without sampler objects: shadows are not soft, one sentence says so, and
// all else is there.
#include "LandscapePicture.h"

#include "vtkCallbackCommand.h"

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

/// Counts warnings, and keeps the last.
struct Warnings
{
  int Count = 0;
  std::string Last;
};

void Take(vtkObject*, unsigned long, void* warnings, void* text)
{
  auto* taken = static_cast<Warnings*>(warnings);
  ++taken->Count;
  taken->Last = static_cast<const char*>(text);
}

/// Light below a board over that of the open ground, in two pictures of the best quality.
double Shadow(Picture& picture)
{
  picture.Pass->SetQuality(vtkLandscapePass::Best);
  picture.Pass->SetSunElevation(89.0);
  picture.Add(Level(20.0), 0.3);
  picture.Add(Box({ -3.0, 0.0, 3.0 }, { 4.0, 8.0, 0.1 }), 0.3);
  picture.Look({ 0.0, -12.0, 1.0 }, { 0.0, 0.0, 0.5 }, { 0.0, 0.0, 1.0 });
  picture.Draw();
  picture.Look({ 0.0, -12.0, 1.2 }, { 0.0, 0.0, 0.5 }, { 0.0, 0.0, 1.0 });
  picture.Draw();
  const auto at = [&](double x) {
    picture.Renderer->SetWorldPoint(x, 0.0, 0.0, 1.0);
    picture.Renderer->WorldToDisplay();
    const double* place = picture.Renderer->GetDisplayPoint();
    return picture.LinearAt(static_cast<int>(place[0]), static_cast<int>(place[1]))[1];
  };
  return at(-3.0) / at(3.0);
}

}

int TestLandscapeOldDriver(int, char*[])
{
  // Mesa reads these when a context is made, once a process.
  setenv("MESA_GL_VERSION_OVERRIDE", "3.2", 1);
  setenv("MESA_GLSL_VERSION_OVERRIDE", "150", 1);
  setenv("MESA_EXTENSION_OVERRIDE", "-GL_ARB_sampler_objects", 1);
  Picture picture;
  picture.Window->Render();
  const std::string driver = picture.Window->ReportCapabilities();
  if (driver.find("OpenGL version string:  3.2") == std::string::npos)
  {
    std::cout << "No driver that may be told to be older" << std::endl;
    return 125; // skipped, as in VTK
  }
  Warnings warnings;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(Take);
  observer->SetClientData(&warnings);
  picture.Pass->AddObserver(vtkCommand::WarningEvent, observer);
  const double shadow = Shadow(picture);
  bool good = Check(warnings.Count == 1 && warnings.Last.find("sampler objects") != std::string::npos,
    std::to_string(warnings.Count) + " warnings, the last: " + warnings.Last);
  good &= Check(shadow > 0.02 && shadow < 0.4, "Light in a shadow is " + std::to_string(shadow) + " of that beside it");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
