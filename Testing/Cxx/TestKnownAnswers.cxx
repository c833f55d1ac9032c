// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Small inputs to classes and to what they share, whose output is known by hand.
#include "Check.h"
#include "Data/Blocks.h"
#include "Data/PlantBlocks.h"
#include "Data/ScatterSites.h"
#include "Data/SeaweedBlocks.h"
#include "Data/WindImage.h"
#include "Pipeline/Pipeline.h"
#include "vtkCovarianceFitFilter.h"
#include "vtkImageSectionFilter.h"
#include "vtkParticleFogFilter.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkPlantWakeFilter.h"
#include "vtkQuadratAnalysisFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaSurfaceFilter.h"
#include "vtkSuspendedParticleSource.h"
#include "vtkTerrainLevelOfDetailFilter.h"
#include "vtkTurningBandsTerrainSource.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace
{

using Place = std::array<double, 3>;

bool Near(const char* what, double is, double wanted, double tolerance)
{
  return Check(std::abs(is - wanted) <= tolerance,
    std::string(what) + ": " + std::to_string(is) + ", not " + std::to_string(wanted));
}

double FieldOf(vtkDataObject* data, const char* name, int component = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, component) : std::numeric_limits<double>::quiet_NaN();
}

vtkNew<vtkPolyData> PointsAt(const std::vector<Place>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Place& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  return data;
}

void AddNumbers(vtkPolyData* data, const char* name, int components, const std::vector<float>& numbers)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (std::size_t n = 0; n < numbers.size(); n += static_cast<std::size_t>(components))
  {
    array->InsertNextTuple(&numbers[n]);
  }
  data->GetPointData()->AddArray(array);
}

/// An image with an array of floats that is a function of the place.
vtkNew<vtkImageData> ImageOf(const std::array<int, 6>& extent, const Place& origin, const Place& spacing,
  const char* name, const std::function<float(const double*)>& valueAt)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  image->SetOrigin(origin[0], origin[1], origin[2]);
  image->SetSpacing(spacing[0], spacing[1], spacing[2]);
  vtkNew<vtkFloatArray> values;
  values->SetName(name);
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    values->InsertNextValue(valueAt(image->GetPoint(id)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// Two particles in the middles of samples: alpha Q pi r^2 over the volume of a sample.
bool FogIsCrossSectionOverVolume()
{
  vtkNew<vtkPolyData> particles = PointsAt({ { 1.0, 2.0, -6.0 }, { 2.0, 2.0, -3.0 } });
  AddNumbers(particles, "Radius", 1, { 0.1f, 0.2f });
  AddNumbers(particles, "Alpha", 1, { 1.0f, 0.5f });
  vtkNew<vtkParticleFogFilter> fog;
  fog->SetInputData(particles);
  fog->UseBoundsOn();
  fog->SetBounds(0.0, 4.0, 0.0, 6.0, -9.0, 0.0);
  fog->SetDimensions(5, 4, 4); // 1 m, 2 m and 3 m apart
  fog->SetExtinctionEfficiency(2.0);
  fog->SetWaterExtinction(0.25);
  const std::array<int, 6> parts[] = { { 0, 4, 0, 3, 0, 3 }, { 1, 3, 1, 2, 1, 2 } };
  bool good = true;
  for (const std::array<int, 6>& part : parts)
  {
    fog->UpdateExtent(part.data());
    vtkImageData* image = fog->GetOutput();
    vtkDataArray* extinction = image->GetPointData()->GetScalars();
    double sum = 0.0;
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      sum += extinction->GetTuple1(id) - 0.25;
    }
    const double first = 2.0 * vtkMath::Pi() * 0.01 / 6.0;
    const double second = 0.5 * 2.0 * vtkMath::Pi() * 0.04 / 6.0;
    good &= Near("spacing of fog", image->GetSpacing()[2], 3.0, 1e-12);
    good &= Near("fog of all samples", sum, first + second, 1e-6);
    good &= Near(
      "fog of a particle", extinction->GetTuple1(image->vtkDataSet::FindPoint(1.0, 2.0, -6.0)), first + 0.25, 1e-6);
    good &= Near(
      "fog of a pale one", extinction->GetTuple1(image->vtkDataSet::FindPoint(2.0, 2.0, -3.0)), second + 0.25, 1e-6);
  }
  return good & Near("cross section", FieldOf(fog->GetOutput(), "CrossSection"), 0.06 * vtkMath::Pi(), 1e-6);
}

double AreaOf(vtkPolyData* data)
{
  double area = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, corners);
    double normal[3];
    area += vtkPolygon::ComputeArea(data->GetPoints(), corners->GetNumberOfIds(), corners->GetPointer(0), normal);
  }
  return area;
}

