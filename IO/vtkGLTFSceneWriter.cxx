// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGLTFSceneWriter.h"

#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
#include "SceneFile.h"
#include "SceneInput.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
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
vtkGLTFSceneWriter::vtkGLTFSceneWriter() = default;

//----------------------------------------------------------------------------
vtkGLTFSceneWriter::~vtkGLTFSceneWriter()
{
  this->SetFileName(nullptr);
}

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
int vtkGLTFSceneWriter::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->InvokeEvent(vtkCommand::StartEvent);
  this->WriteData();
  this->InvokeEvent(vtkCommand::EndEvent);
  this->WriteTime.Modified();
  // An abort is no failure.
  const unsigned long code = this->GetErrorCode();
  return code == vtkErrorCode::NoError || code == vtkErrorCode::UserError ? 1 : littoral::FailedRequest(this);
}

//----------------------------------------------------------------------------
int vtkGLTFSceneWriter::Write()
{
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    return this->Superclass::Write();
  }
  this->Refuse("there is no input.");
  this->SetErrorCode(vtkErrorCode::UnknownError);
  return 0;
}

//----------------------------------------------------------------------------
std::string vtkGLTFSceneWriter::WhyInvalid() const
{
  littoral::ParameterCheck check;
  check.Require(this->FileName && *this->FileName, "FileName is empty.");
  check.Choice("InstanceForm", this->InstanceForm, Nodes + 1);
  check.Choice("LevelForm", this->LevelForm, Low + 1);
  for (const auto& [source, kind] : this->SourceKinds)
  {
    check.Choice("The kind of source " + std::to_string(source), kind, Plain + 1);
  }
  if (this->WriteCamera)
  {
    RequireFinite(check, "CameraPosition", this->CameraPosition);
    RequireFinite(check, "CameraFocalPoint", this->CameraFocalPoint);
    RequireDirection(check, "CameraViewUp", this->CameraViewUp);
    check.Within(
      "CameraViewAngle", this->CameraViewAngle, littoral::ValueInterval::Between(0.0, 180.0), "degrees");
    const bool isApart = !std::equal(this->CameraPosition, this->CameraPosition + 3, this->CameraFocalPoint);
    check.Require(isApart, "CameraFocalPoint must not be CameraPosition.");
  }
  if (this->WriteSun)
  {
    RequireDirection(check, "SunDirection", this->SunDirection);
    check.Color("SunColor", this->SunColor);
    check.NotNegative("SunIlluminance", this->SunIlluminance, "lx");
  }
  if (check.IsGood() && !this->Extras.empty())
  {
    check.Require(littoral::WhyNoExtras(this->Extras));
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
  return options;
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::AddView(littoral::Scene& scene) const
{
  if (this->WriteCamera)
  {
    scene.Camera = littoral::SceneCamera{ TripleOf(this->CameraPosition), TripleOf(this->CameraFocalPoint),
      TripleOf(this->CameraViewUp), this->CameraViewAngle };
  }
  if (this->WriteSun)
  {
    scene.Sun = littoral::SceneSun{ TripleOf(this->SunDirection), TripleOf(this->SunColor), this->SunIlluminance };
  }
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::Refuse(const std::string& reason)
{
  const std::string file = this->FileName && *this->FileName ? std::string("the file ") + this->FileName : "a scene";
  vtkErrorMacro("Cannot write " << file << ": " << reason << (reason.back() == '.' ? "" : "."));
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::WriteData()
{
  std::vector<littoral::SceneSource> sources;
  for (int source = 0; source < this->GetNumberOfInputConnections(0); ++source)
  {
    sources.push_back({ this->GetSourceName(source), static_cast<littoral::SceneKind>(this->GetSourceKind(source)),
      this->GetInputDataObject(0, source) });
  }
  const littoral::SceneOptions options = this->GetOptions();
  littoral::Scene scene;
  scene.Name = this->SceneName;
  scene.Extras = this->Extras;
  this->AddView(scene);
  littoral::SceneOutcome outcome;
  outcome.Reason = this->WhyInvalid();
  outcome.Reason = outcome.Reason.empty() ? littoral::WhyNoScene(scene, sources, options) : outcome.Reason;
  if (outcome.Reason.empty())
  {
    this->SetProgressText("Writing a scene");
    littoral::ReadSources(sources, options, scene);
    outcome = littoral::WriteScene(this->FileName, scene, [this](double share) {
      this->UpdateProgress(share);
      return !littoral::IsAborted(this);
    });
  }
  if (!outcome.Written)
  {
    const bool isAborted = outcome.Reason.empty();
    if (!isAborted)
    {
      this->Refuse(outcome.Reason);
    }
    this->SetErrorCode(isAborted ? vtkErrorCode::UserError : vtkErrorCode::CannotOpenFileError);
  }
}

//----------------------------------------------------------------------------
void vtkGLTFSceneWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto triple = [](const double* a) {
    return littoral::TextOf(a[0]) + " " + littoral::TextOf(a[1]) + " " + littoral::TextOf(a[2]);
  };
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
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
}
