// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGLTFSceneWriter.h"

#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"
#include "SceneFile.h"
#include "SceneInput.h"
#include "SceneReader.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkGLTFSceneWriter);

namespace
{

std::array<double, 3> TripleOf(const double* numbers)
{
  return { { numbers[0], numbers[1], numbers[2] } };
}

double LengthOf(const double* a)
{
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

void RequireFinite(littoral::ParameterCheck& check, const std::string& name, const double* numbers)
{
  for (int part = 0; part < 3; ++part)
  {
    check.Finite(name + "[" + std::to_string(part) + "]", numbers[part]);
  }
}

void RequireDirection(littoral::ParameterCheck& check, const std::string& name, const double* direction)
{
  RequireFinite(check, name, direction);
  check.Require(LengthOf(direction) > 0.0, name + " must not be zero.");
}

}

//----------------------------------------------------------------------------
class vtkGLTFSceneWriter::vtkInternals
{
public:
  explicit vtkInternals(const littoral::SceneOptions& options)
    : Reader(options, this->Scene)
  {
  }

  littoral::Scene Scene;
  littoral::SceneReader Reader;
};

//----------------------------------------------------------------------------
vtkGLTFSceneWriter::vtkGLTFSceneWriter()
  : vtkSingleFileWriter("a scene")
{
  this->SetController(nullptr);
}

//----------------------------------------------------------------------------
vtkGLTFSceneWriter::~vtkGLTFSceneWriter() = default;

//----------------------------------------------------------------------------
int vtkGLTFSceneWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::SetSourceName(int source, const std::string& name)
{
  if (this->GetSourceName(source) != name)
  {
    this->SourceNames[source] = name;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
std::string vtkGLTFSceneWriter::GetSourceName(int source)
{
  const auto found = this->SourceNames.find(source);
  return found == this->SourceNames.end() ? "Source " + std::to_string(source) : found->second;
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::SetSourceKind(int source, int kind)
{
  if (this->GetSourceKind(source) != kind)
  {
    this->SourceKinds[source] = kind;
    this->Modified();
  }
}

//----------------------------------------------------------------------------
int vtkGLTFSceneWriter::GetSourceKind(int source)
{
  const auto found = this->SourceKinds.find(source);
  return found == this->SourceKinds.end() ? Automatic : found->second;
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::ClearSources()
{
  this->SourceNames.clear();
  this->SourceKinds.clear();
  this->Modified();
}

//----------------------------------------------------------------------------
vtkTypeBool vtkGLTFSceneWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (this->WriteMotion && request->Has(Pipeline::REQUEST_UPDATE_EXTENT()))
  {
    for (int source = 0; source < inputVector[0]->GetNumberOfInformationObjects(); ++source)
    {
      inputVector[0]->GetInformationObject(source)->Set(
        Pipeline::UPDATE_TIME_STEP(), this->StartTime + this->Frame / this->FramesPerSecond);
    }
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//----------------------------------------------------------------------------
int vtkGLTFSceneWriter::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector*)
{
  if (this->Frame == 0)
  {
    this->SetErrorCode(vtkErrorCode::NoError);
    this->InvokeEvent(vtkCommand::StartEvent);
  }
  this->WriteData();
  if (this->GetErrorCode() == vtkErrorCode::NoError && this->Frame > 0)
  {
    if (!this->IsStepping)
    {
      request->Set(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING(), 1);
    }
    return 1;
  }
  request->Remove(vtkStreamingDemandDrivenPipeline::CONTINUE_EXECUTING());
  this->InvokeEvent(vtkCommand::EndEvent);
  this->WriteTime.Modified();
  return this->Answer();
}

//----------------------------------------------------------------------------
int vtkGLTFSceneWriter::Write()
{
  this->End();
  // Frame by frame: where an input fails, VTK's executive would never end a loop of its own.
  this->IsStepping = true;
  int written = 0;
  for (int before = -1; this->Frame > before;)
  {
    before = this->Frame;
    written = this->Superclass::Write();
  }
  this->IsStepping = false;
  this->End();
  return written;
}

//----------------------------------------------------------------------------
std::string vtkGLTFSceneWriter::WhyInvalid() const
{
  littoral::ParameterCheck check;
  check.Choice("InstanceForm", this->InstanceForm, Nodes + 1);
  check.Choice("LevelForm", this->LevelForm, Low + 1);
  for (const auto& [source, kind] : this->SourceKinds)
  {
    check.Choice("SourceKind of source " + std::to_string(source), kind, Plain + 1);
  }
  if (this->WriteCamera)
  {
    RequireFinite(check, "CameraPosition", this->CameraPosition);
    RequireFinite(check, "CameraFocalPoint", this->CameraFocalPoint);
    RequireDirection(check, "CameraViewUp", this->CameraViewUp);
    check.Within("CameraViewAngle", this->CameraViewAngle, littoral::ValueInterval::Between(0.0, 180.0), "degrees");
    const bool isApart = !std::equal(this->CameraPosition, this->CameraPosition + 3, this->CameraFocalPoint);
    check.Require(isApart, "CameraFocalPoint must not be CameraPosition.");
  }
  if (this->WriteSun)
  {
    RequireDirection(check, "SunDirection", this->SunDirection);
    check.Color("SunColor", this->SunColor);
    check.NotNegative("SunIlluminance", this->SunIlluminance, "lx");
  }
  if (this->WriteMotion)
  {
    constexpr double mostFrames = 1e5;
    check.Finite("StartTime", this->StartTime, "s");
    check.Within("EndTime", this->EndTime, littoral::ValueInterval::Above(this->StartTime, 1e12), "s");
    check.Range("FramesPerSecond", this->FramesPerSecond, 0.01, 1000.0);
    check.Range("JointTolerance", this->JointTolerance, 0.0, 10.0, "m");
    const double frames = (this->EndTime - this->StartTime) * this->FramesPerSecond;
    check.Require(frames <= mostFrames,
      "Take a lower FramesPerSecond, or an EndTime closer to StartTime: the motion has more than 100000 samples.");
  }
  if (check.IsGood() && !this->Extras.empty())
  {
    check.Require(littoral::WhyRefused([this] { littoral::RequireExtras(this->Extras); }));
  }
  return check.Reason();
}

//----------------------------------------------------------------------------
littoral::SceneOptions vtkGLTFSceneWriter::GetOptions() const
{
  littoral::SceneOptions options;
  options.Instances = static_cast<littoral::SceneInstanceForm>(this->InstanceForm);
  options.Levels = static_cast<littoral::SceneLevelForm>(this->LevelForm);
  options.HasVelocity = this->WriteVelocity;
  options.HasMotion = this->WriteMotion;
  options.JointTolerance = this->JointTolerance;
  return options;
}

//----------------------------------------------------------------------------
std::vector<littoral::SceneSource> vtkGLTFSceneWriter::GetSources()
{
  std::vector<littoral::SceneSource> sources;
  sources.reserve(this->GetNumberOfInputConnections(0));
  for (int source = 0; source < this->GetNumberOfInputConnections(0); ++source)
  {
    sources.push_back({ this->GetSourceName(source), static_cast<littoral::SceneKind>(this->GetSourceKind(source)),
      this->GetInputDataObject(0, source) });
  }
  return sources;
}

//----------------------------------------------------------------------------
int vtkGLTFSceneWriter::GetNumberOfFrames() const
{
  constexpr double rounding = 1e-9; // of a frame
  return this->WriteMotion ? 1 + static_cast<int>((this->EndTime - this->StartTime) * this->FramesPerSecond + rounding)
                           : 1;
}

//----------------------------------------------------------------------------
/// Reads the sources as they are at the first time.
void vtkGLTFSceneWriter::Begin(const std::vector<littoral::SceneSource>& sources)
{
  this->NeedFileName();
  littoral::Require(this->WhyInvalid());
  this->Internals = std::make_unique<vtkInternals>(this->GetOptions());
  littoral::Scene& scene = this->Internals->Scene;
  scene.Name = this->SceneName;
  scene.Extras = this->Extras;
  if (this->WriteCamera)
  {
    scene.Camera = littoral::SceneCamera{ TripleOf(this->CameraPosition), TripleOf(this->CameraFocalPoint),
      TripleOf(this->CameraViewUp), this->CameraViewAngle };
  }
  if (this->WriteSun)
  {
    scene.Sun = littoral::SceneSun{ TripleOf(this->SunDirection), TripleOf(this->SunColor), this->SunIlluminance };
  }
  littoral::RequireScene(scene, sources, this->GetOptions());
  this->Internals->Reader.Add(sources);
}

//----------------------------------------------------------------------------
/// Notes where things are.
void vtkGLTFSceneWriter::Follow(const std::vector<littoral::SceneSource>& sources)
{
  for (const littoral::SceneSource& source : sources)
  {
    if (!source.Data)
    {
      littoral::Refuse(source.Name, " has no data at frame ", this->Frame, ".");
    }
  }
  this->SetProgressText("Reading a motion");
  this->UpdateProgress(0.5 * this->Frame / this->GetNumberOfFrames());
  this->Internals->Reader.Follow(sources, this->Frame / this->FramesPerSecond);
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::WriteScene()
{
  const double first = this->WriteMotion ? 0.5 : 0.0;
  this->Internals->Reader.Finish();
  littoral::Require(littoral::WhyTooLarge(this->Internals->Scene));
  this->SetProgressText("Writing a scene");
  this->Conclude(littoral::WriteScene(this->FileName, this->Internals->Scene, [this, first](double share) {
    this->UpdateProgress(first + (1.0 - first) * share);
    return !littoral::IsAborted(this);
  }));
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::End()
{
  this->Internals.reset();
  this->Frame = 0;
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::WriteInput()
{
  try
  {
    this->WriteFrame();
  }
  catch (...)
  {
    this->End();
    throw;
  }
}

//----------------------------------------------------------------------------
/// A frame of the motion, and the file after the last one.
void vtkGLTFSceneWriter::WriteFrame()
{
  const std::vector<littoral::SceneSource> sources = this->GetSources();
  if (this->Frame == 0)
  {
    this->Begin(sources);
  }
  if (littoral::IsAborted(this))
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    this->End();
    return;
  }
  if (this->WriteMotion)
  {
    this->Follow(sources);
  }
  if (this->Frame + 1 < this->GetNumberOfFrames())
  {
    ++this->Frame;
    return;
  }
  this->WriteScene();
  this->End();
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [](const double* a) {
    return littoral::TextOf(a[0]) + " " + littoral::TextOf(a[1]) + " " + littoral::TextOf(a[2]);
  };
  os << indent << "SceneName: " << this->SceneName << "\n";
  for (const auto& [source, name] : this->SourceNames)
  {
    os << indent << "SourceName " << source << ": " << name << "\n";
  }
  for (const auto& [source, kind] : this->SourceKinds)
  {
    os << indent << "SourceKind " << source << ": " << kind << "\n";
  }
  os << indent << "InstanceForm: " << this->InstanceForm << "\n";
  os << indent << "LevelForm: " << this->LevelForm << "\n";
  os << indent << "WriteVelocity: " << (this->WriteVelocity ? "on" : "off") << "\n";
  os << indent << "WriteCamera: " << (this->WriteCamera ? "on" : "off") << "\n";
  os << indent << "CameraPosition: " << triple(this->CameraPosition) << "\n";
  os << indent << "CameraFocalPoint: " << triple(this->CameraFocalPoint) << "\n";
  os << indent << "CameraViewUp: " << triple(this->CameraViewUp) << "\n";
  os << indent << "CameraViewAngle: " << this->CameraViewAngle << "\n";
  os << indent << "WriteSun: " << (this->WriteSun ? "on" : "off") << "\n";
  os << indent << "SunDirection: " << triple(this->SunDirection) << "\n";
  os << indent << "SunColor: " << triple(this->SunColor) << "\n";
  os << indent << "SunIlluminance: " << this->SunIlluminance << "\n";
  os << indent << "Extras: " << this->Extras << "\n";
  os << indent << "WriteMotion: " << (this->WriteMotion ? "on" : "off") << "\n";
  os << indent << "StartTime: " << this->StartTime << "\n";
  os << indent << "EndTime: " << this->EndTime << "\n";
  os << indent << "FramesPerSecond: " << this->FramesPerSecond << "\n";
  os << indent << "JointTolerance: " << this->JointTolerance << "\n";
}
