// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Currents on grids: of any kind, those of an ocean model, and between bed and surface.
#include "Check.h"
#include "DriftScene.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <limits>

using namespace DriftScene;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A field that is linear in place, v = A x, which all interpolations keep: rotation about z with 0.4 rad/s and a slow
/// rise.
void AddLinearVelocity(vtkDataSet* data, double scale = 1.0)
{
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("uo");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    double p[3];
    data->GetPoint(id, p);
    velocity->InsertNextTuple3(-0.5 * scale * p[1], 0.5 * scale * p[0], 0.0);
  }
  data->GetPointData()->AddArray(velocity);
}

/// Turns an image by 30 degrees, with other numbers along its axes.
void Turn(vtkImageData* image)
{
  image->SetDimensions(41, 31, 5);
  image->SetOrigin(-10.0 * std::cos(Pi / 6.0) + 10.0 * std::sin(Pi / 6.0),
    -10.0 * std::sin(Pi / 6.0) - 10.0 * std::cos(Pi / 6.0), -12.0);
  image->SetSpacing(0.5, 20.0 / 30.0, 3.0);
  image->SetDirectionMatrix(
    std::cos(Pi / 6.0), -std::sin(Pi / 6.0), 0.0, std::sin(Pi / 6.0), std::cos(Pi / 6.0), 0.0, 0.0, 0.0, 1.0);
}

/// Places the nodes of two grids, unequally and, along z, falling.
void PlaceNodes(vtkRectilinearGrid* rectilinear, vtkStructuredGrid* curved)
{
  rectilinear->SetDimensions(11, 11, 4);
  curved->SetDimensions(11, 11, 4);
  vtkNew<vtkDoubleArray> axes[3];
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto place = [](int n, int axis) { return axis == 2 ? 0.5 - 4.0 * n : -10.0 + 2.0 * n + 0.04 * n * (10 - n); };
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 11; ++j)
    {
      for (int i = 0; i < 11; ++i)
      {
        points->InsertNextPoint(place(i, 0), place(j, 1), place(k, 2));
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int n = 0; n < (axis < 2 ? 11 : 4); ++n)
    {
      axes[axis]->InsertNextValue(place(n, axis));
    }
  }
  rectilinear->SetXCoordinates(axes[0]);
  rectilinear->SetYCoordinates(axes[1]);
  rectilinear->SetZCoordinates(axes[2]); // falling
  curved->SetPoints(points);
}

bool CheckGrids()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(21, 21, 5);
  image->SetOrigin(-10.0, -10.0, -12.0);
  image->SetSpacing(1.0, 1.0, 3.0);
  AddLinearVelocity(image);
  vtkNew<vtkImageData> layer;
  layer->SetDimensions(21, 21, 1);
  layer->SetOrigin(-10.0, -10.0, 0.0);
  AddLinearVelocity(layer);
  vtkNew<vtkImageData> turned;
  Turn(turned);
  AddLinearVelocity(turned);
  vtkNew<vtkRectilinearGrid> rectilinear;
  vtkNew<vtkStructuredGrid> curved;
  PlaceNodes(rectilinear, curved);
  AddLinearVelocity(rectilinear);
  AddLinearVelocity(curved);
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkImageData> half;
  half->DeepCopy(image);
  half->GetPointData()->Initialize();
  AddLinearVelocity(half, 0.5);
  blocks->SetBlock(0, half);
  blocks->SetBlock(2, half);
  bool good = true;
  vtkDataObject* grids[] = { image, layer, turned, rectilinear, curved, blocks };
  for (vtkDataObject* grid : grids)
  {
    for (const int interpolation : { Drift::Linear, Drift::CubicSpline })
    {
      vtkNew<Drift> drift;
      vtkNew<vtkPolyData> particles = OneParticle(3.0, 4.0, -2.0);
      particles->GetPoints()->InsertNextPoint(30.0, 0.0, -2.0); // outside
      drift->SetInputData(0, particles);
      drift->SetInputData(1, grid);
      drift->SetVelocityInterpolation(interpolation);
      drift->UpdateTimeStep(2.0);
      const double angle = std::atan2(4.0, 3.0) + 1.0;
      double p[3];
      OutputOf(drift)->GetPoint(0, p);
      const double error = std::hypot(p[0] - 5.0 * std::cos(angle), p[1] - 5.0 * std::sin(angle), p[2] + 2.0);
      std::cout << grid->GetClassName() << ": off by " << error << " m" << std::endl;
      good &= Check(error < 2e-6, "a grid carries points elsewhere");
      OutputOf(drift)->GetPoint(1, p);
      good &= Check(p[0] == 30.0 && p[1] == 0.0, "there is a current outside of the data set");
    }
  }
  // Land is at rest.
  vtkNew<vtkImageData> land;
  land->DeepCopy(image);
  land->GetPointData()->GetArray(0)->Fill(std::numeric_limits<double>::quiet_NaN());
  vtkNew<Drift> drift;
  drift->SetInputData(0, OneParticle(3.0, 4.0, -2.0));
  drift->SetInputData(1, land);
  drift->UpdateTimeStep(2.0);
  return good & Check(OutputOf(drift)->GetPoint(0)[0] == 3.0, "land flows");
}

