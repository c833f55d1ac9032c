// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/Mistakes.h"

#include "Pipeline/FailedInput.h"
#include "Pipeline/SharedKey.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace littoral
{

namespace
{

/// The messages that an algorithm has printed, a line each, without their numbers and types of data.
vtkInformationStringKey* Mistakes()
{
  static auto* key = SharedKey<vtkInformationStringKey>("MISTAKES");
  return key;
}

/// The modification time of the algorithm that they belong to.
vtkInformationIdTypeKey* MistakesTime()
{
  static auto* key = SharedKey<vtkInformationIdTypeKey>("MISTAKES_TIME");
  return key;
}

/// Address of the request that an algorithm answers, 0 when it has been answered. Each time that a counted reference is
/// given up, VTK looks for cycles of references.
vtkInformationIdTypeKey* CurrentRequest()
{
  static auto* key = SharedKey<vtkInformationIdTypeKey>("CURRENT_REQUEST");
  return key;
}

/// Whether a request has asked for information before. VTK has a request for information and another for data, but one
/// for both in its loop over the leaves of a composite: a new one for each loop.
vtkInformationIntegerKey* HasInformed()
{
  static auto* key = SharedKey<vtkInformationIntegerKey>("HAS_INFORMED");
  return key;
}

/// Whether a leaf of such a loop was a mistake.
vtkInformationIntegerKey* HasFailed()
{
  static auto* key = SharedKey<vtkInformationIntegerKey>("HAS_FAILED");
  return key;
}

/// The request of the loop that the algorithm is in; null if it is in none.
vtkInformation* LoopOf(vtkAlgorithm* algorithm)
{
  const vtkIdType address = algorithm->GetInformation()->Get(CurrentRequest());
  auto* request = reinterpret_cast<vtkInformation*>(address); // NOLINT(performance-no-int-to-ptr): not in a loop
  const bool isLoop = request && request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()) && request->Has(HasInformed());
  return isLoop ? request : nullptr;
}

/// A message without its numbers and names of VTK's types, in which those of the leaves of a composite differ.
std::string Essence(std::string text)
{
  for (std::size_t at = text.find(" vtk"); at != std::string::npos; at = text.find(" vtk", at))
  {
    const auto end =
      std::find_if_not(text.begin() + at + 1, text.end(), [](unsigned char letter) { return std::isalnum(letter); });
    text.erase(text.begin() + at, end);
  }
  const auto isNumber = [](unsigned char letter) {
    return std::isdigit(letter) || letter == '.' || letter == '-' || letter == '+';
  };
  text.erase(std::remove_if(text.begin(), text.end(), isNumber), text.end());
  return text;
}

/// Whether one of them is an error.
vtkInformationIntegerKey* HasErred()
{
  static auto* key = SharedKey<vtkInformationIntegerKey>("HAS_ERRED");
  return key;
}

bool HasMistakes(vtkAlgorithm* algorithm)
{
  vtkInformation* info = algorithm->GetInformation();
  return info->Has(MistakesTime()) && info->Get(MistakesTime()) == static_cast<vtkIdType>(algorithm->GetMTime());
}

bool IsEmpty(vtkDataObject* data)
{
  for (int type = 0; data && type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
  {
    if (type != vtkDataObject::FIELD && data->GetNumberOfElements(type) > 0) // VTK passes the field data of inputs on
    {
      return false;
    }
  }
  return true;
}

bool HasErrors(vtkAlgorithm* algorithm)
{
  return HasMistakes(algorithm) && algorithm->GetInformation()->Has(HasErred());
}

/// Whether an upstream algorithm of which something is true has no output.
bool IsDueToUpstream(vtkAlgorithm* algorithm, bool (*isSo)(vtkAlgorithm*) = HasMistakes)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int index = 0; index < algorithm->GetNumberOfInputConnections(port); ++index)
    {
      vtkAlgorithm* producer = algorithm->GetInputAlgorithm(port, index);
      if (producer &&
        ((isSo(producer) && IsEmpty(producer->GetOutputDataObject(0))) || IsDueToUpstream(producer, isSo)))
      {
        return true;
      }
    }
  }
  return false;
}

}

AnsweredRequest::AnsweredRequest(vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector* outputs)
  : Algorithm(algorithm)
  , Request(request)
  , Outputs(outputs)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    request->Set(HasInformed(), 1);
  }
  algorithm->GetInformation()->Set(CurrentRequest(), reinterpret_cast<vtkIdType>(request));
}

