// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Chains of joints whose turns are known.
#include "Numerics/Constants.h"
#include "Plants/JointReduction.h"
#include "Plants/SampledCurve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace littoral;

namespace
{

constexpr double Rate = 24.0; // frames a second

/// A straight chain along x, 1 m a joint, each with a box from itself to the next one.
JointTree Chain(int joints)
{
  JointTree tree;
  for (int joint = 0; joint < joints; ++joint)
  {
    JointTree::Box box;
    box.Add({ joint, -0.1, 0.0 });
    box.Add({ joint + 1.0, 0.1, 0.0 });
    tree.Parents.push_back(joint - 1);
    tree.Rests.emplace_back(joint, 0.0, 0.0);
    tree.Boxes.push_back(box);
  }
  return tree;
}

/// Each joint turned about z relative to its parent.
JointFrame Turned(const JointTree& tree, const std::vector<double>& angles)
{
  JointFrame frame;
  double angle = 0.0;
  Vector3 place{ 0.0, 0.0, 0.0 };
  for (std::size_t joint = 0; joint < tree.Parents.size(); ++joint)
  {
    angle += angles[joint];
    frame.Rotations.emplace_back(
      static_cast<float>(std::cos(0.5 * angle)), 0.0f, 0.0f, static_cast<float>(std::sin(0.5 * angle)));
    frame.Positions.emplace_back(place);
    place += Vector3(std::cos(angle), std::sin(angle), 0.0);
  }
  return frame;
}

/// A number between those of two samples; `before` is the last sampled frame that is not behind the frame.
struct Between
{
  std::size_t Before;
  std::size_t After;
  double Share;
  int Length; ///< frames
};

Between FindSamples(std::size_t samples, int stride, int frames, int frame)
{
  if (samples == 1)
  {
    return { 0, 0, 0.0, 1 };
  }
  std::vector<int> times;
  for (int time = 0; time < frames - 1; time += stride)
  {
    times.push_back(time);
  }
  times.push_back(frames - 1);
  EXPECT_EQ(times.size(), samples);
  std::size_t before = 0;
  while (before + 2 < samples && times[before + 1] <= frame)
  {
    ++before;
  }
  const int length = times[before + 1] - times[before];
  return { before, before + 1, static_cast<double>(frame - times[before]) / length, length };
}

/// The cubic curve through two samples with slopes, by its four points (de Casteljau).
glm::dvec4 CubicBetween(
  const glm::dvec4& from, const glm::dvec4& leaving, const glm::dvec4& arriving, const glm::dvec4& to, double share)
{
  std::array<glm::dvec4, 4> points{ from, from + leaving / 3.0, to - arriving / 3.0, to };
  for (int order = 3; order > 0; --order)
  {
    for (int point = 0; point < order; ++point)
    {
      points[point] = (1.0 - share) * points[point] + share * points[point + 1];
    }
  }
  return points[0];
}

/// A value of entries before, at and after each sample, with slopes a second.
template <typename Get>
glm::dvec4 SmoothAt(const Get& get, const Between& found)
{
  const double time = found.Length / Rate;
  return CubicBetween(get(3 * found.Before + 1), time * get(3 * found.Before + 2), time * get(3 * found.After),
    get(3 * found.After + 1), found.Share);
}

/// The shortest turn between two, by an angle in proportion to the share: exp(s log(b a*)) a.
glm::dquat TurnBetween(const std::array<std::int16_t, 4>& p, const std::array<std::int16_t, 4>& q, double share)
{
  const glm::dquat a = glm::normalize(glm::dquat(p[3], p[0], p[1], p[2]));
  const glm::dquat b = glm::normalize(glm::dquat(q[3], q[0], q[1], q[2]));
  glm::dquat step = b * glm::conjugate(a);
  step = step.w < 0.0 ? -step : step;
  const Vector3 axis(step.x, step.y, step.z);
  const double sine = glm::length(axis);
  if (sine < 1e-12)
  {
    return a;
  }
  const double half = share * std::atan2(sine, step.w);
  return glm::dquat(std::cos(half), axis / sine * std::sin(half)) * a;
}

/// Where the tracks take a place that follows a joint of the tree.
Vector3 Played(const JointTree& tree, const ReducedJoints& reduced, int frames, int frame, int joint,
  const Vector3& place, std::size_t plant = 0)
{
  int kept = reduced.Follows[joint];
  Vector3 at = place - tree.Rests[reduced.Kept[kept]];
  for (; kept >= 0; kept = reduced.Parents[kept])
  {
    const JointTrack& track = reduced.Tracks[plant][kept];
    const bool isSmooth = track.IsSmooth;
    const Between found = FindSamples(track.Rotations.size() / (isSmooth ? 3 : 1), track.Stride, frames, frame);
    const glm::dvec4 smooth = !isSmooth ? glm::dvec4(0.0, 0.0, 0.0, 1.0)
                                        : SmoothAt(
                                            [&](std::size_t index) {
                                              const std::array<std::int16_t, 4>& parts = track.Rotations[index];
                                              return glm::dvec4(parts[0], parts[1], parts[2], parts[3]) / 32767.0;
                                            },
                                            found);
    const glm::dquat turn = isSmooth
      ? glm::normalize(glm::dquat(smooth.w, smooth.x, smooth.y, smooth.z))
      : TurnBetween(track.Rotations[found.Before], track.Rotations[found.After], found.Share);
    const int parent = reduced.Parents[kept];
    const Vector3 below = parent < 0 ? Vector3(0.0) : tree.Rests[reduced.Kept[parent]];
    const auto shift = [&](std::size_t index) { return glm::dvec4(Vector3(track.Translations[index]), 0.0); };
    const Vector3 offset = track.Translations.empty() ? tree.Rests[reduced.Kept[kept]] - below
      : isSmooth                                      ? Vector3(SmoothAt(shift, found))
                 : Vector3(glm::mix(shift(found.Before), shift(found.After), found.Share));
    at = offset + turn * at;
  }
  return at;
}

}

