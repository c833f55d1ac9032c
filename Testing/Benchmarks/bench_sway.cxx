// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A frame of a forest in the wind: 1000 trees of 300 branches, the deformation alone, and the skinning of one tree,
// each against a bound measured in the same run.
#include "Numerics/Constants.h"
#include "Plants/BranchSkin.h"
#include "Plants/ReevesTree.h"
#include "Sway/PlantMotion.h"
#include "Sway/PlantSway.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
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

constexpr std::size_t Samples = 12000;
const WindTimes Times{ 0.05, Samples };

/// A wind of ten minutes in a table, as from an image.
const std::vector<Vector3>& GustTable()
{
  static const std::vector<Vector3> table = [] {
    std::vector<Vector3> velocities(Samples);
    for (std::size_t k = 0; k < Samples; ++k)
    {
      const double t = TwoPi * static_cast<double>(k) / Samples;
      velocities[k] = { 8.0 + 2.0 * std::sin(310.0 * t), std::cos(700.0 * t), std::sin(1900.0 * t) };
    }
    return velocities;
  }();
  return table;
}

void Gusts(const Vector3&, double first, std::size_t count, Vector3* velocities)
{
  const std::vector<Vector3>& table = GustTable();
  std::size_t at =
    static_cast<std::size_t>((std::llround(first) % static_cast<long long>(Samples) + Samples) % Samples);
  for (std::size_t k = 0; k < count; ++k, at = at + 1 < Samples ? at + 1 : 0)
  {
    velocities[k] = table[at];
  }
}

/// Runs a task on threads, which is told its number and theirs.
template <typename Task>
void OnThreads(int threads, const Task& task)
{
  std::vector<std::thread> others;
  for (int t = 1; t < threads; ++t)
  {
    others.emplace_back([&, t] { task(t, threads); });
  }
  task(0, threads);
  for (std::thread& other : others)
  {
    other.join();
  }
}

/// Frames of 1/60 s of a forest: some trees in full, of the others the trunk. Each tabulates anew every 1.6 s, at times
/// of its own.
void MoveForest(benchmark::State& state)
{
  const int threads = static_cast<int>(state.range(0));
  const int inFull = static_cast<int>(state.range(1));
  const Skeleton tree = Tree();
  Skeleton trunk = tree;
  trunk.Branches.resize(1);
  trunk.Nodes.resize(static_cast<std::size_t>(tree.Branches[0].Count));
  const PlantMotion motion(tree, 1);
  const PlantMotion trunkMotion(trunk, 1);
  const SwayOptions options;
  const std::vector<BranchBeam> beams = BeamsOf(tree, {}, options);
  std::vector<PlantSway> sways;
  for (int i = 0; i < Trees; ++i)
  {
    const auto end = i < inFull ? beams.end() : beams.begin() + 1;
    sways.emplace_back(
      std::vector<BranchBeam>(beams.begin(), end), options, Times, Vector3(7.0 * i, 3.1 * i, 0.0), Gusts);
  }
  std::vector<JointPose> poses(Trees * tree.Nodes.size());
  double time = 0.0;
  double slowest = 0.0;
  for (auto _ : state)
  {
    const auto begin = std::chrono::steady_clock::now();
    time += 1.0 / 60.0;
    OnThreads(threads, [&](int part, int parts) {
      std::vector<Vector3> amplitudes(tree.Branches.size());
      for (int i = part; i < Trees; i += parts)
      {
        sways[i].Amplitudes(time, amplitudes.data());
        (i < inFull ? motion : trunkMotion).Pose(amplitudes.data(), poses.data() + i * tree.Nodes.size());
      }
    });
    benchmark::DoNotOptimize(poses.data());
    const std::chrono::duration<double, std::milli> frame = std::chrono::steady_clock::now() - begin;
    slowest = time > 0.1 ? std::max(slowest, frame.count()) : 0.0;
  }
  state.counters["branches"] = static_cast<double>(tree.Branches.size());
  state.counters["joints"] = static_cast<double>(tree.Nodes.size());
  state.counters["slowest frame, ms"] = slowest;
  state.counters["responses, MB"] =
    1e-6 * (inFull * PlantSway::BytesOf(beams.size(), options) + (Trees - inFull) * PlantSway::BytesOf(1, options));
}
BENCHMARK(MoveForest)
  ->ArgNames({ "threads", "in full" })
  ->Args({ 1, 100 })
  ->Args({ 2, 100 })
  ->Args({ 1, Trees })
  ->Args({ 2, Trees })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Iterations(400);

/// The bound: as many poses multiplied by one rotation, read and written once.
void TurnSamePoses(benchmark::State& state)
{
  const int threads = static_cast<int>(state.range(0));
  const std::size_t joints = Tree().Nodes.size();
  std::vector<JointPose> poses(Trees * joints);
  const glm::dquat turn{ 0.8, 0.6, 0.0, 0.0 };
  for (auto _ : state)
  {
    OnThreads(threads, [&](int part, int parts) {
      const std::size_t begin = Trees * part / parts * joints;
      const std::size_t end = Trees * (part + 1) / parts * joints;
      for (std::size_t i = begin; i < end; ++i)
      {
        poses[i].Rotation = turn * poses[i].Rotation;
        poses[i].Shift += RotationOffset(poses[i].Rotation, Vector3(0.0, 0.0, 1.0));
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

/// Changes of the joints of a tree that is bent a little.
std::vector<JointChange> BentTree(const Skeleton& tree)
{
  const PlantMotion motion(tree, 1);
  std::vector<JointPose> poses(tree.Nodes.size());
  motion.Pose(std::vector<Vector3>(tree.Branches.size(), Vector3(0.01, 0.02, 0.0)).data(), poses.data());
  std::vector<JointChange> changes;
  for (std::size_t node = 0; node < poses.size(); ++node)
  {
    changes.push_back(ChangeOf(poses[node], tree.Nodes[node].Position));
  }
  return changes;
}

/// Skins of some trees: one stays in the cache, a stand of 250 does not.
void SkinTrees(benchmark::State& state)
{
  const auto trees = static_cast<std::size_t>(state.range(0));
  const Skeleton tree = Tree();
  const FloatSkin one(SkinOf(tree, {}));
  const std::vector<JointChange> bent = BentTree(tree);
  FloatSkin skin = one;
  std::vector<JointChange> changes = bent;
  for (std::size_t other = 1; other < trees; ++other)
  {
    skin.Points.insert(skin.Points.end(), one.Points.begin(), one.Points.end());
    skin.Normals.insert(skin.Normals.end(), one.Normals.begin(), one.Normals.end());
    skin.Weights.insert(skin.Weights.end(), one.Weights.begin(), one.Weights.end());
    std::transform(one.Ids.begin(), one.Ids.end(), std::back_inserter(skin.Ids),
      [&](int id) { return id + static_cast<int>(other * bent.size()); });
    changes.insert(changes.end(), bent.begin(), bent.end());
  }
  std::vector<float> points(skin.Points.size());
  std::vector<float> normals(skin.Points.size());
  const RestSkin rest{ skin.Points.data(), skin.Normals.data() };
  const SkinBinding binding(skin.Ids.data(), skin.Weights.data(), points.size() / 3);
  for (auto _ : state)
  {
    MoveSkin(rest, binding, changes.data(), 0, points.size() / 3, points.data(), normals.data());
    benchmark::DoNotOptimize(points.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long long>(points.size() / 3));
}
BENCHMARK(SkinTrees)->ArgName("size")->Arg(1)->Arg(250)->Unit(benchmark::kMicrosecond);

}

BENCHMARK_MAIN();
