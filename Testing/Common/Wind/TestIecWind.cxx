// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Deviations, gusts and changes of direction of IEC 61400-1 at 12 m/s, and the wind with them.
#include "Wind/IecWind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace littoral;

namespace
{

constexpr double Degree = 3.14159265358979323846 / 180.0;

IECSite SiteOf(IECClass turbulence)
{
  IECSite site;
  site.Class = turbulence;
  site.HubSpeed = 12.0;
  site.HubHeight = 90.0;
  return site;
}

}

TEST(IecWind, HasTheNumbersOfTheStandardAt12MetresPerSecond)
{
  // class, NTM, ETM of class I [m/s], EOG [m/s], EDC [degrees], computed elsewhere
  const struct
  {
    IECClass Class;
    double Normal, Extreme, Gust, Turn;
  } rows[] = { { IECClass::APlus, 2.628, 4.0147, 6.671, 38.25 }, { IECClass::A, 2.336, 3.5686, 5.930, 34.07 },
    { IECClass::C, 1.752, 2.6765, 4.447, 25.63 } };
  for (const auto& row : rows)
  {
    const IECSite site = SiteOf(row.Class);
    EXPECT_NEAR(DeviationOf(site, IECTurbulence::Normal) / row.Normal, 1.0, 1e-3);
    EXPECT_NEAR(DeviationOf(site, IECTurbulence::Extreme) / row.Extreme, 1.0, 1e-3);
    EXPECT_NEAR(OperatingGustOf(site) / row.Gust, 1.0, 1e-3);
    EXPECT_NEAR(DirectionChangeOf(site) / Degree / row.Turn, 1.0, 1e-3);
  }
  EXPECT_NEAR(DeviationOf(SiteOf(IECClass::B), IECTurbulence::Normal), 0.14 * 14.6, 1e-9);
}

TEST(IecWind, EventsTakeTheirCourse)
{
  const IECSite site = SiteOf(IECClass::A);
  const auto gust = [&](double time) { return StateOf(site, IECEvent::OperatingGust, time).Speed; };
  EXPECT_NEAR(gust(2.458), -1.590, 1.6e-3);
  EXPECT_NEAR(gust(5.25), 4.388, 4.4e-3);
  double lowest = 0.0;
  double highest = 0.0;
  for (double time = -3.0; time < 15.0; time += 0.001)
  {
    lowest = std::min(lowest, gust(time));
    highest = std::max(highest, gust(time));
    EXPECT_NEAR(gust(time), time < 0.0 || time > 10.5 ? 0.0 : gust(10.5 - time), 1e-9);
  }
  EXPECT_NEAR(lowest, gust(2.458), 1e-4);
  EXPECT_NEAR(highest, gust(5.25), 1e-6);
  const auto turn = [&](double time) { return StateOf(site, IECEvent::DirectionChange, time).Turn / Degree; };
  EXPECT_EQ(turn(-1.0), 0.0);
  EXPECT_NEAR(turn(3.0), 0.5 * 34.07, 0.02);
  EXPECT_NEAR(turn(6.0), 34.07, 0.03);
  EXPECT_EQ(turn(60.0), turn(6.0));
  const auto both = [&](double time) { return StateOf(site, IECEvent::CoherentGust, time); };
  EXPECT_NEAR(both(10.0).Speed, 15.0, 1e-9);
  EXPECT_NEAR(both(99.0).Turn / Degree, 60.0, 1e-9);
  EXPECT_NEAR(both(2.5).Speed, 7.5 * (1.0 - std::sqrt(0.5)), 1e-9);
  IECSite calm = site;
  calm.HubSpeed = 3.0;
  EXPECT_NEAR(StateOf(calm, IECEvent::CoherentGust, 10.0).Turn / Degree, 180.0, 1e-9);
}

TEST(IecWind, FastWindsHaveSmallerGusts)
{
  // 56 m/s once a year in class I
  IECSite site = SiteOf(IECClass::A);
  site.HubSpeed = 55.0;
  EXPECT_NEAR(OperatingGustOf(site), 1.35, 1e-9);
  site.HubSpeed = 60.0;
  EXPECT_EQ(OperatingGustOf(site), 0.0);
}

TEST(IecWind, EventPassesThroughTheField)
{
  WindModel model;
  model.ReferenceSpeed = 12.0;
  model.ReferenceHeight = 90.0;
  WindGrid grid;
  grid.Count = { 240, 3, 2 };
  grid.BottomHeight = 90.0;
  std::vector<float> field(240 * 3 * 2 * 3);
  MakeEventWind(model, grid, SiteOf(IECClass::A), IECEvent::CoherentGust, 5.0, field.data());
  const auto at = [&](int line, int step, int component) {
    return field[(static_cast<std::size_t>(line) * 240 + 239 - step) * 3 + component];
  };
  EXPECT_FLOAT_EQ(at(1, 50, 0), 12.0f);
  EXPECT_NEAR(at(1, 200, 0), 27.0 * 0.5, 1e-5);
  EXPECT_NEAR(at(2, 200, 1), 27.0 * std::sqrt(0.75), 1e-5); // to the left
  EXPECT_NEAR(std::hypot(at(3, 200, 0), at(3, 200, 1)), MeanSpeed(model, 92.0) + 15.0, 1e-5);
  EXPECT_EQ(at(0, 100, 2), 0.0f);
}

TEST(IecWind, SaysWhatIsWrong)
{
  EXPECT_EQ(WhyInvalid(IECSite(), IECEvent::None), "");
  EXPECT_NE(WhyInvalid(IECSite(), IECEvent::OperatingGust).find("needs an IECClass"), std::string::npos);
  IECSite site = SiteOf(IECClass::A);
  site.RotorDiameter = -1.0;
  EXPECT_NE(WhyInvalid(site, IECEvent::None).find("RotorDiameter"), std::string::npos);
}
