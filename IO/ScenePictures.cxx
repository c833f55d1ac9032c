// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScenePictures.h"

#include "Data/Arrays.h"
#include "Data/PlantBlocks.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

namespace littoral
{

ScenePicture PictureOf(vtkPolyData* data)
{
  vtkNew<vtkImageData> image;
  CopyToImage(ReadTexture(data), image);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  ScenePicture picture;
  picture.Png = ListOf(writer->GetResult());
  return picture;
}

}
