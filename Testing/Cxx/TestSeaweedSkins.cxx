// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Skins of the preset seaweeds in a swell with a strong current: against VTK's own skinning, and how far what is round
// gets thin, blades get narrow and facets get small, against what the angles of the joints allow.
#include "Check.h"
#include "Data/PlantBlocks.h"
#include "PlantChecks.h"
#include "Plants/SeaweedSegment.h"
#include "vtkFlowPrimitiveSource.h"
#include "vtkPlantScatterFilter.h"
#include "vtkSeaStateSource.h"
#include "vtkSeaweedDeformationFilter.h"
#include "vtkSeaweedSource.h"

#include "vtkMatrix4x4.h"
#include "vtkMatrixToLinearTransform.h"
#include "vtkUnsignedShortArray.h"
#include "vtkWeightedTransformFilter.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Filter = vtkSeaweedDeformationFilter;
using littoral::Vector3;

constexpr double ArmOfMarker = 64.0; // [m]: so long that single precision tells angles well
constexpr double Rounding = 6e-8;    // of a number in single precision, as part of it

Vector3 PointOf(vtkPolyData* data, vtkIdType id)
{
  Vector3 point;
  data->GetPoint(id, &point.x);
  return point;
}

Vector3 NormalOf(vtkPolyData* data, vtkIdType id)
{
  Vector3 normal;
  data->GetPointData()->GetNormals()->GetTuple(id, &normal.x);
  return normal;
}

const char* NameOf(int preset)
{
  constexpr const char* Names[] = { "Custom", "SugarKelp", "GiantKelp", "Eelgrass" };
  return Names[preset];
}

/// The plant with four more vertices for each node of its skeleton, which follow the segment that starts there alone
/// and belong to no polygon: from where they go one reads how the segment moved, whatever its joint.
vtkNew<vtkMultiBlockDataSet> WithMarkers(vtkMultiBlockDataSet* plant)
{
  vtkPolyData* bones = Part(plant, "Skeleton");
  vtkNew<vtkPolyData> leaves;
  leaves->DeepCopy(Part(plant, "Leaves"));
  vtkPointData* arrays = leaves->GetPointData();
  for (int node = 0; node < bones->GetNumberOfPoints(); ++node)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      Vector3 place = PointOf(bones, node);
      if (corner > 0)
      {
        place[corner - 1] += ArmOfMarker;
      }
      leaves->GetPoints()->InsertNextPoint(&place.x);
      for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
      {
        const std::string name = arrays->GetArray(i)->GetName();
        const bool isIds = name == "JointIds";
        const std::array<double, 4> tuple{ isIds ? node : 1.0, isIds ? node : 0.0, isIds ? node : 0.0,
          isIds ? node : 0.0 };
        arrays->GetArray(i)->InsertNextTuple(tuple.data());
      }
    }
  }
  vtkNew<vtkMultiBlockDataSet> high;
  littoral::AddBlock(high, "Skeleton", bones);
  littoral::AddBlock(high, "Skin", Part(plant, "Skin"));
  littoral::AddBlock(high, "Leaves", leaves);
  vtkNew<vtkMultiBlockDataSet> all;
  littoral::AddBlock(all, "High", high);
  return all;
}

/// How a segment moved: a place x goes to Turn x + Shift.
struct Motion
{
  glm::dmat3 Turn{ 1.0 };
  Vector3 Shift{ 0.0 };
};

std::vector<Motion> MotionsOf(vtkPolyData* rest, vtkPolyData* moved, vtkIdType nodes)
{
  std::vector<Motion> motions(static_cast<std::size_t>(nodes));
  const vtkIdType first = rest->GetNumberOfPoints() - 4 * nodes;
  for (vtkIdType node = 0; node < nodes; ++node)
  {
    const vtkIdType foot = first + 4 * node;
    glm::dmat3 before;
    glm::dmat3 after;
    for (int axis = 0; axis < 3; ++axis)
    {
      before[axis] = PointOf(rest, foot + 1 + axis) - PointOf(rest, foot);
      after[axis] = PointOf(moved, foot + 1 + axis) - PointOf(moved, foot);
    }
    Motion& motion = motions[static_cast<std::size_t>(node)];
    motion.Turn = after * glm::inverse(before);
    motion.Shift = PointOf(moved, foot) - motion.Turn * PointOf(rest, foot);
  }
  return motions;
}

