// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWindFieldReader.h"

#include "Data/Arrays.h"
#include "Data/Tables.h"
#include "InflowFile.h"
#include "InflowImage.h"
#include "NetcdfKind.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Mistakes.h"
#include "Pipeline/Pipeline.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkWindFieldReader);

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Planes that are read before the user is heard again, at most.
constexpr int TimesAtOnce = 64;

/// Runs a task, whose refusals get the name of the file in front.
template <typename Task>
void OfFile(const char* path, const Task& task)
{
  try
  {
    task();
  }
  catch (const littoral::InvalidInput& refusal)
  {
    throw littoral::InvalidInput(littoral::FileMessage("read", path ? path : "", "a wind", refusal.what()));
  }
}

/// The index of the plane that passes at a time [s].
int PassingAt(double time, const littoral::InflowGrid& grid)
{
  const double times = grid.Count[0];
  const double gone = std::isfinite(time) ? std::fmod(std::round(time / grid.TimeStep), times) : 0.0;
  return static_cast<int>(gone < 0.0 ? gone + times : gone);
}

/// Points of an image that planes are copied to.
struct PlaneWindow
{
  std::array<int, 6> Extent;
  std::size_t PointsOfPlane; ///< in the file
  std::size_t FirstPoint;    ///< of these points in a plane
  int Across;                ///< points across in a plane
  bool IsTower;              ///< whether they lie downwards
  int Layers;
  std::array<float, 2> Turn;

  std::size_t PointOf(int j, int k) const
  {
    const int layer = this->IsTower ? this->Layers - 1 - k : k;
    return this->FirstPoint + static_cast<std::size_t>(layer) * this->Across + j;
  }
};

/// Copies planes to samples i ... i - count + 1 along the wind.
void CopyToImage(const std::vector<float>& planes, int count, int i, const PlaneWindow& window, float* image)
{
  const std::array<int, 6>& extent = window.Extent;
  const std::size_t along = static_cast<std::size_t>(extent[1]) - extent[0] + 1;
  float* line = image;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j, line += 3 * along)
    {
      const float* from = planes.data() + 3 * window.PointOf(j, k);
      for (int n = 0; n < count; ++n, from += 3 * window.PointsOfPlane)
      {
        float* to = line + 3 * static_cast<std::size_t>(i - n - extent[0]);
        to[0] = window.Turn[0] * from[0] - window.Turn[1] * from[1];
        to[1] = window.Turn[1] * from[0] + window.Turn[0] * from[1];
        to[2] = from[2];
      }
    }
  }
}

void AddFields(const littoral::InflowGrid& grid, vtkImageData* output)
{
  littoral::AddField(output, "ConvectionSpeed", { grid.Speed });
  littoral::AddField(output, "HubHeight", { grid.HubHeight });
  littoral::AddText(output, "Description", grid.Description);
  if (grid.IsPeriodic)
  {
    littoral::AddField(output, "Period", { grid.Count[0] * grid.TimeStep });
  }
}

}

//----------------------------------------------------------------------------
vtkWindFieldReader::vtkWindFieldReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//----------------------------------------------------------------------------
vtkWindFieldReader::~vtkWindFieldReader()
{
  this->SetFileName(nullptr);
}

//----------------------------------------------------------------------------
littoral::InflowFile vtkWindFieldReader::Open() const
{
  littoral::ParameterCheck check;
  check.Choice("PlaneOrder", this->PlaneOrder, LatestFirst + 1);
  littoral::Require(check.Reason());
  return { this->FileName ? this->FileName : "", static_cast<littoral::HawcOrder>(this->PlaneOrder) };
}

//----------------------------------------------------------------------------
littoral::InflowPlacing vtkWindFieldReader::Placing() const
{
  littoral::ParameterCheck check;
  check.Finite("Center[0]", this->Center[0], "m");
  check.Finite("Center[1]", this->Center[1], "m");
  check.Finite("WindDirection", this->WindDirection, "degrees");
  littoral::Require(check.Reason());
  const double angle = vtkMath::RadiansFromDegrees(this->WindDirection);
  return { { this->Center[0], this->Center[1] }, { std::cos(angle), std::sin(angle) } };
}

//----------------------------------------------------------------------------
void vtkWindFieldReader::Announce(littoral::InflowFile& file, vtkInformationVector* outputs) const
{
  const littoral::InflowGrid& grid = file.GetGrid();
  const littoral::InflowPlacing placing = this->Placing();
  std::vector<double> times(grid.Count[0]);
  for (int step = 0; step < grid.Count[0]; ++step)
  {
    times[step] = step * grid.TimeStep;
  }
  const double range[2] = { 0.0, grid.IsPeriodic ? grid.Count[0] * grid.TimeStep : times.back() };
  for (int port = 0; port < 2; ++port)
  {
    double origin[3], spacing[3], turn[9];
    placing.Place(grid, port == 1, origin, spacing, turn);
    vtkInformation* info = outputs->GetInformationObject(port);
    info->Set(Pipeline::WHOLE_EXTENT(), littoral::ExtentOf(grid, port == 1).data(), 6);
    info->Set(vtkDataObject::ORIGIN(), origin, 3);
    info->Set(vtkDataObject::SPACING(), spacing, 3);
    info->Set(vtkDataObject::DIRECTION(), turn, 9);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    info->Set(Pipeline::TIME_STEPS(), times.data(), grid.Count[0]);
    info->Set(Pipeline::TIME_RANGE(), range, 2);
    vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 3);
  }
}

