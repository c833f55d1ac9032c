// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Kernels and the classes that call them, at the same work on as many threads: what a kernel computes is written to
// memory that it has already.
#include "Currents/CurrentDrift.h"
#include "Currents/FlowPrimitives.h"
#include "Data/PlantBlocks.h"
#include "Data/SeaStateTable.h"
#include "Data/SeaweedBlocks.h"
#include "Data/WindImage.h"
#include "Particles/ParticleFog.h"
#include "Particles/ParticleLevels.h"
#include "Patterns/PairFunctions.h"
#include "Patterns/QuadratPattern.h"
#include "Pipeline/Threads.h"
#include "Sea/WaveOrbits.h"
#include "Seaweed/SeaweedMotion.h"
#include "Seaweed/SeaweedSkin.h"
#include "Sway/SwayScene.h"
#include "Terrain/TerrainLevels.h"
#include "Wind/WindField.h"
#include "vtkBeamTreeDeformationFilter.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkParticleFogFilter.h"
#include "vtkParticleLevelOfDetailFilter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkPointPatternStatisticsFilter.h"
#include "vtkPointProcessSource.h"
#include "vtkQuadratPointSource.h"
#include "vtkReevesTreeSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkTerrainLevelOfDetailFilter.h"
#include "vtkWindFieldSource.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace littoral;

namespace
{

constexpr int Million = 1000000;
constexpr double Frame = 1.0 / 48.0; // [s]

/// Particles in 60 m x 60 m x 12 m of water: a sequence of low discrepancy.
struct Particles
{
  std::vector<float> Places;
  vtkNew<vtkPolyData> Set;

  explicit Particles(int count)
    : Places(3 * static_cast<std::size_t>(count))
  {
    const double factors[] = { 0.8191725134, 0.6710436067, 0.5497004779 };
    const double sides[] = { 60.0, 60.0, -12.0 };
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(count);
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      this->Places[i] = static_cast<float>(sides[i % 3] * std::fmod(factors[i % 3] * static_cast<double>(i / 3), 1.0));
    }
    for (int n = 0; n < count; ++n)
    {
      points->SetPoint(n, this->Places.data() + 3 * static_cast<std::size_t>(n));
    }
    this->Set->SetPoints(points);
  }
};

/// A sea of 30 trains on 20 m of water.
struct Waves
{
  vtkNew<vtkSeaStateSource> Source;
  SeaState State;

  Waves()
  {
    this->Source->SetWaterDepth(20.0);
    this->Source->Update();
    this->State = ReadSeaState(this->Source->GetOutput());
  }
};

/// A million particles in 30 trains at a new time.
struct Orbits
{
  Particles Water{ Million };
  Waves Sea;
  vtkNew<vtkParticleOrbitFilter> Filter;
  std::vector<float> Moved = std::vector<float>(3 * Million);
  double Time = 0.0;

  Orbits()
  {
    this->Filter->SetInputData(0, this->Water.Set);
    this->Filter->SetSeaStateConnection(this->Sea.Source->GetOutputPort());
  }
  std::size_t Items() const { return Million * this->Sea.State.Trains.size(); }
  void Kernel()
  {
    const WaveOrbits orbits(this->Sea.State, {}, this->Time += Frame);
    OrbitRequest<float> request;
    request.Centers = this->Water.Places.data();
    request.Displacement = this->Moved.data();
    request.AddsCenters = true;
    SmpFor(Million, [&](std::size_t begin, std::size_t end) { orbits.Evaluate(request, begin, end); });
  }
  void Class() { this->Filter->UpdateTimeStep(this->Time += Frame); }
};

/// The fog of a million particles.
struct Fog
{
  Particles Water{ Million };
  vtkNew<vtkParticleFogFilter> Filter;
  FogGrid Grid;
  FogMemory Memory;

  Fog()
  {
    this->Filter->SetInputData(this->Water.Set);
    this->Filter->UseBoundsOn();
    this->Filter->SetBounds(0.0, 60.0, 0.0, 60.0, -12.0, 0.0);
    this->Filter->SetDimensions(64, 64, 64);
    this->Grid = { { 0.0, 0.0, -12.0 }, { 60.0 / 63.0, 60.0 / 63.0, 12.0 / 63.0 }, { 64, 64, 64 } };
  }
  std::size_t Items() const { return Million; }
  void Kernel()
  {
    const auto read = [this](std::size_t begin, std::size_t end, FogParticle* particles) {
      for (std::size_t n = begin; n < end; ++n)
      {
        const float* place = this->Water.Places.data() + 3 * n;
        *particles++ = { { place[0], place[1], place[2] }, 1e-4 };
      }
    };
    const ParticleFog fog(this->Grid, Million, read, this->Memory, SmpFor);
    benchmark::DoNotOptimize(fog.GetExtinction().data());
  }
  void Class()
  {
    this->Filter->Modified();
    this->Filter->Update();
  }
};