TEST(JointReduction, KeepsWhatTurns)
{
  const JointTree tree = Chain(5);
  // joint 2 turns by a right angle, joint 4 by so little that its end goes by 0.5 mm
  const std::vector<JointFrame> frames = { Turned(tree, { 0.0, 0.0, 0.0, 0.0, 0.0 }),
    Turned(tree, { 0.0, 0.0, 0.5 * Pi, 0.0, 0.0005 }) };
  const ReducedJoints reduced = ReduceJoints(tree, { { frames, 0.001 } }, Rate);
  EXPECT_EQ(reduced.Kept, (std::vector<int>{ 0, 2 }));
  EXPECT_EQ(reduced.Parents, (std::vector<int>{ -1, 0 }));
  EXPECT_EQ(reduced.Follows, (std::vector<int>{ 0, 0, 1, 1, 1 }));
  const Vector3 end = Played(tree, reduced, 2, 1, 4, { 5.0, 0.0, 0.0 });
  EXPECT_NEAR(end.x, 2.0, 0.001);
  EXPECT_NEAR(end.y, 3.0, 0.001);
  EXPECT_EQ(ReduceJoints(tree, { { frames, 0.0 } }, Rate).Kept.size(), 5u);
}

TEST(JointReduction, ErrorsStayBelowTheTolerance)
{
  constexpr int joints = 60;
  constexpr int samples = 20;
  const JointTree tree = Chain(joints);
  std::vector<JointFrame> frames;
  for (int sample = 0; sample < samples; ++sample)
  {
    std::vector<double> angles;
    for (int joint = 0; joint < joints; ++joint)
    {
      angles.push_back(0.01 * std::sin(0.7 * sample + 0.3 * joint) / (1.0 + joint % 7));
    }
    frames.push_back(Turned(tree, angles));
  }
  std::size_t last = joints + 1;
  for (const double tolerance : { 0.0005, 0.01, 0.2 })
  {
    const ReducedJoints reduced = ReduceJoints(tree, { { frames, tolerance } }, Rate);
    EXPECT_LT(reduced.Kept.size(), last);
    last = reduced.Kept.size();
    double worst = 0.0;
    for (int sample = 0; sample < samples; ++sample)
    {
      for (int joint = 0; joint < joints; ++joint)
      {
        const glm::dquat turn = glm::normalize(glm::dquat(frames[sample].Rotations[joint]));
        for (const double along : { 0.0, 0.5, 1.0 })
        {
          const Vector3 right = Vector3(frames[sample].Positions[joint]) + turn * Vector3(along, 0.1, 0.0);
          const Vector3 place = tree.Rests[joint] + Vector3(along, 0.1, 0.0);
          worst = std::max(worst, glm::length(Played(tree, reduced, samples, sample, joint, place) - right));
        }
      }
    }
    EXPECT_LT(worst, tolerance + 2e-5) << reduced.Kept.size();
    EXPECT_GT(worst, 0.2 * tolerance) << "the tolerance is hardly used";
  }
}