/// The sine of half the angle between two rotations.
double HalfSine(const glm::dmat3& a, const glm::dmat3& b)
{
  double sum = 0.0;
  for (int column = 0; column < 3; ++column)
  {
    const Vector3 off = a[column] - b[column];
    sum += glm::dot(off, off);
  }
  return std::min(1.0, std::sqrt(sum / 8.0));
}

/// Waves of 6 s and a current.
struct Weather
{
  double Height;  ///< of waves, from trough to crest [m]
  double Current; ///< [m/s]
};
constexpr Weather Rough{ 2.0, 0.8 };
constexpr Weather Fair{ 0.5, 0.15 };

/// A preset in a regular swell with a current, in 8 m of water or as much as it needs.
struct Swell
{
  vtkNew<vtkSeaweedSource> Plant;
  vtkNew<vtkSeaStateSource> Sea;
  vtkNew<vtkFlowPrimitiveSource> Current;
  vtkNew<Filter> Move;
  vtkNew<vtkMultiBlockDataSet> Rest;

  explicit Swell(int preset, const Weather& weather = Rough)
  {
    this->Plant->SetPreset(preset);
    this->Plant->Update();
    this->Rest->ShallowCopy(WithMarkers(vtkMultiBlockDataSet::SafeDownCast(this->Plant->GetOutputDataObject(0))));
    double bounds[6];
    Part(this->Rest, "Skeleton")->GetBounds(bounds);
    const double depth = std::max(8.0, std::ceil(bounds[5] + 0.5));
    this->Sea->SetSpectrum(vtkSeaStateSource::Regular);
    this->Sea->SetSeaBy(vtkSeaStateSource::HeightAndPeriod);
    this->Sea->SetSignificantWaveHeight(weather.Height);
    this->Sea->SetPeakPeriod(6.0);
    this->Sea->SetSeaLevel(depth);
    this->Sea->SetWaterDepth(depth);
    this->Current->SetFlowType(vtkFlowPrimitiveSource::Uniform);
    this->Current->SetStrength(weather.Current);
    this->Move->SetInputData(this->Rest);
    this->Move->SetSeaStateConnection(this->Sea->GetOutputPort());
    this->Move->AddCurrentConnection(this->Current->GetOutputPort());
  }
};

/// What is measured, against what is allowed.
struct Least
{
  double Ratio = 1.0;
  double Margin = 1.0; ///< least of ratio less bound

  void Take(double ratio, double bound)
  {
    this->Ratio = std::min(this->Ratio, ratio);
    this->Margin = std::min(this->Margin, ratio - bound);
  }

  void Take(const Least& other)
  {
    this->Ratio = std::min(this->Ratio, other.Ratio);
    this->Margin = std::min(this->Margin, other.Margin);
  }
};

struct Shapes
{
  Least Thickness;
  Least Width;
  Least Area;
  double LargestAngle = 0.0;   ///< between neighbours that share a vertex, against rest [rad]
  double LargestTilt = 0.0;    ///< of normals against facets, beyond rest [rad]
  double LengthOfNormal = 0.0; ///< largest difference from 1
  int InsideOut = 0;           ///< normals or facets

  void Take(const Shapes& other)
  {
    this->Thickness.Take(other.Thickness);
    this->Width.Take(other.Width);
    this->Area.Take(other.Area);
    this->LargestAngle = std::max(this->LargestAngle, other.LargestAngle);
    this->LargestTilt = std::max(this->LargestTilt, other.LargestTilt);
    this->LengthOfNormal = std::max(this->LengthOfNormal, other.LengthOfNormal);
    this->InsideOut += other.InsideOut;
  }
};