/// Groups of a million particles, found anew in the order of the former ones, and what a view needs of them.
struct Groups
{
  Particles Water{ Million };
  Waves Sea;
  vtkNew<vtkParticleLevelOfDetailFilter> Filter;
  std::unique_ptr<ParticleGroups> Former;
  double Offset = 0.5; // [m]

  Groups()
  {
    this->Filter->SetInputData(0, this->Water.Set);
    this->Filter->SetSeaStateConnection(this->Sea.Source->GetOutputPort());
    this->Filter->SetViewPoint(30.0, 5.0, -6.0);
  }
  std::size_t Items() const { return Million; }
  double NextOffset() { return this->Offset = this->Offset > 0.5 ? 0.5 : 0.500001; }
  void Kernel()
  {
    GroupOptions options;
    options.MaximumOffset = this->NextOffset();
    std::vector<int> order = this->Former ? this->Former->GetTree() : std::vector<int>();
    this->Former = nullptr;
    this->Former = std::make_unique<ParticleGroups>(
      PlaceList(this->Water.Places.data(), Million), options, 64, SmpFor, NoPoll, std::move(order));
    View view;
    view.Point = { 30.0, 5.0, -6.0 };
    view.AspectRatio = this->Filter->GetAspectRatio();
    const TrainTable table(this->Sea.State, -12.0, 0.0, view, TrainRule::TailSum, 1.0);
    const ParticleSelection selection =
      SelectParticles(*this->Former, table, ViewFrustum(view), {}, 0, this->Former->GetCells().size(), SmpFor);
    benchmark::DoNotOptimize(selection.Parts.data());
  }
  void Class()
  {
    this->Filter->SetOffsetRange(0.0, this->NextOffset());
    this->Filter->Update();
  }
};

/// A step of 100 000 particles under a surface, in a source, a vortex, a uniform flow and a sink.
struct Drift
{
  static constexpr int Count = 100000;
  Particles Water{ Count };
  vtkNew<vtkCurrentDriftFilter> Filter;
  std::vector<FlowPrimitive> Flows;
  WaterLayer Layer;
  FlowField Field;
  std::vector<Vector3> Places = std::vector<Vector3>(Count);
  std::vector<float> Written = std::vector<float>(3 * Count);
  int Step = 0;

  Drift()
  {
    this->Filter->SetInputData(0, this->Water.Set);
    this->Add(vtkFlowPrimitiveSource::Uniform, 0.01, 0.0);
    this->Add(vtkFlowPrimitiveSource::Vortex, 1.0, 32.0);
    this->Add(vtkFlowPrimitiveSource::Source, 1.0, 26.0);
    this->Add(vtkFlowPrimitiveSource::Sink, 1e-3, 35.0);
    this->Layer.Surface = 0.0;
    this->Field = FlowField(this->Flows, this->Layer);
    for (std::size_t i = 0; i < this->Water.Places.size(); ++i)
    {
      this->Places[i / 3][static_cast<int>(i % 3)] = this->Water.Places[i];
    }
    this->Filter->UpdateTimeStep(0.0);
  }
  void Add(int type, double strength, double x)
  {
    vtkNew<vtkFlowPrimitiveSource> flow;
    flow->SetFlowType(type);
    flow->SetStrength(strength);
    flow->SetCenter(x, 0.5 * x, -5.0);
    flow->SetAxis(0.1, 0.2, 1.0);
    this->Filter->AddCurrentConnection(flow->GetOutputPort());
    FlowPrimitive primitive;
    primitive.Type = static_cast<FlowType>(type);
    primitive.Strength = strength;
    primitive.Center = { x, 0.5 * x, -5.0 };
    primitive.Axis = { 0.1, 0.2, 1.0 };
    primitive.CoreRadius = flow->GetCoreRadius();
    this->Flows.push_back(primitive);
  }
  std::size_t Items() const { return Count; }
  void Kernel()
  {
    const auto velocity = [this](const Vector3& at, int) { return this->Field.Velocity(at); };
    SmpFor(Count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        const Vector3 from = this->Places[n];
        Vector3 ahead;
        this->Places[n] = DriftStep(this->Layer, from, 0.1, velocity, &ahead);
        if (!this->Field.Capture(from, ahead))
        {
          this->Field.Capture(from, this->Places[n]);
        }
        std::transform(&this->Places[n].x, &this->Places[n].x + 3, this->Written.data() + 3 * n,
          [](double x) { return static_cast<float>(x); });
      }
    });
  }
  void Class() { this->Filter->UpdateTimeStep(0.1 * ++this->Step); }
};