TEST(JointReduction, TakesFewSamples)
{
  // joint 1 turns evenly, joint 2 swings once a second, joint 3 turns by what the tolerance allows
  constexpr int samples = 121;
  const JointTree tree = Chain(4);
  std::vector<JointFrame> frames;
  for (int sample = 0; sample < samples; ++sample)
  {
    const double time = sample / 24.0;
    frames.push_back(
      Turned(tree, { 0.0, 0.02 * time, 0.02 * std::sin(2.0 * Pi * time), 0.0002 * std::sin(9.0 * time) }));
  }
  const ReducedJoints reduced = ReduceJoints(tree, { { frames, 0.005 } }, Rate);
  ASSERT_EQ(reduced.Kept, (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(reduced.Tracks[0][0].Rotations.size(), 1u);
  EXPECT_EQ(reduced.Tracks[0][1].Rotations.size(), 2u);
  // The best cubic curve over a time h is off by l a (w h / 2)^4 / 192: 2 m * 0.02 * (pi stride / 24)^4 / 192 is 5 mm
  // at a stride of 17 and 10 mm at 20. The best lines are off by l a (w h)^2 / 16, which is 7 mm at a stride of 5, so
  // they want 31 numbers.
  EXPECT_TRUE(reduced.Tracks[0][2].IsSmooth);
  EXPECT_EQ(reduced.Tracks[0][2].Stride, 17);
  EXPECT_EQ(reduced.Tracks[0][2].Rotations.size(), 27u);
  double worst = 0.0;
  for (int sample = 0; sample < samples; ++sample)
  {
    const glm::dquat turn = glm::normalize(glm::dquat(frames[sample].Rotations[3]));
    const Vector3 right = Vector3(frames[sample].Positions[3]) + turn * Vector3(1.0, 0.1, 0.0);
    worst = std::max(worst, glm::length(Played(tree, reduced, samples, sample, 3, { 4.0, 0.1, 0.0 }) - right));
  }
  EXPECT_LT(worst, 0.005);
  EXPECT_GT(worst, 0.0005);
}

TEST(JointReduction, FitsEachPlant)
{
  // the second plant stands still
  const JointTree tree = Chain(3);
  std::vector<JointFrame> moving, still;
  for (int sample = 0; sample < 10; ++sample)
  {
    moving.push_back(Turned(tree, { 0.0, 0.3 * std::sin(2.0 * sample), 0.0 }));
    still.push_back(Turned(tree, { 0.0, 0.05, 0.0 }));
  }
  const ReducedJoints reduced = ReduceJoints(tree, { { moving, 0.001 }, { still, 0.001 } }, Rate);
  ASSERT_EQ(reduced.Kept, (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(reduced.Tracks[0][1].Rotations.size(), 10u);
  EXPECT_EQ(reduced.Tracks[1][1].Rotations.size(), 1u);
  const Vector3 end = Played(tree, reduced, 10, 7, 2, { 3.0, 0.0, 0.0 }, 1);
  EXPECT_NEAR(end.x, 1.0 + 2.0 * std::cos(0.05), 1e-3);
  EXPECT_NEAR(end.y, 2.0 * std::sin(0.05), 1e-3);
}

TEST(JointReduction, KnowsTheToleranceOfEachPlant)
{
  // the same motion of a large plant, whose coordinates are small, and of a small one
  const JointTree tree = Chain(2);
  std::vector<JointFrame> frames;
  for (int frame = 0; frame < 121; ++frame)
  {
    frames.push_back(Turned(tree, { 0.0, 0.02 * std::sin(2.0 * Pi * frame / Rate) }));
  }
  const ReducedJoints reduced = ReduceJoints(tree, { { frames, 0.0002 }, { frames, 0.003 } }, Rate);
  EXPECT_EQ(reduced.Kept.size(), 2u);
  // errors go with the fourth power of the time between samples: 15^(1/4) is 2
  EXPECT_LT(3 * reduced.Tracks[1][1].Rotations.size(), 2 * reduced.Tracks[0][1].Rotations.size());
}

TEST(JointReduction, SamplesFrames)
{
  EXPECT_EQ(SampledFrames(1, 1), (std::vector<int>{ 0 }));
  EXPECT_EQ(SampledFrames(5, 2), (std::vector<int>{ 0, 2, 4 }));
  EXPECT_EQ(SampledFrames(6, 2), (std::vector<int>{ 0, 2, 4, 5 }));
  EXPECT_EQ(SampledFrames(6, 60), (std::vector<int>{ 0, 5 }));
}

TEST(JointReduction, TakesLinesWhereTheyAreFewer)
{
  // a joint that turns to and fro at a constant rate, with a corner twice a second
  const JointTree tree = Chain(2);
  std::vector<JointFrame> frames;
  for (int frame = 0; frame < 121; ++frame)
  {
    frames.push_back(Turned(tree, { 0.0, 0.002 * std::abs(frame % 24 - 12) }));
  }
  const ReducedJoints reduced = ReduceJoints(tree, { { frames, 0.001 } }, Rate);
  ASSERT_EQ(reduced.Tracks[0].size(), 2u);
  EXPECT_FALSE(reduced.Tracks[0][1].IsSmooth);
  EXPECT_EQ(reduced.Tracks[0][1].Stride, 12);
  EXPECT_EQ(reduced.Tracks[0][1].Rotations.size(), 11u);
}

TEST(JointReduction, RefusesSlopesThatHaveNoNumber)
{
  // half the angle changes by up to 0.5 * 1.2 * 2 pi a second, and numbers go up to 1
  const JointTree tree = Chain(2);
  std::vector<JointFrame> frames;
  for (int frame = 0; frame < 121; ++frame)
  {
    frames.push_back(Turned(tree, { 0.0, 1.2 * std::sin(2.0 * Pi * frame / Rate) }));
  }
  const ReducedJoints reduced = ReduceJoints(tree, { { frames, 0.004 } }, Rate);
  double worst = 0.0;
  for (int frame = 0; frame < 121; ++frame)
  {
    const double angle = 1.2 * std::sin(2.0 * Pi * frame / Rate);
    const Vector3 right = Vector3(1.0, 0.0, 0.0) + Vector3(std::cos(angle), std::sin(angle), 0.0);
    worst = std::max(worst, glm::length(Played(tree, reduced, 121, frame, 1, { 2.0, 0.0, 0.0 }) - right));
  }
  EXPECT_LT(worst, 0.004);
}

namespace
{

std::vector<glm::dvec4> Noise(int count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  std::vector<glm::dvec4> values(count);
  for (glm::dvec4& value : values)
  {
    value = { part(random), part(random), part(random), part(random) };
  }
  return values;
}

double SumOfSquares(
  const std::vector<glm::dvec4>& curve, const Sampling& sampling, const std::vector<glm::dvec4>& values)
{
  double sum = 0.0;
  for (int frame = 0; frame < static_cast<int>(values.size()); ++frame)
  {
    const glm::dvec4 away = CurveAt(curve, sampling, static_cast<int>(values.size()), frame) - values[frame];
    sum += glm::dot(away, away);
  }
  return sum;
}

}

TEST(SampledCurve, PassesThroughACubicPolynomial)
{
  constexpr int frames = 25;
  std::vector<glm::dvec4> values;
  for (int frame = 0; frame < frames; ++frame)
  {
    const double t = 0.1 * frame;
    values.emplace_back(1.0, t, t * t, t * t * t - t);
  }
  for (const int stride : { 3, 4, 6, 8, 12, 24 })
  {
    const Sampling sampling{ stride, true };
    const std::vector<glm::dvec4> curve = CurveThrough(values, sampling);
    EXPECT_EQ(static_cast<int>(curve.size()), 3 * (24 / stride + 1));
    EXPECT_EQ(CountOf(sampling, frames), 3 * (24 / stride + 1));
    EXPECT_LT(SumOfSquares(curve, sampling, values), 1e-18) << stride;
    // slopes are changes a frame
    EXPECT_NEAR(curve[2].y, 0.1, 1e-9);
    EXPECT_NEAR(curve[curve.size() - 3].w, 0.1 * (3.0 * 2.4 * 2.4 - 1.0), 1e-9);
  }
}

TEST(SampledCurve, HasTheLeastSumOfSquares)
{
  const std::vector<glm::dvec4> values = Noise(30);
  for (const Sampling& sampling : { Sampling{ 2, false }, Sampling{ 5, false }, Sampling{ 4, true },
         Sampling{ 7, true }, Sampling{ 29, true }, Sampling{ 29, false } })
  {
    const std::vector<glm::dvec4> curve = CurveThrough(values, sampling);
    const double least = SumOfSquares(curve, sampling, values);
    EXPECT_GT(least, 0.1);
    const std::vector<int> sampled = SampledFrames(30, sampling.Stride);
    const bool endsInALine = sampling.IsSmooth && sampled.back() - sampled[sampled.size() - 2] < 3;
    for (std::size_t number = 0; number < curve.size(); ++number)
    {
      if (endsInALine && number + 5 >= curve.size())
      {
        continue; // the slopes of the line follow from its ends
      }
      for (const double step : { -0.01, 0.01 })
      {
        std::vector<glm::dvec4> other = curve;
        other[number] += glm::dvec4(step);
        EXPECT_GE(SumOfSquares(other, sampling, values), least) << sampling.Stride << " " << number;
      }
    }
  }
}

TEST(SampledCurve, KeepsAllSamplesOfAStrideOfOne)
{
  const std::vector<glm::dvec4> values = Noise(9);
  EXPECT_EQ(CurveThrough(values, {}), values);
  EXPECT_EQ(CountOf({}, 9), 9);
  EXPECT_EQ(CountOf({ 4, true }, 10), 12);
}