/// Between the samples of a current that is there at one of them alone, it falls along straight lines.
bool CheckOneSample()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 3, 1);
  image->SetOrigin(0.0, -1.0, 0.0);
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    const double* p = image->GetPoint(id);
    velocity->InsertNextTuple3(p[0] == 2.0 && p[1] == 0.0 ? 1.0 : 0.0, 0.0, 0.0);
  }
  image->GetPointData()->AddArray(velocity);
  bool good = true;
  for (double x = 0.05; x < 4.0; x += 0.1)
  {
    for (const double y : { -0.75, 0.0, 0.375 })
    {
      vtkNew<Drift> drift;
      drift->SetInputData(0, OneParticle(x, y, -2.0));
      drift->SetInputData(1, image);
      drift->SetVelocityInterpolation(Drift::Linear);
      drift->GenerateCurrentOn();
      drift->UpdateTimeStep(0.0);
      const double flow = OutputOf(drift)->GetPointData()->GetArray("Current")->GetComponent(0, 0);
      good &= std::abs(flow - std::max(0.0, 1.0 - std::abs(x - 2.0)) * (1.0 - std::abs(y))) < 1e-6;
    }
  }
  return Check(good, "a current is not interpolated along straight lines");
}

/// A basin of 64 m x 64 m x 10 m with gyres, weaker at the bed, and water that turns over, as the curl of (0, A, B): no
/// divergence, and no flow through any wall.
constexpr double BasinX = 64.0;
constexpr double BasinDepth = 10.0;

void BasinVelocity(const double p[3], double flow[3])
{
  const double x = Pi * p[0] / BasinX;
  const double y = Pi * p[1] / BasinX;
  const double z = Pi * (p[2] / BasinDepth + 1.0);
  const double sine = std::pow(std::sin(y), 2);
  const double strength = 1.0 + 0.5 * std::cos(z - Pi);
  flow[0] = std::pow(std::sin(x), 2) * std::sin(2.0 * y) * strength - 0.3 * std::cos(z) * std::sin(2.0 * x) * sine;
  flow[1] = -std::sin(2.0 * x) * sine * strength;
  flow[2] = 0.6 * BasinDepth / BasinX * std::sin(z) * std::cos(2.0 * x) * sine;
}

/// Samples of the basin: as many along and across, layers from bed to surface, or in the middles of as many.
vtkNew<vtkRectilinearGrid> Basin(int across, int layers, bool middles)
{
  const auto axis = [](int count, double first, double last) {
    vtkNew<vtkDoubleArray> values;
    for (int n = 0; n < count; ++n)
    {
      values->InsertNextValue(n == count - 1 ? last : first + (last - first) * n / (count - 1));
    }
    return values;
  };
  const double end = middles ? 0.5 * BasinDepth / layers : 0.0;
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(across, across, layers);
  grid->SetXCoordinates(axis(across, 0.0, BasinX));
  grid->SetYCoordinates(axis(across, 0.0, BasinX));
  grid->SetZCoordinates(axis(layers, -end, end - BasinDepth)); // down, as ocean models have it
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("uvw");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double flow[3];
    BasinVelocity(grid->GetPoint(id), flow);
    velocity->InsertNextTuple(flow);
  }
  grid->GetPointData()->AddArray(velocity);
  return grid;
}

