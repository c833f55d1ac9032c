// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Wind that veers: its mean direction by height, and gusts that turn with the mean.
#include "Wind/WindVeer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace littoral;

namespace
{

/// A hub at 90 m, and layers across a rotor of 120 m.
struct Rotor
{
  WindModel Model;
  WindGrid Grid;

  Rotor()
  {
    this->Model.ReferenceSpeed = 12.0;
    this->Model.ReferenceHeight = 90.0;
    this->Model.ShearExponent = 0.2;
    this->Grid.Count = { 64, 3, 5 };
    this->Grid.VerticalSpacing = 30.0;
    this->Grid.BottomHeight = 30.0;
  }

  std::vector<float> Make(double veer)
  {
    std::vector<float> field = WindField(this->Model, this->Grid, {}).Make();
    this->Model.Veer = veer;
    TurnWithHeight(this->Model, this->Grid, VeerTurn::FromLocal, field.data());
    return field;
  }
};

}

TEST(WindVeer, MeanDirectionTurnsClockwiseByDegreesPerMetre)
{
  // 0.1 degrees/m: from 6 degrees to the left at the foot of the rotor to 6 to the right at its top
  const double degrees[] = { 6.0, 3.0, 0.0, -3.0, -6.0 };
  Rotor rotor;
  const std::vector<float> field = rotor.Make(0.1);
  const std::size_t samples = 64 * 3;
  for (std::size_t layer = 0; layer < 5; ++layer)
  {
    double mean[2] = { 0.0, 0.0 };
    for (std::size_t n = 0; n < samples; ++n)
    {
      mean[0] += field[3 * (samples * layer + n)] / 192.0;
      mean[1] += field[3 * (samples * layer + n) + 1] / 192.0;
    }
    EXPECT_NEAR(std::atan2(mean[1], mean[0]) * 180.0 / 3.14159265358979323846, degrees[layer], 1e-4);
    EXPECT_NEAR(
      std::hypot(mean[0], mean[1]), 12.0 * std::pow((30.0 + 30.0 * static_cast<double>(layer)) / 90.0, 0.2), 1e-5);
  }
}

TEST(WindVeer, GustsStayThoseOfTheLocalAxes)
{
  Rotor rotor;
  const std::vector<float> straight = rotor.Make(0.0);
  std::vector<float> turned = rotor.Make(0.4);
  double largest = 0.0;
  for (std::size_t n = 0; n < turned.size(); n += 3)
  {
    EXPECT_EQ(turned[n + 2], straight[n + 2]);
    largest = std::max(largest, std::abs(static_cast<double>(turned[n + 1]) - straight[n + 1]));
  }
  EXPECT_GT(largest, 4.0); // 24 degrees at the top
  TurnWithHeight(rotor.Model, rotor.Grid, VeerTurn::ToLocal, turned.data());
  for (std::size_t n = 0; n < turned.size(); ++n)
  {
    EXPECT_NEAR(turned[n], straight[n], 4e-6);
  }
}

TEST(WindVeer, IsWithinTenDegreesPerMetre)
{
  WindModel model;
  model.Veer = -10.5;
  EXPECT_NE(WhyInvalid(model).find("Veer"), std::string::npos);
  model.Veer = -10.0;
  EXPECT_EQ(WhyInvalid(model), "");
}
