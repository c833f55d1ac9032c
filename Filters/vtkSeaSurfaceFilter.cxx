// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSeaSurfaceFilter.h"

#include "Data/Arrays.h"
#include "Data/Inputs.h"
#include "Data/SeaStateTable.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"
#include "Pipeline/Ranges.h"
#include "Sea/SeaColor.h"
#include "Sea/SeaSurface.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkSeaSurfaceFilter);

namespace
{

/// Points that a thread takes at a time.
constexpr std::size_t RangeLength = 4096;

/// Memory of a point and its triangles [bytes].
constexpr double BytesOfPoint = 110.0;

/// Memory of a point's foam and displacement [bytes].
constexpr double BytesOfFoam = 12.0;

/// Height over the sea of the eye for which the water is colored [m]: that of a ship's bridge.
constexpr double EyeHeight = 9.0;

/// Arrays of the surface's points.
struct Arrays
{
  vtkSmartPointer<vtkDoubleArray> Places;
  vtkSmartPointer<vtkFloatArray> Normals;
  vtkSmartPointer<vtkFloatArray> Jacobians;
  vtkSmartPointer<vtkFloatArray> Foam;
  vtkSmartPointer<vtkFloatArray> Ways;
  vtkSmartPointer<vtkUnsignedCharArray> Colors;

  Arrays(vtkIdType count, bool hasFoam, bool hasColors)
    : Places(littoral::NewArray<vtkDoubleArray>("Points", 3, count))
    , Normals(littoral::NewArray<vtkFloatArray>("Normals", 3, count))
    , Jacobians(littoral::NewArray<vtkFloatArray>("Jacobian", 1, count))
    , Foam(littoral::NewArray<vtkFloatArray>("Foam", 1, hasFoam ? count : 0))
    , Ways(littoral::NewArray<vtkFloatArray>("Displacement", 2, hasFoam ? count : 0))
    , Colors(littoral::NewArray<vtkUnsignedCharArray>("RGB", 3, hasColors ? count : 0))
  {
  }

  /// Takes points from an index on; `center` is the center of the disk at sea level.
  void Take(const littoral::SeaSurfacePoints& points, std::size_t begin, const double center[3])
  {
    std::copy(points.Normals.begin(), points.Normals.end(), this->Normals->GetPointer(3 * begin));
    std::copy(points.Jacobians.begin(), points.Jacobians.end(), this->Jacobians->GetPointer(begin));
    std::copy(points.Foam.begin(), points.Foam.end(), this->Foam->GetPointer(begin));
    std::copy(points.Ways.begin(), points.Ways.end(), this->Ways->GetPointer(2 * begin));
    double* place = this->Places->GetPointer(3 * begin);
    for (std::size_t k = 0; k < points.Places.size(); ++k)
    {
      place[k] = center[k % 3] + points.Places[k];
    }
  }

  /// Colors points from an index on, in waves of a significant height [m] with a threshold of foam, for an eye over the
  /// center.
  void Paint(const littoral::SeaSurfacePoints& points, std::size_t begin, double waveHeight, double foam)
  {
    for (std::size_t i = 0; i < points.Jacobians.size(); ++i)
    {
      const float* place = points.Places.data() + 3 * i;
      const float* normal = points.Normals.data() + 3 * i;
      const littoral::Vector3 toEye(-place[0], -place[1], EyeHeight - place[2]);
      littoral::SeaPlace where;
      where.Normal = { normal[0], normal[1], normal[2] };
      where.Distance = glm::length(toEye);
      where.ToEye = toEye / where.Distance;
      const float stretch = points.Foam.empty() ? points.Jacobians[i] : 1.0F - points.Foam[i];
      where.Jacobian = stretch + (littoral::FoamBegins - foam);
      where.Height = place[2] / waveHeight;
      const littoral::Color color = littoral::SeaColor(where);
      std::copy(color.begin(), color.end(), this->Colors->GetPointer(3 * (begin + i)));
    }
  }
};

vtkSmartPointer<vtkCellArray> TrianglesOf(const littoral::SeaSurfaceGrid& grid, const littoral::Poll& poll)
{
  const std::vector<int> corners = grid.MakeTriangles(poll);
  const vtkIdType count = static_cast<vtkIdType>(corners.size() / 3);
  auto offsets = littoral::NewArray<vtkIdTypeArray>("Offsets", 1, count + 1);
  auto connectivity = littoral::NewArray<vtkIdTypeArray>("Connectivity", 1, 3 * count);
  littoral::SteppedPoll steps(poll);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    steps.Step();
    offsets->SetValue(i, 3 * i);
  }
  std::copy(corners.begin(), corners.end(), connectivity->GetPointer(0));
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->SetData(offsets, connectivity);
  return triangles;
}

