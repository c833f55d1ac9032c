// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Currents: flow primitives, and images of velocities.

#include "Data/CurrentData.h"
#include "Data/Inputs.h"
#include "Data/SeaStateTable.h"
#include "Expect.h"
#include "RandomData.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"

namespace
{

vtkSmartPointer<vtkPolyData> Primitives(RandomData& data)
{
  using namespace littoral;
  auto set = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  const vtkIdType count = data.Count();
  for (vtkIdType id = 0; id < count; ++id)
  {
    const double place[3] = { data.Number(), data.Number(), data.Number() };
    points->InsertNextPoint(place);
  }
  set->SetPoints(points);
  data.Fill(set->GetPointData(),
    { sea::FlowType, sea::Strength, sea::Axis, sea::CoreRadius, sea::InfluenceRadius, sea::InfluenceBox,
      sea::InfluenceMargin },
    { 1, 1, 3, 1, 1, 6, 1 }, count);
  return set;
}

vtkSmartPointer<vtkImageData> Velocities(RandomData& data)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int sides[3] = { data.ConsumeIntegralInRange(0, 3), data.ConsumeIntegralInRange(0, 3),
    data.ConsumeIntegralInRange(0, 3) };
  image->SetDimensions(sides);
  image->SetOrigin(data.Number(), data.Number(), data.Number());
  image->SetSpacing(data.Number(), data.Number(), data.Number());
  data.Fill(image->GetPointData(), { "Velocity" }, { 3 }, image->GetNumberOfPoints());
  return image;
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace littoral;
  RandomData data(bytes, size);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int block = 0, count = data.ConsumeIntegralInRange(0u, 2u); block < count; ++block)
  {
    if (data.ConsumeBool())
    {
      blocks->SetBlock(block, Primitives(data));
    }
    else
    {
      blocks->SetBlock(block, Velocities(data));
    }
  }
  const auto interpolation = data.ConsumeBool() ? VelocityInterpolation::Linear : VelocityInterpolation::CubicSpline;
  const std::string name = data.ConsumeBool() ? "" : "Velocity";
  const WaterLayer layer = data.ConsumeBool() ? WaterLayer{} : WaterLayer{ -10.0, 0.0 };
  CurrentSnapshot current;
  const auto read = [&] {
    RequireFit(blocks, "Currents");
    current = ReadCurrent(blocks, name, layer, interpolation);
  };
  if (ReadsOrRefuses(read))
  {
    for (const Vector3& place : { Vector3(0.0), Vector3(1.0, -2.0, -3.0), Vector3(1e6, 0.0, -5.0) })
    {
      const Vector3 velocity = current.Velocity(place);
      Expect(std::isfinite(velocity.x + velocity.y + velocity.z), "The velocity is not finite.");
    }
  }
  return 0;
}
