// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// Ranges that are kept with arrays are those that VTK finds, and are dropped when an array changes; also those of
// particles that drift, which are not looked for.

#include "Numerics/ShiftedTriples.h"
#include "Pipeline/Ranges.h"
#include "vtkCurrentDriftFilter.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkParticleLevelOfDetailFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"
#include "vtkSuspendedParticleSource.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <vector>

namespace
{

int Failures = 0;

void Check(bool holds, const char* what)
{
  if (!holds)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
}

bool AreNear(const double a[2], const double b[2])
{
  return std::abs(a[0] - b[0]) <= 1e-15 * std::abs(b[0]) && std::abs(a[1] - b[1]) <= 1e-15 * std::abs(b[1]);
}

/// Numbers that differ by type, sign and component.
template <typename Array>
void Fill(Array* array, int components, vtkIdType tuples)
{
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
  {
    const double angle = 0.37 * static_cast<double>(k) + static_cast<double>(k % components);
    array->SetValue(k, static_cast<typename Array::ValueType>(100.0 * std::sin(angle) + 100.0));
  }
}

void CheckRanges(vtkDataArray* array)
{
  vtkSmartPointer<vtkDataArray> plain;
  plain.TakeReference(array->NewInstance());
  plain->DeepCopy(array);
  plain->Modified();
  littoral::KeepRanges(array);
  Check(array->GetInformation()->Has(vtkDataArray::PER_COMPONENT()), "ranges are kept");
  for (int c = array->GetNumberOfComponents() > 1 ? -1 : 0; c < array->GetNumberOfComponents(); ++c)
  {
    double kept[2];
    double found[2];
    array->GetRange(kept, c);
    plain->GetRange(found, c);
    Check(AreNear(kept, found), "ranges are those of VTK");
    array->GetFiniteRange(kept, c);
    plain->GetFiniteRange(found, c);
    Check(AreNear(kept, found), "finite ranges are those of VTK");
  }
}

/// Ranges of triples that have gone a way, from those before it. At 3e5 m single precision rounds to 1/32 m.
void CheckShifted(const littoral::Vector3& way)
{
  vtkNew<vtkFloatArray> before;
  vtkNew<vtkFloatArray> after;
  Fill(before.Get(), 3, littoral::FewTuples);
  Fill(after.Get(), 3, littoral::FewTuples);
  littoral::ShiftTriples(before->GetPointer(0), littoral::FewTuples, way, after->GetPointer(0));
  littoral::KeepShiftedRanges(before, way, after);
  Check(after->GetInformation()->Has(vtkDataArray::PER_COMPONENT()), "ranges of shifted places are kept");
  CheckRanges(after);
}

/// Ranges of all particles of a flow that drift, at two times and seen from two places at each.
void CheckDrifting(int flowType)
{
  const double box[12] = { 4.0, 5.0, 3.0, 10.0, -8.5, -7.5, 1.0, 0.01, 2.0 * littoral::FewTuples, 1.0, 1.0, 1.0 };
  vtkNew<vtkSuspendedParticleSource> particles;
  particles->SetPreset(vtkSuspendedParticleSource::Custom);
  particles->SetAmountIs(vtkSuspendedParticleSource::Count);
  particles->AddBox(box);
  vtkNew<vtkFlowPrimitiveSource> flow;
  flow->SetFlowType(flowType);
  flow->SetAxis(flowType == vtkFlowPrimitiveSource::Uniform ? 1.0 : 0.0, 0.0,
    flowType == vtkFlowPrimitiveSource::Uniform ? 0.0 : 1.0);
  flow->SetStrength(0.1);
  vtkNew<vtkCurrentDriftFilter> drift;
  drift->SetInputConnection(0, particles->GetOutputPort());
  drift->AddCurrentConnection(flow->GetOutputPort());
  vtkNew<vtkSeaStateSource> sea;
  vtkNew<vtkParticleLevelOfDetailFilter> levels;
  levels->SetInputConnection(0, drift->GetOutputPort());
  levels->SetSeaStateConnection(sea->GetOutputPort());
  levels->UseLevelsOff();
  levels->UseCullingOff();
  for (const double step : { 0.0, 1.0, 2.0, 3.0 })
  {
    levels->SetViewPoint(5.0 * step, 0.0, -8.0);
    levels->UpdateTimeStep(std::floor(0.5 * step));
    auto* shown = vtkPolyData::SafeDownCast(vtkMultiBlockDataSet::SafeDownCast(levels->GetOutput())->GetBlock(0));
    Check(shown->GetNumberOfPoints() == particles->GetOutput()->GetNumberOfPoints(), "all particles are shown");
    CheckRanges(vtkPolyData::SafeDownCast(drift->GetOutputDataObject(0))->GetPoints()->GetData());
    CheckRanges(shown->GetPoints()->GetData());
  }
  levels->UseLevelsOn();
  levels->SetFarDistance(20.0);
  levels->Update();
  int compared = 0;
  for (unsigned int block = 0; block < 3; ++block)
  {
    auto* shown = vtkPolyData::SafeDownCast(vtkMultiBlockDataSet::SafeDownCast(levels->GetOutput())->GetBlock(block));
    const bool isLarge = shown->GetNumberOfPoints() >= littoral::FewTuples;
    for (int index = 0; isLarge && index < shown->GetPointData()->GetNumberOfArrays(); ++index, ++compared)
    {
      CheckRanges(shown->GetPointData()->GetArray(index));
    }
  }
  Check(compared > 0, "arrays of levels are compared");
}

/// Skins whose ranges are found plant by plant while they are bent: of blades, stipes and floats, each its own.
void CheckBentSkins()
{
  vtkNew<vtkSeaweedSource> weed;
  weed->SetPreset(vtkSeaweedSource::GiantKelp);
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSeaLevel(17.0);
  sea->SetWaterDepth(17.0);
  vtkNew<vtkSeaweedDeformationFilter> move;
  move->SetInputConnection(weed->GetOutputPort());
  move->SetSeaStateConnection(sea->GetOutputPort());
  move->UpdateTimeStep(3.0);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(move->GetOutputDataObject(0));
  int skins = 0;
  auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    auto* block = vtkPolyData::SafeDownCast(each->GetCurrentDataObject());
    if (block && block->GetNumberOfPolys() > 0 && block->GetPointData()->GetArray("JointIds"))
    {
      CheckRanges(block->GetPoints()->GetData());
      CheckRanges(block->GetPointData()->GetNormals());
      ++skins;
    }
  }
  Check(skins > 1, "there are several skins");
}

