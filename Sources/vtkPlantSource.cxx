// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlantSource.h"

#include "Data/PlantBlocks.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Pipeline/RankTeam.h"
#include "Pipeline/SharedParts.h"
#include "Plants/LeafCards.h"
#include "Plants/PlantLevels.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDataObjectMetaDataKey.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkInformationKeyMacro(vtkPlantSource, TEXTURE_SIZES, DataObjectMetaData);

namespace
{

/// Memory of a texel, where it is painted and where it is put out [bytes].
constexpr double BytesOfTexel = 32.0;

void AddTextureSize(vtkDataObject* sizes, const char* block, const std::array<int, 2>& size)
{
  vtkNew<vtkIntArray> array;
  array->SetName(block);
  array->SetNumberOfComponents(2);
  array->InsertNextTypedTuple(size.data());
  sizes->GetFieldData()->AddArray(array);
}

}

//----------------------------------------------------------------------------
vtkPlantSource::vtkPlantSource()
  : Seed(1)
  , MediumCrown(Leaves)
  , TextureSize{ 256, 128 }
  , CrownJitter(0.0)
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(3);
}

//----------------------------------------------------------------------------
vtkPlantSource::~vtkPlantSource() = default;

//----------------------------------------------------------------------------
int vtkPlantSource::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------
int vtkPlantSource::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  littoral::AnnouncePartForm(outputVector->GetInformationObject(0), littoral::PartForm::Whole);
  const int picture[6] = { 0, this->TextureSize[0] - 1, 0, this->TextureSize[1] - 1, 0, 0 };
  outputVector->GetInformationObject(1)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), picture, 6);
  const std::array<int, 2> size = this->LeafTextureSize();
  const int leaf[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, 0 };
  outputVector->GetInformationObject(2)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), leaf, 6);
  vtkNew<vtkDataObject> sizes;
  AddTextureSize(sizes, littoral::plant::Crown, { this->TextureSize[0], this->TextureSize[1] });
  AddTextureSize(sizes, littoral::plant::Leaves, size);
  outputVector->GetInformationObject(0)->Set(vtkPlantSource::TEXTURE_SIZES(), sizes);
  return 1;
}

//----------------------------------------------------------------------------
std::array<int, 2> vtkPlantSource::LeafTextureSize() const
{
  return { littoral::LeafPictureSize, littoral::LeafPictureSize };
}

//----------------------------------------------------------------------------
littoral::PlantLevelOptions vtkPlantSource::MakeOptions()
{
  littoral::PlantLevelOptions options;
  options.Seed = this->Seed;
  options.Crown = static_cast<littoral::MediumCrown>(this->MediumCrown);
  options.TextureColumns = this->TextureSize[0];
  options.TextureRows = this->TextureSize[1];
  options.CrownJitter = this->CrownJitter;
  options.Parallel = littoral::AbortableFor(this);
  options.OnStep = littoral::PollOf(this);
  littoral::Require(littoral::WhyInvalid(options));
  littoral::RequireMemory(BytesOfTexel * options.TextureColumns * options.TextureRows, "A picture of the crown",
    "take a smaller TextureSize");
  return options;
}

//----------------------------------------------------------------------------
int vtkPlantSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  littoral::PlantPrototype prototype;
  if (littoral::IsAskedTogether(outputVector->GetInformationObject(0)))
  {
    littoral::RankTeam team;
    const auto grow = [&] {
      littoral::PlantLevelOptions options = this->MakeOptions();
      options.ShareOf = [&team](std::uint64_t key) {
        team.Agree(key);
        return team.Share();
      };
      prototype = this->Grow(options);
    };
    try
    {
      team.RunAll(grow);
    }
    catch (const littoral::Aborted&)
    {
      return littoral::FailedRequest(this); // on each rank, so that none goes on alone
    }
  }
  else
  {
    prototype = this->Grow(this->MakeOptions());
  }
  auto* output = vtkMultiBlockDataSet::GetData(outputVector, 0);
  littoral::CopyToBlocks(prototype, output);
  if (outputVector->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    littoral::EmptyBlocks(output);
  }
  littoral::KeepRanges(output, littoral::PollOf(this));
  littoral::CopyToImage(prototype.CrownTexture, vtkImageData::GetData(outputVector, 1));
  littoral::CopyToImage(prototype.LeafTexture, vtkImageData::GetData(outputVector, 2));
  return 1;
}

//----------------------------------------------------------------------------
int vtkPlantSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkPlantSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "MediumCrown: " << this->MediumCrown << "\n";
  os << indent << "TextureSize: " << this->TextureSize[0] << " " << this->TextureSize[1] << "\n";
  os << indent << "CrownJitter: " << this->CrownJitter << "\n";
}
