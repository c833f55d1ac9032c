// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredPoints.h"

#include "Data/Arrays.h"
#include "Numerics/InvalidInput.h"
#include "Pipeline/Memory.h"
#include "PlainData.h"

#include "vtkAppendPolyData.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace littoral
{

namespace
{

constexpr int PointsTag = 78150;
constexpr double Copies = 3.0; ///< of points on their way: as they are, as a message, and as it is read or joined

}

vtkSmartPointer<vtkPolyData> GatherPoints(const WriterRanks& ranks, vtkPolyData* own)
{
  vtkMultiProcessController* controller = ranks.GetController();
  const bool hasPoints = own && own->GetNumberOfPoints() > 0;
  const double bytes = hasPoints ? 1024.0 * static_cast<double>(own->GetActualMemorySize()) : 0.0;
  std::vector<double> all(ranks.GetNumberOfRanks());
  controller->AllGather(&bytes, all.data(), 1);
  const double needed = Copies * (ranks.IsFirst() ? std::accumulate(all.begin(), all.end(), 0.0) : bytes);
  ranks.Agree(WhyRefused([&] { RequireMemory(needed, "the points of all ranks", "take fewer"); }));
  if (!ranks.IsFirst())
  {
    if (hasPoints)
    {
      controller->Send(PlainData(own), 0, PointsTag);
    }
    return nullptr;
  }
  vtkNew<vtkAppendPolyData> joined;
  vtkSmartPointer<vtkPolyData> first = hasPoints ? own : nullptr;
  int filled = hasPoints ? 1 : 0;
  if (hasPoints)
  {
    joined->AddInputData(own);
  }
  for (int rank = 1; rank < ranks.GetNumberOfRanks(); ++rank)
  {
    if (all[rank] > 0.0)
    {
      const auto part = vtkSmartPointer<vtkPolyData>::New();
      controller->Receive(part, rank, PointsTag);
      joined->AddInputData(part);
      first = first ? first : part;
      ++filled;
    }
  }
  if (filled < 2)
  {
    return first;
  }
  joined->Update();
  joined->GetOutput()->SetFieldData(first->GetFieldData());
  return joined->GetOutput();
}

vtkSmartPointer<vtkPolyData> InOrder(vtkPolyData* points, const char* name)
{
  vtkDataArray* numbers = points->GetPointData()->GetArray(name);
  if (!numbers)
  {
    return points;
  }
  std::vector<vtkIdType> order;
  SetSize(order, points->GetNumberOfPoints());
  std::iota(order.begin(), order.end(), 0);
  const auto isBefore = [&](vtkIdType a, vtkIdType b) {
    return numbers->GetComponent(a, 0) < numbers->GetComponent(b, 0);
  };
  if (std::is_sorted(order.begin(), order.end(), isBefore))
  {
    return points;
  }
  std::stable_sort(order.begin(), order.end(), isBefore);
  const auto sorted = [&](vtkDataArray* array) {
    auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    copy->SetName(array->GetName());
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    SetTuples(copy, array->GetNumberOfTuples());
    for (std::size_t place = 0; place < order.size(); ++place)
    {
      copy->SetTuple(static_cast<vtkIdType>(place), order[place], array);
    }
    return copy;
  };
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->CopyStructure(points);
  result->SetFieldData(points->GetFieldData());
  vtkNew<vtkPoints> places;
  places->SetData(sorted(points->GetPoints()->GetData()));
  result->SetPoints(places);
  for (int index = 0; index < points->GetPointData()->GetNumberOfArrays(); ++index)
  {
    if (vtkDataArray* array = points->GetPointData()->GetArray(index))
    {
      result->GetPointData()->AddArray(sorted(array));
    }
  }
  return result;
}

}