//----------------------------------------------------------------------------
int vtkWindFieldReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  OfFile(this->FileName, [&] {
    littoral::InflowFile file = this->Open();
    this->Announce(file, outputVector);
  });
  return 1;
}

//----------------------------------------------------------------------------
bool vtkWindFieldReader::Read(littoral::InflowFile& file, bool isTower, vtkInformation* info, vtkImageData* output)
{
  const littoral::InflowGrid& grid = file.GetGrid();
  const littoral::InflowPlacing placing = this->Placing();
  const bool isAsked = info->Has(Pipeline::UPDATE_EXTENT()) != 0;
  const std::array<int, 6> extent =
    isAsked ? littoral::RequestedExtent(info) : std::array<int, 6>{ 0, -1, 0, -1, 0, -1 };
  const double time = littoral::RequestedTime(info);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  output->SetExtent(const_cast<int*>(extent.data()));
  double origin[3], spacing[3], turn[9];
  placing.Place(grid, isTower, origin, spacing, turn);
  output->SetOrigin(origin);
  output->SetSpacing(spacing);
  output->SetDirectionMatrix(turn);
  if (extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4])
  {
    return true; // a rank with nothing to do, or no tower
  }
  const int whole = grid.Count[0];
  const std::array<int, 6> all = littoral::ExtentOf(grid, isTower);
  const bool isWithin = extent[1] <= all[1] && extent[3] <= all[3] && extent[5] <= all[5];
  littoral::Require(isWithin ? "" : "it has changed since it was opened; open it again");
  const int atOnce = std::min(TimesAtOnce, littoral::TimesAtOnce(grid));
  const double points =
    static_cast<double>(output->GetNumberOfPoints()) + static_cast<double>(grid.PointsOfPlane()) * (atOnce + 1.0);
  littoral::RequireMemory(3.0 * sizeof(float) * points, "a wind of this extent", "take a part of it");
  const auto velocity = littoral::NewArray<vtkFloatArray>("Velocity", 3, output->GetNumberOfPoints());
  velocity->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "m/s");
  const PlaneWindow window{ extent, grid.PointsOfPlane(), isTower ? grid.PointsOfGrid() : 0,
    isTower ? 1 : grid.Count[1], isTower, grid.TowerPoints,
    { static_cast<float>(turn[0]), static_cast<float>(turn[3]) } };
  const int passing = PassingAt(time, grid);
  std::vector<float> planes(3 * grid.PointsOfPlane() * atOnce);
  for (int i = extent[1]; i >= extent[0];)
  {
    this->UpdateProgress((extent[1] - i) / (extent[1] - extent[0] + 1.0));
    if (littoral::IsAborted(this))
    {
      output->Initialize();
      return false;
    }
    // later planes are upwind
    const int first = static_cast<int>((static_cast<long long>(passing) + whole - 1 - i) % whole);
    const int count = std::min({ atOnce, whole - first, i - extent[0] + 1 });
    file.Read(first, count, planes.data());
    CopyToImage(planes, count, i, window, velocity->GetPointer(0));
    i -= count;
  }
  output->GetPointData()->SetVectors(velocity);
  AddFields(grid, output);
  return true;
}

//----------------------------------------------------------------------------
int vtkWindFieldReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  for (int port = 0; port < 2; ++port)
  {
    littoral::ForgetExtent(outputVector->GetInformationObject(port));
    vtkImageData::GetData(outputVector, port)->Initialize();
  }
  if (littoral::IsAnnouncedEmpty(outputVector->GetInformationObject(0)))
  {
    return littoral::FailedRequest(this);
  }
  this->SetProgressText("Reading wind");
  OfFile(this->FileName, [&] {
    littoral::InflowFile file = this->Open();
    bool proceeds = true;
    for (int port = 0; port < 2 && proceeds; ++port)
    {
      proceeds = this->Read(
        file, port == 1, outputVector->GetInformationObject(port), vtkImageData::GetData(outputVector, port));
    }
  });
  this->UpdateProgress(1.0);
  return 1;
}

//----------------------------------------------------------------------------
int vtkWindFieldReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(
    this, request, outputs, [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
int vtkWindFieldReader::CanReadFile(const char* name)
{
  const std::string path = name ? name : "";
  const bool isKnown = littoral::WhyRefused([&] { littoral::FormatOf(path); }).empty();
  const bool isNetcdf = isKnown && littoral::FormatOf(path) == littoral::InflowFormat::Netcdf;
  return isKnown && (!isNetcdf || littoral::KindOfNetcdf(path) == littoral::NetcdfKind::Wind) ? 1 : 0;
}

//----------------------------------------------------------------------------
void vtkWindFieldReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << "\n";
  os << indent << "WindDirection: " << this->WindDirection << "\n";
  os << indent << "PlaneOrder: " << this->PlaneOrder << "\n";
}
