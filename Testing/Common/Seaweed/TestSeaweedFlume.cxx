// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A blade in waves against what was measured in a flume: M. Luhar and H. Nepf, Wave-induced dynamics of flexible blades
// (Journal of Fluids and Structures 61, 2016). Data as published with L. Zhu et al. (2020), doi 10.1029/2019JC015517,
// in the repository lzhu7/flexibleBladeDynamicsWavesCurrents: harmonics of the water's velocity by height above the
// clamp, and the orbit of the tip.
#include "Numerics/Constants.h"
#include "Seaweed/SeaweedGrowth.h"
#include "Seaweed/SeaweedMotion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace littoral;

namespace
{

constexpr double Frequency = Pi;      // [rad/s]: 0.5 Hz
constexpr double WaveNumber = 1.9287; // [1/m]
constexpr int Harmonics = 4;

/// Numbers of a table after its line of names.
std::vector<std::vector<double>> ReadRows(const std::string& name)
{
  std::ifstream file(std::string(LITTORAL_TEST_DATA "/Flume2016/") + name);
  std::string line;
  std::getline(file, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(file, line))
  {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
    {
      rows.back().push_back(std::stod(cell));
    }
  }
  return rows;
}

/// The measured flow: u = sum of u_cos cos(h tau) + u_sin sin(h tau), tau = w t - k x, and w likewise.
class Flow
{
public:
  Flow()
    : Rows(ReadRows("flow.csv"))
  {
  }

  Vector3 Velocity(double x, double height, double time) const
  {
    const int levels = static_cast<int>(this->Rows.size()) / Harmonics;
    const auto heightOf = [&](int level) { return this->Rows[Harmonics * level][0]; };
    int level = 0;
    while (level < levels - 2 && heightOf(level + 1) < height)
    {
      ++level;
    }
    const double part = std::clamp((height - heightOf(level)) / (heightOf(level + 1) - heightOf(level)), 0.0, 1.0);
    const double phase = Frequency * time - WaveNumber * x;
    Vector3 velocity(0.0);
    for (int harmonic = 0; harmonic < Harmonics; ++harmonic)
    {
      const std::vector<double>& low = this->Rows[Harmonics * level + harmonic];
      const std::vector<double>& high = this->Rows[Harmonics * (level + 1) + harmonic];
      const auto mixed = [&](int column) { return (1.0 - part) * low[column] + part * high[column]; };
      const double c = std::cos((harmonic + 1) * phase);
      const double s = std::sin((harmonic + 1) * phase);
      velocity += Vector3(mixed(2) * c + mixed(3) * s, 0.0, mixed(4) * c + mixed(5) * s);
    }
    return velocity;
  }

  /// Du/Dt, as a difference along the path of the water.
  Vector3 Acceleration(double x, double height, double time) const
  {
    constexpr double step = 1e-3;
    const Vector3 u = this->Velocity(x, height, time);
    return (this->Velocity(x + step * u.x, height + step * u.z, time + step) -
             this->Velocity(x - step * u.x, height - step * u.z, time - step)) /
      (2.0 * step);
  }

private:
  std::vector<std::vector<double>> Rows;
};

/// The tip of the foam blade over a wave [m], after some waves: 20 cm, 20 mm x 1.9 mm, 500 kPa, 670 kg/m3. The ellipses
/// of links have less area and less second moment than its rectangle. Drag and added mass are those of plates at this
/// Keulegan-Carpenter number.
std::vector<Vector3> OrbitOfTip(const Flow& flow, int links)
{
  constexpr double Clamp = -1.0; // [m]
  constexpr double Length = 0.2;
  Skeleton skeleton;
  skeleton.StartBranch(-1, { 0.0, 0.0, Clamp }, 0.01);
  const std::vector<double> steps = BladeSteps(links);
  for (int i = 1; i <= links; ++i)
  {
    skeleton.Grow({ 0.0, 0.0, Clamp + Length * steps[i] }, 0.01);
  }
  SeaweedSegment segment;
  segment.Tissue = SeaweedTissue::Blade;
  segment.Width = 0.02;
  segment.Thickness = 0.0019;
  segment.Across = { 0.0, 1.0, 0.0 };
  segment.YoungModulus = 500e3 * (1.0 / 12.0) / (Pi / 64.0);
  segment.Density = 1000.0 - 330.0 * 4.0 / Pi;
  SeaweedOptions options;
  options.WaterDensity = 1000.0;
  options.DragCoefficient = 3.4;
  options.AddedMassCoefficient = 2.0;
  const std::vector<SeaweedSegment> segments(skeleton.Nodes.size(), segment);
  const SeaweedMotion motion(LinksOf(skeleton, segments, options), options);
  const LinkBatch& batch = motion.GetBatches().front();
  std::vector<LinkState> states = motion.AtRest();
  std::vector<LinkPose> poses(states.size());
  motion.Pose(states.data(), 0, states.size(), poses.data());
  std::vector<Vector3> middles(batch.PaddedLinks());
  std::vector<WaterAtLink> water(batch.PaddedLinks());
  constexpr int StepsPerWave = 200;
  constexpr double step = TwoPi / Frequency / StepsPerWave;
  constexpr int Waves = 8;
  std::vector<Vector3> orbit;
  for (int n = 0; n < Waves * StepsPerWave; ++n)
  {
    motion.Middles(batch, poses.data(), middles.data(), 0.5 * step);
    const double time = (n + 0.5) * step;
    for (std::size_t i = 0; i < middles.size(); ++i)
    {
      water[i].Velocity = flow.Velocity(middles[i].x, middles[i].z - Clamp, time);
      water[i].Acceleration = flow.Acceleration(middles[i].x, middles[i].z - Clamp, time);
    }
    motion.Step(step, batch, water.data(), states.data(), poses.data());
    if (n >= (Waves - 1) * StepsPerWave)
    {
      const Vector3 tip = poses.back().Foot + motion.GetLinks().back().Length * poses.back().Axis;
      orbit.push_back(tip - Vector3(0.0, 0.0, Clamp));
    }
  }
  return orbit;
}

/// Root mean square of the distances of points from the nearest of others [m].
double DistanceTo(const std::vector<Vector3>& points, const std::vector<Vector3>& others)
{
  double sum = 0.0;
  for (const Vector3& point : points)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3& other : others)
    {
      least = std::min(least, glm::distance(point, other));
    }
    sum += least * least;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

}

TEST(SeaweedFlume, TheTipOfABladeGoesRoundAsMeasured)
{
  std::vector<Vector3> measured;
  for (const std::vector<double>& row : ReadRows("orbit.csv"))
  {
    measured.emplace_back(row[0], 0.0, row[1]);
  }
  ASSERT_GT(measured.size(), 100u);
  const Flow flow;
  for (const int links : { 10, 20 })
  {
    const std::vector<Vector3> orbit = OrbitOfTip(flow, links);
    RecordProperty("ToModel" + std::to_string(links), std::to_string(DistanceTo(measured, orbit)));
    RecordProperty("ToMeasured" + std::to_string(links), std::to_string(DistanceTo(orbit, measured)));
    EXPECT_LT(DistanceTo(measured, orbit), 0.010) << links;
    EXPECT_LT(DistanceTo(orbit, measured), 0.010) << links;
  }
}
