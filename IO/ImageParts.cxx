// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageParts.h"

#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkAlgorithm.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace littoral
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The image of an output, or null.
vtkImageData* ImageOf(vtkAlgorithm* producer, int port)
{
  return vtkImageData::SafeDownCast(producer->GetOutputDataObject(port));
}

vtkImageData* UpdatedPart(vtkAlgorithm* producer, int port, const ImageParts::Extent& extent)
{
  vtkInformation* info = producer->GetOutputInformation(port);
  // a part of its own choice, whatever piece was asked for before
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  info->Set(Pipeline::UPDATE_EXTENT_INITIALIZED(), 1);
  info->Set(Pipeline::UPDATE_EXTENT(), extent.data(), 6);
  const bool isUpdated = producer->GetExecutive()->Update(port) != 0;
  vtkImageData* image = ImageOf(producer, port);
  if (!isUpdated || !image || image->GetNumberOfPoints() == 0)
  {
    throw Aborted();
  }
  return image;
}

}

ImageParts PartsOf(vtkImageData* image)
{
  Require(image ? "" : "there is no input");
  ImageParts parts;
  image->GetExtent(parts.Whole.data());
  parts.Get = [image](const ImageParts::Extent&) { return image; };
  return parts;
}

ImageParts PartsOfInput(vtkAlgorithm* writer)
{
  int port = 0;
  vtkAlgorithm* producer = writer->GetNumberOfInputConnections(0) > 0 ? writer->GetInputAlgorithm(0, 0, port) : nullptr;
  Require(producer ? "" : "there is no input");
  producer->UpdateInformation();
  vtkInformation* info = producer->GetOutputInformation(port);
  Require(ImageOf(producer, port) && info->Has(Pipeline::WHOLE_EXTENT()) ? "" : "the input is no image");
  ImageParts parts;
  info->Get(Pipeline::WHOLE_EXTENT(), parts.Whole.data());
  Require(parts.Whole[1] >= parts.Whole[0] ? "" : "the image has no points");
  parts.Get = [producer, port](const ImageParts::Extent& extent) { return UpdatedPart(producer, port, extent); };
  return parts;
}

}
