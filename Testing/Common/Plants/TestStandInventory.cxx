// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/InvalidInput.h"
#include "Numerics/RandomStream.h"
#include "Plants/InventoryPlants.h"
#include "Plants/StandInventory.h"
#include "Plants/StandPlausibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>

using namespace littoral;

namespace
{

const StandSpeciesTable& Species()
{
  static const StandSpeciesTable table;
  return table;
}

StandInventory Read(const std::string& text, const InventoryOptions& options = {})
{
  StandInventory stand = ReadInventory(ReadTable(text), Species(), options);
  CompleteStand(Species(), options, stand);
  return stand;
}

std::string WhyNot(const std::string& text, const InventoryOptions& options = {})
{
  return WhyRefused([&] { Read(text, options); });
}

testing::AssertionResult Says(const std::string& reason, const char* words)
{
  return (reason.find(words) != std::string::npos ? testing::AssertionSuccess() : testing::AssertionFailure())
    << reason;
}

/// Trees on a square of places 4 m apart, with the rest of the row.
std::string Grid(int side, const std::string& head, const std::string& rest)
{
  std::string text = head + "\n";
  for (int tree = 0; tree < side * side; ++tree)
  {
    text += std::to_string(4 * (tree % side)) + "," + std::to_string(4 * (tree / side)) + rest + "\n";
  }
  return text;
}

}

namespace
{

/// H [ft] = 4.5 + P2 exp(-P3 D^P4), D in inches.
struct CurveInFeet
{
  const char* Species;
  double P2;
  double P3;
  double P4;

  /// Height [m] at a diameter [inches].
  double HeightAt(double inches) const
  {
    return 0.3048 * (4.5 + this->P2 * std::exp(-this->P3 * std::pow(inches, this->P4)));
  }
};

/// The Southern variant of the Forest Vegetation Simulator, table SNALL of its source sn/htdbh.f.
constexpr CurveInFeet SouthernVariant[] = {
  { "fir", 2163.946776, 6.26880851, -0.2161439 },
  { "eastern redcedar", 212.7932729, 3.47154903, -0.3258523 },
  { "spruce", 2163.946776, 6.26880851, -0.2161439 },
  { "sand pine", 3919.995225, 6.87312726, -0.19063343 },
  { "shortleaf pine", 444.0921666, 4.11876312, -0.30617043 },
  { "slash pine", 1087.101439, 5.10450596, -0.24284896 },
  { "longleaf pine", 98.56082813, 3.89930709, -0.86730393 },
  { "pitch pine", 208.7773185, 3.72806565, -0.410875 },
  { "pond pine", 142.7468108, 3.97260802, -0.5870983 },
  { "eastern white pine", 2108.844224, 5.65948135, -0.18563136 },
  { "loblolly pine", 243.860648, 4.28460566, -0.47130185 },
  { "Virginia pine", 926.1802712, 4.46209203, -0.20053974 },
  { "baldcypress", 119.5749091, 4.13535453, -0.79625456 },
  { "hemlock", 266.4562239, 3.99313675, -0.38600287 },
  { "red maple", 268.5564351, 3.11432843, -0.29411156 },
  { "silver maple", 80.51179925, 26.98331005, -2.02202808 },
  { "sugar maple", 209.8555358, 2.95281334, -0.36787496 },
  { "buckeye", 630.9504602, 4.51086779, -0.26826208 },
  { "birch", 170.5253403, 2.68833651, -0.40080716 },
  { "American hornbeam", 628.0209077, 3.88103963, -0.15387585 },
  { "hickory", 337.6684758, 3.62726466, -0.32083172 },
  { "hackberry", 484.7529797, 3.93933286, -0.25998833 },
  { "flowering dogwood", 863.0501053, 4.38560239, -0.14812185 },
  { "American beech", 526.1392688, 3.89232121, -0.22587084 },
  { "ash", 251.4042514, 3.26919806, -0.35905996 },
  { "white ash", 91.35276617, 6.99605268, -1.22937669 },
  { "green ash", 404.9692122, 3.39019741, -0.255096 },
  { "black walnut", 93.71042027, 3.6575094, -0.88246833 },
  { "sweetgum", 290.90548, 3.6239536, -0.3720123 },
  { "yellow-poplar", 625.7696614, 3.87320571, -0.23349496 },
  { "magnolia", 585.6609078, 3.41972033, -0.17661706 },
  { "blackgum", 319.9788466, 3.67313408, -0.30651323 },
  { "sourwood", 690.4917743, 4.15983216, -0.18613455 },
  { "sycamore", 644.3567687, 3.92045786, -0.21444786 },
  { "black cherry", 364.0247807, 3.55987361, -0.27263121 },
  { "white oak", 170.1330787, 3.27815866, -0.48744214 },
  { "scarlet oak", 196.0564703, 3.0067167, -0.38499624 },
  { "southern red oak", 150.4300023, 3.13270999, -0.49925872 },
  { "water oak", 470.0617193, 3.78892643, -0.25123824 },
  { "northern red oak", 700.0636452, 4.10607389, -0.21392785 },
  { "post oak", 765.2907525, 4.22375114, -0.18974706 },
  { "black oak", 224.716279, 3.11648501, -0.35982064 },
  { "live oak", 153.9588254, 3.11348786, -0.38947124 },
  { "black locust", 880.2844971, 4.59642097, -0.21824277 },
  { "willow", 408.2772475, 3.81808285, -0.27210505 },
  { "sassafras", 755.1038099, 4.39496421, -0.21778831 },
  { "basswood", 293.5715132, 3.52261899, -0.35122247 },
  { "elm", 1005.80672, 4.6473994, -0.20336143 },
  { "softwood", 212.7932729, 3.47154903, -0.32585230 },
  { "hardwood", 109.7324294, 2.25025802, -0.41297463 },
};

double OwnHeight(const char* name, double inches)
{
  return HeightOf(Species().GetSpecies()[Species().RowOf(name, "")].Curve, 0.0254 * inches);
}

}

