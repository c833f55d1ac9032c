// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The table of a scattered forest.

#include "Data/PlantTable.h"
#include "Expect.h"
#include "RandomData.h"

#include "vtkMultiBlockDataSet.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  RandomData data(bytes, size);
  vtkNew<vtkMultiBlockDataSet> forest;
  data.Fill(forest->GetFieldData(), { "PlantId", "Species", "Scale", "Azimuth", "Position", "Level" },
    { 1, 1, 1, 1, 3, 1 }, data.Count());
  littoral::PlantTable table;
  ReadsOrRefuses([&] { table = littoral::ReadTable(forest); });
  for (std::size_t row = 0; row < table.Places.size(); ++row)
  {
    const int found = table.RowOf(table.Places[row].Site);
    Expect(found >= 0 && table.Places[found].Site == table.Places[row].Site, "A plant is not in the table.");
  }
  Expect(table.RowOf(-1) == -1, "A plant is there that cannot be.");
  return 0;
}
