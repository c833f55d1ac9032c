// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Velocities in columns: exact for what is linear, on any cells and levels; coasts by their closed forms. Faces to
// nodes: exact for what is linear, at coasts and corners too.
#include "Currents/ColumnVelocity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

using namespace littoral;

namespace
{

using Place = std::array<double, 2>;

/// Samples of functions at the corners of a skewed grid of 5 x 4 columns and three layers.
class Given : public ColumnSamples
{
public:
  std::vector<Place> Corners;
  std::vector<FaceCorners> Cells;
  std::function<Vector3(double, double, double)> Flow;
  std::function<bool(double, double)> Water = [](double, double) { return true; };
  int Count = 3;
  bool Falls = false;

  explicit Given(bool areTriangles)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 5; ++i)
      {
        this->Corners.push_back({ 100.0 * i + 20.0 * j + 7.0 * ((i * j) % 3), 80.0 * j - 15.0 * i });
      }
    }
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 4; ++i)
      {
        const int a = 5 * j + i;
        if (areTriangles)
        {
          this->Cells.push_back({ a, a + 1, a + 6, -1 });
          this->Cells.push_back({ a, a + 6, a + 5, -1 });
        }
        else
        {
          this->Cells.push_back({ a, a + 1, a + 6, a + 5 });
        }
      }
    }
  }

  std::size_t Columns() const override { return this->Corners.size(); }
  int Layers() const override { return this->Count; }
  double Height(std::size_t column, int layer) const override
  {
    // a bed that slopes, levels unevenly apart
    const double share[] = { 0.9, 0.5, 0.2 };
    const int level = this->Falls ? 2 - layer : layer;
    return -share[level] * (30.0 + 0.05 * this->Corners[column][0] - 0.03 * this->Corners[column][1]);
  }
  Vector3 Sample(std::size_t column, int layer) const override
  {
    return this->Flow(this->Corners[column][0], this->Corners[column][1], this->Height(column, layer));
  }
  bool IsWater(std::size_t column, int) const override
  {
    return this->Water(this->Corners[column][0], this->Corners[column][1]);
  }
};

ColumnVelocity VelocityOf(const Given& given, CoastBehaviour coast = CoastBehaviour::Stop)
{
  return { std::make_shared<Given>(given), given.Corners, given.Cells, coast };
}

Vector3 Linear(double x, double y, double z)
{
  return { 1.0 + 2e-3 * x - 3e-3 * y + 0.05 * z, -0.5 + 1e-3 * x + 4e-3 * y - 0.02 * z, 0.1 + 1e-3 * x - 0.01 * z };
}

/// A strip of two square cells of 100 m from x = 0 to 200, of which the columns at 200 are land.
Given Strip(int layers)
{
  Given strip(false);
  strip.Corners = { { 0.0, 0.0 }, { 100.0, 0.0 }, { 200.0, 0.0 }, { 0.0, 100.0 }, { 100.0, 100.0 }, { 200.0, 100.0 } };
  strip.Cells = { { 0, 1, 4, 3 }, { 1, 2, 5, 4 } };
  strip.Count = layers;
  strip.Flow = [](double, double, double) { return Vector3(0.3, 0.4, 0.0); };
  strip.Water = [](double x, double) { return x < 150.0; };
  return strip;
}

}

TEST(ColumnVelocity, IsExactForLinearFlows)
{
  for (const bool areTriangles : { false, true })
  {
    for (const bool falls : { false, true })
    {
      Given given(areTriangles);
      given.Flow = Linear;
      given.Falls = falls;
      const ColumnVelocity velocity = VelocityOf(given);
      int found = 0;
      for (double x = 5.0; x < 450.0; x += 17.0)
      {
        for (double y = -60.0; y < 240.0; y += 13.0)
        {
          const Vector3 place(x, y, -10.0 - 0.02 * x);
          const Vector3 here = velocity.Velocity(place);
          if (here != Vector3(0.0))
          {
            ++found;
            EXPECT_LT(glm::length(here - Linear(x, y, place.z)), 1e-10);
          }
        }
      }
      EXPECT_GT(found, 250);
    }
  }
}

