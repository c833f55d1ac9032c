// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Kelp moves as kelp does in a regular swell: out of phase along its length, slower than the water, never like a stick.
#include "Check.h"
#include "Numerics/Constants.h"
#include "PlantChecks.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkParticleOrbitFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <vector>

namespace
{

using littoral::Vector3;

constexpr double Period = 6.2; // [s]
constexpr int Moments = 31;    // of a period
constexpr double Depth = 17.0; // [m]

/// The nodes of the longest branch.
std::vector<vtkIdType> LongestBranch(vtkPolyData* bones)
{
  std::vector<vtkIdType> longest;
  for (vtkIdType line = 0; line < bones->GetNumberOfLines(); ++line)
  {
    vtkIdType count = 0;
    const vtkIdType* nodes = nullptr;
    bones->GetLines()->GetCellAtId(line, count, nodes);
    Vector3 foot;
    Vector3 tip;
    bones->GetPoint(nodes[0], &foot.x);
    bones->GetPoint(nodes[count - 1], &tip.x);
    Vector3 ends[2] = { Vector3(0.0), Vector3(0.0) }; // of the longest so far
    if (!longest.empty())
    {
      bones->GetPoint(longest.front(), &ends[0].x);
      bones->GetPoint(longest.back(), &ends[1].x);
    }
    if (glm::distance(foot, tip) > glm::distance(ends[0], ends[1]))
    {
      longest.assign(nodes, nodes + count);
    }
  }
  return longest;
}

/// The first harmonic along x of what is at places at each moment [m]; of each place.
std::vector<std::complex<double>> HarmonicsOf(const std::vector<std::vector<Vector3>>& moments)
{
  std::vector<std::complex<double>> harmonics(moments[0].size());
  for (int k = 0; k < Moments; ++k)
  {
    const std::complex<double> turn = std::polar(2.0 / Moments, littoral::TwoPi * k / Moments);
    for (std::size_t place = 0; place < harmonics.size(); ++place)
    {
      harmonics[place] += turn * moments[k][place].x;
    }
  }
  return harmonics;
}

struct Way
{
  std::vector<double> Heights; // over the foot [m]
  std::vector<std::complex<double>> Plant;
  std::vector<std::complex<double>> Water;
};

/// How a stipe of giant kelp goes to and fro, and the water at the mean places of its nodes.
Way MeasureKelp()
{
  vtkNew<vtkSeaweedSource> weed;
  weed->SetPreset(vtkSeaweedSource::GiantKelp);
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSpectrum(vtkSeaStateSource::Regular);
  sea->SetSeaBy(vtkSeaStateSource::HeightAndPeriod);
  sea->SetSignificantWaveHeight(0.5);
  sea->SetPeakPeriod(Period);
  sea->SetWaterDepth(Depth);
  sea->SetSeaLevel(Depth);
  vtkNew<vtkFlowPrimitiveSource> current;
  current->SetStrength(0.08);
  vtkNew<vtkSeaweedDeformationFilter> move;
  move->SetInputConnection(weed->GetOutputPort());
  move->SetSeaStateConnection(sea->GetOutputPort());
  move->AddCurrentConnection(current->GetOutputPort());
  move->SetStartTime(-8.0 * Period);
  std::vector<std::vector<Vector3>> plant;
  std::vector<vtkIdType> nodes;
  for (int k = 0; k < Moments; ++k)
  {
    move->UpdateTimeStep(Period * k / Moments);
    vtkPolyData* bones = Part(move->GetOutputDataObject(0), "Skeleton");
    nodes = nodes.empty() ? LongestBranch(bones) : nodes;
    plant.emplace_back(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      bones->GetPoint(nodes[i], &plant.back()[i].x);
    }
  }
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  Way way;
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    Vector3 mean(0.0);
    for (const std::vector<Vector3>& moment : plant)
    {
      mean += moment[i] / static_cast<double>(Moments);
    }
    places->InsertNextPoint(&mean.x);
    way.Heights.push_back(mean.z - plant[0][0].z);
  }
  vtkNew<vtkPolyData> still;
  still->SetPoints(places);
  vtkNew<vtkParticleOrbitFilter> orbits;
  orbits->SetInputData(still);
  orbits->SetSeaStateConnection(sea->GetOutputPort());
  std::vector<std::vector<Vector3>> water;
  for (int k = 0; k < Moments; ++k)
  {
    orbits->UpdateTimeStep(Period * k / Moments);
    auto* moved = vtkPointSet::SafeDownCast(orbits->GetOutputDataObject(0));
    water.emplace_back(nodes.size() - 1);
    for (std::size_t i = 0; i < water.back().size(); ++i)
    {
      moved->GetPoint(static_cast<vtkIdType>(i), &water.back()[i].x);
    }
  }
  const std::vector<std::complex<double>> all = HarmonicsOf(plant);
  way.Plant.assign(all.begin() + 1, all.end());
  way.Water = HarmonicsOf(water);
  return way;
}

/// What part of a motion along a stipe is left when the best turn of a stick about its foot is taken away.
double PartNotOfAStick(const Way& way, const std::vector<std::complex<double>>& motion)
{
  std::complex<double> lever(0.0, 0.0);
  double arms = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < way.Heights.size(); ++i)
  {
    lever += way.Heights[i] * motion[i];
    arms += way.Heights[i] * way.Heights[i];
    all += std::norm(motion[i]);
  }
  return 1.0 - std::norm(lever) / (arms * all);
}

}

int TestKelpInSwell(int, char*[])
{
  const Way way = MeasureKelp();
  double slowest = 1e9;
  double plant = 0.0;
  double water = 0.0;
  double first = 1e9;
  double last = -1e9;
  for (std::size_t i = 0; i < way.Heights.size(); ++i)
  {
    const double ratio = std::abs(way.Plant[i]) / std::abs(way.Water[i]);
    const double behind = std::arg(way.Plant[i] / way.Water[i]) * 180.0 / littoral::Pi;
    std::cout << way.Heights[i] << " m over the foot: " << std::abs(way.Plant[i]) << " m, " << ratio
              << " of the water there, " << behind << " degrees behind it\n";
    slowest = std::min(slowest, ratio);
    plant += std::norm(way.Plant[i]);
    water += std::norm(way.Water[i]);
    first = std::min(first, behind);
    last = std::max(last, behind);
  }
  const double speed = std::sqrt(plant / water);
  const double bent = PartNotOfAStick(way, way.Plant);
  const double sheared = PartNotOfAStick(way, way.Water); // which itself grows with the height
  std::cout << "speed of the stipe " << speed << " of the water's; phases over " << last - first
            << " degrees; not of a stick " << bent << ", of the water " << sheared << std::endl;
  bool good = Check(way.Heights.size() > 5, "there is no stipe");
  good = Check(std::abs(speed - 0.84) < 0.05, "the kelp has another part of the speed of the water") && good;
  good = Check(last - first > 20.0, "the kelp is in phase along its length") && good;
  good = Check(bent > 1.5 * sheared, "the kelp moves like a stick") && good;
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
