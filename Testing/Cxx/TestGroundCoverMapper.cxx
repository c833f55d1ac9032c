// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Strips that the graphics have are dropped, and made again only when the graphics are taken from their mapper. The
// indices of the first ones draw all.
#include "Check.h"
#include "GroundCoverMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <string>

namespace
{

constexpr int Squares = 4;
constexpr int Indexed = 2; // of them are cells
constexpr int Side = 40;   // pixels of the picture
constexpr int Red = 200;

/// Red squares of side 1, two apart, in a row along x, each a strip of four points.
vtkSmartPointer<vtkPolyData> RedSquares()
{
  auto squares = vtkSmartPointer<vtkPolyData>::New();
  squares->SetPoints(vtkNew<vtkPoints>());
  squares->SetStrips(vtkNew<vtkCellArray>());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (int n = 0; n < Squares; ++n)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      squares->GetPoints()->InsertNextPoint(2.0 * n + corner % 2, corner / 2, 0.0);
      colors->InsertNextTuple3(Red, 0, 0);
    }
    if (n < Indexed)
    {
      const vtkIdType first = 4 * static_cast<vtkIdType>(n);
      const vtkIdType corners[] = { first, first + 1, first + 2, first + 3 };
      squares->GetStrips()->InsertNextCell(4, corners);
    }
  }
  squares->GetPointData()->SetScalars(colors);
  return squares;
}

/// A picture in which the first squares fill a quarter of eight columns each.
struct Shown
{
  Shown()
  {
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(this->Actor);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(4.0);
    camera->SetFocalPoint(4.0, 0.0, 0.0);
    camera->SetPosition(4.0, 0.0, 10.0);
    camera->SetClippingRange(1.0, 20.0);
    this->Window->OffScreenRenderingOn();
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Side, Side);
    this->Window->AddRenderer(this->Renderer);
  }

  int RedPixels()
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, Side - 1, Side - 1, /*front=*/0, pixels);
    int red = 0;
    for (vtkIdType n = 0; n < pixels->GetNumberOfTuples(); ++n)
    {
      red += pixels->GetTypedComponent(n, 0) == Red ? 1 : 0;
    }
    return red;
  }

  vtkNew<littoral::GroundCoverMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

bool CheckPixels(Shown& shown, int squares, const std::string& when)
{
  const int expected = squares * (Side / 8) * (Side / 8);
  const int red = shown.RedPixels();
  return Check(red == expected, when + ": " + std::to_string(red) + " pixels, not " + std::to_string(expected));
}

}

int TestGroundCoverMapper(int, char*[])
{
  Shown shown;
  int made = 0;
  shown.Mapper->SetMaker([&made] {
    ++made;
    return RedSquares();
  });
  shown.Mapper->SetRuns({ { 0, Squares } });
  bool good = CheckPixels(shown, Squares, "all");
  vtkPolyData* kept = shown.Mapper->GetInput();
  good &= Check(kept->GetNumberOfPoints() == 1 && kept->GetPointData()->GetScalars()->GetSize() == 3 &&
      kept->GetNumberOfStrips() == 0,
    "what was sent is kept");
  shown.Mapper->SetRuns({ { 0, 1 }, { 3, 4 } });
  good &= CheckPixels(shown, 2, "some");
  const double* bounds = shown.Mapper->GetBounds();
  good &= Check(bounds[0] == 0.0 && bounds[1] == 2.0 * Squares - 1.0, "bounds of the cells alone");
  good &= Check(made == 1, "made again for another picture");
  shown.Mapper->ReleaseGraphicsResources(shown.Window);
  good &= CheckPixels(shown, 2, "after a release");
  good &= Check(made == 2, "not made again after a release");
  return good ? 0 : 1;
}