/// A million points, one in each quadrat on the average.
struct Quadrats
{
  vtkNew<vtkQuadratPointSource> Source;
  std::vector<double> Positions;
  std::vector<long long> Numbers;

  Quadrats()
  {
    this->Source->SetQuadrats(1000, 1000);
    this->Source->SetMode(vtkQuadratPointSource::Sampling);
  }
  std::size_t Items() const { return Million; }
  void Kernel()
  {
    const QuadratGrid grid{ { 0.0, 0.0 }, { 1000.0, 1000.0 }, { 1000, 1000 } };
    const std::vector<int> counts = QuadratCounts({}, Million, QuadratMode::Sampling, 1, NoPoll, SmpFor);
    constexpr std::size_t atOnce = 4096;
    const std::vector<long long> sites = QuadratSites(counts, 0, counts.size(), atOnce);
    this->Positions.resize(3 * static_cast<std::size_t>(sites.back()));
    this->Numbers.resize(static_cast<std::size_t>(sites.back()));
    SmpFor(sites.size() - 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t batch = begin; batch < end; ++batch)
      {
        PlaceQuadratPoints(grid, 1, counts, batch * atOnce, std::min(counts.size(), (batch + 1) * atOnce),
          this->Positions.data() + 3 * sites[batch], this->Numbers.data() + sites[batch]);
      }
    });
  }
  void Class()
  {
    this->Source->Modified();
    this->Source->Update();
  }
};

/// g of 100 000 random points, each with a thousand others within the longest distance.
struct Pairs
{
  static constexpr int Count = 100000;
  vtkNew<vtkPointPatternStatisticsFilter> Filter;
  std::vector<PlanePosition> Points;
  ObservationWindow Window;

  Pairs()
  {
    const double side = std::sqrt(static_cast<double>(Count));
    vtkNew<vtkPointProcessSource> source;
    source->SetProcess(vtkPointProcessSource::Poisson);
    source->SetIntensity(1.0);
    source->SetSize(side, side);
    source->Update();
    this->Filter->SetInputData(source->GetOutput());
    this->Filter->SetSize(side, side);
    this->Filter->SetFunction(vtkPointPatternStatisticsFilter::PairCorrelation);
    this->Filter->SetNumberOfSimulations(0);
    for (vtkIdType n = 0; n < source->GetOutput()->GetNumberOfPoints(); ++n)
    {
      const double* place = source->GetOutput()->GetPoint(n);
      this->Points.push_back({ place[0], place[1] });
    }
    this->Window = ObservationWindow::Rectangle({ 0.0, 0.0 }, { side, side });
  }
  std::size_t Items() const { return this->Points.size(); }
  void Kernel()
  {
    PairOptions options;
    options.Distances = DefaultDistances(this->Window, this->Points.size(), this->Filter->GetNumberOfSteps());
    options.WantsK = false;
    benchmark::DoNotOptimize(FindPairFunctions(this->Points, this->Window, options, SmpFor).PairCorrelation.data());
  }
  void Class()
  {
    this->Filter->Modified();
    this->Filter->Update();
  }
};

/// A wind of 2000 x 64 x 24 vectors.
struct Wind
{
  vtkNew<vtkWindFieldSource> Source;
  WindGrid Grid;
  WindSynthesis Synthesis;

  Wind()
  {
    this->Grid.Count = { 2000, 64, 24 };
    this->Source->SetDimensions(2000, 64, 24);
  }
  std::size_t Items() const { return this->Grid.NumberOfLines() * this->Grid.Count[0]; }
  void Kernel()
  {
    WindField field({}, this->Grid, this->Synthesis);
    benchmark::DoNotOptimize(field.Make(SmpFor).data());
  }
  void Class()
  {
    this->Source->Modified();
    this->Source->Update();
  }
};

