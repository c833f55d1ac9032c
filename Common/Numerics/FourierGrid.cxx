// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/FourierGrid.h"

#include <kissfft/kissfft.hh>

#include <algorithm>

namespace littoral
{

namespace
{
using Transformer = kissfft<double>;

/// Columns that are gathered together, so that each cache line that is touched is used whole.
constexpr int ColumnsAtOnce = 8;
}

int NextFastLength(int size)
{
  for (int length = std::max(size, 1);; ++length)
  {
    int cofactor = length;
    for (int prime : { 2, 3, 5 })
    {
      while (cofactor % prime == 0)
      {
        cofactor /= prime;
      }
    }
    if (cofactor == 1)
    {
      return length;
    }
  }
}

FourierGrid::FourierGrid(int width, int height)
  : Width(width)
  , Height(height)
  , Values(static_cast<std::size_t>(width) * height)
{
}

void FourierGrid::Transform(bool backward, const ParallelFor& parallel)
{
  parallel(this->Height, [&](std::size_t begin, std::size_t end) {
    Transformer along(this->Width, backward);
    std::vector<std::complex<double>> row(this->Width);
    for (std::size_t j = begin; j < end; ++j)
    {
      std::complex<double>* values = &this->Values[j * this->Width];
      std::copy(values, values + this->Width, row.begin());
      along.transform(row.data(), values);
    }
  });
  const std::size_t groups = (this->Width + ColumnsAtOnce - 1) / ColumnsAtOnce;
  parallel(groups, [&](std::size_t begin, std::size_t end) {
    Transformer along(this->Height, backward);
    std::vector<std::complex<double>> columns(static_cast<std::size_t>(ColumnsAtOnce) * this->Height);
    std::vector<std::complex<double>> result(columns.size());
    for (std::size_t group = begin; group < end; ++group)
    {
      const int first = static_cast<int>(group) * ColumnsAtOnce;
      const int count = std::min(ColumnsAtOnce, this->Width - first);
      for (int j = 0; j < this->Height; ++j)
      {
        for (int c = 0; c < count; ++c)
        {
          columns[static_cast<std::size_t>(c) * this->Height + j] = this->At(first + c, j);
        }
      }
      for (int c = 0; c < count; ++c)
      {
        const std::size_t start = static_cast<std::size_t>(c) * this->Height;
        along.transform(&columns[start], &result[start]);
      }
      for (int j = 0; j < this->Height; ++j)
      {
        for (int c = 0; c < count; ++c)
        {
          this->At(first + c, j) = result[static_cast<std::size_t>(c) * this->Height + j];
        }
      }
    }
  });
}

}
