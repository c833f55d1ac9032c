// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOceanCurrentReader.h"

#include "Data/Arrays.h"
#include "Data/Georeference.h"
#include "Data/Tables.h"
#include "NetcdfKind.h"
#include "Numerics/ParameterCheck.h"
#include "OceanGrid.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"

#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkOceanCurrentReader);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr int ColumnsAtOnce = 200000; ///< before the user is heard again
constexpr double BytesOfPoint = 3.0 * sizeof(double) + 4.0 * sizeof(float);
constexpr double BytesOfCell = 8.0 * sizeof(vtkIdType);
constexpr double BytesOfColumn = 12.0 * sizeof(double); ///< while layers are read

/// Runs a task, whose refusals get the name of the file in front.
template <typename Task>
auto OfFile(const char* path, const Task& task)
{
  try
  {
    return task();
  }
  catch (const littoral::InvalidInput& refusal)
  {
    throw littoral::InvalidInput(littoral::FileMessage("read", path ? path : "", "currents", refusal.what()));
  }
}

/// The number of the time that is nearest to another one.
int NearestTo(double time, const std::vector<double>& times)
{
  if (times.empty() || !std::isfinite(time))
  {
    return 0;
  }
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  const auto next = after == times.end() ? after - 1 : after;
  const bool isBefore = next != times.begin() && time - *(next - 1) <= *next - time;
  return static_cast<int>(next - times.begin()) - (isBefore ? 1 : 0);
}

/// Arrays of points that are filled layer by layer.
struct PointArrays
{
  bool ArePlacesKnown;
  vtkSmartPointer<vtkDoubleArray> Places;
  vtkSmartPointer<vtkFloatArray> Velocity;
  vtkSmartPointer<vtkFloatArray> Depth; ///< null for none

  /// Arrays with places that are known, or null for those that are still to be set.
  PointArrays(vtkIdType points, bool hasDepth, vtkDoubleArray* known)
    : ArePlacesKnown(known != nullptr)
    , Places(known ? known : littoral::NewArray<vtkDoubleArray>("Points", 3, points).Get())
    , Velocity(littoral::NewArray<vtkFloatArray>("Velocity", 3, points))
  {
    this->Velocity->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "m/s");
    if (hasDepth)
    {
      this->Depth = littoral::NewArray<vtkFloatArray>("Depth", 1, points);
      this->Depth->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "m");
    }
  }

  void Set(vtkIdType point, const std::array<double, 2>& place, double height) const
  {
    if (this->ArePlacesKnown)
    {
      return;
    }
    double* to = this->Places->GetPointer(3 * point);
    to[0] = place[0];
    to[1] = place[1];
    to[2] = height;
  }

  void AddTo(vtkPointSet* output) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetData(this->Places);
    output->SetPoints(points);
    output->GetPointData()->SetVectors(this->Velocity);
    if (this->Depth)
    {
      output->GetPointData()->AddArray(this->Depth);
    }
  }
};

void AddFields(const littoral::OceanGrid& grid, int layers, vtkDataObject* output)
{
  littoral::AddField(output, "Layers", { static_cast<double>(layers) });
  if (!grid.FirstDate.empty())
  {
    littoral::AddText(output, "FirstDate", grid.FirstDate);
  }
  if (!grid.System.empty())
  {
    littoral::AddGeoreference(output, { grid.System, 1.0, { 0.0, 0.0 } });
  }
}

}

class vtkOceanCurrentReader::vtkInternals
{
public:
  std::optional<littoral::OceanGrid> Grid; ///< of the file and the properties that are
  littoral::FileStamp Stamp;
  vtkMTimeType Made = 0;
  std::array<int, 3> Announced{ 0, 0, 0 };
  std::size_t AnnouncedTimes = 0;

  /// Places of the points of an extent, which all times share where the surface is level.
  vtkSmartPointer<vtkDoubleArray> Places;
  std::array<long long, 6> PlacesOf{};
};

//----------------------------------------------------------------------------
vtkOceanCurrentReader::vtkOceanCurrentReader()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(1);
}

//----------------------------------------------------------------------------
vtkOceanCurrentReader::~vtkOceanCurrentReader()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------
littoral::OceanChoices vtkOceanCurrentReader::Choices() const
{
  littoral::ParameterCheck check;
  check.Choice("VectorDirections", this->VectorDirections, GridAxes + 1);
  littoral::Require(check.Reason());
  return { { this->UVariable, this->VVariable, this->WVariable },
    static_cast<littoral::OceanDirections>(this->VectorDirections) };
}