TEST(StandAllometry, CurvesOfTheForestVegetationSimulator)
{
  EXPECT_EQ(std::size(SouthernVariant) + 1, Species().GetSpecies().size()); // and all tropics
  for (const CurveInFeet& curve : SouthernVariant)
  {
    for (const double inches : { 3.0, 8.0, 12.0, 40.0 })
    {
      const double wanted = curve.HeightAt(inches);
      EXPECT_NEAR(OwnHeight(curve.Species, inches), wanted, 1e-6 * wanted) << curve.Species;
    }
  }
}

// Other names lead to the same rows.
TEST(StandAllometry, SpeciesHaveOtherNames)
{
  for (const auto& [other, name] : { std::pair("Quercus alba", "white oak"), std::pair("redoak", "northern red oak"),
         std::pair("Carya glabra", "hickory"), std::pair("Pinus", "loblolly pine") })
  {
    EXPECT_EQ(Species().RowOf(other, ""), Species().RowOf(name, "")) << other;
  }
}

// Symbols of the PLANTS database, as the variants of the east of the United States have them (PLNJSP of the sources
// sn/blkdat.f, ne/blkdat.f, cs/blkdat.f and ls/blkdat.f), and without the number that tells species of the same letters
// apart, unless trees of two rows have these letters.
TEST(StandAllometry, SymbolsOfPlants)
{
  for (const auto& [symbol, name] :
    { std::pair("PIEC2", "Pinus echinata"), std::pair("piec", "Pinus echinata"), std::pair("PITA", "Pinus taeda"),
      std::pair("ACSA2", "Acer saccharinum"), std::pair("ACSA3", "Acer saccharum"), std::pair("QUAL", "Quercus alba"),
      std::pair("QUMA3", "Quercus marilandica"), std::pair("litu", "Liriodendron"), std::pair("2TE", "softwood"),
      std::pair("FRAXI", "Fraxinus"), std::pair("PIGL", "Picea glauca"), std::pair("PIGL2", "Pinus glabra"),
      std::pair("CAOV2", "Carya ovata"), std::pair("caco", "Carya cordiformis") })
  {
    EXPECT_EQ(Species().RowOf(symbol, ""), Species().RowOf(name, "")) << symbol;
    EXPECT_GE(Species().RowOf(symbol, ""), 0) << symbol;
  }
  for (const char* symbol : { "ACSA", "PIPU", "SAAL", "POGR4", "alsebl" })
  {
    EXPECT_FALSE(Species().Has(symbol)) << symbol;
  }
}

// Feldpausch et al. (2012), all tropics: 30 cm, 23.1 m.
TEST(StandAllometry, CurveOfAllTropics)
{
  EXPECT_NEAR(OwnHeight("tropical", 30.0 / 2.54), 50.874 * (1.0 - std::exp(-0.042 * std::pow(30.0, 0.784))), 1e-9);
}

TEST(StandAllometry, GrowsFromBreastHeightAndBack)
{
  for (const StandSpecies& species : Species().GetSpecies())
  {
    EXPECT_EQ(WhyInvalid(species.Curve), "") << species.Name;
    double last = 0.0;
    for (double diameter = 0.001; diameter < 1.5; diameter *= 1.1)
    {
      const double height = HeightOf(species.Curve, diameter);
      EXPECT_GT(height, last) << species.Name << " " << diameter;
      EXPECT_LT(height, 80.0) << species.Name;
      EXPECT_NEAR(DiameterOf(species.Curve, height), diameter, 1e-6 + 1e-4 * diameter) << species.Name;
      last = height;
    }
  }
  const HeightCurve curve;
  EXPECT_NEAR(HeightOf(curve, 0.0762 - 1e-9), HeightOf(curve, 0.0762 + 1e-9), 1e-6);
  EXPECT_NEAR(HeightOf(curve, 0.0), 1.3716, 1e-12);
  EXPECT_NEAR(DiameterOf(curve, 500.0), 3.0, 1e-9);
}

