// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWriterRanks_h
#define LittoralWriterRanks_h

// The ranks that write one file together. Private: never installed.

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkMultiProcessController;

namespace littoral
{

/**
 * Each rank has a part of the input, and the first one writes. What one cannot do ends on all of them: on the first by
 * InvalidInput, or by Aborted where it has told why, on the others by Aborted. Each rank must call the same functions.
 */
class WriterRanks
{
public:
  /// Null, or a controller of one process: a rank alone.
  explicit WriterRanks(vtkMultiProcessController* controller);

  bool IsAlone() const;
  bool IsFirst() const { return this->GetRank() == 0; }
  int GetRank() const;
  int GetNumberOfRanks() const;
  vtkMultiProcessController* GetController() const { return this->Controller; }

  /// The first rank that says so; -1 where none does.
  int FirstWith(bool isSo) const;
  /// The largest of the numbers of all.
  int Largest(int number) const;
  /// A number of the first rank, on each.
  int Shared(int number) const;
  /// Ends the work of all for the first reason; none where all are empty.
  void Agree(const std::string& reason) const;
  /// Asks an input, which all ranks have, for the part of this one.
  void AskForPart(vtkInformation* input) const;
  /// The part of this rank, of which the input of a writer is updated: a piece for each rank that has an input. Null
  /// where this rank has none, but another.
  vtkDataObject* PartOfInput(vtkAlgorithm* writer) const;

private:
  std::vector<int> AllOf(int number) const;

  vtkMultiProcessController* Controller;
};

}

#endif