//----------------------------------------------------------------------------
littoral::OceanPlacing vtkOceanCurrentReader::Placing() const
{
  littoral::ParameterCheck check;
  littoral::OceanPlacing placing;
  placing.StartDate = this->StartDate;
  if (this->GivenOrigin)
  {
    check.Range("Origin[0]", this->Origin[0], -360.0, 540.0, "degrees");
    check.Range("Origin[1]", this->Origin[1], -90.0, 90.0, "degrees");
    placing.Origin = littoral::EarthPlace{ this->Origin[0], this->Origin[1] };
  }
  if (this->GivenRegion)
  {
    check.Range("Region[0]", this->Region[0], -360.0, 540.0, "degrees");
    check.Range("Region[1]", this->Region[1], this->Region[0], this->Region[0] + 360.0, "degrees");
    check.Range("Region[2]", this->Region[2], -90.0, 90.0, "degrees");
    check.Range("Region[3]", this->Region[3], this->Region[2], 90.0, "degrees");
    placing.Region = std::array<double, 4>{ this->Region[0], this->Region[1], this->Region[2], this->Region[3] };
  }
  littoral::Require(check.Reason());
  return placing;
}

//----------------------------------------------------------------------------
const littoral::OceanGrid& vtkOceanCurrentReader::Grid()
{
  vtkInternals& own = *this->Internals;
  const std::string path = this->FileName ? this->FileName : "";
  const littoral::OceanChoices choices = this->Choices();
  const littoral::OceanPlacing placing = this->Placing();
  const littoral::FileStamp stamp = littoral::StampOf(path);
  if (!own.Grid || !(own.Stamp == stamp) || own.Made != this->GetMTime())
  {
    own.Grid.reset();
    own.Places = nullptr;
    const littoral::NetcdfFile file(path);
    own.Grid = littoral::MakeOceanGrid(file, littoral::FindOceanRoles(file, choices), placing);
    own.Stamp = stamp;
    own.Made = this->GetMTime();
  }
  return *own.Grid;
}

//----------------------------------------------------------------------------
int vtkOceanCurrentReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPointSet");
  return 1;
}

//----------------------------------------------------------------------------
int vtkOceanCurrentReader::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  // A file that cannot be read is refused by the next request.
  bool isMesh = false;
  littoral::WhyRefused([&] { isMesh = this->Grid().IsMesh; });
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  const char* type = isMesh ? "vtkUnstructuredGrid" : "vtkStructuredGrid";
  if (!output || !output->IsA(type))
  {
    vtkSmartPointer<vtkDataObject> made;
    if (isMesh)
    {
      made = vtkSmartPointer<vtkUnstructuredGrid>::New();
    }
    else
    {
      made = vtkSmartPointer<vtkStructuredGrid>::New();
    }
    info->Set(vtkDataObject::DATA_OBJECT(), made);
    this->GetOutputPortInformation(0)->Set(vtkDataObject::DATA_EXTENT_TYPE(), made->GetExtentType());
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkOceanCurrentReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  OfFile(this->FileName, [&] {
    const littoral::OceanGrid& grid = this->Grid();
    this->Internals->Announced = grid.Count;
    this->Internals->AnnouncedTimes = grid.Times.size();
    vtkInformation* info = outputVector->GetInformationObject(0);
    if (grid.IsMesh)
    {
      info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    }
    else
    {
      const int whole[6] = { 0, grid.Count[0] - 1, 0, grid.Count[1] - 1, 0, grid.Count[2] - 1 };
      info->Set(Pipeline::WHOLE_EXTENT(), whole, 6);
      info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    }
    if (grid.Times.empty())
    {
      info->Remove(Pipeline::TIME_STEPS());
      info->Remove(Pipeline::TIME_RANGE());
      return;
    }
    const double range[2] = { grid.Times.front(), grid.Times.back() };
    info->Set(Pipeline::TIME_STEPS(), grid.Times.data(), static_cast<int>(grid.Times.size()));
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  });
  return 1;
}

