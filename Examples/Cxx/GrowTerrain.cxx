// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// Grows a square terrain of one kilometre and writes it as a VTK image:
//   GrowTerrain terrain.vti [samples a side] [seed]

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTurningBandsTerrainSource.h>
#include <vtkXMLImageDataWriter.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

//------------------------------------------------------------------------------
void ShowProgress(vtkObject*, unsigned long, void*, void* progress)
{
  const long percent = std::lround(100.0 * *static_cast<double*>(progress));
  std::cout << "\rgrowing: " << percent << " %" << std::flush;
}

//------------------------------------------------------------------------------
/// A whole number from the command line; `other` where there is none, 0 where it is none.
int Number(int argc, char* argv[], int index, int other)
{
  if (index >= argc)
  {
    return other;
  }
  char* end = nullptr;
  const long number = std::strtol(argv[index], &end, 10);
  return *end == '\0' && number > 0 && number < 1000000 ? static_cast<int>(number) : 0;
}

} // anonymous namespace

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const int side = Number(argc, argv, 2, 513);
  const int seed = Number(argc, argv, 3, 1);
  if (argc < 2 || side < 2)
  {
    std::cerr << "usage: " << argv[0] << " terrain.vti [samples a side, at least 2] [seed]\n";
    return EXIT_FAILURE;
  }

  const double length = 1000.0; // [m]
  const double spacing = length / (side - 1);

  vtkNew<vtkTurningBandsTerrainSource> terrain;
  terrain->SetWholeExtent(0, side - 1, 0, side - 1, 0, 0);
  terrain->SetSpacing(spacing, spacing, 1.0);
  terrain->SetSeed(seed);

  vtkNew<vtkCallbackCommand> progress;
  progress->SetCallback(ShowProgress);
  terrain->AddObserver(vtkCommand::ProgressEvent, progress);
  terrain->Update();
  std::cout << '\n';

  vtkDataArray* elevation = terrain->GetOutput()->GetPointData()->GetArray("Elevation");
  if (!elevation)
  {
    std::cerr << "no terrain\n";
    return EXIT_FAILURE;
  }
  double range[2];
  elevation->GetRange(range);
  std::cout << side << " x " << side << " samples, " << range[0] << " m to " << range[1] << " m\n";

  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(argv[1]);
  writer->SetInputConnection(terrain->GetOutputPort());
  // Not the default, appended data: VTK up to 9.3 cannot read it back with expat from 2.6 on, nor
  // with the expat of an up-to-date Debian 12.
  writer->SetDataModeToBinary();
  if (!writer->Write())
  {
    std::cerr << "could not write " << argv[1] << '\n';
    return EXIT_FAILURE;
  }
  std::cout << "written: " << argv[1] << '\n';
  return EXIT_SUCCESS;
}