TEST(StandAllometry, CrownsAndDensity)
{
  // D = 0.557 (H W)^0.809 exp(0.056^2 / 2)
  const double width = CrownDiameterOf(0.3, 20.0);
  EXPECT_NEAR(0.557 * std::pow(20.0 * width, 0.809) * std::exp(0.5 * 0.056 * 0.056), 30.0, 1e-9);
  EXPECT_NEAR(width, 6.889, 1e-3);
  // R's itcSegment, dbh(H = 25, CA = 8, biome = 0), by the coefficients of its table: 0.557, 0.809, 0.056.
  EXPECT_NEAR(CrownDiameterOf(0.4055734, 25.0), 8.0, 1e-4);
  EXPECT_NEAR(DiameterOfDensity(284.0), 0.254, 1e-12);
  EXPECT_NEAR(284.0 * std::pow(2.0, 1.605), 864.0, 1.0); // half as thick
  EXPECT_NEAR(DiameterOfDensity(284.0 * std::pow(2.0, 1.605)), 0.127, 1e-12);
  double square = 0.0;
  constexpr int draws = 100000;
  for (int draw = 0; draw < draws; ++draw)
  {
    square += std::pow(DiameterInStand(0.3, (draw + 0.5) / draws), 2);
  }
  EXPECT_NEAR(std::sqrt(square / draws), 0.3, 1e-5);
}

TEST(StandInventory, KnownNamesAndUnits)
{
  const StandInventory plain = Read("x,y,species,DBH,Height\n1,2,oak,30,20\n5,7,Pinus palustris,12.5,\n");
  ASSERT_EQ(plain.Trees.size(), 2u);
  EXPECT_DOUBLE_EQ(plain.Trees[0].Diameter, 0.3);
  EXPECT_DOUBLE_EQ(plain.Trees[0].Height, 20.0);
  EXPECT_FALSE(plain.Trees[0].ImputedDiameter || plain.Trees[0].ImputedHeight);
  EXPECT_TRUE(plain.Trees[1].ImputedHeight);
  EXPECT_EQ(Species().GetSpecies()[plain.Trees[1].Species].Name, "longleaf pine");
  // ForestGEO: millimetres, status, coordinates of the plot.
  const StandInventory geo =
    Read("treeID,sp,gx,gy,dbh,status\n1,alsebl,3.5,4.5,250,A\n2,quru,8,9,NA,A\n3,quru,9,9,40,D\n");
  ASSERT_EQ(geo.Trees.size(), 2u);
  EXPECT_EQ(geo.Dropped, 1);
  EXPECT_DOUBLE_EQ(geo.Trees[0].Diameter, 0.25);
  EXPECT_DOUBLE_EQ(geo.Trees[0].X, 3.5);
  EXPECT_EQ(geo.Unlisted, std::vector<std::string>{ "alsebl" });
  EXPECT_EQ(Species().GetSpecies()[geo.Trees[1].Species].Name, "northern red oak");
  // Units in names, and told.
  const StandInventory feet = Read("x_ft,y (ft),dbh_in,height [ft]\n10,20,10,50\n40,20,8,NA\n");
  EXPECT_NEAR(feet.Trees[0].X, 3.048, 1e-12);
  EXPECT_NEAR(feet.Trees[0].Diameter, 0.254, 1e-12);
  EXPECT_NEAR(feet.Trees[0].Height, 15.24, 1e-12);
  InventoryOptions options;
  options.DiameterUnit = LengthUnit::Millimetre;
  options.CoordinateUnit = LengthUnit::Foot;
  const StandInventory told = Read("x,y,dbh\n10,20,150\n", options);
  EXPECT_DOUBLE_EQ(told.Trees[0].Diameter, 0.15);
  EXPECT_NEAR(told.Trees[0].Y, 6.096, 1e-12);
  // Girths, a genus of its own, ForestGEO's other names, a species that is not said.
  const StandInventory girths = Read("x,y,genus,species,girth\n1,2,Pinus,taeda,62.8318530718\n5,7,Quercus,alba,94\n");
  EXPECT_NEAR(girths.Trees[0].Diameter, 0.2, 1e-12);
  EXPECT_EQ(Species().GetSpecies()[girths.Trees[0].Species].Name, "loblolly pine");
  EXPECT_EQ(girths.Trees[1].Name, "Quercus alba");
  EXPECT_TRUE(girths.Unlisted.empty());
  EXPECT_DOUBLE_EQ(Read("x,y,dbh,girth\n1,2,30,95\n").Trees[0].Diameter, 0.3);
  EXPECT_NEAR(Read("x,y,gbh_in\n1,2,31.4159265359\n").Trees[0].Diameter, 0.254, 1e-10);
  EXPECT_DOUBLE_EQ(Read("TreeID,Mnemonic,PX,PY,DBH,Status\n1,quru,3.5,4.5,250,alive\n").Trees[0].Diameter, 0.25);
  EXPECT_TRUE(Read("x,y,species\n1,2,\n").Unlisted.empty());
  // Any subset.
  EXPECT_EQ(Read("x,y\n0,0\n3,4\n9,1\n").Trees.size(), 3u);
  EXPECT_EQ(Read("x,y,height\n0,0,12\n3,4,13\n").Trees.size(), 2u);
  InventoryOptions named;
  named.Columns.Diameter = "marks";
  EXPECT_DOUBLE_EQ(Read("x,y,marks\n0,0,32.9\n", named).Trees[0].Diameter, 0.329);
}

