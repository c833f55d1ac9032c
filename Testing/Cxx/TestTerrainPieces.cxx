// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The same bytes for any part of the extent and any number of threads.
#include "Numerics/SimdClones.h"
#include "vtkTurningBandsTerrainSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <iostream>

namespace
{

/// Samples along each side of the terrain, and of a part in it.
constexpr int Size = LITTORAL_IS_SANITIZED ? 512 : 1024;
constexpr int PartSize = Size / 16;
constexpr int FirstColumn = -100;

vtkNew<vtkTurningBandsTerrainSource> Source()
{
  vtkNew<vtkTurningBandsTerrainSource> source;
  source->SetWholeExtent(FirstColumn, FirstColumn + Size - 1, 0, Size - 1, 0, 0);
  source->SetAnisotropyRatio(2.5);
  source->SetAnisotropyAngle(25.0);
  source->SetSlope(0.1, -0.05);
  source->ReflectanceOn();
  return source;
}

const float* Values(vtkTurningBandsTerrainSource* source, const char* name)
{
  return vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray(name))->GetPointer(0);
}

/// Whether numbers have the same bytes.
bool AreSame(const float* a, const float* b, std::size_t count)
{
  return std::memcmp(static_cast<const void*>(a), static_cast<const void*>(b), count * sizeof(float)) == 0;
}

/// Where a row of an array begins.
std::size_t RowAt(int row, int length)
{
  return static_cast<std::size_t>(row) * length;
}

}

int TestTerrainPieces(int, char*[])
{
  bool good = true;
  auto whole = Source();
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "STDThread", false }, [&]() { whole->Update(); });
  auto threaded = Source();
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2, "STDThread", false }, [&]() { threaded->Update(); });
  auto part = Source();
  constexpr int column = Size * 400 / 1024; // of the whole
  constexpr int firstRow = Size * 555 / 1024;
  const int extent[6] = { FirstColumn + column, FirstColumn + column + PartSize - 1, firstRow, firstRow + PartSize - 1,
    0, 0 };
  part->UpdateExtent(extent);
  for (const char* name : { "Elevation", "Reflectance" })
  {
    const float* a = Values(whole, name);
    if (!AreSame(a, Values(threaded, name), RowAt(Size, Size)))
    {
      std::cerr << name << " differs between one and two threads" << std::endl;
      good = false;
    }
    const float* b = Values(part, name);
    for (int j = 0; j < PartSize; ++j)
    {
      const int row = firstRow + j;
      if (!AreSame(b + RowAt(j, PartSize), a + RowAt(row, Size) + column, PartSize))
      {
        std::cerr << name << " differs in row " << row << " of a part" << std::endl;
        good = false;
        break;
      }
    }
    for (int n = 0; name[0] == 'R' && n < Size * Size; ++n)
    {
      good &= a[n] >= 0.0f && a[n] <= 1.0f;
    }
  }
  // Lines are counted by the whole grid, for a part as well; and more of them on a larger grid.
  const auto linesOf = [](vtkTurningBandsTerrainSource* source) {
    return source->GetOutput()->GetFieldData()->GetArray("ElevationLines")->GetComponent(0, 0);
  };
  auto half = Source();
  constexpr int halfRow = Size * 200 / 1024;
  half->SetWholeExtent(FirstColumn, FirstColumn + Size / 2 - 1, halfRow, halfRow + Size / 2 - 1, 0, 0);
  half->UpdateExtent(extent);
  if (linesOf(part) != linesOf(whole) || std::abs(linesOf(whole) / linesOf(half) - 2.0) > 0.02)
  {
    std::cerr << linesOf(whole) << " lines, in a part " << linesOf(part) << ", on half the grid " << linesOf(half)
              << std::endl;
    good = false;
  }
  // What is asked for is what is taken.
  half->SetNumberOfLines(20);
  half->UpdateExtent(extent);
  good &= linesOf(half) == 20;

  auto other = Source();
  other->SetSeed(2);
  other->UpdateExtent(extent);
  if (std::memcmp(Values(part, "Elevation"), Values(other, "Elevation"), PartSize * PartSize * sizeof(float)) == 0)
  {
    std::cerr << "another seed gives the same terrain" << std::endl;
    good = false;
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