/// A layer is a section of its own area; of a block of 6 m x 8 m x 3 m the bottom, the far side and sections across.
bool SectionsHaveTheirAreas()
{
  const auto height = [](const double* place) {
    return static_cast<float>(place[0] + 10.0 * place[1] + 100.0 * place[2]);
  };
  bool good = true;
  vtkNew<vtkImageSectionFilter> sections;
  sections->SetInputData(ImageOf({ 2, 5, 1, 5, 7, 7 }, { 0.0, 0.0, 0.0 }, { 2.0, 2.0, 1.0 }, "Height", height));
  sections->Update();
  good &= Near("area of a layer", AreaOf(sections->GetOutput()), 48.0, 1e-9);
  sections->SetInputData(ImageOf({ 2, 5, 1, 5, 7, 10 }, { 0.0, 0.0, 0.0 }, { 2.0, 2.0, 1.0 }, "Height", height));
  sections->SetCrossSections(2);
  sections->Update();
  vtkPolyData* output = sections->GetOutput();
  good &= Near("area of sections", AreaOf(output), 48.0 + 18.0 + 2.0 * 24.0, 1e-9);
  const double* bounds = output->GetBounds();
  good &= Check(bounds[0] == 4.0 && bounds[1] == 10.0 && bounds[3] == 10.0 && bounds[4] == 7.0 && bounds[5] == 10.0,
    "sections lie elsewhere");
  vtkDataArray* values = output->GetPointData()->GetArray("Height");
  for (vtkIdType id = 0; good && id < output->GetNumberOfPoints(); ++id)
  {
    good = Near("value of a section", values->GetTuple1(id), height(output->GetPoint(id)), 1e-5);
  }
  return good;
}

/// Without a study area it is the box of the points, cut into as many quadrats as there are points.
bool QuadratsFitTheBoxOfThePoints()
{
  std::vector<Place> places;
  for (int n = 0; n < 200; ++n)
  {
    places.push_back({ 1000.0 + 2.0 * (n % 20), -50.0 + 4.0 * (n / 20), 0.0 });
  }
  vtkNew<vtkQuadratAnalysisFilter> analysis;
  analysis->SetInputData(PointsAt(places));
  analysis->Update();
  vtkTable* table = analysis->GetOutput();
  bool good = Near("origin of the box", FieldOf(table, "Origin", 0), 1000.0, 1e-9);
  good &= Near("origin of the box", FieldOf(table, "Origin", 1), -50.0, 1e-9);
  good &= Near("width of the box", FieldOf(table, "Size", 0), 38.0, 1e-9);
  good &= Near("height of the box", FieldOf(table, "Size", 1), 36.0, 1e-9);
  // Squares of 6.84 m2, a point each.
  good &= Near("columns of quadrats", FieldOf(table, "Quadrats", 0), 15.0, 0.0);
  return good & Near("rows of quadrats", FieldOf(table, "Quadrats", 1), 14.0, 0.0);
}

/// Lags go up to half of the shorter side, and a fractal's waves up to four times the longer one.
bool LagsGoByTheSidesOfTheImage()
{
  vtkNew<vtkCovarianceFitFilter> fit;
  fit->SetInputData(
    ImageOf({ 0, 39, 0, 29, 0, 0 }, { 0.0, 0.0, 0.0 }, { 1.0, 4.0, 1.0 }, "Elevation", [](const double* p) {
      return static_cast<float>(std::sin(0.9 * p[0] + 0.4 * p[1]) + std::sin(0.3 * p[0] - 0.17 * p[1]) + 0.01 * p[1]);
    })); // 39 m by 116 m
  fit->FitAnisotropyOff();
  fit->Update();
  auto* variogram = vtkTable::SafeDownCast(fit->GetOutputDataObject(1));
  const vtkIdType rings = variogram->GetNumberOfRows();
  const double longest = rings > 0 ? variogram->GetValueByName(rings - 1, "Lag").ToDouble() : 0.0;
  bool good = Check(longest > 18.0 && longest <= 19.5, "another longest lag: " + std::to_string(longest));
  vtkTable* fits = fit->GetOutput();
  for (vtkIdType row = 0; row < fits->GetNumberOfRows(); ++row)
  {
    good &= fits->GetValueByName(row, "Model").ToString() != "Fractal" ||
      Near("longest wave of a fractal", fits->GetValueByName(row, "Range").ToDouble(), 464.0, 1e-9);
  }
  return good;
}

