// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/WorkShare.h"

#include <algorithm>
#include <utility>

namespace littoral
{

void WorkShare::Complete(NumberRows& rows) const
{
  if (this->Ranks > 1)
  {
    this->Exchange(rows);
  }
}

void WorkShare::CompleteFirst(NumberRows& rows) const
{
  if (this->Ranks > 1)
  {
    this->Collect(rows);
  }
}

NumberRows WorkShare::Gather(std::vector<double> row) const
{
  NumberRows rows(this->Ranks);
  rows[this->Rank] = std::move(row);
  this->Complete(rows);
  return rows;
}

void WorkShare::AddUp(std::vector<double>& numbers) const
{
  const NumberRows rows = this->Gather(std::move(numbers));
  numbers.assign(rows.front().size(), 0.0);
  for (const std::vector<double>& row : rows)
  {
    std::transform(row.begin(), row.end(), numbers.begin(), numbers.begin(), std::plus<>());
  }
}

void WorkShare::AddUp(std::map<int, double>& numbers) const
{
  std::vector<double> own;
  for (const auto& [key, number] : numbers)
  {
    own.insert(own.end(), { static_cast<double>(key), number });
  }
  numbers.clear();
  const NumberRows rows = this->Gather(std::move(own));
  for (const std::vector<double>& row : rows)
  {
    for (std::size_t n = 0; n < row.size(); n += 2)
    {
      numbers[static_cast<int>(row[n])] += row[n + 1];
    }
  }
}

}
