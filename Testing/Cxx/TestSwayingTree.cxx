// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A birch in a storm at three times, in full on the left and in the middle level on the right: a picture.
#include "PlantScene.h"

#include "vtkBeamTreeDeformationFilter.h"
#include "vtkReevesTreeSource.h"
#include "vtkWindFieldSource.h"

#include "vtkImageData.h"

int TestSwayingTree(int argc, char* argv[])
{
  vtkNew<vtkReevesTreeSource> tree;
  tree->SetPreset(vtkReevesTreeSource::Birch);
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(300, 4, 8);
  wind->SetReferenceSpeed(15.0);
  PlantScene scene;
  int column = 0;
  for (const double time : { 0.0, 9.5, 21.0 })
  {
    // The last with a picture of the moving crown.
    tree->SetMediumCrown(column == 2 ? vtkReevesTreeSource::Envelope : vtkReevesTreeSource::Leaves);
    vtkNew<vtkBeamTreeDeformationFilter> sway;
    sway->SetInputConnection(tree->GetOutputPort());
    sway->SetWindConnection(wind->GetOutputPort());
    sway->UpdateTimeStep(time);
    vtkDataObject* plants = sway->GetOutputDataObject(0);
    scene.AddAsCarried(BlockAt(plants, "High"), 9.0 * column);
    scene.AddAsCarried(BlockAt(plants, "Medium"), 9.0 * column + 28.0);
    ++column;
  }
  const double eye[3] = { 23.0, -90.0, 7.0 };
  const double focus[3] = { 23.0, 0.0, 6.8 };
  scene.Window->SetSize(400, 130);
  return scene.Compare(argc, argv, eye, focus, 11.8);
}