bool HasBoundsOf(vtkPoints* points, vtkDataArray* positions)
{
  vtkNew<vtkPoints> plain;
  plain->SetData(positions);
  return std::equal(plain->GetBounds(), plain->GetBounds() + 6, points->GetBounds());
}

/// Bounds of points with ranges are those that VTK finds, also after a change; and they are taken from the ranges.
void CheckBounds()
{
  vtkNew<vtkFloatArray> places;
  Fill(places.Get(), 3, 1000);
  const auto points = littoral::PointsWithRanges(places);
  Check(HasBoundsOf(points, places), "bounds of points");
  places->SetValue(4, 1e6F);
  places->Modified();
  Check(HasBoundsOf(points, places), "bounds of changed points");
  places->SetValue(5, std::numeric_limits<float>::quiet_NaN());
  places->Modified();
  Check(HasBoundsOf(points, places), "bounds of points that are not all finite");
  vtkNew<vtkFloatArray> none;
  none->SetNumberOfComponents(3);
  Check(HasBoundsOf(littoral::PointsWithRanges(none), none), "bounds of no points");

  Fill(places.Get(), 3, 10);
  places->Modified();
  const double marked = -77.0;
  const auto mark = [&] {
    littoral::KeepRanges(places);
    const double range[2] = { marked, 0.0 };
    vtkInformationVector* kept = places->GetInformation()->Get(vtkDataArray::PER_COMPONENT());
    kept->GetInformationObject(0)->Set(vtkDataArray::COMPONENT_RANGE(), range, 2);
  };
  mark();
  Check(littoral::PointsWithRanges(places)->GetBounds()[0] == marked, "bounds are the ranges that are kept");

  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> plain;
  plain->SetData(places); // which drops the ranges
  data->SetPoints(plain);
  mark();
  littoral::KeepRanges(data);
  Check(data->GetPoints()->GetBounds()[0] == marked, "bounds of data are the ranges that are kept");
  vtkPoints* own = data->GetPoints();
  littoral::KeepRanges(data);
  Check(data->GetPoints() == own, "points with ranges stay");
}