TEST(StandInventory, SeveralPlotsAndStems)
{
  const std::string text = "plot,x,y,dbh,treeid\nA,0,0,20,1\nA,10,8,30,2\nB,1,1,25,1\nB,5,9,35,2\nB,5,9,10,2\n";
  const StandInventory both = Read(text);
  ASSERT_EQ(both.Trees.size(), 4u);
  EXPECT_EQ(both.Plots, (std::vector<std::string>{ "A", "B" }));
  EXPECT_DOUBLE_EQ(both.Trees[2].X, 30.0); // 10 + 20, and the low corners in a line
  EXPECT_DOUBLE_EQ(both.Trees[2].Y, 0.0);
  EXPECT_DOUBLE_EQ(both.Trees[3].X, 34.0);
  EXPECT_DOUBLE_EQ(both.Trees[3].Diameter, 0.35); // the thicker stem
  EXPECT_EQ(both.Dropped, 1);
  InventoryOptions options;
  options.Plot = "B";
  EXPECT_EQ(Read(text, options).Trees.size(), 2u);
  // Stems stand within 2 m of each other; trees of one name farther apart are several.
  EXPECT_EQ(Read("x,y,dbh,treeid\n0,0,20,1\n0.3,0,25,1\n9,9,30,1\n9,10.9,28,1\n3,3,30,\n3.1,3,30,\n").Trees.size(), 4u);
  EXPECT_DOUBLE_EQ(Read("x,y,dbh,treeid\n0,0,20,1\n0.3,0,25,1\n5,5,9,2\n").Trees[0].X, 0.3);
  // Plots apart stay where they are.
  const StandInventory apart = Read("plot,x,y\nA,0,0\nA,9,9\nB,100,100\nB,109,120\n");
  EXPECT_DOUBLE_EQ(apart.Trees[2].X, 100.0);
}

TEST(StandInventory, DrawsBySeedAndRow)
{
  const std::string text = Grid(20, "x,y,species", ",white oak");
  const StandInventory one = Read(text);
  const StandInventory same = Read(text);
  InventoryOptions options;
  options.Seed = 2;
  const StandInventory other = Read(text, options);
  int differences = 0;
  for (std::size_t tree = 0; tree < one.Trees.size(); ++tree)
  {
    EXPECT_EQ(one.Trees[tree].Diameter, same.Trees[tree].Diameter);
    EXPECT_EQ(one.Trees[tree].Height, same.Trees[tree].Height);
    differences += one.Trees[tree].Diameter != other.Trees[tree].Diameter;
  }
  EXPECT_GT(differences, 390);
  // A stand without any measure: its quadratic mean is Reineke's of 1 tree on 16 m2, cut to 0.05 m or more.
  const double wanted = DiameterOfDensity(1e4 * 400.0 / AreaOf(one));
  EXPECT_NEAR(AreaOf(one), std::pow(76.0 * 401.0 / 399.0, 2), 1e-9);
  const double square = std::accumulate(one.Trees.begin(), one.Trees.end(), 0.0,
    [](double sum, const StandTree& tree) { return sum + tree.Diameter * tree.Diameter; });
  EXPECT_NEAR(std::sqrt(square / 400.0) / wanted, 1.0, 0.05);
  // Heights vary about the curve by a tenth.
  double mean = 0.0;
  double deviation = 0.0;
  for (const StandTree& tree : one.Trees)
  {
    const double curve = HeightOf(Species().GetSpecies()[tree.Species].Curve, tree.Diameter) - 1.3716;
    const double part = (tree.Height - 1.3716) / curve - 1.0;
    mean += part / 400.0;
    deviation += part * part / 400.0;
    EXPECT_LE(std::abs(part), 0.2 + 1e-9);
  }
  EXPECT_NEAR(mean, 0.0, 0.015);
  EXPECT_NEAR(std::sqrt(deviation), 0.1 * 0.96, 0.01); // cut at two standard deviations
}

TEST(StandInventory, DrawsFromWhatWasMeasured)
{
  // Half of the trees have a diameter, of 20 to 40 cm; all of those are a third higher than the curve.
  const int row = Species().RowOf("white oak", "");
  std::string text = "x,y,species,dbh,height\n";
  for (int tree = 0; tree < 200; ++tree)
  {
    const double diameter = 0.2 + 0.001 * tree;
    const double height = 4.0 / 3.0 * HeightOf(Species().GetSpecies()[row].Curve, diameter);
    text += std::to_string(3 * tree) + ",1,white oak," + std::to_string(100.0 * diameter) + "," +
      std::to_string(height) + "\n" + std::to_string(3 * tree) + ",5,white oak,,\n" + std::to_string(3 * tree) +
      ",9,white oak,," + std::to_string(height) + "\n";
  }
  InventoryOptions options;
  options.HeightVariation = 0.0;
  const StandInventory stand = Read(text, options);
  for (std::size_t tree = 0; tree < stand.Trees.size(); tree += 3)
  {
    EXPECT_FALSE(stand.Trees[tree].ImputedDiameter);
    const StandTree& drawn = stand.Trees[tree + 1];
    EXPECT_GE(drawn.Diameter, 0.2 - 1e-9);
    EXPECT_LE(drawn.Diameter, 0.4);
    EXPECT_NEAR(drawn.Height, 4.0 / 3.0 * HeightOf(Species().GetSpecies()[row].Curve, drawn.Diameter), 1e-3);
    EXPECT_NEAR(stand.Trees[tree + 2].Diameter, stand.Trees[tree].Diameter, 1e-4);
  }
}

