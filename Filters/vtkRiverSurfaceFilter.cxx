// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRiverSurfaceFilter.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Cells.h"
#include "Data/Inputs.h"
#include "Data/Tables.h"
#include "Data/TerrainGrid.h"
#include "Drainage/RiverSurface.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Exceptions.h"
#include "Pipeline/Pipeline.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <map>
#include <vector>

vtkStandardNewMacro(vtkRiverSurfaceFilter);

namespace
{

constexpr double BytesOfSection = 200.0;
constexpr unsigned char WaterColor[3] = { 118, 141, 156 };

/// Nodes of the lines of rivers, of which those of one place are one.
littoral::RiverNetwork NetworkOf(vtkPolyData* lines)
{
  littoral::RiverNetwork network;
  if (lines->GetNumberOfPoints() == 0)
  {
    return network;
  }
  littoral::Require(lines->GetNumberOfLines() > 0 ? "" : "the input has no lines; rivers are those of Drainage.");
  littoral::RequireCells(lines, "the input");
  vtkDataArray* areas = littoral::ArrayReader::OfPoints(lines, "The input").Need("DrainageArea", 1);
  std::map<std::array<double, 3>, std::size_t> known;
  const auto nodeOf = [&](vtkIdType point) {
    std::array<double, 3> at;
    lines->GetPoint(point, at.data());
    const double area = areas->GetComponent(point, 0);
    const littoral::Vector3 place(at[0], at[1], at[2]);
    littoral::Require(littoral::IsSensible(place) && littoral::IsSensible(area) && area > 0.0
        ? ""
        : "a point of a river has no place, or no DrainageArea above 0.");
    const auto [found, isNew] = known.emplace(at, network.Places.size());
    if (isNew)
    {
      network.Places.push_back(place);
      network.Areas.push_back(area);
    }
    return found->second;
  };
  vtkCellArray* cells = lines->GetLines();
  for (vtkIdType line = 0; line < cells->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(line, size, points);
    std::vector<std::size_t> course;
    for (vtkIdType k = 0; k < size; ++k)
    {
      const std::size_t node = nodeOf(points[k]);
      if (course.empty() || course.back() != node)
      {
        course.push_back(node);
      }
    }
    if (course.size() > 1)
    {
      network.Courses.push_back(std::move(course));
    }
  }
  return network;
}

/// Puts nodes on the ground below them, where it is.
void PutOnGround(littoral::RiverNetwork& network, vtkImageData* terrain)
{
  const littoral::HeightGrid grid = littoral::MakeGrid(terrain);
  for (littoral::Vector3& place : network.Places)
  {
    const littoral::GroundPoint ground = grid.At(place.x, place.y);
    place.z = ground.IsCovered && littoral::IsSensible(ground.Height) ? ground.Height : place.z;
  }
}

void WriteBands(const std::vector<std::vector<littoral::RiverSection>>& rivers, vtkIdType sections, double lift,
  const littoral::Poll& poll, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  littoral::SetTuples(points->GetData(), 2 * sections);
  const auto widths = littoral::NewArray<vtkDoubleArray>("ChannelWidth", 1, 2 * sections);
  const auto areas = littoral::NewArray<vtkDoubleArray>("DrainageArea", 1, 2 * sections);
  const auto banks = littoral::NewArray<vtkFloatArray>("Bank", 1, 2 * sections);
  const auto normals = littoral::NewArray<vtkFloatArray>("Normals", 3, 2 * sections);
  const auto colors = littoral::NewArray<vtkUnsignedCharArray>("RGB", 3, 2 * sections);
  vtkNew<vtkCellArray> triangles;
  vtkIdType next = 0;
  for (const std::vector<littoral::RiverSection>& river : rivers)
  {
    poll();
    for (std::size_t k = 0; k < river.size(); ++k)
    {
      const littoral::RiverSection& section = river[k];
      for (const littoral::Vector3& bank : section.Banks)
      {
        points->SetPoint(next, bank.x, bank.y, bank.z + lift);
        widths->SetValue(next, section.Width);
        areas->SetValue(next, section.Area);
        banks->SetValue(next, next % 2 == 0 ? 1.0F : -1.0F);
        normals->SetTuple3(next, section.Normal.x, section.Normal.y, section.Normal.z);
        colors->SetTypedTuple(next++, WaterColor);
      }
      if (k > 0)
      {
        // Left and right bank above, left and right bank here
        const vtkIdType quad[4] = { next - 4, next - 3, next - 2, next - 1 };
        triangles->InsertNextCell({ quad[0], quad[1], quad[3] });
        triangles->InsertNextCell({ quad[0], quad[3], quad[2] });
      }
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->AddArray(widths);
  output->GetPointData()->AddArray(areas);
  output->GetPointData()->AddArray(banks);
  output->GetPointData()->AddArray(colors);
  output->GetPointData()->SetNormals(normals);
}

}

//----------------------------------------------------------------------------
vtkRiverSurfaceFilter::vtkRiverSurfaceFilter()
  : WidthOfUnitArea(littoral::RiverShape().WidthOfUnitArea)
  , WidthExponent(littoral::RiverShape().WidthExponent)
  , Smoothing(littoral::RiverShape().Smoothing)
  , Subdivision(littoral::RiverShape().Subdivision)
  , Lift(0.1)
{
  this->SetNumberOfInputPorts(2);
}

//----------------------------------------------------------------------------
vtkRiverSurfaceFilter::~vtkRiverSurfaceFilter() = default;

//----------------------------------------------------------------------------
int vtkRiverSurfaceFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkRiverSurfaceFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    if (inputVector[port]->GetNumberOfInformationObjects() > 0)
    {
      littoral::RequestAll(inputVector[port]->GetInformationObject(0));
    }
  }
  return 1;
}