/// Even tracers in a basin 2000 s later: chi-squared over 4 x 4 x 4 boxes, and the part within 1 cm of bed and surface.
void Stir(vtkDataSet* basin, int interpolation, double& chi, double& atWalls)
{
  constexpr int Count = 2048;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto number = [](int n, int base) {
    double part = 1.0;
    double sum = 0.0;
    for (; n > 0; n /= base)
    {
      part /= base;
      sum += part * (n % base);
    }
    return sum;
  };
  for (int n = 1; n <= Count; ++n) // Halton's sequence
  {
    points->InsertNextPoint(BasinX * number(n, 2), BasinX * number(n, 3), -BasinDepth * number(n, 5));
  }
  vtkNew<vtkPolyData> tracers;
  tracers->SetPoints(points);
  vtkNew<Drift> drift;
  drift->SetInputData(0, tracers);
  drift->SetInputData(1, basin);
  drift->SetWaterDepth(BasinDepth);
  drift->SetTimeStep(5.0);
  drift->SetVelocityInterpolation(interpolation);
  drift->UpdateTimeStep(2000.0);
  std::vector<int> boxes(64, 0);
  int near = 0;
  for (int n = 0; n < Count; ++n)
  {
    const double* p = OutputOf(drift)->GetPoint(n);
    near += p[2] > -0.01 || p[2] < 0.01 - BasinDepth;
    const auto box = [](double part) { return std::min(3, std::max(0, static_cast<int>(4.0 * part))); };
    ++boxes[static_cast<std::size_t>(box(p[0] / BasinX) + 4 * box(p[1] / BasinX) + 16 * box(-p[2] / BasinDepth))];
  }
  chi = 0.0;
  for (const int many : boxes)
  {
    chi += std::pow(many - Count / 64.0, 2) / (Count / 64.0);
  }
  atWalls = static_cast<double>(near) / Count;
}

/// An ocean model's currents keep an even distribution. Of 2048 tracers, chi-squared of 63 degrees of freedom is below
/// 105 but once in a thousand times, and above it in half of the cases if densities differ by 14 % rms; 4 are expected
/// within 1 cm of a wall.
bool CheckOcean()
{
  bool good = true;
  for (const bool middles : { false, true })
  {
    vtkNew<vtkRectilinearGrid> basin = Basin(17, 9, middles);
    double chi[2];
    double atWalls[2];
    for (const int interpolation : { Drift::Linear, Drift::CubicSpline })
    {
      Stir(basin, interpolation, chi[interpolation], atWalls[interpolation]);
      std::cout << (middles ? "middles of layers, " : "bed to surface, ")
                << (interpolation == Drift::Linear ? "linear" : "spline") << ": chi-squared " << chi[interpolation]
                << " of 63, " << 100.0 * atWalls[interpolation] << " % within 1 cm of bed and surface" << std::endl;
    }
    good &= Check(chi[1] < 105.0, "an ocean model's current gathers tracers");
    good &= Check(atWalls[1] < 0.006, "an ocean model's current gathers tracers at bed and surface");
    good &= Check(chi[1] < chi[0], "splines gather more than straight lines");
  }
  return good;
}

/// A grid whose current rises by 0.05 m/s and `turn` times y [m].
vtkSmartPointer<vtkImageData> TiltedGrid(const int dimensions[3], double low, double step, double turn)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions);
  image->SetOrigin(-40.0, -40.0, low);
  image->SetSpacing(4.0, 4.0, step);
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    velocity->InsertNextTuple3(0.2, 0.0, 0.05 + turn * image->GetPoint(id)[1]);
  }
  image->GetPointData()->AddArray(velocity);
  return image;
}

/// Grids that flow through the bed and the surface: what goes in and out again is taken away.
bool CheckGridsThroughWalls()
{
  bool good = true;
  const struct
  {
    const char* Name;
    int Dimensions[3];
    double Low;
    double Step;
    double Depth;
    double Turn;
  } cases[] = { { "wider than the water", { 21, 21, 9 }, -16.0, 4.0, 10.0, 0.01 },
    { "up to both walls", { 21, 21, 6 }, -10.0, 2.0, 10.0, 0.0 },
    { "without a bed", { 21, 21, 9 }, -16.0, 4.0, 0.0, 0.01 },
    { "of one layer", { 21, 21, 1 }, -3.0, 1.0, 10.0, 0.01 } };
  for (const auto& one : cases)
  {
    for (const int interpolation : { Drift::Linear, Drift::CubicSpline })
    {
      vtkNew<Drift> drift;
      drift->SetInputData(0, OneParticle(-30.0, 7.0, -4.0));
      drift->SetInputData(1, TiltedGrid(one.Dimensions, one.Low, one.Step, one.Turn));
      drift->SetWaterDepth(one.Depth);
      drift->SetVelocityInterpolation(interpolation);
      drift->UpdateTimeStep(200.0);
      const double* p = OutputOf(drift)->GetPoint(0);
      const double error = std::hypot(p[0] - 10.0, p[1] - 7.0, p[2] + 4.0);
      std::cout << "a tilted grid " << one.Name << ": off by " << error << " m" << std::endl;
      good &= Check(error < 1e-4, "a grid flows through bed and surface");
    }
  }
  return good;
}