TEST(ColumnVelocity, CornersAndSidesBelongToIt)
{
  Given given(false);
  given.Flow = Linear;
  const ColumnVelocity velocity = VelocityOf(given);
  for (const FaceCorners& cell : given.Cells)
  {
    const Place& a = given.Corners[cell[0]];
    const Place& b = given.Corners[cell[1]];
    for (const double share : { 0.0, 0.3, 1.0 })
    {
      const double x = a[0] + share * (b[0] - a[0]), y = a[1] + share * (b[1] - a[1]);
      EXPECT_LT(glm::length(velocity.Velocity({ x, y, -14.0 }) - Linear(x, y, -14.0)), 1e-7);
    }
  }
  EXPECT_EQ(velocity.Velocity({ -50.0, 0.0, -14.0 }), Vector3(0.0));
  EXPECT_EQ(velocity.Velocity({ 1e9, 1e9, -14.0 }), Vector3(0.0));
}

TEST(ColumnVelocity, GoesOnForALayerBeyondItsSamples)
{
  Given strip = Strip(3);
  strip.Water = [](double, double) { return true; };
  strip.Flow = [](double, double, double z) { return Vector3(z, 0.0, 0.0); };
  const ColumnVelocity velocity = VelocityOf(strip);
  // levels at x = y = 0: -27, -15 and -6
  const auto at = [&](double z) { return velocity.Velocity({ 0.0, 0.0, z }).x; };
  EXPECT_NEAR(at(-20.0), -20.0, 1e-12);
  EXPECT_NEAR(at(-6.0), -6.0, 1e-12);
  EXPECT_NEAR(at(2.9), -6.0, 1e-12);
  EXPECT_EQ(at(3.1), 0.0);
  EXPECT_NEAR(at(-38.9), -27.0, 1e-12);
  EXPECT_EQ(at(-39.1), 0.0);
  EXPECT_LE(velocity.Heights().Low, -27.0);
  EXPECT_GE(velocity.Heights().High, -6.0);
}

TEST(ColumnVelocity, OneLayerHoldsForAllHeights)
{
  const ColumnVelocity velocity = VelocityOf(Strip(1));
  EXPECT_EQ(velocity.Velocity({ 50.0, 50.0, -500.0 }), Vector3(0.3, 0.4, 0.0));
  EXPECT_TRUE(std::isinf(velocity.Heights().Low) && std::isinf(velocity.Heights().High));
  EXPECT_TRUE(velocity.IsLevelAt(0.0));
}

TEST(ColumnVelocity, StopsOrSlidesAtACoast)
{
  const ColumnVelocity stop = VelocityOf(Strip(1), CoastBehaviour::Stop);
  const ColumnVelocity slide = VelocityOf(Strip(1), CoastBehaviour::Slide);
  for (const double x : { 100.0, 130.0, 170.0, 199.0 })
  {
    const double water = (200.0 - x) / 100.0;
    EXPECT_LT(glm::length(stop.Velocity({ x, 40.0, 0.0 }) - water * Vector3(0.3, 0.4, 0.0)), 1e-12);
    EXPECT_LT(glm::length(slide.Velocity({ x, 40.0, 0.0 }) - Vector3(water * 0.3, 0.4, 0.0)), 1e-12);
  }
  // away from the land it is as without land
  Given leaving = Strip(1);
  leaving.Flow = [](double, double, double) { return Vector3(-0.3, 0.4, 0.0); };
  EXPECT_LT(
    glm::length(VelocityOf(leaving, CoastBehaviour::Slide).Velocity({ 170.0, 40.0, 0.0 }) - Vector3(-0.3, 0.4, 0.0)),
    1e-12);
  EXPECT_EQ(slide.Velocity({ 200.0, 40.0, 0.0 }), Vector3(0.0));
}

