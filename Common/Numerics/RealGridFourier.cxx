// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RealGridFourier.h"

#include <algorithm>

namespace littoral
{

namespace
{

/// Real columns that one pack of complex lines transforms.
constexpr std::size_t ColumnsAtOnce = 2 * FourierLanes;

/// Columns from first on, below them zeros: FourierLanes as real parts, as many as imaginary parts.
void ReadColumns(const std::vector<double>& values, std::array<int, 2> size, std::size_t first, DoubleLinePack& columns)
{
  const auto width = static_cast<std::size_t>(size[0]);
  std::fill(columns.Re.begin(), columns.Re.end(), 0.0);
  std::fill(columns.Im.begin(), columns.Im.end(), 0.0);
  const auto copy = [&](std::size_t begin, std::size_t row, std::vector<double>& part) {
    if (begin < width)
    {
      std::copy_n(
        &values[row * width + begin], std::min<std::size_t>(FourierLanes, width - begin), &part[row * FourierLanes]);
    }
  };
  for (std::size_t row = 0; row < static_cast<std::size_t>(size[1]); ++row)
  {
    copy(first, row, columns.Re);
    copy(first + FourierLanes, row, columns.Im);
  }
}

}

RealGridFourier::RealGridFourier(
  const std::vector<double>& values, std::array<int, 2> size, std::array<int, 2> padded, const ParallelFor& parallel)
  : Size(size)
  , Padded(padded)
  , Along(padded[0])
  , Stride((static_cast<std::size_t>(size[0]) + ColumnsAtOnce - 1) / ColumnsAtOnce * ColumnsAtOnce)
  , Re(this->Stride * this->NumberOfRows())
  , Im(this->Re.size())
{
  this->TransformColumns(values, parallel);
}

void RealGridFourier::TransformColumns(const std::vector<double>& values, const ParallelFor& parallel)
{
  const auto height = static_cast<std::size_t>(this->Padded[1]);
  const DoubleLineFourier across(this->Padded[1]);
  parallel(this->Stride / ColumnsAtOnce, [&](std::size_t begin, std::size_t end) {
    DoubleLinePack columns(height);
    for (std::size_t group = begin; group < end; ++group)
    {
      ReadColumns(values, this->Size, group * ColumnsAtOnce, columns);
      across.Backward(columns);
      for (std::size_t k = 0; k < static_cast<std::size_t>(this->NumberOfRows()); ++k)
      {
        // F = A + i B of real columns a, b: A = (F(k) + F*(-k)) / 2, B = (F(k) - F*(-k)) / 2i
        const std::size_t here = k * FourierLanes;
        const std::size_t there = k == 0 ? 0 : (height - k) * FourierLanes;
        double* re = &this->Re[k * this->Stride + group * ColumnsAtOnce];
        double* im = &this->Im[k * this->Stride + group * ColumnsAtOnce];
        for (std::size_t lane = 0; lane < FourierLanes; ++lane)
        {
          re[lane] = 0.5 * (columns.Re[here + lane] + columns.Re[there + lane]);
          im[lane] = 0.5 * (columns.Im[here + lane] - columns.Im[there + lane]);
          re[lane + FourierLanes] = 0.5 * (columns.Im[here + lane] + columns.Im[there + lane]);
          im[lane + FourierLanes] = 0.5 * (columns.Re[there + lane] - columns.Re[here + lane]);
        }
      }
    }
  });
}

void RealGridFourier::TransformRows(int pack, DoubleLinePack& rows) const
{
  const auto width = static_cast<std::size_t>(this->Size[0]);
  std::fill(rows.Re.begin() + static_cast<std::ptrdiff_t>(width * FourierLanes), rows.Re.end(), 0.0);
  std::fill(rows.Im.begin() + static_cast<std::ptrdiff_t>(width * FourierLanes), rows.Im.end(), 0.0);
  for (int lane = 0; lane < FourierLanes; ++lane)
  {
    const int row = pack * FourierLanes + lane;
    const bool isThere = row < this->NumberOfRows();
    const std::size_t start = isThere ? row * this->Stride : 0;
    for (std::size_t i = 0; i < width; ++i)
    {
      rows.Re[i * FourierLanes + lane] = isThere ? this->Re[start + i] : 0.0;
      rows.Im[i * FourierLanes + lane] = isThere ? this->Im[start + i] : 0.0;
    }
  }
  this->Along.Backward(rows);
}

}