TEST(StandInventory, OneMessageEach)
{
  EXPECT_TRUE(Says(WhyNot("a,b\n1,2\n"), "no columns x and y"));
  EXPECT_TRUE(Says(WhyNot("a,b\n1,2\n"), "a, b"));
  InventoryOptions options;
  options.Columns.Diameter = "Dicke";
  EXPECT_TRUE(Says(WhyNot("x,y,dbh\n1,2,3\n", options), "no column 'Dicke'; the table has x, y, dbh."));
  EXPECT_TRUE(Says(WhyNot("x,y,tag,Art,Dicke\n1,2,7,Eiche,30\n"), "none of Art, Dicke is known as a species"));
  EXPECT_EQ(WhyNot("id,x,y,plot,status,tag\n1,1,2,A,alive,7\n"), "");
  EXPECT_EQ(WhyNot("x,y,dbh,Art\n1,2,30,Eiche\n"), "");
  EXPECT_TRUE(Says(WhyNot("x,y\n"), "no rows"));
  EXPECT_TRUE(Says(WhyNot("x,y,status\n1,2,dead\n"), "none of the 1 rows"));
  EXPECT_TRUE(Says(WhyNot("x,y\n1,2\n3,4\n1,2\n"), "rows 1 and 3 stand at the same place (1, 2) m"));
  options = {};
  options.AllowCoincident = true;
  EXPECT_EQ(WhyNot("x,y\n1,2\n3,4\n1,2\n", options), "");
  EXPECT_TRUE(Says(WhyNot("x,y,dbh\n1,2,thick\n"), "row 1 has 'thick' for dbh"));
  TextTable commas;
  commas.Names = { "x", "y" };
  commas.Columns = { { "3,5" }, { "4" } };
  EXPECT_TRUE(Says(
    WhyRefused([&] { ReadInventory(commas, Species(), {}); }), "row 1 has '3,5' for x, which is no number, or two"));
  EXPECT_TRUE(Says(WhyNot("x,y,dbh\n1,2,-3\n"), "dbh of row 1 is -0.03 m"));
  EXPECT_TRUE(Says(WhyNot("x,y,height\n1,2,5e-324\n"), "height of row 1 is 4.94066e-324 m; it must be the length"));
  EXPECT_TRUE(Says(WhyNot("x,y\n1,NA\n"), "row 1 has no place: its y is 'NA'"));
  // Millimetres said to be centimetres, and feet said to be metres.
  EXPECT_TRUE(Says(WhyNot(Grid(3, "x,y,dbh", ",452")), "set DiameterUnit, to mm."));
  EXPECT_TRUE(Says(WhyNot(Grid(3, "x,y,height", ",95")), "height in m would have a median of 95 m"));
  options = {};
  options.DiameterUnit = LengthUnit::Metre;
  EXPECT_TRUE(Says(WhyNot(Grid(3, "x,y,dbh", ",12"), options), "to cm or mm or in"));
  EXPECT_TRUE(Says(WhyNot(Grid(3, "x,y,dbh,height", ",150,10")), "do not fit each other"));
  EXPECT_TRUE(Says(WhyNot(Grid(3, "x,y,dbh,height", ",2,20")), "do not fit each other"));
  // A plot on a unit square.
  std::string unit = "x,y\n";
  for (int tree = 0; tree < 100; ++tree)
  {
    unit += std::to_string(0.1 * (tree % 10)) + "," + std::to_string(0.1 * static_cast<double>(tree / 10)) + "\n";
  }
  EXPECT_TRUE(Says(WhyNot(unit), "set CoordinateScale"));
  EXPECT_TRUE(Says(WhyNot(unit), "Degrees must be projected"));
  options = {};
  options.CoordinateScale = 924.0;
  options.CoordinateUnit = LengthUnit::Foot;
  EXPECT_EQ(WhyNot(unit, options), "");
  options = {};
  options.DefaultSpecies = "moss";
  EXPECT_TRUE(Says(WhyNot("x,y\n1,2\n", options), "DefaultSpecies is 'moss'"));
  options = {};
  options.HeightVariation = 0.5;
  EXPECT_TRUE(Says(WhyNot("x,y\n1,2\n", options), "HeightVariation"));
}

// A column 1 cm thick that clamps at the foot buckles where J of order -1/3 has its first zero, 1.86635: H^3 = 9 / 4
// j^2 E D^2 / (16 density g), with McMahon's (1973) wood, 1.7e6 m of E / (density g).
TEST(StandPlausibility, NoTreeIsThreeTimesAsHighAsOneThatBuckles)
{
  const double critical = std::cbrt(9.0 / 4.0 * 1.86635 * 1.86635 * 1.7e6 * 0.01 * 0.01 / 16.0);
  EXPECT_TRUE(CanStand(0.01, 1.37 + 3.0 * 0.99 * critical));
  EXPECT_FALSE(CanStand(0.01, 1.37 + 3.0 * 1.02 * critical));
  EXPECT_TRUE(CanStand(7.7, 84.0)) << "General Sherman";
  EXPECT_TRUE(CanStand(0.05, 12.0));
  EXPECT_FALSE(CanStand(5.005, 4.0));
  EXPECT_TRUE(CanStand(0.3, std::nan("")) && CanStand(std::nan(""), 30.0));
}