/// Normals of a wavy surface by the places of neighbouring points.
bool NormalsStandOnTheSurface()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(60.0, 0.0, 0.0);
  plane->SetPoint2(0.0, 60.0, 0.0);
  plane->SetResolution(120, 120);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSpectrum(vtkSeaStateSource::Regular);
  sea->SetSeaBy(vtkSeaStateSource::HeightAndPeriod);
  sea->SetSignificantWaveHeight(3.0);
  sea->SetPeakPeriod(6.0); // some 56 m long
  sea->SetMeanDirection(25.0);
  vtkNew<vtkParticleOrbitFilter> surface;
  surface->SetInputConnection(0, plane->GetOutputPort());
  surface->SetSeaStateConnection(sea->GetOutputPort());
  surface->UpdateTimeStep(1.3);
  auto* output = vtkPolyData::SafeDownCast(surface->GetOutputDataObject(0));
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  bool good = Check(normals && output->GetNumberOfPoints() == 121 * 121, "no surface");
  double steepest = 0.0;
  for (vtkIdType id = 122; good && id < 120 * 121 - 1; ++id)
  {
    if (id % 121 == 0 || id % 121 == 120)
    {
      continue;
    }
    double along[2][3];
    double ends[3];
    for (const int axis : { 0, 1 })
    {
      const vtkIdType step = axis == 0 ? 1 : 121;
      output->GetPoint(id + step, along[axis]);
      output->GetPoint(id - step, ends);
      vtkMath::Subtract(along[axis], ends, along[axis]);
    }
    double normal[3];
    vtkMath::Cross(along[0], along[1], normal);
    vtkMath::Normalize(normal);
    for (int axis = 0; axis < 3; ++axis)
    {
      good &= Near("normal", normals->GetComponent(id, axis), normal[axis], 1e-3);
    }
    steepest = std::max(steepest, std::abs(normal[0]));
  }
  return good & Check(steepest > 0.1, "a flat sea");
}

/// The disk of a nearly calm sea lies about its center at sea level.
bool SurfaceLiesAboutItsCenter()
{
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSpectrum(vtkSeaStateSource::Regular);
  sea->SetSeaBy(vtkSeaStateSource::HeightAndPeriod);
  sea->SetSignificantWaveHeight(0.002);
  sea->SetSeaLevel(37.0);
  vtkNew<vtkSeaSurfaceFilter> surface;
  surface->SetInputConnection(sea->GetOutputPort());
  surface->SetCenter(300.0, -120.0);
  surface->SetRadius(200.0);
  surface->SetSpacing(4.0);
  surface->Update();
  const double* bounds = surface->GetOutput()->GetBounds();
  bool good = true;
  const double ends[6] = { 100.0, 500.0, -320.0, 80.0, 37.0, 37.0 };
  for (int end = 0; end < 6; ++end)
  {
    good &= Near("end of the disk", bounds[end], ends[end], 0.05);
  }
  return good;
}

/// Field data of a sea: the height of its trains, and what a range of frequencies leaves out.
bool SeaTellsItsEnergy()
{
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSeaBy(vtkSeaStateSource::HeightAndPeriod);
  sea->SetSignificantWaveHeight(2.0);
  sea->SetPeakPeriod(8.0);
  sea->SetNumberOfTrains(80);
  sea->SetFrequencyRange(0.72, 4.0); // leaves less out than it warns of
  sea->Update();
  vtkTable* table = sea->GetOutput();
  double energy = 0.0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    energy += 0.5 * std::pow(table->GetValueByName(row, "Amplitude").ToDouble(), 2);
  }
  // m_0 = (H / 4)^2
  bool good = Near("height of the trains", FieldOf(table, "SignificantWaveHeight"), 4.0 * std::sqrt(energy), 1e-9);
  good &= Check(FieldOf(table, "EnergyLeftOut") > 1e-4, "nothing is left out");
  return good & Near("energy left out", FieldOf(table, "EnergyLeftOut"), 1.0 - energy / 0.25, 1e-6);
}