TEST(ColumnVelocity, SlidesAlongACoastInAnyDirection)
{
  for (const double angle : { 0.5, 2.0, -1.1 })
  {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const auto turned = [&](const Vector3& a) {
      return Vector3(cosine * a.x - sine * a.y, sine * a.x + cosine * a.y, a.z);
    };
    Given strip = Strip(1);
    for (Place& corner : strip.Corners)
    {
      const Vector3 place = turned({ corner[0], corner[1], 0.0 });
      corner = { place.x, place.y };
    }
    strip.Water = [&](double x, double y) { return cosine * x + sine * y < 150.0; };
    strip.Flow = [&](double, double, double) { return turned({ 0.3, 0.4, 0.0 }); };
    const ColumnVelocity slide = VelocityOf(strip, CoastBehaviour::Slide);
    const Vector3 here = slide.Velocity(turned({ 170.0, 40.0, 0.0 }));
    EXPECT_LT(glm::length(here - turned({ 0.3 * 0.3, 0.4, 0.0 })), 1e-12);
    // the land on another side of the cells
    strip.Water = [&](double x, double y) { return cosine * y - sine * x < 50.0; };
    const Vector3 beside = VelocityOf(strip, CoastBehaviour::Slide).Velocity(turned({ 170.0, 40.0, 0.0 }));
    EXPECT_LT(glm::length(beside - turned({ 0.3, 0.6 * 0.4, 0.0 })), 1e-12);
  }
}

TEST(FacesToNodes, AreExactForLinearValues)
{
  const Given given(true);
  const FacesToNodes toNodes(given.Corners, given.Cells);
  const auto valueAt = [](double x, double y) { return 3.0 + 0.02 * x - 0.05 * y; };
  std::vector<double> values;
  for (const FaceCorners& face : given.Cells)
  {
    const Place &a = given.Corners[face[0]], &b = given.Corners[face[1]], &c = given.Corners[face[2]];
    values.push_back(valueAt((a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0));
  }
  for (int n = 0; n < static_cast<int>(given.Corners.size()); ++n)
  {
    EXPECT_NEAR(toNodes.At(n, values.data()), valueAt(given.Corners[n][0], given.Corners[n][1]), 1e-10) << n;
  }
}

TEST(FacesToNodes, AreExactForVectorsOnALargerMesh)
{
  std::vector<Place> nodes;
  std::vector<FaceCorners> faces;
  for (int j = 0; j < 9; ++j)
  {
    for (int i = 0; i < 9; ++i)
    {
      nodes.push_back({ 5000.0 * i + 900.0 * ((i + 2 * j) % 3), 5000.0 * j - 700.0 * ((2 * i + j) % 5) });
    }
  }
  for (int j = 0; j < 8; ++j)
  {
    for (int i = 0; i < 8; ++i)
    {
      const int a = 9 * j + i;
      faces.push_back({ a, a + 1, a + 9, -1 });
      faces.push_back({ a + 1, a + 10, a + 9, -1 });
    }
  }
  const auto valueAt = [](double x, double y) { return Vector3(1e-4 * x, 2e-4 * y, 1.0 + 1e-4 * (x - y)); };
  std::vector<Vector3> values;
  for (const FaceCorners& face : faces)
  {
    const Place &a = nodes[face[0]], &b = nodes[face[1]], &c = nodes[face[2]];
    values.push_back(valueAt((a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0));
  }
  const FacesToNodes toNodes(nodes, faces);
  for (int n = 0; n < 81; ++n)
  {
    EXPECT_LT(glm::length(toNodes.At(n, values.data()) - valueAt(nodes[n][0], nodes[n][1])), 1e-10) << n;
  }
}

TEST(FacesToNodes, TakeTheMeanOfTooFewAndNothingOfNone)
{
  const std::vector<Place> nodes{ { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 }, { 9.0, 9.0 } };
  const FacesToNodes toNodes(nodes, { { 0, 1, 2, -1 } });
  const double value = 5.0;
  EXPECT_EQ(toNodes.At(0, &value), 5.0);
  EXPECT_TRUE(std::isnan(toNodes.At(3, &value)));
}