/// A skin, its joints and how they moved.
class Skin
{
public:
  Skin(vtkPolyData* bonesAtRest, vtkPolyData* bones, vtkPolyData* rest, vtkPolyData* moved,
    const std::vector<Motion>& motions)
    : BonesAtRest(bonesAtRest)
    , Bones(bones)
    , Rest(rest)
    , Moved(moved)
    , Motions(motions)
    , Ids(vtkIntArray::SafeDownCast(rest->GetPointData()->GetArray("JointIds")))
    , Weights(vtkFloatArray::SafeDownCast(rest->GetPointData()->GetArray("JointWeights")))
  {
  }

  int Joint(vtkIdType vertex, int which) const { return this->Ids->GetValue(4 * vertex + which); }
  double Weight(vtkIdType vertex, int which) const { return this->Weights->GetValue(4 * vertex + which); }

  /// Of the two joints of a vertex.
  double HalfSineAt(vtkIdType vertex) const
  {
    return this->Weight(vertex, 1) > 0.0
      ? HalfSine(this->Motions[this->Joint(vertex, 0)].Turn, this->Motions[this->Joint(vertex, 1)].Turn)
      : 0.0;
  }

  /// What is at a right angle to the joint's axis keeps this part of its length: with shares w and 1 - w of two
  /// rotations by a apart, the square is w^2 + (1 - w)^2 + 2 w (1 - w) cos a.
  double Keeps(vtkIdType vertex) const
  {
    const double sine = this->HalfSineAt(vertex);
    return std::sqrt(1.0 - 4.0 * this->Weight(vertex, 0) * this->Weight(vertex, 1) * sine * sine);
  }

  void MeasureRound(Shapes& shapes) const
  {
    auto* tissue = vtkIntArray::SafeDownCast(this->BonesAtRest->GetPointData()->GetArray("Tissue"));
    for (vtkIdType vertex = 0; vertex < this->Rest->GetNumberOfPoints(); ++vertex)
    {
      this->MeasureNormal(vertex, shapes);
      if (tissue->GetValue(this->Joint(vertex, 0)) == static_cast<int>(littoral::SeaweedTissue::Stipe))
      {
        this->MeasureThickness(vertex, shapes);
      }
    }
  }

  /// Rows of a blade, which begin with u = 0 and end with u = 1, from edge to edge.
  void MeasureWidths(Shapes& shapes) const
  {
    vtkDataArray* places = this->Rest->GetPointData()->GetTCoords();
    const vtkIdType end = this->EndOfPolygons();
    vtkIdType first = 0;
    for (vtkIdType vertex = 0; vertex < end; ++vertex)
    {
      this->MeasureNormal(vertex, shapes);
      const double u = places->GetComponent(vertex, 0);
      first = u == 0.0 ? vertex : first;
      if (u == 1.0)
      {
        const double rest = glm::distance(PointOf(this->Rest, vertex), PointOf(this->Rest, first));
        const double now = glm::distance(PointOf(this->Moved, vertex), PointOf(this->Moved, first));
        const Vector3 far = glm::max(glm::abs(PointOf(this->Rest, vertex)), glm::abs(PointOf(this->Moved, vertex)));
        shapes.Width.Take(now / rest, this->Keeps(vertex) - 8.0 * Rounding * glm::length(far) / rest);
        shapes.LargestAngle = std::max(shapes.LargestAngle, 2.0 * std::asin(this->HalfSineAt(vertex)));
      }
    }
  }