/// Corners of a particle's square are a radius along and across from its middle, and hold the corners of its picture.
bool SquaresAreAsLargeAsTheirParticles()
{
  vtkNew<vtkSuspendedParticleSource> source;
  source->SetMode(vtkSuspendedParticleSource::Quads);
  source->SetDensity(0.1);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkPolyData* output = source->GetOutput();
  vtkDataArray* radius = output->GetPointData()->GetArray("Radius");
  vtkDataArray* offset = output->GetPointData()->GetArray("Offset");
  vtkDataArray* uv = output->GetPointData()->GetTCoords();
  bool good = Check(output->GetNumberOfPoints() > 100, "no particles");
  for (vtkIdType id = 0; good && id < output->GetNumberOfPoints(); id += 5)
  {
    std::vector<std::array<double, 2>> corners;
    for (vtkIdType corner = id + 1; corner < id + 5; ++corner)
    {
      double p[3];
      double q[3];
      output->GetPoint(id, p);
      output->GetPoint(corner, q);
      const double away = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
      good &= Near("half of a square's diagonal", away / radius->GetTuple1(id), std::sqrt(2.0), 1e-5);
      good &= Near("offset of a corner", offset->GetComponent(corner, 1), q[1] - p[1], 1e-6);
      corners.push_back({ uv->GetComponent(corner, 0), uv->GetComponent(corner, 1) });
    }
    // In turn around the picture, whose middle is the particle's.
    const double width = corners[1][0] + corners[2][0] - corners[0][0] - corners[3][0];
    const double height = corners[2][1] + corners[3][1] - corners[0][1] - corners[1][1];
    good &= Check(std::abs(width) > 0.5 && std::abs(height) > 0.2, "a picture is folded");
    good &= Near("middle of a picture", corners[0][0] + corners[2][0], 2.0 * uv->GetComponent(id, 0), 1e-5);
    good &= Near("middle of a picture", corners[0][1] + corners[2][1], 2.0 * uv->GetComponent(id, 1), 1e-5);
  }
  return good;
}

/// A terrain without relief is its plane, through the middle of its whole extent, in any part of it.
bool TerrainWithoutReliefIsItsPlane()
{
  vtkNew<vtkTurningBandsTerrainSource> source;
  source->SetWholeExtent(-10, 30, 4, 64, 0, 0); // middle 10, 34
  source->SetSpacing(2.0, 5.0, 1.0);
  source->SetOrigin(7.0, 9.0, 0.0);
  source->SetStandardDeviation(0.0);
  source->SetMean(100.0);
  source->SetSlope(0.25, -0.5);
  const int parts[2][6] = { { -10, 30, 4, 64, 0, 0 }, { 3, 9, 20, 50, 0, 0 } };
  bool good = true;
  for (const auto& part : parts)
  {
    source->UpdateExtent(part);
    vtkImageData* output = source->GetOutput();
    for (vtkIdType id = 0; good && id < output->GetNumberOfPoints(); ++id)
    {
      const double* p = output->GetPoint(id);
      good = Near("height", output->GetPointData()->GetArray("Elevation")->GetTuple1(id),
        100.0 + 0.25 * (p[0] - 27.0) - 0.5 * (p[1] - 179.0), 1e-4);
    }
  }
  return good;
}

/// Reflectance of two scales, the second a tenth of the first: squares of differences of neighbours by its covariance,
/// (K_0(r / a) - K_0(10 r / a)) / ln 10.
bool ReflectanceHasItsSecondScale()
{
  vtkNew<vtkTurningBandsTerrainSource> source;
  source->SetWholeExtent(0, 511, 0, 511, 0, 0);
  source->SetSpacing(1.0, 1.0, 1.0);
  source->ReflectanceOn();
  source->SetReflectanceModel(vtkTurningBandsTerrainSource::Telis);
  source->SetReflectanceRange(20.0);
  source->SetReflectanceMean(0.5);
  source->SetReflectanceStandardDeviation(0.1);
  source->Update();
  vtkDataArray* values = source->GetOutput()->GetPointData()->GetArray("Reflectance");
  double squares = 0.0;
  for (int j = 0; j < 512; ++j)
  {
    for (int i = 0; i < 511; ++i)
    {
      squares += std::pow(values->GetTuple1(512 * j + i + 1) - values->GetTuple1(512 * j + i), 2) / (512.0 * 511.0);
    }
  }
  // K_0(0.05) = 3.11423 and K_0(0.5) = 0.92442 (Abramowitz and Stegun, table 9.8)
  const double correlation = (3.11423 - 0.92442) / std::log(10.0);
  return Near("square of the differences of neighbours", squares / 0.02, 1.0 - correlation, 0.15 * (1.0 - correlation));
}

