// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSingleFileWriter.h"

#include "GatheredImage.h"
#include "GatheredPoints.h"
#include "ImageParts.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "ReplacedFile.h"
#include "WriterRanks.h"

#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>
#include <new>

vtkCxxSetObjectMacro(vtkSingleFileWriter, Controller, vtkMultiProcessController);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr int NoExtent[6] = { 0, -1, 0, -1, 0, -1 };

}

//----------------------------------------------------------------------------
vtkSingleFileWriter::vtkSingleFileWriter(const char* content)
  : Content(content)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//----------------------------------------------------------------------------
vtkSingleFileWriter::~vtkSingleFileWriter()
{
  this->SetController(nullptr);
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------
vtkTypeBool vtkSingleFileWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const littoral::WriterRanks ranks(this->Controller);
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (input && request->Has(Pipeline::REQUEST_UPDATE_EXTENT()) && !ranks.IsAlone())
  {
    ranks.AskForPart(input);
    this->NoteExtent(input);
  }
  return littoral::WithoutExceptions(
    this, request, outputVector, [&] { return this->Superclass::ProcessRequest(request, inputVector, outputVector); });
}

//----------------------------------------------------------------------------
int vtkSingleFileWriter::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  if (!littoral::WriterRanks(this->Controller).IsAlone())
  {
    this->WriteOwnParts([this] { return this->GetInput(); });
    return this->Answer();
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  this->InvokeEvent(vtkCommand::StartEvent);
  this->WriteData();
  this->InvokeEvent(vtkCommand::EndEvent);
  this->WriteTime.Modified();
  return this->Answer();
}

//----------------------------------------------------------------------------
int vtkSingleFileWriter::Answer()
{
  const unsigned long code = this->GetErrorCode();
  return code == vtkErrorCode::NoError || code == vtkErrorCode::UserError ? 1 : littoral::FailedRequest(this);
}

//----------------------------------------------------------------------------
int vtkSingleFileWriter::Write()
{
  const littoral::WriterRanks ranks(this->Controller);
  if (!ranks.IsAlone())
  {
    return this->WriteOwnParts([&] { return ranks.PartOfInput(this); });
  }
  this->IsWritten = false;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Superclass::Write();
  }
  else
  {
    this->WriteOrRefuse([] { littoral::Refuse("there is no input"); });
  }
  if (!this->IsWritten && this->GetErrorCode() == vtkErrorCode::NoError)
  {
    this->SetErrorCode(vtkErrorCode::UnknownError); // an input failed, and has told why
  }
  return this->IsWritten ? 1 : 0;
}

//----------------------------------------------------------------------------
int vtkSingleFileWriter::WriteParts(const std::function<void(const littoral::ImageParts&)>& write)
{
  const littoral::WriterRanks ranks(this->Controller);
  if (!ranks.IsAlone())
  {
    return this->WriteOwnParts([&] { return ranks.PartOfInput(this); });
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  this->InvokeEvent(vtkCommand::StartEvent);
  this->WriteOrRefuse([&] { write(littoral::PartsOfInput(this)); });
  this->InvokeEvent(vtkCommand::EndEvent);
  this->WriteTime.Modified();
  return this->IsWritten ? 1 : 0;
}

//----------------------------------------------------------------------------
int vtkSingleFileWriter::WriteOwnParts(const std::function<vtkDataObject*()>& ownPart)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->InvokeEvent(vtkCommand::StartEvent);
  this->WriteOrRefuse([&] {
    vtkDataObject* own = ownPart();
    if (this->Announced[1] < this->Announced[0] && this->GetNumberOfInputConnections(0) > 0)
    {
      this->NoteExtent(this->GetInputInformation(0, 0));
    }
    this->WriteTogether(own);
  });
  this->Whole = nullptr;
  std::copy_n(NoExtent, 6, this->Announced);
  this->ShareOutcome();
  this->InvokeEvent(vtkCommand::EndEvent);
  this->WriteTime.Modified();
  return this->IsWritten ? 1 : 0;
}