//----------------------------------------------------------------------------
int vtkRiverSurfaceFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (littoral::AsksForLaterPiece(request, outputVector))
  {
    return 1;
  }
  littoral::RiverShape shape;
  shape.WidthOfUnitArea = this->WidthOfUnitArea;
  shape.WidthExponent = this->WidthExponent;
  shape.Smoothing = this->Smoothing;
  shape.Subdivision = this->Subdivision;
  littoral::Require(littoral::WhyInvalid(shape));
  littoral::ParameterCheck check;
  check.Finite("Lift", this->Lift, "m");
  littoral::Require(check.Reason());
  auto* lines = littoral::InputOf<vtkPolyData>(inputVector[0], "Input");
  auto* terrain = littoral::OptionalInputOf<vtkImageData>(inputVector[1], "Terrain");
  littoral::RequireMemory(BytesOfSection * shape.Subdivision * static_cast<double>(lines->GetNumberOfPoints()),
    "the surface of the rivers", "lower Subdivision.");
  littoral::RiverNetwork network = NetworkOf(lines);
  littoral::SmoothCourses(network, shape.Smoothing);
  const littoral::Poll poll = littoral::PollOf(this);
  this->UpdateProgress(0.3);
  poll();
  if (terrain)
  {
    PutOnGround(network, terrain);
  }
  littoral::LetFlow(network);
  const auto rivers = littoral::RiverSections(network, shape);
  this->UpdateProgress(0.6);
  poll();
  vtkIdType sections = 0;
  for (const auto& river : rivers)
  {
    sections += static_cast<vtkIdType>(river.size());
  }
  WriteBands(rivers, sections, this->Lift, poll, vtkPolyData::GetData(outputVector));
  return 1;
}

//----------------------------------------------------------------------------
int vtkRiverSurfaceFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot make the surface of rivers: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkRiverSurfaceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WidthOfUnitArea: " << this->WidthOfUnitArea << "\n";
  os << indent << "WidthExponent: " << this->WidthExponent << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "Subdivision: " << this->Subdivision << "\n";
  os << indent << "Lift: " << this->Lift << "\n";
}
