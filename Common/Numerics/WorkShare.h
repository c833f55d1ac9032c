// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralWorkShare_h
#define LittoralWorkShare_h

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
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

  /// Number of own rows of so many.
  std::size_t OwnOf(std::size_t rows) const { return (rows + this->Ranks - 1 - this->Rank) / this->Ranks; }
  /// Number of the own row n among those of all.
  std::size_t RowOf(std::size_t own) const { return this->Rank + this->Ranks * own; }

  void Complete(NumberRows& rows) const
  {
    if (this->Ranks > 1)
    {
      this->Exchange(rows);
    }
  }

  /// A row of each process, in their order.
  NumberRows Gather(std::vector<double> row) const
  {
    NumberRows rows(this->Ranks);
    rows[this->Rank] = std::move(row);
    this->Complete(rows);
    return rows;
  }

  /// Sums over all processes, of whole numbers.
  void AddUp(std::vector<double>& numbers) const
  {
    const NumberRows rows = this->Gather(std::move(numbers));
    numbers.assign(rows.front().size(), 0.0);
    for (const std::vector<double>& row : rows)
    {
      std::transform(row.begin(), row.end(), numbers.begin(), numbers.begin(), std::plus<>());
    }
  }

  /// The same of numbers by their keys.
  void AddUp(std::map<int, double>& numbers) const
  {
    std::vector<double> own;
    for (const auto& [key, number] : numbers)
    {
      own.insert(own.end(), { static_cast<double>(key), number });
    }
    numbers.clear();
    for (const std::vector<double>& row : this->Gather(std::move(own)))
    {
      for (std::size_t n = 0; n < row.size(); n += 2)
      {
        numbers[static_cast<int>(row[n])] += row[n + 1];
      }
    }
  }
};

}

#endif