//----------------------------------------------------------------------------
/// Each file of a series has its image by itself, but is asked for by the input of the series.
void vtkSingleFileWriter::NoteExtent(vtkInformation* input)
{
  if (input && input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Get(Pipeline::WHOLE_EXTENT(), this->Announced);
  }
}

//----------------------------------------------------------------------------
/// Tells each rank what became of the file.
void vtkSingleFileWriter::ShareOutcome()
{
  const littoral::WriterRanks ranks(this->Controller);
  this->IsWritten = ranks.Shared(this->IsWritten ? 1 : 0) != 0;
  this->SetErrorCode(static_cast<unsigned long>(ranks.Shared(static_cast<int>(this->GetErrorCode()))));
}

//----------------------------------------------------------------------------
void vtkSingleFileWriter::WriteTogether(vtkDataObject* own)
{
  this->Whole = this->GatherInput(own);
  if (littoral::WriterRanks(this->Controller).IsFirst())
  {
    this->WriteInput();
  }
}

//----------------------------------------------------------------------------
void vtkSingleFileWriter::WritePartsTogether(
  vtkDataObject* own, const std::function<void(const littoral::ImageParts&)>& write)
{
  const littoral::WriterRanks ranks(this->Controller);
  littoral::ImageParts::Extent announced;
  std::copy_n(this->Announced, 6, announced.begin());
  littoral::GatheredImage image(ranks, vtkImageData::SafeDownCast(own), announced);
  ranks.IsFirst() ? write(image.Parts()) : image.Serve();
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> vtkSingleFileWriter::GatherInput(vtkDataObject* own)
{
  const littoral::WriterRanks ranks(this->Controller);
  vtkSmartPointer<vtkDataObject> whole;
  if (ranks.FirstWith(vtkImageData::SafeDownCast(own) != nullptr) >= 0)
  {
    this->WritePartsTogether(own, [&](const littoral::ImageParts& parts) { whole = parts.Get(parts.Whole); });
  }
  else
  {
    whole = littoral::GatherPoints(ranks, vtkPolyData::SafeDownCast(own));
  }
  return whole;
}

//----------------------------------------------------------------------------
vtkDataObject* vtkSingleFileWriter::GetWholeInput()
{
  return this->Whole ? this->Whole.GetPointer() : this->GetInput();
}

//----------------------------------------------------------------------------
void vtkSingleFileWriter::WriteData()
{
  this->WriteOrRefuse([this] { this->WriteInput(); });
}

//----------------------------------------------------------------------------
void vtkSingleFileWriter::WriteOrRefuse(const std::function<void()>& write)
{
  this->IsWritten = false;
  std::string reason;
  try
  {
    write();
  }
  catch (const littoral::Aborted&)
  {
    this->SetErrorCode(littoral::IsAborted(this) ? vtkErrorCode::UserError : vtkErrorCode::UnknownError);
  }
  catch (const littoral::InvalidInput& refusal)
  {
    reason = refusal.what();
  }
  catch (const std::bad_alloc&)
  {
    reason = "there is not enough memory";
  }
  catch (const std::exception& error) // other ranks wait for what becomes of it
  {
    reason = error.what();
  }
  if (!reason.empty())
  {
    vtkErrorMacro(<< littoral::FileMessage("write", this->FileName ? this->FileName : "", this->Content, reason));
    if (this->GetErrorCode() == vtkErrorCode::NoError)
    {
      this->SetErrorCode(vtkErrorCode::UnknownError);
    }
  }
}

//----------------------------------------------------------------------------
std::string vtkSingleFileWriter::NeedFileName() const
{
  littoral::Require(this->FileName && *this->FileName ? "" : "FileName is empty");
  return this->FileName;
}

//----------------------------------------------------------------------------
void vtkSingleFileWriter::Conclude(const littoral::FileOutcome& outcome)
{
  this->IsWritten = outcome.Written;
  if (!outcome.Written)
  {
    this->SetErrorCode(outcome.Reason.empty() ? vtkErrorCode::UserError : vtkErrorCode::CannotOpenFileError);
  }
  littoral::Require(outcome.Reason);
  this->UpdateProgress(1.0);
}

//----------------------------------------------------------------------------
void vtkSingleFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