//----------------------------------------------------------------------------
bool vtkOceanCurrentReader::Read(vtkInformation* info, vtkStructuredGrid* output)
{
  const littoral::OceanGrid& grid = this->Grid();
  const std::array<int, 6> extent = littoral::RequestedExtent(info);
  output->SetExtent(const_cast<int*>(extent.data()));
  if (extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4])
  {
    return true; // a rank with nothing to do
  }
  const vtkIdType width = extent[1] - extent[0] + 1;
  const vtkIdType height = extent[3] - extent[2] + 1;
  const int layers = extent[5] - extent[4] + 1;
  littoral::RequireMemory(BytesOfPoint * static_cast<double>(width * height) * layers + BytesOfColumn * ColumnsAtOnce,
    "one time of its currents", "give a smaller Region");
  const littoral::NetcdfFile file(this->FileName ? this->FileName : "");
  const littoral::OceanRoles roles = littoral::FindOceanRoles(file, this->Choices());
  const littoral::OceanLayers reader(file, roles, grid);
  const int time = NearestTo(littoral::RequestedTime(info), grid.Times);
  const std::array<long long, 6> part{ extent[0], extent[1], extent[2], extent[3], extent[4], extent[5] };
  const bool isLevel = !roles.Surface;
  vtkInternals& own = *this->Internals;
  const bool areKnown = isLevel && own.Places && own.PlacesOf == part;
  const PointArrays arrays(width * height * layers, !grid.Depth.empty(), areKnown ? own.Places.Get() : nullptr);
  const int rowsAtOnce = static_cast<int>(std::clamp<vtkIdType>(ColumnsAtOnce / width, 1, height));
  std::vector<double> heights;
  for (int row = extent[2]; row <= extent[3]; row += rowsAtOnce)
  {
    const littoral::OceanWindow window{ extent[0], extent[1], row, std::min(row + rowsAtOnce - 1, extent[3]) };
    const std::vector<double> surface = reader.Surface(time, window);
    heights.resize(surface.size());
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      const vtkIdType first = (static_cast<vtkIdType>(k - extent[4]) * height + (row - extent[2])) * width;
      reader.Velocities(time, k, window, arrays.Velocity->GetPointer(3 * first));
      reader.Heights(k, window, surface, heights.data());
      for (std::size_t n = 0; n < heights.size(); ++n)
      {
        const std::size_t column = (window[2] + n / width) * grid.Count[0] + extent[0] + n % width;
        const auto point = first + static_cast<vtkIdType>(n);
        arrays.Set(point, grid.Places[column], heights[n]);
        if (arrays.Depth)
        {
          arrays.Depth->SetValue(point, static_cast<float>(grid.Depth[column]));
        }
      }
      this->UpdateProgress(
        (row - extent[2] + static_cast<double>(k - extent[4]) / layers) / static_cast<double>(height));
      if (littoral::IsAborted(this))
      {
        return false;
      }
    }
  }
  file.RequireUnchanged();
  own.Places = isLevel ? arrays.Places : nullptr;
  own.PlacesOf = part;
  arrays.AddTo(output);
  AddFields(grid, layers, output);
  return true;
}