/// The sectors of a piece, and numbers of those of its neighbors before and behind it.
struct Part
{
  int First;
  int Own;
  int Before;
  int Behind;

  int Count() const { return this->Before + this->Own + this->Behind; }
  bool IsGhost(int sector) const { return sector < this->Before || sector >= this->Before + this->Own; }
};

/// A level of ghosts is a sector on each side, as long as there are others.
Part PartOf(vtkInformation* information, int sectors)
{
  const littoral::PieceRange own = littoral::RequestedPart(information, sectors);
  Part part{ static_cast<int>(own.Begin), static_cast<int>(own.End - own.Begin), 0, 0 };
  const int levels = std::max(0, information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()));
  if (part.Own > 0)
  {
    part.Before = std::min(levels, sectors - part.Own);
    part.Behind = std::min(levels, sectors - part.Own - part.Before);
  }
  return part;
}

/// Marks the triangles of neighbors, and the points that the piece behind or the first one has.
void MarkGhosts(const Part& part, bool isClosed, vtkPolyData* surface)
{
  const auto marks = [](vtkIdType count) {
    auto made = littoral::NewArray<vtkUnsignedCharArray>(vtkDataSetAttributes::GhostArrayName(), 1, count);
    made->FillValue(0);
    return made;
  };
  const auto cells = marks(surface->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < cells->GetNumberOfTuples(); ++cell)
  {
    // one triangle a sector at the center, then two on each ring
    const vtkIdType column = cell < part.Count() ? cell : (cell - part.Count()) / 2 % part.Count();
    cells->SetValue(cell, part.IsGhost(static_cast<int>(column)) ? vtkDataSetAttributes::DUPLICATECELL : 0);
  }
  const int columns = part.Count() + (isClosed ? 0 : 1);
  const auto points = marks(surface->GetNumberOfPoints());
  points->SetValue(0, part.First == 0 ? 0 : vtkDataSetAttributes::DUPLICATEPOINT);
  for (vtkIdType point = 1; point < points->GetNumberOfTuples(); ++point)
  {
    const bool isGhost = part.IsGhost(static_cast<int>((point - 1) % columns));
    points->SetValue(point, isGhost ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  }
  surface->GetCellData()->AddArray(cells);
  surface->GetPointData()->AddArray(points);
}

}

//----------------------------------------------------------------------------
vtkSeaSurfaceFilter::vtkSeaSurfaceFilter()
  : Center{ 0.0, 0.0 }
  , Radius(5000.0)
  , Spacing(0.6)
  , Sectors(360)
  , Choppiness(1.0)
  , WaterColors(true)
  , FoamThreshold(littoral::FoamBegins)
  , FoamLifetime(0.0)
  , TimeRange{ 0.0, 60.0 }
{
}

//----------------------------------------------------------------------------
vtkSeaSurfaceFilter::~vtkSeaSurfaceFilter() = default;

//----------------------------------------------------------------------------
int vtkSeaSurfaceFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//----------------------------------------------------------------------------
int vtkSeaSurfaceFilter::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector->GetInformationObject(0);
  littoral::AnnounceTimes(output, this->TimeRange);
  output->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//----------------------------------------------------------------------------
int vtkSeaSurfaceFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
littoral::SeaSurfaceParameters vtkSeaSurfaceFilter::MakeParameters() const
{
  littoral::SeaSurfaceParameters parameters;
  std::copy(this->Center, this->Center + 2, parameters.Center);
  parameters.Radius = this->Radius;
  parameters.Spacing = this->Spacing;
  parameters.Sectors = this->Sectors;
  return parameters;
}