TEST(StandPlausibility, CodesForMissingValuesAreNoMeasures)
{
  const auto measured = [](const std::string& word, const InventoryOptions& options = {}) {
    const std::string more = word + ",15\n90,2," + word + ",16\n";
    const StandInventory stand =
      ReadInventory(ReadTable(Grid(6, "x,y,dbh_mm,height", ",312,18") + "80,2," + more), Species(), options);
    EXPECT_EQ(stand.MissingCodes.size(), std::isfinite(stand.Trees[36].Diameter) ? 0u : 1u) << word;
    return stand.Trees[36].Diameter;
  };
  for (const char* code : { "999", "9999", "99999", "999.9", "5005", "-9", "-999", "-9999.0", "6400" })
  {
    EXPECT_TRUE(std::isnan(measured(code))) << code;
  }
  EXPECT_DOUBLE_EQ(measured("599"), 0.599);
  EXPECT_DOUBLE_EQ(measured("1001"), 1.001);
  InventoryOptions options;
  options.AllowImplausible = true;
  EXPECT_DOUBLE_EQ(measured("999", options), 0.999);
  EXPECT_TRUE(std::isnan(measured("-999", options)));
  // A tree of 99.9 cm among trees of 60 cm, heights of 99.9 m, and all of a column.
  EXPECT_DOUBLE_EQ(Read(Grid(5, "x,y,dbh", ",60") + "30,2,99.9\n").Trees[25].Diameter, 0.999);
  EXPECT_TRUE(Read(Grid(5, "x,y,dbh,height", ",30,20") + "30,2,30,99.9\n").Trees[25].ImputedHeight);
  EXPECT_TRUE(Read("x,y,dbh\n1,2,-9999\n5,2,-9999\n").Trees[0].ImputedDiameter);
}

// Trees that cannot be, in a stand that can; the advice for one that cannot is not refused in its turn.
TEST(StandPlausibility, OneMessageForWhatNoStandHas)
{
  const std::string pines = Grid(6, "x,y,dbh_mm,height", ",312,18");
  EXPECT_EQ(WhyNot(pines), "");
  EXPECT_TRUE(
    Says(WhyNot(pines + "80,2,5004,20\n"), "the tree of row 37 would be 5.004 m thick and 20 m high; correct it"));
  EXPECT_EQ(WhyNot(pines + "80,2,2900,20\n"), "");
  EXPECT_TRUE(Says(WhyNot(pines + "80,2,12,20\n80,8,12,20\n"), "the tree of row 37, like 1 more, would be"));
  InventoryOptions options;
  options.AllowImplausible = true;
  EXPECT_EQ(WhyNot(pines + "80,2,5004,20\n", options), "");
  EXPECT_TRUE(Says(WhyNot(pines + "80,2,50040,20\n", options), "at most 12 m"));
  // Metres taken for centimetres: trunks of 1.6 to 3.7 mm.
  EXPECT_TRUE(Says(WhyNot(Grid(6, "x,y,dbh", ",0.25")), "set DiameterUnit, to m or ft or in."));
  // Without heights 3120 mm may be 31 cm; at 18 m they may not be 3 cm.
  EXPECT_TRUE(Says(WhyNot(Grid(6, "x,y,dbh,height", ",312,18")), "set DiameterUnit, to mm."));
  EXPECT_TRUE(Says(WhyNot(Grid(6, "x,y,dbh,height", ",31,1800")), "set HeightUnit, to cm or in."));
  // 36 trees of 1.2 m on 20 x 20 m, and (37 / 35)^2 of it: 911 m2 a hectare, where millimetres would have 9.
  EXPECT_TRUE(Says(WhyNot(Grid(6, "x,y,dbh", ",120")),
    "basal area of 911 m2 a hectare, which is no stand of trees; set DiameterUnit, to mm."));
  EXPECT_TRUE(
    Says(WhyNot(pines + "80,2,12,80\n80,8,12,80\n80,14,12,80\n86,8,12,80\n86,14,12,80\n"), "cannot be; check"));
}

// A tree is at most four times as thick as the upper tenth of the others, or 3 m, and never more than 12 m.
TEST(StandPlausibility, ThickTreesNeedOthers)
{
  const auto likely = [](double others) { return LargestLikelyDiameter(std::vector<double>(20, others)); };
  EXPECT_DOUBLE_EQ(likely(0.3), 3.0);
  EXPECT_DOUBLE_EQ(likely(1.5), 6.0);
  EXPECT_DOUBLE_EQ(likely(5.0), 12.0);
  EXPECT_DOUBLE_EQ(LargestLikelyDiameter({}), 3.0);
}

// Two trees of 150 feet are among those of 60, though 150 m would be a code.
TEST(StandPlausibility, HeightsInFeetAreNoCodes)
{
  const std::string text = Grid(5, "x,y,height (ft)", ",60") + "30,2,150\n40,2,150\n";
  EXPECT_NEAR(Read(text).Trees[25].Height, 45.72, 1e-9);
  EXPECT_TRUE(Read(text).MissingCodes.empty());
  EXPECT_EQ(Read(Grid(5, "x,y,height (ft)", ",60") + "30,2,450\n40,2,450\n").MissingCodes.size(), 1u);
}