/// Ranges of parts are those of the whole, where some parts have no tuples; short arrays keep none.
void CheckParts()
{
  vtkNew<vtkFloatArray> whole;
  Fill(whole.Get(), 3, littoral::FewTuples);
  const float* begin = whole->GetPointer(0);
  std::vector<littoral::TupleRanges> parts(3);
  parts[0].AddTuples(begin, begin + 300, 3);
  parts[1].AddTuples(begin, begin, 3);
  parts[2].AddTuples(begin + 300, begin + whole->GetNumberOfValues(), 3);
  littoral::KeepRangesOfParts(whole, parts);
  CheckRanges(whole);

  vtkNew<vtkFloatArray> few;
  Fill(few.Get(), 3, littoral::FewTuples - 1);
  littoral::KeepRangesOfParts(few, parts);
  littoral::PointsWithRanges(few);
  Check(!few->GetInformation()->Has(vtkDataArray::PER_COMPONENT()), "a short array keeps no ranges");
  Check(littoral::AreWithin(few, 200.1) && !littoral::AreWithin(few, 199.0), "a short array is looked through");
  few->SetValue(9, std::numeric_limits<float>::quiet_NaN());
  Check(!littoral::AreWithin(few, 200.1), "a short array with a value that is none");
}

}

int TestRanges(int, char*[])
{
  CheckBentSkins();
  CheckParts();
  CheckShifted({ 0.0, 0.0, 0.0 });
  CheckShifted({ 0.1, -3e5, 7.0 });
  CheckDrifting(vtkFlowPrimitiveSource::Uniform);
  CheckDrifting(vtkFlowPrimitiveSource::Vortex);
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkDoubleArray> doubles;
  vtkNew<vtkIntArray> ints;
  vtkNew<vtkUnsignedCharArray> bytes;
  Fill(floats.Get(), 3, 200000); // more than one thread takes at once
  Fill(doubles.Get(), 1, 1000);
  Fill(ints.Get(), 4, 1000);
  Fill(bytes.Get(), 3, 10);
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(floats), static_cast<vtkDataArray*>(doubles),
         static_cast<vtkDataArray*>(ints), static_cast<vtkDataArray*>(bytes) })
  {
    CheckRanges(array);
  }

  // Vectors are taken four at a time; what is left over counts as well.
  for (vtkIdType tuples = 1; tuples < 10; ++tuples)
  {
    vtkNew<vtkFloatArray> few;
    Fill(few.Get(), 3, tuples);
    CheckRanges(few);
    for (vtkIdType value = 0; value < 3 * tuples; ++value)
    {
      for (const float bad : { std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity() })
      {
        vtkNew<vtkFloatArray> spoilt;
        spoilt->DeepCopy(few);
        spoilt->SetValue(value, bad);
        spoilt->Modified();
        littoral::KeepRanges(spoilt);
        Check(!spoilt->GetInformation()->Has(vtkDataArray::PER_COMPONENT()), "vectors that are not finite are VTK's");
      }
    }
  }

  doubles->SetValue(7, 1e6);
  doubles->Modified();
  Check(doubles->GetRange()[1] == 1e6, "a changed array is looked at anew");

  doubles->SetValue(8, std::numeric_limits<double>::quiet_NaN());
  doubles->Modified();
  littoral::KeepRanges(doubles);
  Check(!doubles->GetInformation()->Has(vtkDataArray::PER_COMPONENT()), "values that are not finite are VTK's concern");

  CheckBounds();

  vtkNew<vtkFloatArray> empty;
  littoral::KeepRanges(empty);
  Check(!empty->HasInformation(), "an empty array has no range");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
