// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVDBVolumeWriter.h"

#include "NumberedSuffix.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/FailedInput.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "VolumeFile.h"
#include "VolumeGather.h"
#include "VolumeInput.h"
#include "WriterRanks.h"

#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <filesystem>

vtkStandardNewMacro(vtkVDBVolumeWriter);
vtkCxxSetObjectMacro(vtkVDBVolumeWriter, Controller, vtkMultiProcessController);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Memory of the grids, with what becomes of them while they are written, and of the largest box of other ranks
/// [bytes].
double BytesOf(const std::vector<littoral::Volume>& volumes)
{
  double grids = 0.0;
  double box = 0.0;
  for (const littoral::Volume& volume : volumes)
  {
    for (const littoral::VolumeBlock& block : volume.Blocks)
    {
      grids += 1.1 * sizeof(float) * volume.Components * static_cast<double>(block.Count());
      box = std::max(box, block.Load ? littoral::BytesToLoad(block, volume.Components) : 0.0);
    }
  }
  return grids + box;
}

/// The time steps of an input.
int StepsOf(vtkInformation* input)
{
  return input && input->Has(Pipeline::TIME_STEPS()) ? input->Length(Pipeline::TIME_STEPS()) : 0;
}

/// Whether one extent lies in another; one without points does.
bool Holds(const std::array<int, 6>& outer, const int inner[6])
{
  bool holds = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    holds = holds && outer[2 * axis] <= inner[2 * axis] && outer[2 * axis + 1] >= inner[2 * axis + 1];
  }
  return holds || inner[1] < inner[0] || inner[3] < inner[2] || inner[5] < inner[4];
}

/// Why the input of all ranks cannot be written; empty if it can.
std::string WhyUnfit(const littoral::VolumeInput& input)
{
  if (!input.Reason.empty())
  {
    return input.Reason;
  }
  if (input.Samples == 0)
  {
    return "the input is empty.";
  }
  if (input.Volumes.empty())
  {
    return "the input has no array of numbers, or none is chosen.";
  }
  return littoral::WhyRefused([&] {
    littoral::RequireMemory(BytesOf(input.Volumes), "a file of its volumes", "take a smaller or coarser grid");
  });
}

/// Gives the only volume a name, unless that is empty. Why it cannot; empty if it can.
std::string NameVolumes(std::vector<littoral::Volume>& volumes, const std::string& name)
{
  if (!name.empty() && volumes.size() > 1)
  {
    return "GridName is '" + name + "', but there are " + std::to_string(volumes.size()) +
      " volumes; choose one array, or leave GridName empty.";
  }
  volumes.front().Name = name.empty() ? volumes.front().Name : name;
  return {};
}

}

//----------------------------------------------------------------------------
vtkVDBVolumeWriter::vtkVDBVolumeWriter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//----------------------------------------------------------------------------
vtkVDBVolumeWriter::~vtkVDBVolumeWriter()
{
  this->SetController(nullptr);
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------
vtkDataArraySelection* vtkVDBVolumeWriter::GetPointDataArraySelection()
{
  return this->PointDataArraySelection;
}

//----------------------------------------------------------------------------
vtkDataArraySelection* vtkVDBVolumeWriter::GetCellDataArraySelection()
{
  return this->CellDataArraySelection;
}

//----------------------------------------------------------------------------
vtkMTimeType vtkVDBVolumeWriter::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->PointDataArraySelection->GetMTime(),
    this->CellDataArraySelection->GetMTime() });
}

//----------------------------------------------------------------------------
int vtkVDBVolumeWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//----------------------------------------------------------------------------
vtkTypeBool vtkVDBVolumeWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (input && this->Controller && request->Has(Pipeline::REQUEST_UPDATE_EXTENT()))
  {
    littoral::WriterRanks(this->Controller).AskForPart(input);
    this->NoteExtent(input, inputVector[0] != this->GetExecutive()->GetInputInformation(0));
  }
  if (this->WriteAllTimeSteps && input && request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    if (!this->IsStepping)
    {
      this->NumberOfSteps = StepsOf(input);
      this->CurrentStep = 0;
    }
    return 1;
  }
  if (this->WriteAllTimeSteps && input && request->Has(Pipeline::REQUEST_UPDATE_EXTENT()))
  {
    if (this->CurrentStep < StepsOf(input))
    {
      input->Set(Pipeline::UPDATE_TIME_STEP(), input->Get(Pipeline::TIME_STEPS())[this->CurrentStep]);
    }
    return 1;
  }
  return littoral::WithoutExceptions(
    this, request, outputVector, [&] { return this->Superclass::ProcessRequest(request, inputVector, outputVector); });
}

