// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Particles that drift, in levels of detail: their places and opacities, any history of times, and a way of all that is
// told in place of moved points.
#include "Check.h"
#include "SeaParticles.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkParticleLevelOfDetailFilter.h"
#include "vtkSeaStateSource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

using namespace littoral::testing;

namespace
{

using Levels = vtkParticleLevelOfDetailFilter;
using Sea = vtkSeaStateSource;

/// Opacity of a master at a place, seen by LookAlongY(): a smooth step down to 0 from 11.5 m to 12.5 m.
double OpacityAt(const double place[3])
{
  const double eye[3] = { 0.0, 0.0, -4.0 };
  const double step = std::clamp(std::sqrt(vtkMath::Distance2BetweenPoints(place, eye)) - 11.5, 0.0, 1.0);
  return 1.0 - step * step * (3.0 - 2.0 * step);
}

/// How far particles that are fog are behind or ahead of a way that all have gone: they go by steps of so many pixels
/// 11.5 m before LookAlongY(), at most 2 cm.
double FogAway(double way, double pixels)
{
  const double step = std::min(0.02, pixels * 2.0 * 11.5 * std::tan(vtkMath::RadiansFromDegrees(20.0)) / 1080.0);
  return std::abs(way - step * std::round(way / step));
}

/// Particles of levels are where they have drifted to; those that are fog are so far away from there.
bool CheckDriftedPlaces(Levels* levels, vtkPolyData* particles, bool areAll, double fogAway)
{
  bool good = true;
  std::vector<double> alpha(static_cast<std::size_t>(particles->GetNumberOfPoints()), 0.0);
  for (int index = 0; index < 3; ++index)
  {
    vtkPolyData* block = BlockOf(levels, index);
    vtkDataArray* ids = block->GetPointData()->GetArray("ParticleId");
    vtkDataArray* alphas = block->GetPointData()->GetArray("Alpha");
    for (vtkIdType n = 0; n < block->GetNumberOfPoints(); ++n)
    {
      double a[3];
      double b[3];
      const auto id = static_cast<vtkIdType>(ids->GetTuple1(n));
      block->GetPoint(n, a);
      particles->GetPoint(id, b);
      alpha[id] += alphas->GetTuple1(n);
      const bool isMaster =
        index == 1 && alphas->GetTuple1(n) > 0.0 && block->GetPointData()->GetArray("MasterId")->GetTuple1(n) < 0.0;
      good &= !isMaster || std::abs(alphas->GetTuple1(n) - OpacityAt(a)) < 1e-4;
      const double away = std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
      good &= index < 2 ? away == 0.0 : std::abs(away - fogAway) < 1e-5;
    }
  }
  good = Check(good, "a particle of a level is not where it has drifted to, or has the opacity of another place");
  // Weights change by 3/2 a metre.
  const auto isWhole = [=](double sum) { return std::abs(sum - 1.0) < 1.5 * fogAway + 1e-5; };
  return good &
    Check(!areAll || std::all_of(alpha.begin(), alpha.end(), isWhole), "alphas of drifted particles do not sum to 1");
}

/// Frames of particles that drift, alike or not, as levels that have seen others before and as new ones show them. The
/// frames that are held keep their bytes.
bool CheckDriftedFrames()
{
  bool good = true;
  vtkNew<Sea> sea;
  vtkNew<vtkPolyData> particles = Particles(30000, VTK_FLOAT);
  for (const int flow : { vtkFlowPrimitiveSource::Uniform, vtkFlowPrimitiveSource::Vortex })
  {
    vtkNew<vtkFlowPrimitiveSource> current;
    current->SetFlowType(flow);
    current->SetStrength(flow == vtkFlowPrimitiveSource::Uniform ? 0.3 : 20.0);
    vtkNew<vtkCurrentDriftFilter> drift;
    drift->SetInputData(0, particles);
    drift->AddCurrentConnection(current->GetOutputPort());
    double pixels = 1.0;
    const auto look = [&](Levels* levels, double time) {
      levels->SetPixelError(pixels);
      levels->SetInputConnection(0, drift->GetOutputPort());
      levels->SetSeaStateConnection(sea->GetOutputPort());
      LookAlongY(levels);
      levels->SetUseCulling(flow != vtkFlowPrimitiveSource::Uniform);
      levels->UpdateTimeStep(time);
      return BytesOf(levels);
    };
    vtkNew<Levels> kept;
    std::vector<vtkSmartPointer<vtkDataArray>> held;
    std::vector<std::vector<char>> bytes;
    for (const double time : { 0.0, 0.1, 0.3, 0.207, 4.0, 0.1, 40.0, 2.0 })
    {
      pixels = time == 4.0 ? 5.0 : 1.0;
      vtkNew<Levels> fresh;
      good &= Check(look(kept, time) == look(fresh, time), "a frame depends on those before");
      const bool areAll = flow == vtkFlowPrimitiveSource::Uniform;
      good &= CheckDriftedPlaces(kept, vtkPolyData::SafeDownCast(drift->GetOutputDataObject(0)), areAll,
        areAll ? FogAway(0.3 * time, pixels) : 0.0);
      for (int index = 0; index < 3; ++index)
      {
        held.emplace_back(BlockOf(kept, index)->GetPoints()->GetData());
        held.emplace_back(BlockOf(kept, index)->GetPointData()->GetArray("Alpha"));
      }
      while (bytes.size() < held.size())
      {
        vtkDataArray* next = held[bytes.size()];
        Append(bytes.emplace_back(), next);
      }
    }
    for (std::size_t n = 0; n < held.size(); ++n)
    {
      std::vector<char> now;
      Append(now, held[n]);
      good &= Check(now == bytes[n], "a frame that is held has changed");
    }
    // A way of 0.2 m has the levels of those up to 0.4 m, and none of its own.
    const auto masterIds = [&](double time) {
      look(kept, time);
      return vtkSmartPointer<vtkDataArray>(BlockOf(kept, 1)->GetPointData()->GetArray("MasterId"));
    };
    const bool goTogether = flow == vtkFlowPrimitiveSource::Uniform;
    good &= Check(
      !goTogether || masterIds(2.0 / 3.0) == masterIds(1.2), "a multiple of the step of ways has levels of its own");
    // Together, all keep their master.
    const auto masters = [&](double time) {
      look(kept, time);
      std::map<vtkIdType, vtkIdType> all;
      vtkPointData* arrays = BlockOf(kept, 1)->GetPointData();
      vtkDataArray* ids = arrays->GetArray("ParticleId");
      for (vtkIdType n = 0; n < ids->GetNumberOfTuples(); ++n)
      {
        const auto master = static_cast<vtkIdType>(arrays->GetArray("MasterId")->GetTuple1(n));
        all[static_cast<vtkIdType>(ids->GetTuple1(n))] =
          master < 0 ? -1 : static_cast<vtkIdType>(ids->GetTuple1(master));
      }
      return all;
    };
    const auto before = masters(0.0);
    int changed = 0;
    for (const auto& [particle, master] : masters(40.0))
    {
      const auto same = before.find(particle);
      changed += same != before.end() && master >= 0 && same->second >= 0 && same->second != master;
    }
    good &= Check(flow != vtkFlowPrimitiveSource::Uniform || changed == 0, "groups that drift alike change");
  }
  return good;
}

/// Levels of particles whose common way is told have the bytes of those that have been moved; where there is none, all
/// are moved.
bool CheckToldWay()
{
  bool good = true;
  vtkNew<Sea> sea;
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    vtkNew<vtkPolyData> particles = Particles(5000, type);
    for (const int flow : { vtkFlowPrimitiveSource::Uniform, vtkFlowPrimitiveSource::Vortex })
    {
      const bool goTogether = flow == vtkFlowPrimitiveSource::Uniform;
      vtkNew<vtkFlowPrimitiveSource> current;
      current->SetFlowType(flow);
      current->SetStrength(goTogether ? 0.3 : 20.0);
      vtkNew<vtkCurrentDriftFilter> drifts[2];
      vtkNew<Levels> levels[2];
      for (int tells = 0; tells < 2; ++tells)
      {
        drifts[tells]->SetInputData(0, particles);
        drifts[tells]->AddCurrentConnection(current->GetOutputPort());
        drifts[tells]->SetWayAsField(tells == 1);
        levels[tells]->SetInputConnection(0, drifts[tells]->GetOutputPort());
        levels[tells]->SetSeaStateConnection(sea->GetOutputPort());
        LookAlongY(levels[tells]);
      }
      for (const int placement : { Levels::OwnPlace, Levels::Scattered })
      {
        for (const double time : { 0.0, 0.1, 4.0, 0.207 })
        {
          for (Levels* each : { levels[0].Get(), levels[1].Get() })
          {
            each->SetSlavePlacement(placement);
            each->UpdateTimeStep(time);
          }
          good &= Check(BytesOf(levels[0]) == BytesOf(levels[1]), "a way that is told gives other levels");
          auto* told = vtkPolyData::SafeDownCast(drifts[1]->GetOutputDataObject(0));
          vtkDataArray* way = told->GetFieldData()->GetArray("DriftWay");
          good &= Check((way != nullptr) == goTogether, "a way is told where there is none, or the other way round");
          good &=
            Check(!way || std::abs(way->GetComponent(0, 0) - 0.3 * time) < 1e-12, "a way is not that of the flow");
          good &= Check((told->GetPoints()->GetData() == particles->GetPoints()->GetData()) == goTogether,
            "points are moved although their way is told, or not although it is not");
          good &= Check(!levels[1]->GetOutputDataObject(0)->GetFieldData()->GetArray("DriftWay"), "a way is told on");
        }
      }
    }
  }
  return good;
}

