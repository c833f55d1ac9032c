// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ErrorCounter_h
#define ErrorCounter_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <iostream>
#include <string>

/// Counts an algorithm's own error messages, and if told so warnings, and keeps the last; silences the executive's echo
/// of a failed request.
class ErrorCounter : public vtkCommand
{
public:
  static ErrorCounter* New() { return new ErrorCounter; }

  void Watch(vtkAlgorithm* algorithm)
  {
    this->Algorithm = algorithm;
    algorithm->AddObserver(vtkCommand::ErrorEvent, this);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
  }

  /// Counts warnings as well, from now on.
  void WatchWarnings() { this->Algorithm->AddObserver(vtkCommand::WarningEvent, this); }

  void Execute(vtkObject* caller, unsigned long event, void* text) override
  {
    if (event == vtkCommand::WarningEvent)
    {
      ++this->Warnings;
      this->LastWarning = static_cast<const char*>(text);
    }
    else if (caller == this->Algorithm)
    {
      ++this->Count;
      this->Last = static_cast<const char*>(text);
    }
  }

  /// Updates and checks for exactly one message, which names the given word, and for an update that says it failed.
  bool ExpectOneNaming(const std::string& word)
  {
    this->Count = 0;
    this->Last.clear();
    this->Algorithm->Modified();
    const bool succeeded = this->Algorithm->GetExecutive()->Update();
    const bool good = this->Count == 1 && this->Last.find(word) != std::string::npos && !succeeded;
    if (!good)
    {
      std::cerr << "wanted one message with '" << word << "' and a failure; got " << this->Count
                << " messages, the last: " << this->Last << (succeeded ? " (no failure)" : "") << std::endl;
    }
    return good;
  }

  int Count = 0;
  std::string Last;
  int Warnings = 0;
  std::string LastWarning;

private:
  vtkAlgorithm* Algorithm = nullptr;
};

/// Whether an update of an algorithm fails with exactly one message, which names the given word.
inline bool FailsNaming(const std::string& word, vtkAlgorithm* algorithm)
{
  vtkNew<ErrorCounter> errors;
  errors->Watch(algorithm);
  return errors->ExpectOneNaming(word);
}

#endif
