// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Minutes of a sea of many directions, and of currents with hardly a wave: no tip sinks to its holdfast, no frond
// crosses itself, and no blade folds where the sea is moderate, hardly one where it is rough, at the defaults.
#include "Check.h"
#include "Numerics/Constants.h"
#include "PlantChecks.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using littoral::Vector3;

/// A plant, its sea, and what it must keep to.
struct Case
{
  int Preset;
  double Wind;           ///< [m/s]
  double Depth;          ///< [m]
  int Seconds;           ///< of a long film
  int Seeds;             ///< of long films
  double MostFolded;     ///< share of the fronds' seconds
  double Current = 0.0;  ///< [m/s]
  bool IsByWind = false; ///< else with the waves of that wind on deep water
};

/// What was worst in a film.
struct Worst
{
  double LowestTip = 1e9;     ///< over the holdfast [m]
  double LargestBend = 0.0;   ///< between neighbours of a branch [degrees]
  int Folded = 0;             ///< times frond with a bend of more than 90 degrees
  int Fronds = 0;             ///< times frond
  double LeastDistance = 1e9; ///< between segments that are no neighbours, of the shorter one's length
};

/// The least distance between segments a and b, over a grid of points: at most a tenth of a length above the exact one.
double DistanceOf(const Vector3 a[2], const Vector3 b[2])
{
  constexpr int Points = 6;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < Points; ++i)
  {
    const Vector3 point = a[0] + (i / (Points - 1.0)) * (a[1] - a[0]);
    const Vector3 along = b[1] - b[0];
    const double part = std::clamp(glm::dot(point - b[0], along) / glm::dot(along, along), 0.0, 1.0);
    least = std::min(least, glm::distance(point, b[0] + part * along));
  }
  return least;
}

void TakeBranch(const std::vector<Vector3>& nodes, double foot, Worst& worst)
{
  worst.LowestTip = std::min(worst.LowestTip, nodes.back().z - foot);
  double bend = 0.0; // [degrees]
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    const double length = glm::distance(nodes[i], nodes[i + 1]);
    if (i > 0)
    {
      const Vector3 before = glm::normalize(nodes[i] - nodes[i - 1]);
      const double cosine = std::clamp(glm::dot(before, (nodes[i + 1] - nodes[i]) / length), -1.0, 1.0);
      bend = std::max(bend, std::acos(cosine) * 180.0 / littoral::Pi);
    }
    for (std::size_t j = i + 2; j + 1 < nodes.size(); ++j)
    {
      const double shorter = std::min(length, glm::distance(nodes[j], nodes[j + 1]));
      worst.LeastDistance = std::min(worst.LeastDistance, DistanceOf(&nodes[i], &nodes[j]) / shorter);
    }
  }
  worst.LargestBend = std::max(worst.LargestBend, bend);
  worst.Folded += bend > 90.0 ? 1 : 0;
  ++worst.Fronds;
}

/// Branches of more than three segments: blades of a canopy hang on their floats as they like.
void TakePicture(vtkPolyData* bones, Worst& worst)
{
  Vector3 foot;
  bones->GetPoint(0, &foot.x);
  for (vtkIdType line = 1; line < bones->GetNumberOfLines(); ++line)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    bones->GetLines()->GetCellAtId(line, count, ids);
    std::vector<Vector3> nodes(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      bones->GetPoint(ids[i], &nodes[i].x);
    }
    if (count > 4)
    {
      TakeBranch(nodes, foot.z, worst);
    }
  }
}

bool TestPlant(const Case& one, int seed, int seconds)
{
  vtkNew<vtkSeaweedSource> weed;
  weed->SetPreset(one.Preset);
  weed->SetSeed(seed);
  vtkNew<vtkSeaStateSource> sea;
  // Height and period of Pierson and Moskowitz on deep water: higher than such a wind raises here
  sea->SetWindSpeed(one.Wind);
  sea->SetSeaBy(one.IsByWind ? vtkSeaStateSource::Wind : vtkSeaStateSource::HeightAndPeriod);
  sea->SetSignificantWaveHeight(4.0 * one.Wind * one.Wind / 9.80665 * std::sqrt(8.1e-3 / (4.0 * 0.74)));
  sea->SetPeakPeriod(littoral::TwoPi * one.Wind / (std::pow(0.8 * 0.74, 0.25) * 9.80665));
  sea->SetSeaLevel(one.Depth);
  sea->SetWaterDepth(one.Depth);
  sea->SetSeed(seed + 6);
  vtkNew<vtkSeaweedDeformationFilter> move;
  move->SetInputConnection(weed->GetOutputPort());
  move->SetSeaStateConnection(sea->GetOutputPort());
  vtkNew<vtkFlowPrimitiveSource> current;
  current->SetStrength(one.Current);
  if (one.Current > 0.0)
  {
    move->AddCurrentConnection(current->GetOutputPort());
  }
  Worst worst;
  for (int second = 0; second <= seconds; ++second)
  {
    move->UpdateTimeStep(second);
    TakePicture(Part(move->GetOutputDataObject(0), "Skeleton"), worst);
  }
  const double folded = static_cast<double>(worst.Folded) / worst.Fronds;
  std::ostringstream who;
  who << weed->GetPresetAsString() << ", wind of " << one.Wind << " m/s, current of " << one.Current << " m/s, seed "
      << seed;
  std::cout << who.str() << ": lowest tip " << worst.LowestTip << " m over its holdfast, largest bend "
            << worst.LargestBend << " degrees, folded " << 100.0 * folded << " %, least distance "
            << worst.LeastDistance << " segments" << std::endl;
  bool good = Check(worst.LowestTip > 0.0, who.str() + ": a tip sinks to its holdfast");
  good = Check(folded <= one.MostFolded, who.str() + ": fronds fold") && good;
  const bool mayTouch = one.MostFolded > 0.01; // a blade that folds
  return Check(mayTouch || worst.LeastDistance > 0.1, who.str() + ": a frond crosses itself") && good;
}

}

/// With --long films of ten minutes and three seeds, else a sixth of the time and one seed.
int TestKelpInSea(int argc, char* argv[])
{
  const bool isLong = argc > 1 && std::string(argv[argc - 1]) == "--long";
  bool good = true;
  for (const Case& one : {
         Case{ vtkSeaweedSource::SugarKelp, 6.0, 6.0, 600, 3, 0.0 },
         Case{ vtkSeaweedSource::SugarKelp, 7.0, 6.0, 600, 3, 0.005 },
         Case{ vtkSeaweedSource::SugarKelp, 8.0, 6.0, 600, 3, 0.08 },
         Case{ vtkSeaweedSource::SugarKelp, 2.0, 6.0, 600, 3, 0.0, 0.15 },
         Case{ vtkSeaweedSource::SugarKelp, 2.0, 6.0, 600, 3, 0.0, 0.3 },
         Case{ vtkSeaweedSource::SugarKelp, 8.0, 6.0, 600, 3, 0.0, 0.0, true },
         Case{ vtkSeaweedSource::SugarKelp, 10.0, 6.0, 600, 3, 0.04, 0.0, true },
         Case{ vtkSeaweedSource::Eelgrass, 5.0, 6.0, 600, 1, 0.0 },
         Case{ vtkSeaweedSource::GiantKelp, 6.0, 17.0, 120, 1, 0.0 },
       })
  {
    for (int seed = 1; seed <= (isLong ? one.Seeds : 1); ++seed)
    {
      good = TestPlant(one, seed, isLong ? one.Seconds : one.Seconds / 6) && good;
    }
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