//----------------------------------------------------------------------------
bool vtkOceanCurrentReader::Read(vtkInformation* info, vtkUnstructuredGrid* output)
{
  const littoral::OceanGrid& grid = this->Grid();
  const littoral::PieceRange part = littoral::RequestedPart(info, static_cast<long long>(grid.Faces.size()));
  const int layers = grid.Count[2];
  const auto nodes = static_cast<vtkIdType>(grid.Columns());
  littoral::RequireMemory((BytesOfPoint * layers + BytesOfColumn) * static_cast<double>(nodes) +
      BytesOfCell * static_cast<double>(grid.Faces.size()) * layers,
    "one time of its currents", "take a smaller file");
  // nodes of the faces of this piece, in their order
  std::vector<vtkIdType> numberOf(grid.Columns(), -1);
  for (long long f = part.Begin; f < part.End; ++f)
  {
    for (const int node : grid.Faces[static_cast<std::size_t>(f)])
    {
      if (node >= 0)
      {
        numberOf[static_cast<std::size_t>(node)] = 0;
      }
    }
  }
  vtkIdType used = 0;
  for (vtkIdType& number : numberOf)
  {
    number = number < 0 ? -1 : used++;
  }
  if (used == 0)
  {
    return true;
  }
  const littoral::NetcdfFile file(this->FileName ? this->FileName : "");
  const littoral::OceanRoles roles = littoral::FindOceanRoles(file, this->Choices());
  const littoral::OceanLayers reader(file, roles, grid);
  const int time = NearestTo(littoral::RequestedTime(info), grid.Times);
  const PointArrays arrays(used * layers, !grid.Depth.empty(), nullptr);
  const littoral::OceanWindow window{ 0, static_cast<int>(nodes) - 1, 0, 0 };
  const std::vector<double> surface = reader.Surface(time, window);
  std::vector<double> heights(surface.size());
  std::vector<float> velocities(3 * surface.size());
  for (int k = 0; k < layers; ++k)
  {
    reader.Velocities(time, k, window, velocities.data());
    reader.Heights(k, window, surface, heights.data());
    for (std::size_t column = 0; column < grid.Columns(); ++column)
    {
      if (numberOf[column] < 0)
      {
        continue;
      }
      const vtkIdType point = k * used + numberOf[column];
      arrays.Set(point, grid.Places[column], heights[column]);
      std::copy_n(&velocities[3 * column], 3, arrays.Velocity->GetPointer(3 * point));
      if (arrays.Depth)
      {
        arrays.Depth->SetValue(point, static_cast<float>(grid.Depth[column]));
      }
    }
    this->UpdateProgress((k + 1.0) / layers);
    if (littoral::IsAborted(this))
    {
      return false;
    }
  }
  file.RequireUnchanged();
  output->Allocate((part.End - part.Begin) * std::max(layers - 1, 1));
  for (int k = 0; k < std::max(layers - 1, 1); ++k)
  {
    for (long long f = part.Begin; f < part.End; ++f)
    {
      const littoral::FaceCorners& face = grid.Faces[static_cast<std::size_t>(f)];
      const int corners = face[3] < 0 ? 3 : 4;
      vtkIdType ids[8];
      for (int c = 0; c < corners; ++c)
      {
        // VTK's wedges have their first triangle clockwise as seen from the second
        const int corner = layers > 1 && corners == 3 ? (3 - c) % 3 : c;
        ids[c] = k * used + numberOf[static_cast<std::size_t>(face[corner])];
        ids[corners + c] = ids[c] + used;
      }
      const int flat = corners == 3 ? VTK_TRIANGLE : VTK_QUAD;
      const int thick = corners == 3 ? VTK_WEDGE : VTK_HEXAHEDRON;
      output->InsertNextCell(layers > 1 ? thick : flat, layers > 1 ? 2 * corners : corners, ids);
    }
  }
  arrays.AddTo(output);
  AddFields(grid, layers, output);
  return true;
}

//----------------------------------------------------------------------------
int vtkOceanCurrentReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  littoral::ForgetExtent(info);
  output->Initialize();
  if (littoral::IsAnnouncedEmpty(info))
  {
    return littoral::FailedRequest(this);
  }
  this->SetProgressText("Reading currents");
  OfFile(this->FileName, [&] {
    const littoral::OceanGrid& grid = this->Grid();
    const bool isSame = grid.Count == this->Internals->Announced &&
      grid.Times.size() == this->Internals->AnnouncedTimes &&
      grid.IsMesh == (vtkUnstructuredGrid::SafeDownCast(output) != nullptr);
    littoral::Require(isSame ? "" : "it has changed since it was opened; open it again");
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(output);
    const bool isWhole = mesh ? this->Read(info, mesh) : this->Read(info, vtkStructuredGrid::SafeDownCast(output));
    if (!isWhole)
    {
      output->Initialize();
    }
    else if (!grid.Times.empty())
    {
      const int time = NearestTo(littoral::RequestedTime(info), grid.Times);
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), grid.Times[static_cast<std::size_t>(time)]);
    }
  });
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkOceanCurrentReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs, [&] {
    if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
    {
      return this->RequestDataObject(request, inputs, outputs);
    }
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  });
}

//----------------------------------------------------------------------------
int vtkOceanCurrentReader::CanReadFile(const char* name)
{
  return name && littoral::KindOfNetcdf(name) == littoral::NetcdfKind::Sea ? 1 : 0;
}

//----------------------------------------------------------------------------
void vtkOceanCurrentReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "UVariable: " << this->UVariable << "\n";
  os << indent << "VVariable: " << this->VVariable << "\n";
  os << indent << "WVariable: " << this->WVariable << "\n";
  os << indent << "VectorDirections: " << this->VectorDirections << "\n";
  os << indent << "GivenOrigin: " << this->GivenOrigin << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << "\n";
  os << indent << "GivenRegion: " << this->GivenRegion << "\n";
  os << indent << "Region: " << this->Region[0] << " " << this->Region[1] << " " << this->Region[2] << " "
     << this->Region[3] << "\n";
  os << indent << "StartDate: " << this->StartDate << "\n";
}