//----------------------------------------------------------------------------
int vtkVDBVolumeWriter::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector*)
{
  if (!this->WriteAllTimeSteps)
  {
    this->NumberOfSteps = 0;
    this->CurrentStep = 0;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  this->InvokeEvent(vtkCommand::StartEvent);
  this->WriteData();
  this->InvokeEvent(vtkCommand::EndEvent);
  this->WriteTime.Modified();
  const bool written = this->GetErrorCode() == vtkErrorCode::NoError;
  if (written && !this->IsStepping && ++this->CurrentStep < this->NumberOfSteps)
  {
    request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
  }
  else if (!this->IsStepping)
  {
    request->Remove(Pipeline::CONTINUE_EXECUTING());
    this->CurrentStep = 0;
  }
  // An abort is no failure.
  return written || this->GetErrorCode() == vtkErrorCode::UserError ? 1 : littoral::FailedRequest(this);
}

//----------------------------------------------------------------------------
int vtkVDBVolumeWriter::Write()
{
  const littoral::WriterRanks ranks(this->Controller);
  const bool hasInput = this->GetNumberOfInputConnections(0) > 0;
  if (!hasInput && ranks.IsAlone())
  {
    this->Refuse("there is no input.");
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return 0;
  }
  if (hasInput && this->WriteAllTimeSteps)
  {
    this->GetInputAlgorithm()->UpdateInformation();
  }
  const bool isSeries = hasInput && this->WriteAllTimeSteps;
  this->NumberOfSteps = ranks.Largest(isSeries ? StepsOf(this->GetInputInformation(0, 0)) : 0);
  // Step by step: where the input fails, VTK's executive would never end a loop of its own.
  this->IsStepping = true;
  bool isWritten = true;
  for (this->CurrentStep = 0; isWritten && this->CurrentStep < std::max(1, this->NumberOfSteps); ++this->CurrentStep)
  {
    isWritten = this->WriteStep(hasInput);
  }
  this->IsStepping = false;
  this->CurrentStep = 0;
  return isWritten ? 1 : 0;
}

//----------------------------------------------------------------------------
bool vtkVDBVolumeWriter::WriteStep(bool hasInput)
{
  this->IsAwaited = true;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (hasInput)
  {
    this->Superclass::Write();
  }
  if (this->IsAwaited && littoral::WriterRanks(this->Controller).IsAlone())
  {
    this->SetErrorCode(vtkErrorCode::UnknownError); // the input has failed, and has told why
  }
  else if (this->IsAwaited) // the input has failed here, and others wait for it
  {
    this->WritePart(nullptr, hasInput);
  }
  return this->GetErrorCode() == vtkErrorCode::NoError;
}

//----------------------------------------------------------------------------
/// Each file of a series has its image by itself, but is asked for by the input of the series.
void vtkVDBVolumeWriter::NoteExtent(vtkInformation* input, bool isOfSeries)
{
  if (input->Has(Pipeline::WHOLE_EXTENT()) && (isOfSeries || this->Announced[1] < this->Announced[0]))
  {
    input->Get(Pipeline::WHOLE_EXTENT(), this->Announced);
  }
}

//----------------------------------------------------------------------------
bool vtkVDBVolumeWriter::HasFileName() const
{
  return this->FileName && *this->FileName;
}

//----------------------------------------------------------------------------
std::string vtkVDBVolumeWriter::WhyInvalid() const
{
  littoral::ParameterCheck check;
  check.NotNegative("Tolerance", this->Tolerance);
  constexpr std::size_t longest = 255; // name of a file [bytes]
  check.Require(!this->WriteAllTimeSteps ||
      (this->FileNameSuffix.size() <= longest && littoral::NumberedSuffix(this->FileNameSuffix).IsValid),
    "FileNameSuffix is '" + this->FileNameSuffix.substr(0, longest) +
      "'; it must hold one number like %d or %04d, in at most 255 characters.");
  return check.Reason();
}

//----------------------------------------------------------------------------
std::string vtkVDBVolumeWriter::StepFileName() const
{
  if (this->NumberOfSteps == 0)
  {
    return this->FileName;
  }
  const std::filesystem::path whole(this->FileName);
  const std::string name = whole.stem().string() +
    littoral::NumberedSuffix(this->FileNameSuffix).With(this->CurrentStep) + whole.extension().string();
  return (whole.parent_path() / name).string();
}

//----------------------------------------------------------------------------
void vtkVDBVolumeWriter::Refuse(const std::string& reason)
{
  if (littoral::WriterRanks(this->Controller).IsFirst())
  {
    vtkErrorMacro(<< littoral::FileMessage(
                    "write", this->HasFileName() ? this->StepFileName() : "", "a volume", reason));
  }
}

//----------------------------------------------------------------------------
void vtkVDBVolumeWriter::WriteData()
{
  this->IsAwaited = false;
  vtkDataObject* data = this->GetInput();
  if (!data && littoral::WriterRanks(this->Controller).IsAlone())
  {
    this->Refuse("there is no input.");
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return;
  }
  this->WritePart(data, littoral::HasFailedInput(this));
}

//----------------------------------------------------------------------------
/// Writes what all ranks have, each of which calls this.
void vtkVDBVolumeWriter::WritePart(vtkDataObject* data, bool hasFailed)
{
  this->IsAwaited = false;
  const littoral::WriterRanks ranks(this->Controller);
  if (!ranks.IsAlone() && ranks.FirstWith(hasFailed) == 0) // it has told why
  {
    this->SetErrorCode(vtkErrorCode::UnknownError);
    return;
  }
  littoral::VolumeInput input;
  if (data)
  {
    input = littoral::ReadVolumes(data, this->PointDataArraySelection, this->CellDataArraySelection);
  }
  const std::string reason = this->HasFileName() ? this->WhyInvalid() : "FileName is empty.";
  if (!reason.empty())
  {
    input.Reason = reason;
  }
  if (hasFailed && !ranks.IsAlone())
  {
    input.Reason = "the input has failed on rank " + std::to_string(ranks.GetRank()) + ".";
  }
  littoral::GatherShapes(ranks, input);
  littoral::FileOutcome outcome;
  {
    const littoral::VolumeServing serving(ranks);
    if (ranks.IsFirst())
    {
      outcome = this->WriteGathered(input);
    }
    else
    {
      serving.Serve(input);
    }
  }
  std::fill_n(this->Announced, 6, -1);
  this->Announced[0] = 0;
  const bool isWritten = ranks.Shared(outcome.Written ? 1 : 0) != 0;
  const bool isAborted = ranks.Shared(!outcome.Written && outcome.Reason.empty() ? 1 : 0) != 0;
  if (!outcome.Reason.empty())
  {
    this->Refuse(outcome.Reason);
  }
  if (!isWritten)
  {
    this->SetErrorCode(isAborted ? vtkErrorCode::UserError : vtkErrorCode::CannotOpenFileError);
  }
}

//----------------------------------------------------------------------------
littoral::FileOutcome vtkVDBVolumeWriter::WriteGathered(littoral::VolumeInput& input)
{
  std::string reason = WhyUnfit(input);
  if (reason.empty() && input.Extent[1] >= input.Extent[0] && !Holds(input.Extent, this->Announced))
  {
    reason = "a rank has not its part of the image.";
  }
  if (reason.empty())
  {
    littoral::JoinVolumes(input.Volumes);
    reason = NameVolumes(input.Volumes, this->GridName);
  }
  if (!reason.empty())
  {
    return { false, reason };
  }
  const double steps = std::max(1, this->NumberOfSteps);
  this->SetProgressText("Writing volumes");
  return littoral::WriteVolumes(this->StepFileName(), input.Volumes, input.Remarks,
    { this->HalfFloat, this->Tolerance, static_cast<littoral::VolumeCompression>(this->Compression) }, littoral::SmpFor,
    [&](double share) {
      this->UpdateProgress((this->CurrentStep + share) / steps);
      return !littoral::IsAborted(this);
    });
}

//----------------------------------------------------------------------------
void vtkVDBVolumeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "HalfFloat: " << (this->HalfFloat ? "on" : "off") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "GridName: " << this->GridName << "\n";
  os << indent << "Compression: " << this->Compression << "\n";
  os << indent << "WriteAllTimeSteps: " << (this->WriteAllTimeSteps ? "on" : "off") << "\n";
  os << indent << "FileNameSuffix: " << this->FileNameSuffix << "\n";
  os << indent << "PointDataArraySelection:\n";
  this->PointDataArraySelection->PrintSelf(os, indent.GetNextIndent());
  os << indent << "CellDataArraySelection:\n";
  this->CellDataArraySelection->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Controller: " << this->Controller << "\n";
}
