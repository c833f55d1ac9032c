// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A seaweed in a regular swell, half a wave apart: it sways with the water, not like a stick.
#include "PlantScene.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

int TestSeaweedSwell(int argc, char* argv[])
{
  vtkNew<vtkSeaweedSource> weed;
  weed->SetPreset(vtkSeaweedSource::Eelgrass);
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSpectrum(vtkSeaStateSource::Regular);
  sea->SetSeaBy(vtkSeaStateSource::HeightAndPeriod);
  sea->SetSignificantWaveHeight(0.45);
  sea->SetPeakPeriod(4.0);
  sea->SetSeaLevel(3.0);
  sea->SetWaterDepth(3.0);
  vtkNew<vtkSeaweedDeformationFilter> move;
  move->SetInputConnection(weed->GetOutputPort());
  move->SetSeaStateConnection(sea->GetOutputPort());
  PlantScene scene;
  scene.Window->SetSize(500, 260); // leaves of more than a pixel, which are drawn alike by all versions of VTK
  for (int side = 0; side < 2; ++side)
  {
    move->UpdateTimeStep(11.0 + 2.0 * side);
    vtkNew<vtkMultiBlockDataSet> plant;
    plant->DeepCopy(BlockAt(move->GetOutputDataObject(0), "High"));
    scene.Add(plant, 1.1 * side);
  }
  const double eye[3] = { 0.65, -12.0, 0.9 };
  const double focus[3] = { 0.65, 0.0, 0.47 };
  return scene.Compare(argc, argv, eye, focus, 5.4);
}
