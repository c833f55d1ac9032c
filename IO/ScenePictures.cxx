// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScenePictures.h"

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
  vtkUnsignedCharArray* bytes = writer->GetResult();
  ScenePicture picture;
  picture.Png.assign(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
  return picture;
}

}