//----------------------------------------------------------------------------
std::string vtkSeaSurfaceFilter::WhyBadProperties(double time) const
{
  littoral::ParameterCheck check;
  check.Require(littoral::WhyInvalid(this->MakeParameters()));
  check.Range("Choppiness", this->Choppiness, 0.0, 1.0);
  check.Range("FoamThreshold", this->FoamThreshold, 0.0, 1.0);
  check.Range("FoamLifetime", this->FoamLifetime, 0.0, 100.0, "s");
  check.Increasing("TimeRange", this->TimeRange, "s");
  check.Finite("the requested time", time, "s");
  return check.Reason();
}

//----------------------------------------------------------------------------
int vtkSeaSurfaceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  const double time = littoral::RequestedTime(information);
  const littoral::SeaState sea = littoral::ReadSeaState(littoral::InputOf<vtkTable>(inputVector[0], "Input"));
  littoral::Require(this->WhyBadProperties(time));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const Part part = PartOf(information, this->Sectors);
  const int first = part.First - part.Before + this->Sectors; // around the disk
  const littoral::SeaSurfaceGrid grid(this->MakeParameters(), first, first + part.Count());
  if (grid.GetNumberOfPoints() > 0)
  {
    this->MakeSurface(sea, grid, time, output);
  }
  if (part.Count() > part.Own)
  {
    MarkGhosts(part, part.Count() == this->Sectors, output);
  }
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  littoral::KeepRanges(output, littoral::PollOf(this));
  return 1;
}

//----------------------------------------------------------------------------
void vtkSeaSurfaceFilter::MakeSurface(
  const littoral::SeaState& sea, const littoral::SeaSurfaceGrid& grid, double time, vtkPolyData* output)
{
  const littoral::SeaSurfaceParameters parameters = this->MakeParameters();
  const bool hasFoam = this->FoamLifetime > 0.0;
  const double bytesOfPoint = BytesOfPoint + (hasFoam ? BytesOfFoam : 0.0);
  littoral::RequireMemory(
    bytesOfPoint * static_cast<double>(grid.GetNumberOfPoints()), "the surface", "take fewer points along its sides");
  const double waveHeight = std::max(1e-9, 4.0 * std::sqrt(littoral::EnergyOf(sea.Trains)));
  const double center[3] = { this->Center[0], this->Center[1], sea.SeaLevel };
  Arrays arrays(static_cast<vtkIdType>(grid.GetNumberOfPoints()), hasFoam, this->WaterColors);
  littoral::ForRanges(
    littoral::AbortableFor(this), grid.GetNumberOfPoints(), RangeLength, [&](std::size_t begin, std::size_t end) {
      const littoral::SeaSurfacePoints points =
        littoral::SurfaceOf(sea, parameters, grid, this->Choppiness, time, begin, end, this->FoamLifetime);
      arrays.Take(points, begin, center);
      if (this->WaterColors)
      {
        arrays.Paint(points, begin, waveHeight, this->FoamThreshold);
      }
    });
  vtkNew<vtkPoints> points;
  points->SetData(arrays.Places);
  output->SetPoints(points);
  output->SetPolys(TrianglesOf(grid, littoral::PollOf(this)));
  output->GetPointData()->SetNormals(arrays.Normals);
  output->GetPointData()->AddArray(arrays.Jacobians);
  if (hasFoam)
  {
    output->GetPointData()->AddArray(arrays.Foam);
    output->GetPointData()->AddArray(arrays.Ways);
  }
  if (this->WaterColors)
  {
    output->GetPointData()->SetScalars(arrays.Colors);
  }
}

//----------------------------------------------------------------------------
int vtkSeaSurfaceFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot make a surface: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkSeaSurfaceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Sectors: " << this->Sectors << "\n";
  os << indent << "Choppiness: " << this->Choppiness << "\n";
  os << indent << "WaterColors: " << (this->WaterColors ? "on" : "off") << "\n";
  os << indent << "FoamThreshold: " << this->FoamThreshold << "\n";
  os << indent << "FoamLifetime: " << this->FoamLifetime << "\n";
  os << indent << "TimeRange: " << this->TimeRange[0] << " " << this->TimeRange[1] << "\n";
}