/// Colors go by the height over the lowest place: a terrain that is lifted has the same ones.
bool ColorsDoNotDependOnSeaLevel()
{
  std::vector<std::vector<double>> colors;
  for (const double lift : { 0.0, 800.0 })
  {
    vtkNew<vtkTerrainLevelOfDetailFilter> filter;
    filter->SetInputData(
      ImageOf({ 0, 40, 0, 30, 0, 0 }, { 0.0, 0.0, 0.0 }, { 10.0, 10.0, 1.0 }, "Elevation", [&](const double* p) {
        return static_cast<float>(lift + 64.0 * std::sin(0.01 * p[0]) * std::cos(0.02 * p[1]));
      }));
    filter->UseCullingOff();
    filter->SetNumberOfLevels(1);
    filter->Update();
    colors.emplace_back();
    for (unsigned int number = 0; number < filter->GetOutput()->GetNumberOfBlocks(); ++number)
    {
      auto* block = vtkPolyData::SafeDownCast(filter->GetOutput()->GetBlock(number));
      vtkDataArray* painted = block ? block->GetPointData()->GetArray("RGB") : nullptr;
      for (vtkIdType id = 0; painted && id < painted->GetNumberOfTuples(); ++id)
      {
        for (int channel = 0; channel < 3; ++channel)
        {
          colors.back().push_back(painted->GetComponent(id, channel));
        }
      }
    }
  }
  bool good = Check(!colors[0].empty() && colors[0].size() == colors[1].size(), "no colors");
  for (std::size_t n = 0; good && n < colors[0].size(); ++n)
  {
    good = Near("color of a lifted terrain", colors[1][n], colors[0][n], 1.0);
  }
  return good;
}

/// Two moving nodes of other densities: the wake begins at their center of mass.
bool WakeBeginsAtTheCenterOfMass()
{
  vtkNew<vtkPolyData> bones = PointsAt({ { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 8.0 } });
  AddNumbers(bones, "Velocity", 3, { 1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f });
  AddNumbers(bones, "Acceleration", 3, { 0.5f, 0.0f, 0.0f, 0.5f, 0.0f, 0.0f });
  AddNumbers(bones, littoral::plant::Radius, 1, { 0.1f, 0.1f });
  AddNumbers(bones, littoral::seaweed::Length, 1, { 1.0f, 1.0f });
  AddNumbers(bones, littoral::seaweed::Density, 1, { 500.0f, 1500.0f });
  vtkNew<vtkMultiBlockDataSet> high;
  littoral::AddBlock(high, littoral::plant::Skeleton, bones);
  vtkNew<vtkMultiBlockDataSet> plants;
  littoral::AddBlock(plants, littoral::plant::High, high);
  vtkNew<vtkPlantWakeFilter> wake;
  wake->SetInputData(plants);
  wake->Update();
  vtkPolyData* output = wake->GetOutput();
  if (!Check(output->GetNumberOfPoints() == 1, "no wake"))
  {
    return false;
  }
  const bool isAlong = Near("center of mass", output->GetPoint(0)[0], 3.0, 1e-5);
  const bool isUp = Near("center of mass", output->GetPoint(0)[2], 6.0, 1e-5);
  return isAlong && isUp;
}