  /// Triangles of the fans of all polygons.
  void MeasureFacets(Shapes& shapes) const
  {
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < this->Rest->GetNumberOfPolys(); ++cell)
    {
      this->Rest->GetPolys()->GetCellAtId(cell, corners);
      for (vtkIdType i = 2; i < corners->GetNumberOfIds(); ++i)
      {
        this->MeasureTriangle({ corners->GetId(0), corners->GetId(i - 1), corners->GetId(i) }, shapes);
      }
    }
  }

private:
  vtkPolyData* BonesAtRest;
  vtkPolyData* Bones;
  vtkPolyData* Rest;
  vtkPolyData* Moved;
  const std::vector<Motion>& Motions;
  vtkIntArray* Ids;
  vtkFloatArray* Weights;

  vtkIdType EndOfPolygons() const
  {
    double range[2];
    this->Rest->GetPolys()->GetConnectivityArray()->GetRange(range, 0);
    return static_cast<vtkIdType>(range[1]) + 1;
  }

  void MeasureNormal(vtkIdType vertex, Shapes& shapes) const
  {
    const double length = glm::length(NormalOf(this->Moved, vertex));
    shapes.LengthOfNormal = std::max(shapes.LengthOfNormal, std::abs(length - 1.0));
  }

  /// The nearest point on the segments that a vertex follows.
  Vector3 NearestOf(vtkPolyData* bones, vtkIdType vertex, const Vector3& place) const
  {
    Vector3 nearest(1e9);
    for (int i = 0; i < 2 && this->Weight(vertex, i) > 0.0; ++i)
    {
      const Vector3 foot = PointOf(bones, this->Joint(vertex, i));
      const Vector3 along = PointOf(bones, this->Joint(vertex, i) + 1) - foot;
      const double part = std::clamp(glm::dot(place - foot, along) / glm::dot(along, along), 0.0, 1.0);
      const Vector3 point = foot + part * along;
      nearest = glm::distance(place, point) < glm::distance(place, nearest) ? point : nearest;
    }
    return nearest;
  }

  /// A vertex at r from its joint goes to (w A + (1 - w) B) r, with A and B a apart. Let k be cos(a / 2). That is at
  /// least k |r| long; it leans against either segment by a / 2 more than at rest, and by the little that r turns when
  /// a part of it shrinks by k, whose sine is at most (1 - k) / (1 + k).
  void MeasureThickness(vtkIdType vertex, Shapes& shapes) const
  {
    const Vector3 rest = PointOf(this->Rest, vertex);
    const Vector3 moved = PointOf(this->Moved, vertex);
    const double before = glm::distance(rest, this->NearestOf(this->BonesAtRest, vertex, rest));
    const Vector3 nearest = this->NearestOf(this->Bones, vertex, moved);
    const double after = glm::distance(moved, nearest);
    double bound = 1.0;
    if (this->Weight(vertex, 1) > 0.0)
    {
      const double sine = this->HalfSineAt(vertex);
      const double k = std::sqrt(1.0 - sine * sine);
      const int pivot = std::max(this->Joint(vertex, 0), this->Joint(vertex, 1));
      const Vector3 r = rest - PointOf(this->BonesAtRest, pivot);
      double lean = 0.0;
      for (int i = 0; i < 2; ++i)
      {
        const int node = this->Joint(vertex, i);
        const Vector3 axis = PointOf(this->BonesAtRest, node + 1) - PointOf(this->BonesAtRest, node);
        lean = std::max(lean, std::asin(std::min(1.0, std::abs(glm::dot(glm::normalize(r), glm::normalize(axis))))));
      }
      const double all = lean + std::asin(sine) + std::asin((1.0 - k) / (1.0 + k));
      bound = k * std::cos(std::min(0.5 * littoral::Pi, all));
      shapes.LargestAngle = std::max(shapes.LargestAngle, 2.0 * std::asin(sine));
    }
    const double far = std::max(glm::length(rest), glm::length(moved));
    shapes.Thickness.Take(after / before, bound - 8.0 * Rounding * far / before);
    // The outermost vertex of a stipe has a normal along it. Those of the flat end at its foot are judged with their
    // facets.
    const double out = glm::dot(NormalOf(this->Rest, vertex), rest - this->NearestOf(this->BonesAtRest, vertex, rest));
    const bool isSide = out > 0.1 * before;
    shapes.InsideOut += isSide && glm::dot(NormalOf(this->Moved, vertex), moved - nearest) <= 0.0 ? 1 : 0;
  }

  void MeasureTriangle(const std::array<vtkIdType, 3>& corners, Shapes& shapes) const
  {
    const auto area = [&](vtkPolyData* data) {
      const Vector3 first = PointOf(data, corners[0]);
      return 0.5 * glm::cross(PointOf(data, corners[1]) - first, PointOf(data, corners[2]) - first);
    };
    const Vector3 rest = area(this->Rest);
    const Vector3 moved = area(this->Moved);
    shapes.Area.Take(glm::length(moved) / glm::length(rest), 0.0);
    const Vector3 turned = this->Motions[this->Joint(corners[0], 0)].Turn * rest;
    shapes.InsideOut += glm::dot(moved, turned) > 0.0 ? 0 : 1;
    for (vtkIdType corner : corners)
    {
      const auto tilt = [&](vtkPolyData* data, const Vector3& facet) {
        return std::acos(std::clamp(glm::dot(NormalOf(data, corner), glm::normalize(facet)), -1.0, 1.0));
      };
      const double before = tilt(this->Rest, rest);
      const double after = tilt(this->Moved, moved);
      shapes.LargestTilt = std::max(shapes.LargestTilt, after - before);
      shapes.InsideOut += before < 0.45 * littoral::Pi && after > 0.5 * littoral::Pi ? 1 : 0;
    }
  }
};

