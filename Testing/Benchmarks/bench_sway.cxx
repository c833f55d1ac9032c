// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A frame of a forest in the wind: 1000 trees of 300 branches, the deformation alone, and the skinning of one tree,
// each against a bound measured in the same run.
#include "BranchSkin.h"
#include "Constants.h"
#include "PlantMotion.h"
#include "PlantSway.h"
#include "ReevesTree.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <thread>
#include <vector>

using namespace littoral;

namespace
{

constexpr int Trees = 1000;
constexpr std::size_t Branches = 300;

/// The first branches of an oak.
Skeleton Tree()
{
  Skeleton oak = GrowReevesTree(PresetParameters(TreePreset::Oak)).Wood;
  if (oak.Branches.size() > Branches)
  {
    oak.Nodes.resize(static_cast<std::size_t>(oak.Branches[Branches].First));
    oak.Branches.resize(Branches);
  }
  return oak;
}

void Gusts(const Vector3&, std::vector<Vector3>& velocities)
{
  velocities.resize(2400);
  for (std::size_t k = 0; k < velocities.size(); ++k)
  {
    const double t = TwoPi * static_cast<double>(k) / 2400.0;
    velocities[k] = { 8.0 + 2.0 * std::sin(31.0 * t), std::cos(70.0 * t), std::sin(190.0 * t) };
  }
}

/// Runs trees [0, Trees) in equal parts on threads.
template <typename Task>
void OnThreads(int threads, const Task& task)
{
  std::vector<std::thread> others;
  for (int t = 1; t < threads; ++t)
  {
    others.emplace_back([&, t] { task(Trees * t / threads, Trees * (t + 1) / threads); });
  }
  task(0, Trees / threads);
  for (std::thread& other : others)
  {
    other.join();
  }
}

/// All trees at full detail, each at a time of its own, as if the wind came to it later.
void MoveForest(benchmark::State& state)
{
  const int threads = static_cast<int>(state.range(0));
  const Skeleton tree = Tree();
  const PlantMotion motion(tree, 1);
  const SwayOptions options;
  const PlantSway sway(BeamsOf(tree, {}, options), options, 0.05, Vector3(0.0), Gusts);
  std::vector<JointPose> poses(Trees * tree.Nodes.size());
  double time = 0.0;
  for (auto _ : state)
  {
    time += 1.0 / 60.0;
    OnThreads(threads, [&](int begin, int end) {
      std::vector<Vector3> amplitudes(tree.Branches.size());
      for (int i = begin; i < end; ++i)
      {
        sway.Amplitudes(time - 0.1 * i, amplitudes.data());
        motion.Pose(amplitudes.data(), poses.data() + i * tree.Nodes.size());
      }
    });
    benchmark::DoNotOptimize(poses.data());
  }
  state.counters["branches"] = static_cast<double>(tree.Branches.size());
  state.counters["joints"] = static_cast<double>(tree.Nodes.size());
}
BENCHMARK(MoveForest)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The bound: as many poses multiplied by one rotation, read and written once.
void TurnSamePoses(benchmark::State& state)
{
  const int threads = static_cast<int>(state.range(0));
  const std::size_t joints = Tree().Nodes.size();
  std::vector<JointPose> poses(Trees * joints);
  const glm::dquat turn{ 0.8, 0.6, 0.0, 0.0 };
  for (auto _ : state)
  {
    OnThreads(threads, [&](int begin, int end) {
      for (std::size_t i = begin * joints; i < end * joints; ++i)
      {
        poses[i].Rotation = turn * poses[i].Rotation;
        poses[i].Shift += TurnedBy(poses[i].Rotation, Vector3(0.0, 0.0, 1.0));
      }
    });
    benchmark::DoNotOptimize(poses.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(TurnSamePoses)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

struct FloatSkin
{
  std::vector<float> Points;
  std::vector<float> Normals;
  std::vector<int> Ids;
  std::vector<float> Weights;

  explicit FloatSkin(const PlantMesh& mesh)
  {
    for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Points.push_back(static_cast<float>(mesh.Points[vertex][axis]));
        this->Normals.push_back(static_cast<float>(mesh.Normals[vertex][axis]));
      }
      for (int i = 0; i < 4; ++i)
      {
        this->Ids.push_back(mesh.JointIds[vertex][i]);
        this->Weights.push_back(static_cast<float>(mesh.JointWeights[vertex][i]));
      }
    }
  }
};

void SkinOneTree(benchmark::State& state)
{
  const Skeleton tree = Tree();
  const FloatSkin skin(SkinOf(tree, {}));
  const PlantMotion motion(tree, 1);
  std::vector<JointPose> poses(tree.Nodes.size());
  motion.Pose(std::vector<Vector3>(tree.Branches.size(), Vector3(0.01, 0.02, 0.0)).data(), poses.data());
  std::vector<JointChange> changes;
  for (std::size_t node = 0; node < poses.size(); ++node)
  {
    changes.push_back(ChangeOf(poses[node], tree.Nodes[node].Position));
  }
  std::vector<float> points(skin.Points.size());
  std::vector<float> normals(skin.Points.size());
  const RestSkin<float> rest{ skin.Points.data(), skin.Normals.data(), skin.Ids.data(), skin.Weights.data() };
  for (auto _ : state)
  {
    MoveSkin(rest, changes.data(), 0, points.size() / 3, points.data(), normals.data());
    benchmark::DoNotOptimize(points.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long long>(points.size() / 3));
}
BENCHMARK(SkinOneTree)->Unit(benchmark::kMicrosecond);

}

BENCHMARK_MAIN();