TEST(StandPlausibility, ATreeMistypedByKilometres)
{
  std::string text = Grid(6, "x,y", "");
  EXPECT_EQ(WhyNot(text + "60,3\n"), "");
  EXPECT_TRUE(Says(WhyNot(text + "2003,3\n"), "the tree of row 37 stands 1983 m along x from the others"));
  EXPECT_TRUE(Says(
    WhyNot(text + "3,-3000\n"), "the tree of row 37 stands 3000 m along y from the others, which are within 20 m"));
  // Others within 20 m may have one at 100 m, those within 316 m one at 632 m.
  EXPECT_EQ(WhyNot(text + "3,118\n"), "");
  EXPECT_TRUE(Says(WhyNot(text + "3,122\n"), "102 m along y"));
  const std::string wide = Grid(80, "x,y", "");
  EXPECT_EQ(WhyNot(wide + "3,946\n"), "");
  EXPECT_TRUE(Says(WhyNot(wide + "3,950\n"), "634 m along y"));
  InventoryOptions options;
  options.AllowImplausible = true;
  EXPECT_EQ(WhyNot(text + "2003,3\n", options), "");
  EXPECT_EQ(WhyNot("x,y\n0,0\n1,1\n2,900\n"), ""); // too few to tell
}

// Random trees on 100 x 60 m: the mean area is that of the plot.
TEST(StandInventory, AreaOfRandomTreesIsThatOfTheirPlot)
{
  for (const int count : { 5, 40 })
  {
    double mean = 0.0;
    constexpr int stands = 4000;
    for (int one = 0; one < stands; ++one)
    {
      const RandomStream random(one, RandomPurpose::StandDiameters);
      StandInventory stand;
      stand.Plots = { "" };
      for (int tree = 0; tree < count; ++tree)
      {
        const auto place = random.UniformPair(static_cast<std::uint64_t>(tree), 0);
        stand.Trees.emplace_back();
        stand.Trees.back().X = 100.0 * place[0];
        stand.Trees.back().Y = 60.0 * place[1];
      }
      mean += AreaOf(stand) / stands;
    }
    EXPECT_NEAR(mean / 6000.0, 1.0, 0.04) << count;
  }
}

TEST(StandInventory, NoColumnIsIgnoredInSilence)
{
  const StandInventory inches = Read("x,y,DIA (in),HT (ft)\n1,2,10,50\n5,2,8,45\n");
  EXPECT_NEAR(inches.Trees[0].Diameter, 0.254, 1e-12);
  EXPECT_NEAR(inches.Trees[0].Height, 15.24, 1e-12);
  EXPECT_TRUE(Says(WhyNot("x,y,dbh1,dbh2,ht\n1,2,10,11,9\n"), "set DiameterColumn: dbh1, dbh2 may be"));
  EXPECT_TRUE(Says(WhyNot("x,y,dbh_furlong\n1,2,10\n"), "set DiameterColumn: dbh_furlong may be"));
  EXPECT_TRUE(Says(WhyNot("x,y,BHD,Art\n1,2,10,Eiche\n"), "set DiameterColumn"));
  EXPECT_TRUE(Says(WhyNot("x,y,dbh,Height2019\n1,2,10,8\n"), "set HeightColumn: Height2019 may be"));
  EXPECT_TRUE(Says(WhyNot("x,y,dbh_mm,dbh (cm)\n1,2,100,10\n"), "set DiameterColumn: both dbh_mm and dbh (cm) may be"));
  InventoryOptions options;
  options.Columns.Diameter = "-";
  EXPECT_TRUE(Read("x,y,dbh1,ht\n1,2,10,9\n", options).Trees[0].ImputedDiameter);
  options.Columns.Diameter = "dbh1";
  EXPECT_DOUBLE_EQ(Read("x,y,dbh1,dbh2\n1,2,10,12\n", options).Trees[0].Diameter, 0.1);
  const StandInventory rest = Read("id,x,y,quadrat,dbh,agb,crown base height,status\n1,1,2,7,10,3,2,A\n");
  EXPECT_EQ(rest.Unread, (std::vector<std::string>{ "quadrat", "agb", "crown base height" }));
}

// Trees in a row take a strip of a tenth of its length, or another part that is asked for; a tree alone, one of a
// metre.
TEST(StandInventory, AreaOfARow)
{
  const StandInventory row = Read("x,y\n0,3\n10,3\n20,3\n30,3\n40,3\n");
  EXPECT_NEAR(AreaOf(row, 0.1), 60.0 * 6.0, 1e-9);
  EXPECT_NEAR(AreaOf(row, 0.5), 60.0 * 30.0, 1e-9);
  EXPECT_NEAR(AreaOf(Read("x,y\n0,3\n"), 0.1), 0.01, 1e-12);
}

// Twenty trees a square metre are no stand: 36 trees with a distance of 0.26 m are, of 0.2 m are not.
TEST(StandInventory, NoStandIsDenserThanTwentyTreesASquareMetre)
{
  InventoryOptions options;
  const std::string six = Grid(6, "x,y", ""); // 4 m apart
  options.CoordinateScale = 0.26 / 4.0;
  EXPECT_EQ(WhyNot(six, options), "");
  options.CoordinateScale = 0.2 / 4.0;
  EXPECT_TRUE(Says(WhyNot(six, options), "are no stand"));
  EXPECT_EQ(WhyNot(Grid(4, "x,y", ""), options), ""); // 16 trees: too few to tell
}