/// A tile of a terrain as VTK has it, without colors.
struct TerrainArrays
{
  std::vector<Vector3> Places;
  std::vector<float> Heights;
  std::vector<std::array<float, 3>> Normals;
  std::vector<std::array<float, 2>> Shares; ///< of the way along the sides
  std::vector<long long> Corners;
  std::vector<long long> Firsts; ///< of triangles
  std::vector<int> Levels;
};

/// A new view of a terrain of 1025 x 1025 samples in levels.
struct TerrainView
{
  static constexpr int Samples = 1025;
  vtkNew<vtkTerrainLevelOfDetailFilter> Filter;
  std::unique_ptr<TerrainPyramid> Pyramid;
  std::vector<TerrainArrays> Tiles;
  double X = 5000.0; // of the eye [m]

  TerrainView()
  {
    HeightSamples samples;
    samples.Width = Samples;
    samples.Height = Samples;
    samples.Spacing = { 10.0, 10.0 };
    vtkNew<vtkFloatArray> heights;
    heights->SetName("Elevation");
    for (int i = 0; i < Samples * Samples; ++i)
    {
      const double x = i % Samples;
      const double y = i / Samples;
      samples.Values.push_back(static_cast<float>(
        200.0 * std::sin(0.02 * x) * std::cos(0.03 * y) + 20.0 * std::sin(0.3 * x + 0.2 * y) * std::sin(0.25 * y)));
      heights->InsertNextValue(samples.Values.back());
    }
    vtkNew<vtkImageData> image;
    image->SetDimensions(Samples, Samples, 1);
    image->SetSpacing(10.0, 10.0, 1.0);
    image->GetPointData()->SetScalars(heights);
    this->Filter->SetInputData(image);
    this->Filter->SetViewDirection(0.0, 1.0, -0.2);
    this->Filter->GroundColorsOff();
    this->Pyramid = std::make_unique<TerrainPyramid>(
      std::move(samples), this->Filter->GetTileSize(), this->Filter->GetNumberOfLevels(), SmpFor);
  }
  std::size_t Items() const { return Samples * Samples; }
  void Kernel()
  {
    View view;
    view.Point = { this->X += 1.0, 0.0, 600.0 };
    view.Direction = { 0.0, 1.0, -0.2 };
    view.AspectRatio = this->Filter->GetAspectRatio();
    TerrainRule rule;
    rule.ByPixelError = true;
    const std::vector<int> levels = SelectLevels(*this->Pyramid, ViewFrustum(view), rule);
    this->Tiles.resize(levels.size());
    SmpFor(levels.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t tile = begin; tile < end; ++tile)
      {
        if (levels[tile] != Culled)
        {
          this->Write(MakePatch(*this->Pyramid, levels, tile).Surface, levels[tile], this->Tiles[tile]);
        }
      }
    });
  }
  void Write(const TerrainMesh& mesh, int level, TerrainArrays& to) const
  {
    const HeightSamples& samples = this->Pyramid->GetSamples();
    const std::size_t points = mesh.Samples.size();
    to.Places.resize(points);
    to.Heights.resize(points);
    to.Normals.resize(points);
    to.Shares.resize(points);
    for (std::size_t i = 0; i < points; ++i)
    {
      const std::size_t sample = mesh.Samples[i];
      const auto column = static_cast<double>(sample % Samples);
      const auto row = static_cast<double>(sample / Samples);
      to.Places[i] = { 10.0 * column, 10.0 * row, samples.Values[sample] };
      to.Heights[i] = samples.Values[sample];
      to.Normals[i] = this->Pyramid->GetNormal(sample);
      to.Shares[i] = { static_cast<float>(column / (Samples - 1)), static_cast<float>(row / (Samples - 1)) };
    }
    to.Corners.assign(mesh.Triangles.begin(), mesh.Triangles.end());
    to.Levels.assign(mesh.Triangles.size() / 3, level);
    to.Firsts.resize(mesh.Triangles.size() / 3);
    for (std::size_t i = 0; i < to.Firsts.size(); ++i)
    {
      to.Firsts[i] = 3 * static_cast<long long>(i);
    }
  }
  void Class()
  {
    this->Filter->SetViewPoint(this->X += 1.0, 0.0, 600.0);
    this->Filter->Update();
  }
};