Shapes Measured(Swell& scene)
{
  Shapes shapes;
  vtkPolyData* bones = Part(scene.Rest, "Skeleton");
  vtkPolyData* moved = Part(scene.Move->GetOutputDataObject(0), "Skeleton");
  const std::vector<Motion> motions = MotionsOf(
    Part(scene.Rest, "Leaves"), Part(scene.Move->GetOutputDataObject(0), "Leaves"), bones->GetNumberOfPoints());
  for (const char* name : { "Skin", "Leaves" })
  {
    const Skin skin(bones, moved, Part(scene.Rest, name), Part(scene.Move->GetOutputDataObject(0), name), motions);
    name[0] == 'S' ? skin.MeasureRound(shapes) : skin.MeasureWidths(shapes);
    skin.MeasureFacets(shapes);
  }
  return shapes;
}

/// A preset in a swell. In any, no vertex comes closer to its neighbours than linear blend skinning must bring it at
/// the angles of the joints. Where these stay below a right angle, nothing collapses: what is blended keeps at least
/// cos(45 degrees), no facet turns over, and none is lost.
bool TestShapes(int preset, int joint, int method, const Weather& weather, bool mayFold)
{
  Swell scene(preset, weather);
  scene.Move->SetJoint(joint);
  scene.Move->SetMethod(method);
  Shapes all;
  for (double time = 0.0; time < 6.1; time += 0.5)
  {
    scene.Move->UpdateTimeStep(time);
    all.Take(Measured(scene));
  }
  const double degree = littoral::Pi / 180.0;
  const std::string who = std::string(NameOf(preset)) + ", Joint " + std::to_string(joint) + ", Method " +
    std::to_string(method) + ", waves of " + std::to_string(weather.Height).substr(0, 4) + " m";
  std::cout << who << ": neighbours turn by up to " << all.LargestAngle / degree << " degrees; least thickness "
            << all.Thickness.Ratio << ", width " << all.Width.Ratio << ", area " << all.Area.Ratio
            << " of rest; inside out " << all.InsideOut << "; normals tilt by up to " << all.LargestTilt / degree
            << " degrees" << std::endl;
  bool good = Check(all.Thickness.Margin >= 0.0, who + ": a stipe is thinner than its joints can make it");
  good = Check(all.Width.Margin >= 0.0, who + ": a blade is narrower than its joints can make it") && good;
  good = Check(all.LengthOfNormal < 1e-6, who + ": normals are not of length 1") && good;
  if (method == 0)
  {
    // Two angles of up to MaximumAngle, here 60 degrees, turn by 2 acos(cos(30) cos(30)).
    const double most = joint == 0 ? 60.0 * degree : 2.0 * std::acos(0.75);
    good = Check(all.LargestAngle < most + 1e-4, who + ": a joint turns beyond MaximumAngle") && good;
  }
  if (!mayFold)
  {
    good = Check(all.LargestAngle < 90.0 * degree, who + ": a joint turns by a right angle") && good;
    good = Check(all.Width.Ratio > std::sqrt(0.5), who + ": a blade collapses") && good;
    good = Check(all.Thickness.Ratio > std::sqrt(0.5), who + ": a stipe collapses") && good;
    good = Check(all.Area.Ratio > 0.1, who + ": a facet collapses") && good;
    good = Check(all.InsideOut == 0, who + ": facets or normals are inside out") && good;
  }
  return good;
}

