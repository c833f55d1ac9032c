// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralRankTeam_h
#define LittoralRankTeam_h

#include "Numerics/WorkShare.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;

namespace littoral
{

/**
 * The ranks that are asked for one update, each for its piece, and share its work where all have the same input. Only
 * where there is one piece a rank of the global controller, and of an image the part that VTK makes of the piece; else
 * a rank is alone. On a team each rank answers each of the others' exchanges, also when it fails: then the first rank
 * says why, and the others say nothing.
 */
class RankTeam
{
public:
  /// All ranks, for what each of them is asked for as a whole.
  RankTeam();
  /// The ranks that are asked for the output of a request; also for parts that a consumer has chosen of an image, where
  /// each rank has what any part needs. Until data are asked for, VTK does not tell the part that it makes of a piece.
  RankTeam(vtkInformation* request, vtkInformationVector* outputs, bool hasAnyPart = false);

  bool IsAlone() const { return this->Ranks < 2; }
  bool IsFirst() const { return this->Rank == 0; }
  /// Whether all have agreed.
  bool IsSharing() const { return this->IsShared; }

  /// Does the work of an update, which reads the input, agrees on it, once, and takes its share. Exceptions are thrown
  /// on, on the first rank those of the others, too, and there alone; the others end as by an abort.
  void Run(const std::function<void()>& work);

  /// The same for work that each rank would do where they do not agree: what one of them cannot do ends on all.
  void RunAll(const std::function<void()>& work);

  /// Whether something holds on all ranks, all of which ask.
  bool HoldsOnAll(bool own) const;

  /// Whether this rank has work to do: on a team whether all have the same input, by a number other than 0 that tells
  /// inputs apart, or it is the first.
  bool Agree(std::uint64_t input);

  /// Share of this rank; all of the work where they have not agreed.
  WorkShare Share();

private:
  std::string FirstReason(const std::string& own) const;
  void GoOn();
  [[noreturn]] void End(const std::string& reason) const;
  void Leave(const std::string& reason);
  std::vector<double> OwnNumbers(const NumberRows& rows) const;
  void TakeNumbers(const double* next, std::size_t rank, NumberRows& rows) const;
  void Exchange(NumberRows& rows);
  void Collect(NumberRows& rows);
  void Deal(const SingleRows& sent, SingleRows& received);

  vtkMultiProcessController* Controller;
  std::size_t Rank = 0;
  std::size_t Ranks = 1;
  bool HasAgreed = false;
  bool IsShared = false;
};

}

#endif
