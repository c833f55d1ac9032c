// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Inventories of stands as files of any bytes, or of words that such tables have.

#include "Expect.h"
#include "Plants/InventoryPlants.h"
#include "Plants/StandInventory.h"
#include "RandomData.h"

#include <cmath>

namespace
{

/// A table of known names and of cells that are mostly numbers.
std::string TableOf(RandomData& data)
{
  const std::vector<const char*> names = { "x", "y", "dbh", "height", "species", "plot", "treeid", "status", "dbh_mm",
    "x (ft)", "girth", "genus", "gx", "gy", "\"a;b\"" };
  const std::vector<const char*> words = { "", "NA", "999", "-9", "1,5", "1.234,5", "oak", "Pinus taeda", "A", "dead",
    "5005", "1e300", "\"", "nan", "-inf", "0" };
  const auto oneOf = [&](const std::vector<const char*>& all) {
    return all[data.ConsumeIntegralInRange<std::size_t>(0, all.size() - 1)];
  };
  const char* separator = oneOf({ ",", ";", "\t" });
  const int columns = data.ConsumeIntegralInRange(1, 6);
  std::string text = "x" + std::string(separator) + "y";
  for (int column = 2; column < columns; ++column)
  {
    text += separator + std::string(oneOf(names));
  }
  for (vtkIdType row = data.Count(); row > 0; --row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const bool isNumber = data.ConsumeIntegralInRange(0, 7) != 0;
      text += (column == 0 ? "\n" : separator) + (isNumber ? std::to_string(data.Number()) : std::string(oneOf(words)));
    }
  }
  return text;
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace littoral;
  static const StandSpeciesTable species = StandSpeciesTable();
  RandomData data(bytes, size);
  const bool isText = data.ConsumeBool();
  InventoryOptions options;
  options.Seed = data.ConsumeIntegralInRange(0, 3);
  options.AllowCoincident = data.ConsumeBool();
  options.AllowImplausible = data.ConsumeBool();
  options.KeepDead = data.ConsumeBool();
  options.DiameterUnit = static_cast<LengthUnit>(data.ConsumeIntegralInRange(0, NumberOfLengthUnits - 1));
  options.HeightUnit = static_cast<LengthUnit>(data.ConsumeIntegralInRange(0, NumberOfLengthUnits - 1));
  const std::string text = isText ? data.ConsumeRemainingBytesAsString() : TableOf(data);
  TextTable table;
  if (!ReadsOrRefuses([&] { table = ReadTable(text); }))
  {
    return 0;
  }
  for (const std::vector<std::string>& column : table.Columns)
  {
    Expect(column.size() == table.NumberOfRows(), "A column has other rows.");
  }
  StandInventory stand;
  if (!ReadsOrRefuses([&] {
        stand = ReadInventory(table, species, options);
        CompleteStand(species, options, stand);
      }))
  {
    return 0;
  }
  Expect(!stand.Trees.empty() && stand.Trees.size() <= table.NumberOfRows(), "There are trees without a row.");
  Expect(AreaOf(stand) > 0.0 && std::isfinite(AreaOf(stand)), "The stand has no area.");
  for (const StandTree& tree : stand.Trees)
  {
    Expect(std::isfinite(tree.X) && std::isfinite(tree.Y), "A tree has no place.");
    Expect(tree.Diameter > 0.0 && tree.Diameter <= 12.0, "A tree is not as thick as one.");
    Expect(tree.Height > 0.0 && tree.Height <= 600.0, "A tree is not as high as one.");
    Expect(std::isfinite(CrownDiameterOf(tree.Diameter, tree.Height)), "A tree has no crown.");
  }
  const InventoryPlants plants = PlantsOfInventory(species, stand, 3);
  for (const int plant : plants.OfTree)
  {
    Expect(plant >= 0 && static_cast<std::size_t>(plant) < plants.Plants.size(), "A tree has no plant.");
  }
  return 0;
}
