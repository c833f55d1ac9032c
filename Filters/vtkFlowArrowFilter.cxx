// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowArrowFilter.h"

#include "Currents/FlowArrows.h"
#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/CurrentData.h"
#include "Data/FlowPrimitiveData.h"
#include "Data/Inputs.h"
#include "Geometry/TextureImage.h"
#include "Numerics/Constants.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Pipeline.h"

#include "vtkAppendPolyData.h"
#include "vtkArrowSource.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkGlyph3D.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkFlowArrowFilter);

namespace
{

constexpr double LargestDrawing = 1e9; // [m], whose fourth power is a number in single precision
constexpr int MostArrowsAlong = 300;
constexpr int CornersOfRing = 72;
constexpr double RingThickness = 0.008; ///< radius of its tube, of the drawing radius

/// Color of an arrow, from blue at the slowest to amber at the fastest.
littoral::Color ArrowColor(double share)
{
  const littoral::Vector3 slow(88.0, 150.0, 190.0);
  const littoral::Vector3 fast(250.0, 176.0, 64.0);
  const littoral::Vector3 color = glm::mix(slow, fast, share);
  return { static_cast<unsigned char>(color.x), static_cast<unsigned char>(color.y),
    static_cast<unsigned char>(color.z) };
}

/// The array RGB of a drawing: by speed, and one color for rings.
void Paint(vtkPolyData* drawn)
{
  vtkDataArray* speeds = littoral::ArrayReader::OfPoints(drawn, "the drawing").Seek("Speed", 1);
  if (!speeds)
  {
    return; // nothing is drawn
  }
  const double fastest = std::max(1e-300, speeds->GetRange()[1]);
  auto colors = littoral::NewArray<vtkUnsignedCharArray>("RGB", 3, drawn->GetNumberOfPoints());
  for (vtkIdType i = 0; i < drawn->GetNumberOfPoints(); ++i)
  {
    const double speed = speeds->GetComponent(i, 0);
    const littoral::Color color = speed > 0.0 ? ArrowColor(speed / fastest) : littoral::Color{ 226, 236, 238 };
    std::copy(color.begin(), color.end(), colors->GetPointer(3 * i));
  }
  drawn->GetPointData()->AddArray(colors);
  drawn->GetPointData()->SetActiveScalars("RGB");
}

/// Solid arrows along arms, with their speeds.
vtkSmartPointer<vtkPolyData> DrawArrows(const std::vector<littoral::FlowArrow>& arrows)
{
  vtkNew<vtkPoints> tails;
  tails->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> arms;
  arms->SetName("Arm");
  arms->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> speeds;
  speeds->SetName("Speed");
  for (const littoral::FlowArrow& arrow : arrows)
  {
    tails->InsertNextPoint(&arrow.Tail.x);
    arms->InsertNextTuple(&arrow.Arm.x);
    speeds->InsertNextValue(arrow.Speed);
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(tails);
  places->GetPointData()->SetVectors(arms);
  places->GetPointData()->SetScalars(speeds);
  vtkNew<vtkArrowSource> shape;
  shape->SetTipResolution(16);
  shape->SetShaftResolution(12);
  shape->SetShaftRadius(0.04);
  shape->SetTipRadius(0.12);
  vtkNew<vtkGlyph3D> glyphs;
  glyphs->SetInputData(places);
  glyphs->SetSourceConnection(shape->GetOutputPort());
  glyphs->SetScaleModeToScaleByVector();
  glyphs->SetColorModeToColorByScalar();
  glyphs->Update();
  vtkSmartPointer<vtkPolyData> solid = glyphs->GetOutput();
  vtkNew<vtkPolyData> drawn;
  drawn->CopyStructure(solid);
  drawn->GetPointData()->SetNormals(solid->GetPointData()->GetNormals());
  if (vtkDataArray* colors = littoral::ArrayReader::OfPoints(solid, "the arrows").Seek("Speed", 1))
  {
    drawn->GetPointData()->SetScalars(colors);
  }
  return drawn.Get();
}

/// A tube along a circle.
vtkSmartPointer<vtkPolyData> DrawRing(const littoral::FlowRing& ring, double thickness)
{
  const littoral::Vector3 other =
    std::abs(ring.Normal.z) < 0.9 ? littoral::Vector3(0, 0, 1) : littoral::Vector3(1, 0, 0);
  const littoral::Vector3 u = littoral::Normalised(glm::cross(other, ring.Normal));
  const littoral::Vector3 v = glm::cross(ring.Normal, u);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(CornersOfRing + 1);
  for (int i = 0; i <= CornersOfRing; ++i)
  {
    const double angle = littoral::TwoPi * i / CornersOfRing;
    const littoral::Vector3 place = ring.Center + ring.Radius * (std::cos(angle) * u + std::sin(angle) * v);
    lines->InsertCellPoint(points->InsertNextPoint(&place.x));
  }
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  line->SetLines(lines);
  auto speeds = littoral::NewArray<vtkDoubleArray>("Speed", 1, points->GetNumberOfPoints());
  speeds->Fill(0.0);
  line->GetPointData()->SetScalars(speeds);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line);
  tube->SetRadius(thickness);
  tube->SetNumberOfSides(8);
  tube->Update();
  return tube->GetOutput();
}

}