int AnsweredRequest::WithoutInput() const
{
  if (this->Request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) &&
    this->Algorithm->GetNumberOfInputConnections(0) == 0)
  {
    littoral::FailedBy(this->Algorithm, "There is no input.");
  }
  return 0;
}

void AnsweredRequest::EmptyOutputs() const
{
  const bool isOfData = this->Request->Has(vtkDemandDrivenPipeline::REQUEST_DATA());
  for (int port = 0; isOfData && port < this->Outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* data = vtkDataObject::GetData(this->Outputs, port))
    {
      data->Initialize();
    }
  }
}

int AnsweredRequest::FailedBy(const std::string& message) const
{
  if (this->Request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    FailedInformation(this->Algorithm, this->Outputs);
  }
  this->EmptyOutputs();
  return littoral::FailedBy(this->Algorithm, message);
}

AnsweredRequest::~AnsweredRequest()
{
  this->Algorithm->GetInformation()->Set(CurrentRequest(), 0);
}

bool IsNewMistake(vtkAlgorithm* algorithm, const std::string& message, bool isError)
{
  vtkInformation* info = algorithm->GetInformation();
  vtkInformation* loop = LoopOf(algorithm);
  const bool isFurther = loop && loop->Has(HasFailed());
  if (loop && isError)
  {
    loop->Set(HasFailed(), 1);
  }
  const std::string line = Essence(message) + "\n";
  const std::string printed = HasMistakes(algorithm) ? info->Get(Mistakes()) : "";
  if (printed.empty())
  {
    info->Remove(HasErred());
  }
  if (isError)
  {
    info->Set(HasErred(), 1);
  }
  if (isFurther || printed.find(line) != std::string::npos || IsDueToUpstream(algorithm))
  {
    return false;
  }
  info->Set(Mistakes(), (printed + line).c_str());
  info->Set(MistakesTime(), static_cast<vtkIdType>(algorithm->GetMTime()));
  return true;
}

bool HasFailedInput(vtkAlgorithm* algorithm)
{
  return IsDueToUpstream(algorithm, HasErrors);
}

void KeepMistakes(vtkAlgorithm* algorithm, vtkMTimeType before)
{
  vtkInformation* info = algorithm->GetInformation();
  if (info->Has(MistakesTime()) && info->Get(MistakesTime()) == static_cast<vtkIdType>(before))
  {
    info->Set(MistakesTime(), static_cast<vtkIdType>(algorithm->GetMTime()));
  }
}

int FailedRequest(vtkAlgorithm* algorithm)
{
  return algorithm->GetExecutive()->IsA("vtkPVCompositeDataPipeline") ? 1 : 0;
}

int FailedBy(vtkAlgorithm* algorithm, const std::string& message)
{
  if (IsNewMistake(algorithm, message))
  {
    vtkErrorWithObjectMacro(algorithm, << message);
  }
  return FailedRequest(algorithm);
}

std::string FileMessage(const std::string& verb, const std::string& path, const std::string& what, std::string reason)
{
  const std::filesystem::path file(path);
  const std::string name = path.empty() ? what : file.filename().string();
  const std::string folder = file.has_parent_path() ? file.parent_path().string() + "/" : "";
  for (std::size_t at = 0; !folder.empty() && (at = reason.find(folder)) != std::string::npos;)
  {
    reason.erase(at, folder.size());
  }
  reason.erase(reason.find_last_not_of('.') + 1);
  std::error_code error;
  const bool isMissing =
    reason.find("o such file") != std::string::npos && !folder.empty() && !std::filesystem::exists(folder, error);
  reason = isMissing ? "there is no folder " + file.parent_path().string() : reason;
  reason = std::filesystem::is_directory(file, error) ? "it is a folder; give the name of a file in it" : reason;
  for (const char* action : { "set ", "choose ", "give " })
  {
    const std::size_t cut = reason.rfind(std::string("; ") + action);
    if (cut != std::string::npos)
    {
      std::string remedy = reason.substr(cut + 2);
      remedy.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(remedy.front())));
      return remedy + ": cannot " + verb + " " + name + ", " + reason.substr(0, cut) + ".";
    }
  }
  return "Cannot " + verb + " " + name + ": " + reason + ".";
}

int FailedInformation(vtkAlgorithm* algorithm, vtkInformationVector* outputs)
{
  const int none[6] = { 0, -1, 0, -1, 0, -1 };
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), none, 6);
  }
  return FailedRequest(algorithm);
}

bool IsAnnouncedEmpty(vtkInformation* output)
{
  int whole[6] = { 0, 0, 0, 0, 0, 0 };
  output->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  return whole[1] < whole[0];
}

}