/// Blades and stipes of a whole plant as vtkWeightedTransformFilter moves them. A plant of 14 m has steps of 1e-6 m in
/// single precision at its top.
bool TestSkinning(int preset, int joint)
{
  Swell scene(preset);
  scene.Move->SetJoint(joint);
  scene.Move->UpdateTimeStep(3.0);
  bool good = true;
  vtkPolyData* bones = Part(scene.Rest, "Skeleton");
  const std::vector<Motion> motions = MotionsOf(
    Part(scene.Rest, "Leaves"), Part(scene.Move->GetOutputDataObject(0), "Leaves"), bones->GetNumberOfPoints());
  vtkNew<vtkWeightedTransformFilter> oracle;
  oracle->SetTransformIndexArray("Indices");
  oracle->SetWeightArray("JointWeights");
  oracle->SetNumberOfTransforms(static_cast<int>(motions.size()));
  for (std::size_t node = 0; node < motions.size(); ++node)
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        matrix->SetElement(row, column, motions[node].Turn[column][row]);
      }
      matrix->SetElement(row, 3, motions[node].Shift[row]);
    }
    vtkNew<vtkMatrixToLinearTransform> transform;
    transform->SetInput(matrix);
    transform->Update();
    oracle->SetTransform(transform, static_cast<int>(node));
  }
  for (const char* name : { "Skin", "Leaves" })
  {
    vtkPolyData* rest = Part(scene.Plant->GetOutputDataObject(0), name);
    vtkPolyData* moved = Part(scene.Move->GetOutputDataObject(0), name);
    vtkNew<vtkPolyData> indexed;
    indexed->ShallowCopy(rest);
    vtkDataArray* ids = rest->GetPointData()->GetArray("JointIds");
    vtkNew<vtkUnsignedShortArray> indices;
    indices->SetName("Indices");
    indices->SetNumberOfComponents(4);
    indices->SetNumberOfTuples(ids->GetNumberOfTuples());
    for (int component = 0; component < 4; ++component)
    {
      indices->CopyComponent(component, ids, component);
    }
    indexed->GetPointData()->AddArray(indices);
    oracle->SetInputData(indexed);
    oracle->Update();
    auto* wanted = vtkPolyData::SafeDownCast(oracle->GetOutputDataObject(0));
    double error = 0.0;
    double tilt = 0.0;
    double size = 1.0;
    double most = 0.0;
    for (vtkIdType vertex = 0; vertex < rest->GetNumberOfPoints(); ++vertex)
    {
      const Vector3 place = PointOf(moved, vertex);
      error = std::max(error, glm::distance(place, PointOf(wanted, vertex)));
      const Vector3 normal = glm::normalize(NormalOf(wanted, vertex));
      tilt = std::max(tilt, glm::distance(NormalOf(moved, vertex), normal));
      size = std::max(size, glm::length(place));
      most = std::max(most, glm::distance(place, PointOf(rest, vertex)));
    }
    const std::string who = std::string(NameOf(preset)) + ", Joint " + std::to_string(joint) + ", " + name;
    std::cout << who << ": moves by up to " << most << " m, differs from VTK's by " << error << " m, in normals by "
              << tilt << std::endl;
    good = Check(error < 1e-6 * size && tilt < 1e-6 * size, who + " differs from vtkWeightedTransformFilter") && good;
  }
  return good;
}