//----------------------------------------------------------------------------
vtkFlowArrowFilter::vtkFlowArrowFilter() = default;

//----------------------------------------------------------------------------
vtkFlowArrowFilter::~vtkFlowArrowFilter() = default;

//----------------------------------------------------------------------------
int vtkFlowArrowFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  littoral::RequestAll(inputVector[0]->GetInformationObject(0));
  return 1;
}

//----------------------------------------------------------------------------
int vtkFlowArrowFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* data = littoral::InputOf<vtkPointSet>(inputVector[0], "Input");
  littoral::ParameterCheck check;
  check.Count("ArrowsAlong", this->ArrowsAlong, 1, MostArrowsAlong);
  littoral::Require(check.Reason());
  if (data->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  auto* input = vtkPolyData::SafeDownCast(data);
  if (!littoral::HoldsFlowPrimitives(data) && littoral::ArrayReader::OfPoints(data, "the input").Find("Velocity", 3))
  {
    return this->DrawSamples(data, outputVector);
  }
  littoral::Require(
    input ? "" : "the input has no point array Velocity of three components, and holds no flow primitives.");
  std::vector<littoral::FlowPrimitive> primitives;
  littoral::Require(littoral::HoldsFlowPrimitives(input)
      ? ""
      : "the input holds no flow primitives; it needs the point array FlowType.");
  littoral::ReadFlowPrimitives(input, primitives);
  for (const littoral::FlowPrimitive& primitive : primitives)
  {
    const double size = littoral::DrawingRadius(primitive);
    if (size > LargestDrawing)
    {
      littoral::Refuse("the influence of a flow primitive reaches ", littoral::TextOf(size),
        " m; arrows reach at most ", littoral::TextOf(LargestDrawing), " m.");
    }
  }
  if (primitives.empty() ||
    outputVector->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkNew<vtkAppendPolyData> all;
  std::vector<littoral::FlowArrow> arrows;
  for (const littoral::FlowPrimitive& primitive : primitives)
  {
    const std::vector<littoral::FlowArrow> some = littoral::ArrowsOf(primitive);
    arrows.insert(arrows.end(), some.begin(), some.end());
    for (const littoral::FlowRing& ring : littoral::RingsOf(primitive))
    {
      all->AddInputData(DrawRing(ring, RingThickness * littoral::DrawingRadius(primitive)));
    }
  }
  all->AddInputData(DrawArrows(arrows));
  all->Update();
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(all->GetOutput());
  Paint(output);
  return 1;
}

//----------------------------------------------------------------------------
int vtkFlowArrowFilter::DrawSamples(vtkPointSet* data, vtkInformationVector* outputVector)
{
  if (outputVector->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  const std::vector<littoral::FlowArrow> arrows =
    littoral::ArrowsAt(littoral::ReadSamples(data, "Velocity"), this->ArrowsAlong);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(DrawArrows(arrows));
  Paint(output);
  return 1;
}

//----------------------------------------------------------------------------
int vtkFlowArrowFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

//----------------------------------------------------------------------------
int vtkFlowArrowFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return littoral::WithoutExceptions(this, request, outputs,
    "Cannot draw arrows: ", [&] { return this->Superclass::ProcessRequest(request, inputs, outputs); });
}

//----------------------------------------------------------------------------
void vtkFlowArrowFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrowsAlong: " << this->ArrowsAlong << "\n";
}