/// Vertices of a block that moves: as the class has them at rest, and memory for a frame of them.
struct Skin
{
  RestSkin Rest;
  SkinBinding Binding;
  std::size_t Vertices;
  std::vector<float> Points;
  std::vector<float> Normals;

  explicit Skin(vtkPolyData* block)
    : Rest(ReadSkin(block))
    , Binding(ReadBinding(block))
    , Vertices(static_cast<std::size_t>(block->GetNumberOfPoints()))
    , Points(3 * this->Vertices)
    , Normals(3 * this->Vertices)
  {
  }
  void Move(const JointChange* changes, std::size_t begin, std::size_t end)
  {
    MoveSkin(this->Rest, this->Binding, changes, begin, end, this->Points.data(), this->Normals.data());
  }
};

/// A frame of 100 trees of 300 branches and 1500 leaves in the wind.
struct Sway
{
  static constexpr int Trees = 100;
  vtkNew<vtkPlantScatterFilter> Scatter;
  vtkNew<vtkWindFieldSource> Gusts;
  vtkNew<vtkBeamTreeDeformationFilter> Filter;
  std::unique_ptr<SwayScene> Scene;
  std::unique_ptr<Skin> Wood;
  std::unique_ptr<Skin> Leaves;
  double Time = 0.0;

  Sway()
  {
    vtkNew<vtkQuadratPointSource> sites;
    sites->SetQuadrats(10, 10);
    sites->SetSize(100.0, 100.0);
    vtkNew<vtkReevesTreeSource> tree;
    tree->SetPreset(vtkReevesTreeSource::Custom);
    tree->SetOrders(2);
    tree->SetMainBranches(42);
    tree->SetSideBranches(6);
    tree->SetNumberOfLeaves(1500);
    this->Scatter->SetInputConnection(0, sites->GetOutputPort());
    this->Scatter->AddPrototypeConnection(tree->GetOutputPort());
    this->Scatter->UseLevelsOff();
    this->Scatter->UseCullingOff();
    this->Gusts->SetDimensions(1200, 50, 12);
    this->Gusts->SetCenter(50.0, 50.0);
    this->Filter->SetInputConnection(0, this->Scatter->GetOutputPort());
    this->Filter->SetWindConnection(this->Gusts->GetOutputPort());
    this->Filter->AddPrototypeConnection(tree->GetOutputPort());
    this->Filter->UpdateTimeStep(0.0);
    this->MakeScene();
  }
  /// The scene by the blocks of the plants alone: each is its own species.
  void MakeScene()
  {
    auto* plants = vtkMultiBlockDataSet::SafeDownCast(this->Scatter->GetOutputDataObject(0));
    vtkPolyData* leaves = PlantPartOf(plants, plant::High, plant::Leaves);
    const std::vector<Skeleton> skeletons = PlantsOf(ReadSkeleton(PlantPartOf(plants, plant::High, plant::Skeleton)));
    this->Wood = std::make_unique<Skin>(PlantPartOf(plants, plant::High, plant::Skin));
    this->Leaves = std::make_unique<Skin>(leaves);
    this->Scene = std::make_unique<SwayScene>(
      SwaySettings(), ReadWind(this->Gusts->GetOutput()), std::vector<PlantPlace>(Trees), std::vector<SwaySpecies>());
    std::vector<int> plantOf;
    std::vector<double> areas;
    for (std::size_t index = 0; index < skeletons.size(); ++index)
    {
      plantOf.insert(plantOf.end(), skeletons[index].Nodes.size(), static_cast<int>(index));
    }
    areas.resize(plantOf.size());
    for (const LeafCorners& leaf : ReadLeaves(leaves))
    {
      areas[leaf.Node] += leaf.Area;
      this->Scene->AddLeaf(leaf.Corners, plantOf[leaf.Node], static_cast<std::uint64_t>(plantOf[leaf.Node]));
    }
    auto area = areas.begin();
    for (std::size_t index = 0; index < skeletons.size(); ++index)
    {
      const auto end = area + static_cast<std::ptrdiff_t>(skeletons[index].Nodes.size());
      this->Scene->AddPlant(static_cast<int>(index), skeletons[index],
        this->Scene->BeamsOf(static_cast<int>(index), skeletons[index], std::vector<double>(area, end)));
      area = end;
    }
  }
  std::size_t Items() const { return this->Wood->Vertices + this->Leaves->Vertices; }
  void Kernel()
  {
    this->Scene->MoveTo(this->Time += Frame, SmpFor);
    const JointChange* changes = this->Scene->GetChanges().data();
    ForRanges(SmpFor, this->Wood->Vertices, 4096,
      [&](std::size_t begin, std::size_t end) { this->Wood->Move(changes, begin, end); });
    ForRanges(SmpFor, this->Scene->GetNumberOfLeaves(), 1024, [&](std::size_t begin, std::size_t end) {
      const auto [first, last] = this->Scene->VerticesOfLeaves(begin, end, this->Leaves->Vertices);
      this->Leaves->Move(changes, first, last);
      this->Scene->TurnLeaves(begin, end, this->Leaves->Points.data(), this->Leaves->Normals.data());
    });
  }
  void Class() { this->Filter->UpdateTimeStep(this->Time += Frame); }
};