/// Another way of the same points is heard of.
bool CheckOtherWay()
{
  vtkNew<Sea> sea;
  vtkNew<vtkFlowPrimitiveSource> current;
  current->SetFlowType(vtkFlowPrimitiveSource::Uniform);
  vtkNew<vtkCurrentDriftFilter> drift;
  drift->SetInputData(0, Particles(5000, VTK_FLOAT));
  drift->AddCurrentConnection(current->GetOutputPort());
  drift->WayAsFieldOn();
  vtkNew<vtkPolyData> states[2];
  for (const int state : { 0, 1 })
  {
    drift->UpdateTimeStep(4.0 * state);
    states[state]->ShallowCopy(drift->GetOutputDataObject(0));
  }
  states[1]->SetPoints(states[0]->GetPoints());
  vtkNew<Levels> one;
  vtkNew<Levels> other;
  for (Levels* levels : { one.Get(), other.Get() })
  {
    levels->SetSeaStateConnection(sea->GetOutputPort());
    LookAlongY(levels);
    for (int state = levels == other ? 1 : 0; state < 2; ++state)
    {
      levels->SetInputData(0, states[state]);
      levels->UpdateTimeStep(4.0);
    }
  }
  return Check(BytesOf(one) == BytesOf(other), "levels stay where another way is told of the same points");
}

}

int TestDriftedParticleLevels(int, char*[])
{
  bool good = CheckDriftedFrames();
  good &= CheckToldWay();
  good &= CheckOtherWay();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
