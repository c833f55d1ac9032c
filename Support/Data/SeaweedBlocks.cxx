// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SeaweedBlocks.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Seaweed/SegmentAngles.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace littoral
{

void AddSegments(const Skeleton& skeleton, const std::vector<SeaweedSegment>& segments, vtkPolyData* block)
{
  const auto nodes = static_cast<vtkIdType>(segments.size());
  const auto add = [&](const char* name, const auto& valueOf) {
    const auto array = NewArray<vtkFloatArray>(name, 1, nodes);
    for (std::size_t node = 0; node < segments.size(); ++node)
    {
      array->SetValue(static_cast<vtkIdType>(node), static_cast<float>(valueOf(node)));
    }
    block->GetPointData()->AddArray(array);
  };
  const auto of = [&](double SeaweedSegment::*member) {
    return [&segments, member](std::size_t node) { return segments[node].*member; };
  };
  add(seaweed::Width, of(&SeaweedSegment::Width));
  add(seaweed::Thickness, of(&SeaweedSegment::Thickness));
  add(seaweed::YoungModulus, of(&SeaweedSegment::YoungModulus));
  add(seaweed::DampingRatio, of(&SeaweedSegment::DampingRatio));
  add(seaweed::Density, of(&SeaweedSegment::Density));
  add(seaweed::Length, [&](std::size_t node) {
    const SkeletonBranch& branch = skeleton.Branches[skeleton.Nodes[node].Branch];
    const std::size_t foot = std::min(node, static_cast<std::size_t>(branch.First + branch.Count - 2));
    return glm::distance(skeleton.Nodes[foot + 1].Position, skeleton.Nodes[foot].Position);
  });
  const std::vector<SegmentAngles> angles = AnglesOf(skeleton);
  add(seaweed::Attachment, [&](std::size_t node) { return angles[node].Attachment; });
  add(seaweed::RestTheta, [&](std::size_t node) { return angles[node].Theta; });
  add(seaweed::RestPhi, [&](std::size_t node) { return angles[node].Phi; });
  const auto across = NewArray<vtkFloatArray>(seaweed::Across, 3, nodes);
  const auto tissue = NewArray<vtkIntArray>(seaweed::Tissue, 1, nodes);
  for (vtkIdType node = 0; node < nodes; ++node)
  {
    const SeaweedSegment& segment = segments[static_cast<std::size_t>(node)];
    across->SetTuple3(node, segment.Across.x, segment.Across.y, segment.Across.z);
    tissue->SetValue(node, static_cast<int>(segment.Tissue));
  }
  block->GetPointData()->AddArray(across);
  block->GetPointData()->AddArray(tissue);
}

std::vector<SeaweedSegment> ReadSegments(vtkPolyData* block)
{
  const vtkIdType nodes = block->GetNumberOfPoints();
  std::vector<SeaweedSegment> segments;
  SetSize(segments, nodes);
  const ArrayReader points = ArrayReader::OfPoints(block, "High/Skeleton");
  const struct
  {
    const char* Name;
    double SeaweedSegment::*Member;
  } numbers[] = { { seaweed::Width, &SeaweedSegment::Width }, { seaweed::Thickness, &SeaweedSegment::Thickness },
    { seaweed::YoungModulus, &SeaweedSegment::YoungModulus }, { seaweed::DampingRatio, &SeaweedSegment::DampingRatio },
    { seaweed::Density, &SeaweedSegment::Density } };
  for (const auto& number : numbers)
  {
    vtkDataArray* array = points.Need(number.Name, 1);
    for (vtkIdType node = 0; node < nodes; ++node)
    {
      segments[static_cast<std::size_t>(node)].*number.Member = array->GetComponent(node, 0);
    }
  }
  vtkDataArray* across = points.Need(seaweed::Across, 3);
  vtkDataArray* tissue = points.Need(seaweed::Tissue, 1);
  for (vtkIdType node = 0; node < nodes; ++node)
  {
    SeaweedSegment& segment = segments[static_cast<std::size_t>(node)];
    const std::string ofNode = "node " + std::to_string(node) + " of High/Skeleton: ";
    across->GetTuple(node, &segment.Across.x);
    ReadWhole(ofNode + seaweed::Tissue, tissue->GetComponent(node, 0), 0, 3, segment.Tissue);
    InContext(ofNode, [&] { Require(WhyInvalid(segment)); });
  }
  return segments;
}

}
