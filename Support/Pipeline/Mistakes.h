// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportMistakes_h
#define LittoralSupportMistakes_h

// Report of an input or a property that a filter cannot work with: one message, not one for each execution. Private:
// never installed, never wrapped.

#include "vtkSetGet.h" // for vtkWarningMacro
#include "vtkType.h"

#include <sstream>
#include <string>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

namespace littoral
{

/**
 * Whether a message is to be printed: the first time since the algorithm was modified. Messages that differ in numbers
 * and names of types alone are the same. What follows from an upstream algorithm that has reported a mistake and has no
 * output is not printed; nor is a second error while VTK hands the leaves of a composite to the algorithm one by one.
 */
bool IsNewMistake(vtkAlgorithm* algorithm, const std::string& message, bool isError = true);

/// Lets mistakes be told by the request that they belong to, as long as it is answered.
class AnsweredRequest
{
public:
  AnsweredRequest(vtkAlgorithm* algorithm, vtkInformation* request, vtkInformationVector* outputs);
  ~AnsweredRequest();

  /// 0, after a message if there is no input that the type of the output could follow from. VTK has none for that.
  int WithoutInput() const;

  /// Empties the outputs of a request for data, with the field data that VTK passes on.
  void EmptyOutputs() const;

  /// Reports a mistake, empties the outputs or announces them as empty, and returns FailedRequest().
  int FailedBy(const std::string& message) const;

  AnsweredRequest(const AnsweredRequest&) = delete;
  AnsweredRequest& operator=(const AnsweredRequest&) = delete;

private:
  vtkAlgorithm* Algorithm;
  vtkInformation* Request;
  vtkInformationVector* Outputs;
};

/// Reports a mistake of an algorithm, which may have an output, by one vtkErrorMacro, and returns FailedRequest().
int FailedBy(vtkAlgorithm* algorithm, const std::string& message);

/**
 * Sentence about a file that cannot be read or written (`verb`), named without its folder, unless that is what is
 * missing; `what` stands for one without a name. What a user can do about it ("; set ...", "; choose ...", "; give
 * ...", at the end of the reason) comes first, since ParaView's list of messages shows the first 75 characters: "Set
 * Projection to UTM: cannot read srtm.hgt, its coordinates are degrees."
 */
std::string FileMessage(const std::string& verb, const std::string& path, const std::string& what, std::string reason);

/// Carries the printed messages over a modification since the time `before` that mends nothing, such as another view.
void KeepMistakes(vtkAlgorithm* algorithm, vtkMTimeType before);

/**
 * The result of a request that has failed: 0 in VTK. In ParaView it is 1, with the output as it is: a failed update
 * stops the representations, and each of them reports it at each rendering.
 */
int FailedRequest(vtkAlgorithm* algorithm);

/// FailedRequest() for RequestInformation(): the outputs are announced as empty.
int FailedInformation(vtkAlgorithm* algorithm, vtkInformationVector* outputs);

/// Whether FailedInformation() announced an output. For the beginning of RequestData().
bool IsAnnouncedEmpty(vtkInformation* output);

}

/// vtkWarningMacro(), but once for each mistake.
#define littoralWarningMacro(x)                                                                                        \
  do                                                                                                                   \
  {                                                                                                                    \
    std::ostringstream littoralMessage;                                                                                \
    littoralMessage << "" x;                                                                                           \
    if (littoral::IsNewMistake(this, littoralMessage.str(), false))                                                    \
    {                                                                                                                  \
      vtkWarningMacro(<< littoralMessage.str());                                                                       \
    }                                                                                                                  \
  }                                                                                                                    \
  while (false)

#endif