/// Part of a wind, from its fourth layer on: between layers heights go by their logarithms.
bool WindOfAPartIsThatOfItsHeights()
{
  vtkNew<vtkImageData> image;
  image->SetExtent(0, 7, 0, 2, 3, 6);
  image->SetOrigin(0.0, 0.0, 2.0);
  image->SetSpacing(0.4, 1.0, 5.0); // layers from 17 m on
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    velocity->InsertNextTuple3(10.0 + 2.0 * (image->GetPoint(id)[2] - 17.0), 0.0, 0.0);
  }
  image->GetPointData()->AddArray(velocity);
  vtkNew<vtkDoubleArray> speed;
  speed->SetName("ConvectionSpeed");
  speed->InsertNextValue(8.0);
  image->GetFieldData()->AddArray(speed);
  std::shared_ptr<const littoral::FrozenWind> wind;
  const std::string why = littoral::WhyRefused([&] { wind = littoral::ReadWind(image); });
  if (!Check(why.empty(), why))
  {
    return false;
  }
  bool good = Near("time step of a wind", wind->GetTimes().Step, 0.05, 1e-12);
  littoral::Vector3 at;
  wind->Sample({ 1.0, 1.0, 22.0 }, 0.0, 1, &at);
  good &= Near("wind of a layer", at.x, 20.0, 1e-5);
  wind->Sample({ 1.0, 1.0, 19.5 }, 0.0, 1, &at);
  return good & Near("wind between layers", at.x, 10.0 + 10.0 * std::log(19.5 / 17.0) / std::log(22.0 / 17.0), 1e-5);
}

/// Sites on a part of a terrain that is a plane stand on that plane.
bool PlantsStandOnAPartOfATerrain()
{
  const auto plane = [](const double* p) { return static_cast<float>(0.5 * p[0] - 0.25 * p[1] + 3.0); };
  vtkNew<vtkImageData> terrain =
    ImageOf({ 10, 15, -4, 3, 0, 0 }, { 100.0, 50.0, 0.0 }, { 2.0, 5.0, 1.0 }, "Elevation", plane);
  vtkNew<vtkPolyData> sites = PointsAt({ { 121.0, 31.0, 0.0 }, { 128.5, 60.0, 0.0 }, { 124.25, 47.5, 9.0 } });
  littoral::ScatterOptions options;
  options.Weights = { 1.0 };
  std::vector<littoral::PlantPlace> places;
  const std::string why = littoral::WhyRefused([&] {
    places = littoral::PlacePlants(
      sites, littoral::MakeSitePart(sites, 1.0, 0, 1), terrain, options, littoral::GroundLimits());
  });
  bool good = Check(why.empty() && places.size() == 3, "plants are not placed: " + why);
  for (std::size_t site = 0; good && site < 3; ++site)
  {
    const double* p = sites->GetPoint(static_cast<vtkIdType>(site));
    good = Near("ground", places[site].Foot.z, 0.5 * p[0] - 0.25 * p[1] + 3.0, 1e-4);
  }
  return good;
}

/// Pieces of what does not divide evenly cover all, each once, and hold as many but for one.
bool PiecesCoverAll()
{
  bool good = true;
  for (const long long count : { 0ll, 1ll, 10ll, 100000000007ll })
  {
    long long end = 0;
    for (int piece = 0; piece < 3; ++piece)
    {
      vtkNew<vtkInformation> info;
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), piece);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 3);
      const littoral::PieceRange part = littoral::RequestedPart(info, count);
      good &= Check(part.Begin == end, "pieces leave something out, or overlap");
      good &= Check(std::abs(part.End - part.Begin - count / 3) <= 1, "a piece has another size");
      end = part.End;
    }
    good &= Check(end == count, "pieces end too early");
  }
  return good;
}

}

int TestKnownAnswers(int, char*[])
{
  bool good = FogIsCrossSectionOverVolume();
  good &= SectionsHaveTheirAreas();
  good &= QuadratsFitTheBoxOfThePoints();
  good &= LagsGoByTheSidesOfTheImage();
  good &= NormalsStandOnTheSurface();
  good &= SurfaceLiesAboutItsCenter();
  good &= SeaTellsItsEnergy();
  good &= SquaresAreAsLargeAsTheirParticles();
  good &= TerrainWithoutReliefIsItsPlane();
  good &= ReflectanceHasItsSecondScale();
  good &= ColorsDoNotDependOnSeaLevel();
  good &= WakeBeginsAtTheCenterOfMass();
  good &= WindOfAPartIsThatOfItsHeights();
  good &= PlantsStandOnAPartOfATerrain();
  good &= PiecesCoverAll();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
