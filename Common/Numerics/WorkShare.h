// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWorkShare_h
#define LittoralWorkShare_h

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace littoral
{

/// Rows of numbers, each of a length of its own.
using NumberRows = std::vector<std::vector<double>>;

/// The same in single precision, one row a process.
using SingleRows = std::vector<std::vector<float>>;

/// Share of one of several processes in work that all of them are asked for, with the same input: every row whose
/// number is its rank modulo their number.
struct WorkShare
{
  std::size_t Rank = 0;
  std::size_t Ranks = 1;
  std::function<void(NumberRows& rows)> Exchange; ///< completes the rows by those of the others; called by all of them
  /// Row n that is sent goes to process n; what each has sent is received.
  std::function<void(const SingleRows& sent, SingleRows& received)> Deal;
  std::function<void(NumberRows& rows)> Collect; ///< completes the rows of the first process alone; called by all

  bool IsFirst() const { return this->Rank == 0; }
  /// Number of own rows of so many.
  std::size_t OwnOf(std::size_t rows) const { return (rows + this->Ranks - 1 - this->Rank) / this->Ranks; }
  /// Number of the own row n among those of all.
  std::size_t RowOf(std::size_t own) const { return this->Rank + this->Ranks * own; }

  void Complete(NumberRows& rows) const;

  /// Completes the rows of the first process; the others keep their own ones alone.
  void CompleteFirst(NumberRows& rows) const;

  /// A row of each process, in their order.
  NumberRows Gather(std::vector<double> row) const;

  /// Sums over all processes, of whole numbers.
  void AddUp(std::vector<double>& numbers) const;

  /// The same of numbers by their keys.
  void AddUp(std::map<int, double>& numbers) const;
};

}

#endif