/// How far two states of a plant are apart in a picture of 1080 lines, of what is in the picture [pixels].
double LargestJump(vtkPolyData* before, vtkPolyData* after, const Vector3& eye)
{
  const double tangent = std::tan(15.0 * littoral::Pi / 180.0);
  const float* p = vtkFloatArray::SafeDownCast(before->GetPoints()->GetData())->GetPointer(0);
  const float* q = vtkFloatArray::SafeDownCast(after->GetPoints()->GetData())->GetPointer(0);
  double most = 0.0;
  for (vtkIdType vertex = 0; vertex < after->GetNumberOfPoints(); ++vertex, p += 3, q += 3)
  {
    const Vector3 place(q[0], q[1], q[2]);
    const Vector3 sight = place - eye;
    const bool isSeen =
      sight.y > 0.1 && std::abs(sight.z) < tangent * sight.y && std::abs(sight.x) < tangent * sight.y * 16.0 / 9.0;
    if (isSeen)
    {
      const double pixel = 2.0 * sight.y * tangent / 1080.0;
      most = std::max(most, glm::distance(place, Vector3(p[0], p[1], p[2])) / pixel);
    }
  }
  return most;
}

/// Blades and stipes.
using Parts = std::array<vtkSmartPointer<vtkPolyData>, 2>;

/// A plant in levels of detail, seen from a distance along y while time stands still.
struct Watched
{
  vtkNew<Filter> Move;
  double Height = 0.0; ///< of the eye [m]

  Parts At(double distance)
  {
    this->Move->SetViewPoint(0.0, -distance, this->Height);
    this->Move->UpdateTimeStep(2.5);
    return { Part(this->Move->GetOutputDataObject(0), "Leaves"), Part(this->Move->GetOutputDataObject(0), "Skin") };
  }
};

/// The largest jump in steps of a centimetre between two distances, and where. A stretch that moves less in all is not
/// cut up: a jump in it would have to be taken back within it.
struct Jumps
{
  static constexpr double Enough = 0.8; // [pixels]
  static constexpr double Step = 0.01;  // [m]

  Watched& Scene;
  double Worst = 0.0;
  double Where = 0.0;

  void Find(double near, const Parts& before, double far, const Parts& after)
  {
    const Vector3 eye(0.0, -far, this->Scene.Height);
    const double jump = std::max(LargestJump(before[0], after[0], eye), LargestJump(before[1], after[1], eye));
    if (jump > Enough && far - near > 1.5 * Step)
    {
      const double middle = near + Step * std::round(0.5 * (far - near) / Step);
      const auto between = this->Scene.At(middle);
      this->Find(near, before, middle, between);
      this->Find(middle, between, far, after);
      return;
    }
    this->Where = jump > this->Worst ? far : this->Where;
    this->Worst = std::max(this->Worst, jump);
  }
};