/// A step of 10 000 physical seaweeds of ten segments in a swell of 30 trains, without their skins or with them.
template <bool WithSkins>
struct Seaweeds
{
  static constexpr int Plants = 10000;
  Waves Sea;
  vtkNew<vtkPlantScatterFilter> Scatter;
  vtkNew<vtkSeaweedDeformationFilter> Filter;
  SeaweedOptions Options;
  std::unique_ptr<SeaweedMotion> Motion;
  std::unique_ptr<SeaweedStand> Stand;
  std::unique_ptr<SeaweedSkin> Runs;
  std::unique_ptr<Skin> Blades;
  std::vector<LinkState> States;
  std::vector<LinkPose> Poses;
  std::vector<JointChange> Changes;
  int Step = 0;

  Seaweeds()
  {
    vtkNew<vtkPoints> places;
    for (int plant = 0; plant < Plants; ++plant)
    {
      places->InsertNextPoint(0.13 * plant, plant % 10, -10.0);
    }
    vtkNew<vtkPolyData> sites;
    sites->SetPoints(places);
    vtkNew<vtkSeaweedSource> weed;
    weed->SetPreset(vtkSeaweedSource::Custom);
    weed->SetForm(vtkSeaweedSource::Tuft);
    weed->SetNumberOfFronds(1);
    weed->SetSegmentsPerBranch(10);
    this->Scatter->SetInputData(sites);
    this->Scatter->AddPrototypeConnection(weed->GetOutputPort());
    this->Scatter->UseLevelsOff();
    this->Scatter->UseCullingOff();
    this->Scatter->Update();
    auto* all = vtkMultiBlockDataSet::SafeDownCast(this->Scatter->GetOutputDataObject(0));
    vtkNew<vtkMultiBlockDataSet> high;
    AddBlock(high, plant::Skeleton, PlantPartOf(all, plant::High, plant::Skeleton));
    if (WithSkins)
    {
      AddBlock(high, plant::Skin, PlantPartOf(all, plant::High, plant::Skin));
    }
    vtkNew<vtkMultiBlockDataSet> bed;
    AddBlock(bed, plant::High, high);
    this->Filter->SetInputData(bed);
    this->Filter->SetSeaStateConnection(this->Sea.Source->GetOutputPort());
    this->Filter->SetStartTime(0.0);
    this->MakeMotion(bed);
    // Two frames fill the arrays that all later ones take in turn.
    this->Class();
    this->Class();
  }
  void MakeMotion(vtkMultiBlockDataSet* bed)
  {
    vtkPolyData* bones = PlantPartOf(bed, plant::High, plant::Skeleton);
    const Skeleton skeleton = ReadSkeleton(bones);
    const std::vector<SeaweedLink> links = LinksOf(skeleton, ReadSegments(bones), this->Options);
    this->Stand = std::make_unique<SeaweedStand>(skeleton, links, FindPlantIds(bones)->GetPointer(0));
    this->Motion = std::make_unique<SeaweedMotion>(links, this->Options);
    this->States = this->Motion->AtRest();
    this->Poses.resize(this->States.size());
    this->Motion->Pose(this->States.data(), 0, this->States.size(), this->Poses.data());
    this->Changes.resize(skeleton.Nodes.size());
    if (WithSkins)
    {
      vtkPolyData* block = PlantPartOf(bed, plant::High, plant::Skin);
      this->Blades = std::make_unique<Skin>(block);
      this->Runs = std::make_unique<SeaweedSkin>(ReadJointIds(block), this->Blades->Vertices, *this->Stand);
    }
  }
  std::size_t Items() const { return WithSkins ? this->Blades->Vertices : this->States.size(); }
  /// The water at the middles of the links of a batch.
  static void FindWater(const WaveOrbits& orbits, const std::vector<Vector3>& middles, std::vector<WaterAtLink>& water)
  {
    const std::size_t count = middles.size();
    std::vector<float> numbers(14 * count, 0.0f);
    OrbitRequest<float> request;
    float* centers = numbers.data();
    for (std::size_t i = 0; i < count; ++i)
    {
      std::transform(&middles[i].x, &middles[i].x + 3, centers + 3 * i, [](double x) { return static_cast<float>(x); });
    }
    request.Centers = centers;
    request.Velocity = centers + 3 * count;
    request.Acceleration = centers + 6 * count;
    request.VelocityGradient = centers + 9 * count;
    orbits.Evaluate(request, 0, count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const float* velocity = request.Velocity + 3 * i;
      const float* acceleration = request.Acceleration + 3 * i;
      water[i].Velocity = { velocity[0], velocity[1], velocity[2] };
      water[i].Acceleration = { acceleration[0], acceleration[1], acceleration[2] };
    }
  }
  void StepLinks()
  {
    const WaveOrbits orbits(this->Sea.State, {}, Frame * (++this->Step - 0.5));
    const std::vector<LinkBatch>& batches = this->Motion->GetBatches();
    SmpFor(batches.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<Vector3> middles;
      std::vector<WaterAtLink> water;
      for (std::size_t batch = begin; batch < end; ++batch)
      {
        middles.resize(batches[batch].PaddedLinks());
        water.resize(middles.size());
        this->Motion->Middles(batches[batch], this->Poses.data(), middles.data(), 0.5 * Frame);
        FindWater(orbits, middles, water);
        this->Motion->Step(Frame, batches[batch], water.data(), this->States.data(), this->Poses.data());
      }
    });
  }
  void BendBlades()
  {
    const std::vector<StandPlant>& plants = this->Stand->GetPlants();
    const std::vector<SeaweedLink>& links = this->Motion->GetLinks();
    SmpFor(plants.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t plant = begin; plant < end; ++plant)
      {
        for (std::size_t link = plants[plant].FirstLink; link < plants[plant].EndLink; ++link)
        {
          this->Changes[static_cast<std::size_t>(links[link].Node)] = ChangeOf(links[link], this->Poses[link]);
        }
        std::for_each(this->Runs->RunsOf(plant), this->Runs->RunsOf(plant + 1),
          [&](const SkinRun& run) { this->Blades->Move(this->Changes.data(), run.First, run.End); });
      }
    });
  }
  void Kernel()
  {
    this->StepLinks();
    if (WithSkins)
    {
      this->BendBlades();
    }
  }
  void Class() { this->Filter->UpdateTimeStep(Frame * ++this->Step); }
};
using SeaweedSteps = Seaweeds<false>;
using SeaweedSkins = Seaweeds<true>;