// Of nine diameters no others are drawn, of ten are, between them too.
TEST(StandInventory, DrawsFromTenMeasuredDiameters)
{
  const auto drawn = [](int measured) {
    std::string text = Grid(8, "x,y,dbh", ",");
    for (int tree = 0; tree < measured; ++tree)
    {
      text += std::to_string(40 + 4 * tree) + ",2," + std::to_string(80 + tree) + "\n";
    }
    const StandInventory stand = Read(text);
    std::vector<double> diameters;
    for (std::size_t tree = 0; tree < 64; ++tree)
    {
      diameters.push_back(stand.Trees[tree].Diameter);
    }
    return diameters;
  };
  for (const double diameter : drawn(9))
  {
    EXPECT_LT(diameter, 0.79); // by the density
  }
  double off = 0.0;
  for (const double diameter : drawn(10))
  {
    EXPECT_GE(diameter, 0.8);
    EXPECT_LE(diameter, 0.89 + 1e-12);
    off = std::max(off, std::abs(100.0 * diameter - std::round(100.0 * diameter)));
  }
  EXPECT_GT(off, 0.3);
}

TEST(StandSpecies, TablesOfUsers)
{
  const StandSpeciesTable own(ReadTable("species,kind,curve,a,b,c\nGINKGO;Ginkgo biloba,Birch,weibull,30,0.03,0.9\n"
                                        "Metasequoia,Pine,,,,\n"));
  EXPECT_EQ(own.RowOf("ginkgo", ""), 0);
  EXPECT_EQ(own.RowOf("Metasequoia glyptostroboides", ""), 1);
  EXPECT_EQ(own.RowOf("oak", "Ginkgo biloba"), 0);
  EXPECT_EQ(own.RowOf("oak", ""), -1);
  const auto why = [](const char* text) { return WhyRefused([&] { StandSpeciesTable{ ReadTable(text) }; }); };
  EXPECT_TRUE(Says(why("name,kind\na,b\n"), "needs the columns species and kind"));
  EXPECT_TRUE(Says(why("species,kind,curve,a,b,c\nyew,Pine,spline,1,1,1\n"), "row 1 of the table of species (yew)"));
  EXPECT_TRUE(Says(why("species,kind,curve,a,b,c\nyew,Pine,curtis,1,1,1\n"), "c is 1"));
  EXPECT_TRUE(Says(why("species,kind,curve,a,b,c\nyew,Pine,curtis,x,1,-1\n"), "no number a"));
  EXPECT_TRUE(Says(why("species,kind\nyew,\n"), "needs a species and a kind"));
}

// Of 30 pines of 10 to 39 cm and 2 oaks: thirds of the pines, and one plant for oaks that are nearly as thick, in the
// order of the table; each is the middle of its trees.
TEST(InventoryPlants, StandForTreesOfAKindThatAreAboutAsThick)
{
  std::string text = "x,y,species,dbh,height\n";
  for (int tree = 0; tree < 30; ++tree)
  {
    const int thick = 10 + (7 * tree) % 30;
    text += std::to_string(3 * tree) + ",1," + "Pinus taeda," + std::to_string(thick) + "," +
      std::to_string(5 + thick / 2) + "\n";
  }
  const StandInventory stand = Read(text + "5,9,oak,30,15\n15,9,Quercus rubra,33,16\n");
  const InventoryPlants plants = PlantsOfInventory(Species(), stand, 3);
  ASSERT_EQ(plants.Plants.size(), 4u);
  EXPECT_EQ(plants.Plants[3].Kind, "Oak");
  const double middles[] = { 0.15, 0.25, 0.35 };
  for (std::size_t tree = 0; tree < 30; ++tree)
  {
    const int size = static_cast<int>((stand.Trees[tree].Diameter - 0.0999) / 0.1);
    EXPECT_EQ(plants.OfTree[tree], size) << stand.Trees[tree].Diameter;
  }
  EXPECT_EQ(plants.OfTree[30], 3);
  EXPECT_EQ(plants.OfTree[31], 3);
  for (std::size_t size = 0; size < 3; ++size)
  {
    EXPECT_EQ(plants.Plants[size].Kind, "Pine");
    EXPECT_DOUBLE_EQ(plants.Plants[size].Diameter, middles[size]);
    EXPECT_NEAR(plants.Plants[size].Height, 5.0 + 50.0 * middles[size], 0.5001);
    const double crown = CrownDiameterOf(plants.Plants[size].Diameter, plants.Plants[size].Height);
    EXPECT_NEAR(plants.Plants[size].CrownDiameter, crown, 0.05 * crown);
  }
  // One class, as many as there are trees, and kinds without a tree.
  EXPECT_EQ(PlantsOfInventory(Species(), stand, 1).Plants.size(), 2u);
  EXPECT_EQ(PlantsOfInventory(Species(), stand, 20).Plants.size(), 6u + 1u); // ln(39 / 10) / ln 1.3 is 5.2
  EXPECT_EQ(PlantsOfInventory(Species(), Read("x,y,species,dbh\n1,2,oak,10\n5,2,oak,90\n"), 20).Plants.size(), 2u);
  InventoryOptions options;
  options.DiameterClasses = 0;
  EXPECT_TRUE(Says(WhyNot("x,y\n1,2\n", options), "DiameterClasses is 0"));
  options.DiameterClasses = 21;
  EXPECT_TRUE(Says(WhyNot("x,y\n1,2\n", options), "DiameterClasses is 21"));
}
