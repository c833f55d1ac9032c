// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSingleFileWriter.h"

#include "ImageParts.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "ReplacedFile.h"

#include "vtkCommand.h"
#include "vtkErrorCode.h"

#include <new>

//----------------------------------------------------------------------------
vtkSingleFileWriter::vtkSingleFileWriter(const char* content)
  : Content(content)
{
}

//----------------------------------------------------------------------------
vtkSingleFileWriter::~vtkSingleFileWriter()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------
vtkTypeBool vtkSingleFileWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return littoral::WithoutExceptions(
    this, request, outputVector, [&] { return this->Superclass::ProcessRequest(request, inputVector, outputVector); });
}

//----------------------------------------------------------------------------
int vtkSingleFileWriter::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
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
  this->SetErrorCode(vtkErrorCode::NoError);
  this->InvokeEvent(vtkCommand::StartEvent);
  this->WriteOrRefuse([&] { write(littoral::PartsOfInput(this)); });
  this->InvokeEvent(vtkCommand::EndEvent);
  this->WriteTime.Modified();
  return this->IsWritten ? 1 : 0;
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
}