template <typename Pair>
void ByKernel(benchmark::State& state)
{
  Pair pair;
  pair.Kernel(); // memory is new
  for (auto _ : state)
  {
    pair.Kernel();
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long long>(pair.Items()));
}

template <typename Pair>
void ByClass(benchmark::State& state)
{
  Pair pair;
  pair.Class();
  for (auto _ : state)
  {
    pair.Class();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long long>(pair.Items()));
}

#define BENCHMARK_PAIR(Pair)                                                                                           \
  BENCHMARK_TEMPLATE(ByKernel, Pair)->Unit(benchmark::kMillisecond)->UseRealTime();                                    \
  BENCHMARK_TEMPLATE(ByClass, Pair)->Unit(benchmark::kMillisecond)->UseRealTime()

BENCHMARK_PAIR(Orbits);
BENCHMARK_PAIR(SeaweedSteps);
BENCHMARK_PAIR(SeaweedSkins);
BENCHMARK_PAIR(Sway);
BENCHMARK_PAIR(Drift);
BENCHMARK_PAIR(Groups);
BENCHMARK_PAIR(TerrainView);
BENCHMARK_PAIR(Wind);
BENCHMARK_PAIR(Fog);
BENCHMARK_PAIR(Quadrats);
BENCHMARK_PAIR(Pairs);

}

BENCHMARK_MAIN();