/// A camera that goes through the bands of the levels of detail moves no point of a plant by a pixel with a centimetre.
bool TestBands(int preset, int method, int seed, double stretch = 0.16)
{
  vtkNew<vtkSeaweedSource> weed;
  weed->SetPreset(preset);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> sites;
  sites->SetPoints(points);
  vtkNew<vtkPlantScatterFilter> meadow;
  meadow->SetInputData(0, sites);
  meadow->AddPrototypeConnection(weed->GetOutputPort());
  meadow->SetUseLevels(false);
  meadow->SetUseCulling(false);
  meadow->Update();
  vtkPolyData* rest = Part(meadow->GetOutputDataObject(0), "Skeleton");
  double bounds[6];
  rest->GetBounds(bounds);
  vtkNew<vtkSeaStateSource> sea;
  sea->SetSeaLevel(std::max(12.0, bounds[5] + 1.0));
  sea->SetSeed(seed);
  vtkNew<vtkFlowPrimitiveSource> current;
  current->SetFlowType(vtkFlowPrimitiveSource::Uniform);
  current->SetStrength(0.15);
  Watched scene;
  Filter* move = scene.Move;
  move->SetInputConnection(meadow->GetOutputPort());
  move->SetSeaStateConnection(sea->GetOutputPort());
  move->AddCurrentConnection(current->GetOutputPort());
  move->SetMethod(method);
  move->SetUseLevels(true);
  move->SetViewDirection(0.0, 1.0, 0.0);
  scene.Height = 0.5 * (bounds[4] + bounds[5]);
  // Bands are as long as the plant reaches, which is not beyond twice its height.
  const double band = std::max(12.0, 2.0 * (bounds[5] - bounds[4]));
  Jumps jumps{ scene };
  double near = 4.5;
  auto before = scene.At(near);
  while (near < 20.5 + band)
  {
    const double far = near + stretch;
    auto after = scene.At(far);
    jumps.Find(near, before, far, after);
    near = far;
    before = std::move(after);
  }
  const std::string who =
    std::string(NameOf(preset)) + ", Method " + std::to_string(method) + ", Seed " + std::to_string(seed);
  std::cout << who << ": a step of 1 cm moves the plant by at most " << jumps.Worst << " pixels, at " << jumps.Where
            << " m" << std::endl;
  return Check(jumps.Worst > 0.0 && jumps.Worst < 1.0, who + ": levels jump by " + std::to_string(jumps.Worst));
}

}

/// With --long giant kelp in all its motions too, which take most of the time.
int TestSeaweedSkins(int argc, char* argv[])
{
  const bool isLong = argc > 1 && std::string(argv[argc - 1]) == "--long";
  constexpr int SugarKelp = vtkSeaweedSource::SugarKelp;
  constexpr int GiantKelp = vtkSeaweedSource::GiantKelp;
  constexpr int Eelgrass = vtkSeaweedSource::Eelgrass;
  const double stretch = isLong ? 0.16 : 0.32; // [m]
  bool good = true;
  for (int joint : { 0, 1 })
  {
    for (int preset : { SugarKelp, GiantKelp, Eelgrass })
    {
      good = ((preset == GiantKelp && !isLong) || TestSkinning(preset, joint)) && good;
      good = TestShapes(preset, joint, 0, Rough, false) && good;
    }
    // Limp blades fold where they please.
    good = TestShapes(SugarKelp, joint, 1, Rough, true) && good;
    good = (!isLong || TestShapes(GiantKelp, joint, 1, Rough, true)) && good;
    good = TestShapes(Eelgrass, joint, 1, Rough, false) && good;
  }
  good = TestShapes(SugarKelp, 0, 1, Fair, false) && good;
  good = TestBands(SugarKelp, 1, 1, stretch) && TestBands(Eelgrass, 0, 1, stretch) && good;
  // Of eight seas, those that showed loads which follow what is shown: by 1.4 and 3.8 pixels.
  good = TestBands(GiantKelp, 0, 8, stretch) && good;
  if (isLong)
  {
    good = TestBands(GiantKelp, 0, 7) && TestBands(GiantKelp, 0, 1) && TestBands(GiantKelp, 1, 1) && good;
    good = TestBands(SugarKelp, 0, 1) && TestBands(Eelgrass, 1, 1) && good;
  }
  return good ? 0 : 1;
}