/// Between the end of a grid and a wall that is near, the horizontal flow goes on, and the vertical one falls to 0.
bool CheckEndOfGrid()
{
  bool good = true;
  const int dimensions[3] = { 21, 21, 9 };
  const auto ended = TiltedGrid(dimensions, -9.0, 1.0, 0.0); // up to -1 m
  const auto currentAt = [&](double z, double level) {
    vtkNew<Drift> drift;
    drift->SetInputData(0, OneParticle(0.0, 0.0, z));
    drift->SetInputData(1, ended);
    drift->GenerateCurrentOn();
    drift->SetSeaLevel(level);
    drift->UpdateTimeStep(0.0);
    const double* flow = OutputOf(drift)->GetPointData()->GetArray("Current")->GetTuple3(0);
    return std::array<double, 2>{ flow[0], flow[2] };
  };
  good &= Check(std::abs(currentAt(-0.25, 0.0)[0] - 0.2) < 1e-6 && std::abs(currentAt(-0.25, 0.0)[1] - 0.0125) < 1e-6,
    "the end of a grid is not joined to the surface");
  good &= Check(std::abs(currentAt(-2.0, 0.0)[1] - 0.05) < 1e-6, "a grid below the surface is changed");
  good &= Check(currentAt(-0.25, 0.5)[0] == 0.0, "a grid reaches farther than its last step");
  return good;
}

/// Of uneven layers each end has its own step: 5 m at the bed, 1 m at the surface.
bool CheckUnevenLayers()
{
  bool good = true;
  for (const bool isFalling : { false, true })
  {
    const double heights[2][4] = { { -9.0, -4.0, -2.0, -1.0 }, { -1.0, -2.0, -4.0, -9.0 } };
    vtkNew<vtkDoubleArray> z;
    vtkNew<vtkDoubleArray> along;
    for (const double height : heights[isFalling])
    {
      z->InsertNextValue(height);
    }
    along->InsertNextValue(-50.0);
    along->InsertNextValue(50.0);
    vtkNew<vtkRectilinearGrid> uneven;
    uneven->SetDimensions(2, 2, 4);
    uneven->SetXCoordinates(along);
    uneven->SetYCoordinates(along);
    uneven->SetZCoordinates(z);
    vtkNew<vtkDoubleArray> velocity;
    velocity->SetName("Velocity");
    velocity->SetNumberOfComponents(3);
    for (vtkIdType id = 0; id < uneven->GetNumberOfPoints(); ++id)
    {
      velocity->InsertNextTuple3(0.2, 0.0, 0.0);
    }
    uneven->GetPointData()->AddArray(velocity);
    const auto flowAt = [&](double height, double level, double depth) {
      vtkNew<Drift> drift;
      drift->SetInputData(0, OneParticle(0.0, 0.0, height));
      drift->SetInputData(1, uneven);
      drift->GenerateCurrentOn();
      drift->SetSeaLevel(level);
      drift->SetWaterDepth(depth);
      drift->UpdateTimeStep(0.0);
      return OutputOf(drift)->GetPointData()->GetArray("Current")->GetComponent(0, 0);
    };
    good &= Check(std::abs(flowAt(-0.5, 0.0, 13.0) - 0.2) < 1e-6, "uneven layers are not joined to the surface");
    good &= Check(flowAt(0.5, 1.0, 14.0) == 0.0, "uneven layers reach too far up");
    good &= Check(std::abs(flowAt(-12.0, 0.0, 13.0) - 0.2) < 1e-6, "uneven layers are not joined to the bed");
    good &= Check(flowAt(-14.5, 0.0, 15.0) == 0.0, "uneven layers reach too far down");
  }
  return good;
}

}

int TestCurrentGrids(int, char*[])
{
  bool good = CheckGrids();
  good &= CheckOneSample();
  good &= CheckOcean();
  good &= CheckGridsThroughWalls();
  good &= CheckEndOfGrid();
  good &= CheckUnevenLayers();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
