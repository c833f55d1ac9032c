// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// An oak in a wind: at rest without one, the same at any time whatever was asked before, segments of one length, one
// request to the wind for all frames, and clear words about bad input.
#include "ErrorCounter.h"
#include "PlantScene.h"

#include "vtkBeamTreeDeformationFilter.h"
#include "vtkPlantScatterFilter.h"
#include "vtkReevesTreeSource.h"
#include "vtkWindFieldSource.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <set>
#include <vector>

namespace
{

constexpr int Samples = 400;
constexpr double Convection = 10.0; // [m/s]
constexpr double Spacing = 0.5;     // [m]
constexpr double Period = Samples * Spacing / Convection;

/// A wind with gusts; of a strength, somewhere, with or without a flaw. It counts how often it is asked.
class WindSource : public vtkImageAlgorithm
{
public:
  static WindSource* New();
  vtkTypeMacro(WindSource, vtkImageAlgorithm);
  vtkSetMacro(Strength, double);
  vtkSetMacro(Side, double);
  vtkSetMacro(Top, double);
  vtkSetMacro(Duration, int);
  vtkSetMacro(Speed, double);
  double Strength = 8.0;
  double Side = -20.0;
  double Top = 17.0;
  int Duration = Samples; // [samples]
  double Speed = Convection;
  int Executions = 0;

protected:
  WindSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    const int extent[6] = { 0, this->Duration - 1, 0, 4, 0, 3 };
    const double range[2] = { 0.0, Period };
    output->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    output->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    ++this->Executions;
    auto* image = vtkImageData::GetData(output);
    image->SetDimensions(this->Duration, 5, 4);
    image->SetSpacing(Spacing, 10.0, (this->Top - 2.0) / 3.0);
    image->SetOrigin(0.0, this->Side, 2.0);
    vtkNew<vtkFloatArray> velocity;
    velocity->SetName("Velocity");
    velocity->SetNumberOfComponents(3);
    for (int i = 0; i < this->Duration * 20; ++i)
    {
      const double t = 6.283185307179586 * (i % Samples) / Samples;
      velocity->InsertNextTuple3(this->Strength * (1.0 + 0.3 * std::sin(5.0 * t) + 0.2 * std::sin(33.0 * t)),
        0.2 * this->Strength * std::cos(9.0 * t), 0.1 * this->Strength * std::sin(21.0 * t));
    }
    image->GetPointData()->AddArray(velocity);
    vtkNew<vtkDoubleArray> speed;
    speed->SetName("ConvectionSpeed");
    speed->InsertNextValue(this->Speed);
    image->GetFieldData()->AddArray(speed);
    vtkNew<vtkDoubleArray> period;
    period->SetName("Period");
    period->InsertNextValue(this->Speed > 0.0 ? this->Duration * Spacing / this->Speed : 0.0);
    image->GetFieldData()->AddArray(period);
    return 1;
  }
};
vtkStandardNewMacro(WindSource);

std::vector<float> PointsOf(vtkDataObject* plants, const char* path)
{
  auto* data = vtkPolyData::SafeDownCast(BlockAt(plants, path));
  auto* points = vtkFloatArray::SafeDownCast(data->GetPoints()->GetData());
  return { points->GetPointer(0), points->GetPointer(0) + points->GetNumberOfValues() };
}

/// Skeleton, skin and leaves, in one.
std::vector<float> AllPoints(vtkDataObject* plants)
{
  std::vector<float> all;
  for (const char* path : { "High/Skeleton", "High/Skin", "High/Leaves" })
  {
    const std::vector<float> part = PointsOf(plants, path);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

double Farthest(const std::vector<float>& a, const std::vector<float>& b)
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    farthest = std::max(farthest, std::abs(static_cast<double>(a[i]) - b[i]));
  }
  return farthest;
}

/// Largest change of the length of a segment [m].
double Stretch(vtkDataObject* rest, vtkDataObject* moved)
{
  const std::vector<float> a = PointsOf(rest, "High/Skeleton");
  const std::vector<float> b = PointsOf(moved, "High/Skeleton");
  auto* parents = vtkIntArray::SafeDownCast(
    vtkPolyData::SafeDownCast(BlockAt(rest, "High/Skeleton"))->GetPointData()->GetArray("ParentId"));
  const auto length = [&](const std::vector<float>& p, vtkIdType i, vtkIdType j) {
    return std::hypot(
      p[3 * i] - double(p[3 * j]), p[3 * i + 1] - double(p[3 * j + 1]), p[3 * i + 2] - double(p[3 * j + 2]));
  };
  double stretch = 0.0;
  for (vtkIdType node = 0; node < parents->GetNumberOfValues(); ++node)
  {
    const int parent = parents->GetValue(node);
    stretch = std::max(stretch, parent < 0 ? 0.0 : std::abs(length(a, node, parent) - length(b, node, parent)));
  }
  return stretch;
}

int Failures = 0;

void Expect(bool holds, const char* what)
{
  if (!holds)
  {
    std::cerr << "Failed: " << what << "\n";
    ++Failures;
  }
}

/// Texture coordinates of the crowns.
std::vector<float> TCoordsOf(vtkDataObject* plants)
{
  auto* data = vtkPolyData::SafeDownCast(BlockAt(plants, "Medium/Crown"));
  auto* places = vtkFloatArray::SafeDownCast(data->GetPointData()->GetTCoords());
  return { places->GetPointer(0), places->GetPointer(0) + places->GetNumberOfValues() };
}

/// By how much the points above a height have moved on average [m].
double MeanShift(
  const std::vector<float>& rest, const std::vector<float>& moved, double low, double high, double shift[3])
{
  int count = 0;
  std::fill_n(shift, 3, 0.0);
  for (std::size_t i = 0; i < rest.size(); i += 3)
  {
    if (rest[i + 2] >= low && rest[i + 2] <= high)
    {
      ++count;
      for (int axis = 0; axis < 3; ++axis)
      {
        shift[axis] += double(moved[i + axis]) - rest[i + axis];
      }
    }
  }
  for (int axis = 0; axis < 3 && count > 0; ++axis)
  {
    shift[axis] /= count;
  }
  return std::hypot(shift[0], shift[1], shift[2]);
}

/// The frequency of a plant's trunk, in field data, and what it follows from.
void CheckFrequency(WindSource* wind)
{
  vtkNew<vtkReevesTreeSource> tree;
  tree->SetPreset(vtkReevesTreeSource::Pine);
  tree->SetTextureSize(32, 16); // small pictures cost less
  vtkNew<vtkBeamTreeDeformationFilter> sway;
  sway->SetTextureSize(32, 16);
  sway->SetNumberOfTextures(2);
  sway->SetInputConnection(tree->GetOutputPort());
  sway->SetWindConnection(wind->GetOutputPort());
  const auto frequency = [&] {
    sway->UpdateTimeStep(0.0);
    vtkDataArray* array = sway->GetOutputDataObject(0)->GetFieldData()->GetArray("Frequency");
    return array && array->GetNumberOfTuples() == 1 ? array->GetTuple1(0) : -1.0;
  };
  double before = 0.0;
  for (const double diameter : { 0.15, 0.25 })
  {
    tree->SetSpeciesHeight(15.0);
    tree->SetSpeciesDiameter(diameter);
    const double now = frequency();
    const double line = 0.0766 + 3.1219 * 100.0 * diameter / 225.0; // of measured conifers (Moore and Maguire 2004)
    std::cout << "a pine of 15 m and " << 100.0 * diameter << " cm: " << now << " Hz, " << line << " measured\n";
    Expect(now > 1.1 * before, "a thicker trunk is faster");
    Expect(now > 0.7 * line && now < 1.45 * line, "a pine has about the frequency of pines");
    before = now;
  }
  tree->SetPreset(vtkReevesTreeSource::Custom);
  tree->SetNumberOfLeaves(500);
  tree->SetCrownRadius(2.0);
  tree->SetTrunkRadius(0.1);
  const double thin = frequency();
  tree->SetTrunkRadius(0.15);
  Expect(frequency() > 1.3 * thin && thin > 0.0, "TrunkRadius decides");
  vtkNew<ErrorCounter> errors;
  errors->Watch(tree);
  tree->SetSpeciesDiameter(-1.0);
  Expect(errors->ExpectOneNaming("SpeciesDiameter"), "SpeciesDiameter is refused");
  tree->SetSpeciesDiameter(0.0);
  tree->SetSpeciesHeight(1e3);
  Expect(errors->ExpectOneNaming("SpeciesHeight"), "SpeciesHeight is refused");
}

/// The point of a skeleton at the tip of the trunk, which is its first line.
vtkIdType TipOf(vtkDataObject* plants)
{
  vtkNew<vtkIdList> trunk;
  vtkPolyData::SafeDownCast(BlockAt(plants, "High/Skeleton"))->GetCellPoints(0, trunk);
  return trunk->GetId(trunk->GetNumberOfIds() - 1);
}

/// A tree on each of some places, in full view.
vtkNew<vtkPlantScatterFilter> WoodOf(vtkPoints* feet, vtkAlgorithm* tree)
{
  vtkNew<vtkPolyData> sites;
  sites->SetPoints(feet);
  vtkNew<vtkPlantScatterFilter> wood;
  wood->SetInputData(sites);
  wood->AddPrototypeConnection(tree->GetOutputPort());
  wood->UseCullingOff();
  return wood;
}

/// The envelope sways as the trunk in full does, and shows one picture after the other.
void CheckEnvelope(vtkBeamTreeDeformationFilter* sway, vtkReevesTreeSource* tree)
{
  vtkDataObject* rest = tree->GetOutputDataObject(0);
  sway->SetInputConnection(0, tree->GetOutputPort());
  const std::vector<float> crown = PointsOf(rest, "Medium/Crown");
  std::set<float> pictures;
  double difference = 0.0;
  double largest = 0.0;
  for (int frame = 0; frame < 40; ++frame)
  {
    const double time = 0.0703 * frame;
    sway->UpdateTimeStep(time);
    vtkDataObject* now = sway->GetOutputDataObject(0);
    pictures.insert(TCoordsOf(now)[1]);
    // The tip of the trunk, and the vertices of the crown at its height.
    const vtkIdType tip = TipOf(rest);
    const std::vector<float> a = PointsOf(rest, "High/Skeleton");
    const std::vector<float> b = PointsOf(now, "High/Skeleton");
    double mean[3];
    MeanShift(crown, PointsOf(now, "Medium/Crown"), a[3 * tip + 2] - 1.2, a[3 * tip + 2] + 1.2, mean);
    for (int axis = 0; axis < 2; ++axis)
    {
      const double wanted = double(b[3 * tip + axis]) - a[3 * tip + axis];
      largest = std::max(largest, std::abs(wanted));
      difference = std::max(difference, std::abs(mean[axis] - wanted));
    }
  }
  std::cout << "the trunk's tip goes " << largest << " m, the envelope around it differs by " << difference << " m; "
            << pictures.size() << " pictures\n";
  Expect(largest > 0.005 && difference < 0.15 * largest, "the envelope sways as the trunk does");
  Expect(pictures.size() == 8, "all pictures are shown in turn");
  sway->UpdateTimeStep(1.1);
  const std::vector<float> once = PointsOf(sway->GetOutputDataObject(0), "Medium/Crown");
  const std::vector<float> places = TCoordsOf(sway->GetOutputDataObject(0));
  sway->UpdateTimeStep(1.1 + Period);
  Expect(Farthest(once, PointsOf(sway->GetOutputDataObject(0), "Medium/Crown")) < 1e-4 &&
      places == TCoordsOf(sway->GetOutputDataObject(0)),
    "the middle level repeats");
}

/// The pictures of the envelope differ from each other and hold leaves.
void CheckPictures(vtkBeamTreeDeformationFilter* sway)
{
  sway->SetTextureSize(256, 128);
  sway->Update(1);
  auto* image = vtkImageData::SafeDownCast(sway->GetOutputDataObject(1));
  auto* texels = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  const int* size = image->GetDimensions();
  Expect(size[0] == 260 && size[1] == 8 * 132, "eight pictures with borders, one above the other");
  const auto picture = [&](int index) { return texels->GetPointer(4 * 260 * (132 * index + 2)); };
  int changed = 0;
  int opaque = 0;
  for (int texel = 0; texel < 260 * 128; ++texel)
  {
    changed += std::memcmp(picture(2) + 4 * texel, picture(3) + 4 * texel, 4) != 0;
    opaque += picture(3)[4 * texel + 3] > 127;
  }
  std::cout << "of a picture, " << 100.0 * opaque / (260 * 128) << " % is leaf; from one to the next "
            << 100.0 * changed / (260 * 128) << " % changes\n";
  Expect(opaque > 260 * 128 / 4 && changed > 260 * 128 / 20, "pictures hold leaves that move");
  sway->SetTextureSize(32, 16);
}

/// Trees of a wood in full have trunks that go the same way as in the middle level, whose trunks at rest and swaying
/// are given.
void CheckTrunksInFull(vtkPlantScatterFilter* wood, vtkBeamTreeDeformationFilter* many,
  const std::vector<float>& straight, const std::vector<float>& trunks)
{
  wood->UseLevelsOff();
  many->UpdateTimeStep(2.0);
  double full[3];
  double cone[3];
  const std::vector<float> bones = PointsOf(wood->GetOutputDataObject(0), "High/Skeleton");
  auto* first = vtkPolyData::SafeDownCast(BlockAt(wood->GetOutputDataObject(0), "High/Skeleton"));
  vtkNew<vtkIdList> line;
  first->GetCellPoints(0, line);
  const std::size_t tip = static_cast<std::size_t>(line->GetId(line->GetNumberOfIds() - 1));
  const std::vector<float> bent = PointsOf(many->GetOutputDataObject(0), "High/Skeleton");
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    full[axis] = double(bent[3 * tip + axis]) - bones[3 * tip + axis];
  }
  const auto ofFirst = static_cast<std::ptrdiff_t>(straight.size() / 2);
  MeanShift({ straight.begin(), straight.begin() + ofFirst }, { trunks.begin(), trunks.begin() + ofFirst },
    bones[3 * tip + 2] - 0.05, bones[3 * tip + 2] + 0.05, cone);
  const double miss = std::hypot(full[0] - cone[0], full[1] - cone[1]);
  std::cout << "the tip of a scattered trunk goes " << std::hypot(full[0], full[1])
            << " m in full, in the middle level it differs by " << miss << " m\n";
  Expect(miss < 0.01 * std::hypot(full[0], full[1]), "a tree sways alike in both levels");
}

/// A forest in the middle level: with its prototypes it sways, without them it stands.
void CheckMediumForest(vtkReevesTreeSource* tree, WindSource* wind)
{
  vtkNew<vtkPoints> feet;
  feet->InsertNextPoint(3.0, 4.0, 50.0);
  feet->InsertNextPoint(23.0, -5.0, 60.0);
  const auto wood = WoodOf(feet, tree);
  wood->SetNearDistance(1.0);
  wood->SetFarDistance(1e4);
  wood->Update();
  const std::vector<float> standing = PointsOf(wood->GetOutputDataObject(0), "Medium/Crown");
  vtkNew<vtkBeamTreeDeformationFilter> many;
  many->SetTextureSize(32, 16);
  many->SetNumberOfTextures(2);
  many->SetInputConnection(wood->GetOutputPort());
  many->SetWindConnection(wind->GetOutputPort());
  many->UpdateTimeStep(2.0);
  Expect(PointsOf(many->GetOutputDataObject(0), "Medium/Crown") == standing, "without prototypes, crowns stand still");
  many->AddPrototypeConnection(tree->GetOutputPort());
  many->UpdateTimeStep(2.0);
  const std::vector<float> swaying = PointsOf(many->GetOutputDataObject(0), "Medium/Crown");
  const std::vector<float> trunks = PointsOf(many->GetOutputDataObject(0), "Medium/Trunk");
  Expect(standing.size() == 2 * PointsOf(tree->GetOutputDataObject(0), "Medium/Crown").size() &&
      Farthest(swaying, standing) > 0.005,
    "with them, they sway");
  const std::vector<float> straight = PointsOf(wood->GetOutputDataObject(0), "Medium/Trunk");
  Expect(Farthest(trunks, straight) > 0.002, "trunks sway");
  const std::size_t half = swaying.size() / 2;
  bool apart = false;
  for (std::size_t i = 0; i < half; ++i)
  {
    apart |= std::abs((swaying[i] - standing[i]) - (swaying[half + i] - standing[half + i])) > 1e-4;
  }
  Expect(apart, "crowns at two places sway differently");

  CheckTrunksInFull(wood, many, straight, trunks);

  wind->SetStrength(0.0);
  wood->UseLevelsOn();
  many->UpdateTimeStep(2.0);
  Expect(PointsOf(many->GetOutputDataObject(0), "Medium/Crown") == standing, "crowns stand still without wind");
  wind->SetStrength(8.0);

  wood->UseLevelsOff();
  vtkNew<ErrorCounter> errors;
  errors->Watch(many);
  many->AddPrototypeConnection(wood->GetOutputPort()); // two trunks
  Expect(errors->ExpectOneNaming("single plants"), "a forest is no prototype");
}

/// Cards of leaves go with the trunk as an envelope does, and keep their own picture and its mean.
void CheckCards(WindSource* wind)
{
  vtkNew<vtkReevesTreeSource> tree;
  tree->Update();
  vtkNew<vtkBeamTreeDeformationFilter> sway;
  sway->SetInputConnection(tree->GetOutputPort());
  sway->SetWindConnection(wind->GetOutputPort());
  sway->UpdateTimeStep(2.0);
  vtkDataObject* rest = tree->GetOutputDataObject(0);
  vtkDataObject* now = sway->GetOutputDataObject(0);
  const vtkIdType tip = TipOf(rest);
  const std::vector<float> a = PointsOf(rest, "High/Skeleton");
  const std::vector<float> b = PointsOf(now, "High/Skeleton");
  double mean[3];
  MeanShift(
    PointsOf(rest, "Medium/Crown"), PointsOf(now, "Medium/Crown"), a[3 * tip + 2] - 1.0, a[3 * tip + 2] + 1.0, mean);
  const double wanted[2] = { double(b[3 * tip]) - a[3 * tip], double(b[3 * tip + 1]) - a[3 * tip + 1] };
  const double apart = std::hypot(mean[0] - wanted[0], mean[1] - wanted[1]);
  const double length = std::hypot(wanted[0], wanted[1]);
  std::cout << "cards about the trunk's tip, which goes " << length << " m, differ by " << apart << " m\n";
  Expect(length > 0.002 && apart < 0.15 * length, "cards sway as the trunk does");

  auto* still = vtkPolyData::SafeDownCast(BlockAt(rest, "Medium/Crown"));
  auto* moved = vtkPolyData::SafeDownCast(BlockAt(now, "Medium/Crown"));
  Expect(moved->GetFieldData()->GetArray("TextureMean")->GetComponent(0, 0) ==
      still->GetFieldData()->GetArray("TextureMean")->GetComponent(0, 0),
    "cards keep the mean of their texture");
  const auto texelAt = [](vtkPolyData* crown, vtkIdType point) {
    vtkDataArray* size = crown->GetFieldData()->GetArray("TextureSize");
    vtkDataArray* places = crown->GetPointData()->GetTCoords();
    // About half of the way from a corner to the card's middle, within a texel.
    double at[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      const double corner = places->GetComponent(point, axis);
      const double middle = 0.5 * (corner + places->GetComponent(point + (point % 4 < 2 ? 2 : -2), axis));
      at[axis] = std::floor((0.45 * corner + 0.55 * middle) * size->GetTuple1(axis));
    }
    return crown->GetFieldData()->GetArray("Texture")->GetTuple4(
      static_cast<vtkIdType>(at[1] * size->GetTuple1(0) + at[0]));
  };
  int others = 0;
  for (vtkIdType point = 0; point < 400; ++point)
  {
    const double one = texelAt(still, point)[3];
    others += one != texelAt(moved, point)[3];
  }
  Expect(others == 0, "cards show their own tufts");
}

/// Pictures of crowns go with the wind, wherever it blows to: what a plant shows now, one downwind shows when the wind
/// has come to it, and one beside it shows at the same time.
void CheckArrival(vtkReevesTreeSource* tree)
{
  vtkNew<vtkWindFieldSource> wind;
  wind->SetDimensions(240, 8, 12);
  wind->SetWindDirection(90.0);
  wind->SetReferenceSpeed(8.0);
  vtkNew<vtkPoints> feet;
  feet->InsertNextPoint(0.0, 0.0, 0.0);
  feet->InsertNextPoint(0.0, 12.0, 0.0);
  feet->InsertNextPoint(9.0, 0.0, 0.0);
  const auto wood = WoodOf(feet, tree);
  wood->SetNearDistance(1.0);
  wood->SetFarDistance(1e4);
  vtkNew<vtkBeamTreeDeformationFilter> sway;
  sway->SetInputConnection(wood->GetOutputPort());
  sway->AddPrototypeConnection(tree->GetOutputPort());
  sway->SetWindConnection(wind->GetOutputPort());
  sway->SetTextureSize(32, 16);
  const auto pictures = [&](double time, std::size_t plant) {
    sway->UpdateTimeStep(time);
    const std::vector<float> all = TCoordsOf(sway->GetOutputDataObject(0));
    const auto third = static_cast<std::ptrdiff_t>(all.size() / 3);
    const auto first = all.begin() + third * static_cast<std::ptrdiff_t>(plant);
    return std::vector<float>(first, first + third);
  };
  int changes = 0;
  for (int k = 0; k < 12; ++k)
  {
    const double time = 0.0713 + 0.217 * k;
    const std::vector<float> now = pictures(time, 0);
    Expect(pictures(time + 12.0 / 8.0, 1) == now, "a crown downwind shows what the wind brought it");
    Expect(pictures(time, 2) == now, "crowns side by side in the wind show the same");
    changes += pictures(time, 1) != now;
  }
  Expect(changes > 3, "a crown downwind is in another phase");
}

/// With a coefficient as large as that of drag, an upright trunk goes as far to the right of the wind as along it.
void CheckLift(vtkBeamTreeDeformationFilter* sway, vtkDataObject* rest)
{
  constexpr std::size_t Joint = 12; // of the trunk
  const std::vector<float> still = PointsOf(rest, "High/Skeleton");
  const auto shift = [&](double lift) {
    sway->SetLiftCoefficient(lift);
    sway->UpdateTimeStep(2.0);
    const std::vector<float> now = PointsOf(sway->GetOutputDataObject(0), "High/Skeleton");
    return std::array<double, 2>{ double(now[3 * Joint]) - still[3 * Joint],
      double(now[3 * Joint + 1]) - still[3 * Joint + 1] };
  };
  for (int response : { 0, 1 })
  {
    sway->SetResponse(response);
    const std::array<double, 2> drag = shift(0.0);
    const std::array<double, 2> both = shift(1.1);
    const double miss = std::hypot(both[0] - drag[0] - drag[1], both[1] - drag[1] + drag[0]);
    std::cout << "response " << response << ": drag moves a joint by " << drag[0] << ", " << drag[1]
              << " m, lift turns that to the right within " << miss << " m\n";
    Expect(miss < 0.05 * std::hypot(drag[0], drag[1]), "lift is drag, turned to the right");
  }
  sway->SetLiftCoefficient(0.0);
  sway->SetResponseToInterpolated();
}

/// Everything of a wood that moves: the same on one and on two threads, all at once and in two pieces.
void CheckThreadsAndPieces(vtkReevesTreeSource* tree, WindSource* wind)
{
  vtkNew<vtkPoints> feet;
  for (int i = 0; i < 12; ++i)
  {
    feet->InsertNextPoint(7.0 * (i % 6), 7.0 * (i / 6) - 14.0, 10.0);
  }
  const auto wood = WoodOf(feet, tree);
  wood->SetViewPoint(0.0, -15.0, 12.0);
  wood->SetNearDistance(16.0);
  wood->SetFarDistance(500.0);
  struct Moved
  {
    std::vector<float> All;
    std::vector<float> Crowns;
    std::vector<float> Leaves;
  };
  const auto moved = [&](vtkBeamTreeDeformationFilter* sway, int threads, int piece, int pieces) {
    vtkSMPTools::Initialize(threads);
    sway->SetTextureSize(32, 16);
    sway->SetNumberOfTextures(2);
    sway->SetInputConnection(0, wood->GetOutputPort());
    sway->SetWindConnection(wind->GetOutputPort());
    sway->RemoveAllPrototypes();
    sway->AddPrototypeConnection(tree->GetOutputPort());
    sway->UpdateInformation();
    sway->GetOutputInformation(0)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), 3.3);
    sway->UpdatePiece(piece, pieces, 0);
    vtkDataObject* now = sway->GetOutputDataObject(0);
    return Moved{ AllPoints(now), PointsOf(now, "Medium/Crown"), PointsOf(now, "High/Leaves") };
  };
  vtkNew<vtkBeamTreeDeformationFilter> filters[4];
  const Moved one = moved(filters[0], 1, 0, 1);
  const Moved two = moved(filters[1], 2, 0, 1);
  Expect(one.All.size() > 1000 && two.All == one.All && one.Crowns.size() > 1000 && two.Crowns == one.Crowns,
    "same bytes on one and on two threads");
  Moved joined = moved(filters[2], 0, 0, 2);
  const Moved others = moved(filters[3], 0, 1, 2);
  joined.Crowns.insert(joined.Crowns.end(), others.Crowns.begin(), others.Crowns.end());
  Expect(!others.Crowns.empty() && joined.Crowns == one.Crowns, "two pieces are the whole");
  joined.Leaves.insert(joined.Leaves.end(), others.Leaves.begin(), others.Leaves.end());
  Expect(joined.Leaves == one.Leaves, "leaves of two pieces are the whole");
  Expect(moved(filters[3], 0, 0, 1).All == one.All, "a piece leaves nothing in the whole");
}

/// What an observer hears and does.
class Listener : public vtkCommand
{
public:
  static Listener* New() { return new Listener; }
  void Execute(vtkObject* caller, unsigned long, void* progress) override
  {
    ++this->Count;
    const double now = *static_cast<double*>(progress);
    this->Falls |= now < this->Last - 1e-12;
    this->Last = now;
    if (this->Stops)
    {
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    }
  }
  int Count = 0;
  double Last = 0.0;
  bool Falls = false;
  bool Stops = false;
};

void CheckProgressAndAbort(vtkBeamTreeDeformationFilter* sway, WindSource* wind)
{
  vtkNew<Listener> listener;
  wind->Modified();
  sway->AddObserver(vtkCommand::ProgressEvent, listener);
  sway->UpdateTimeStep(0.7);
  Expect(listener->Count > 4 && !listener->Falls && listener->Last == 1.0, "progress goes from start to end");
  const std::vector<float> right = AllPoints(sway->GetOutputDataObject(0));
  listener->Stops = true;
  wind->Modified();
  sway->UpdateTimeStep(0.7);
  sway->SetAbortExecute(0);
  sway->RemoveObserver(listener);
  sway->Modified();
  sway->UpdateTimeStep(0.7);
  Expect(AllPoints(sway->GetOutputDataObject(0)) == right, "after an abort all is made");
}

/// Plants that lack something, or say something that cannot be.
void CheckBadPlants(vtkBeamTreeDeformationFilter* sway, vtkReevesTreeSource* tree, ErrorCounter* errors)
{
  const auto complains = [&](const char* about, const std::function<void(vtkMultiBlockDataSet*)>& spoil) {
    vtkNew<vtkMultiBlockDataSet> plant;
    plant->DeepCopy(tree->GetOutputDataObject(0));
    spoil(plant);
    sway->SetInputDataObject(0, plant);
    Expect(errors->ExpectOneNaming(about), about);
  };
  const auto part = [](vtkMultiBlockDataSet* plant, const char* path) {
    return vtkPolyData::SafeDownCast(BlockAt(plant, path));
  };
  complains("no block High/Skeleton", [](vtkMultiBlockDataSet* plant) { plant->Initialize(); });
  complains("ParentId",
    [&](vtkMultiBlockDataSet* plant) { part(plant, "High/Skeleton")->GetPointData()->RemoveArray("ParentId"); });
  complains("Radius",
    [&](vtkMultiBlockDataSet* plant) { part(plant, "High/Skeleton")->GetPointData()->RemoveArray("Radius"); });
  complains("JointIds",
    [&](vtkMultiBlockDataSet* plant) { part(plant, "High/Skin")->GetPointData()->RemoveArray("JointIds"); });
  complains("JointIds of High/Leaves", [&](vtkMultiBlockDataSet* plant) {
    part(plant, "High/Leaves")->GetPointData()->GetArray("JointIds")->SetComponent(5, 0, 1e6);
  });
  complains("not finite", [&](vtkMultiBlockDataSet* plant) {
    part(plant, "High/Skeleton")->GetPoints()->SetPoint(7, 0.0, std::numeric_limits<double>::quiet_NaN(), 1.0);
  });
  complains("YoungModulus",
    [&](vtkMultiBlockDataSet* plant) { plant->GetFieldData()->GetArray("Wood")->SetComponent(0, 0, -1.0); });

  // A forest and prototypes that are not its own; more pictures than there is memory.
  vtkNew<vtkPoints> feet;
  feet->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkIntArray> species;
  species->SetName("Species");
  species->InsertNextValue(1);
  vtkNew<vtkPolyData> sites;
  sites->SetPoints(feet);
  sites->GetPointData()->AddArray(species);
  vtkNew<vtkPlantScatterFilter> wood;
  wood->SetInputData(sites);
  wood->AddPrototypeConnection(tree->GetOutputPort());
  wood->AddPrototypeConnection(tree->GetOutputPort());
  wood->UseCullingOff();
  sway->SetInputConnection(0, wood->GetOutputPort());
  sway->AddPrototypeConnection(tree->GetOutputPort());
  Expect(errors->ExpectOneNaming("Species"), "too few prototypes");
  sway->SetTextureSize(4096, 4096);
  sway->SetNumberOfTextures(16);
  for (int i = 0; i < 127; ++i)
  {
    sway->AddPrototypeConnection(tree->GetOutputPort());
  }
  Expect(errors->ExpectOneNaming("GiB of memory"), "too many pictures");
}

/// All points at a time [s].
std::vector<float> PointsAt(vtkBeamTreeDeformationFilter* sway, double time)
{
  sway->UpdateTimeStep(time);
  return AllPoints(sway->GetOutputDataObject(0));
}

/// An oak sways, the same at a time asked again or first, and repeats.
void CheckMotion(vtkBeamTreeDeformationFilter* sway, vtkReevesTreeSource* tree, WindSource* wind)
{
  vtkDataObject* rest = tree->GetOutputDataObject(0);
  for (const int response : { 0, 1 })
  {
    sway->SetResponse(response);
    const std::vector<float> first = PointsAt(sway, 1.3);
    const double far = Farthest(first, AllPoints(rest));
    const double stretch = Stretch(rest, sway->GetOutputDataObject(0));
    std::cout << "response " << response << ": a point goes up to " << far << " m, segments change by " << stretch
              << " m\n";
    Expect(far > 0.02 && far < 3.0, "an oak sways, and not too much");
    Expect(stretch < 1e-6, "segments keep their lengths");
    const std::vector<float> second = PointsAt(sway, 4.7);
    Expect(Farthest(first, second) > 1e-3, "the plant moves with time");
    Expect(PointsAt(sway, 1.3) == first, "a time asked again gives the same bytes");
    Expect(Farthest(PointsAt(sway, 1.3 + Period), first) < 1e-4, "the motion repeats after the period");
    vtkNew<vtkBeamTreeDeformationFilter> other;
    other->SetTextureSize(32, 16);
    other->SetNumberOfTextures(2);
    other->SetInputConnection(tree->GetOutputPort());
    other->SetWindConnection(wind->GetOutputPort());
    other->SetResponse(response);
    other->UpdateTimeStep(4.7);
    Expect(AllPoints(other->GetOutputDataObject(0)) == second, "a time asked first gives the same bytes");
  }
  Expect(wind->Executions == 1, "the wind is asked once");
  Expect(Farthest(PointsOf(rest, "Low").empty() ? std::vector<float>{ 1.0f } : PointsOf(rest, "Low"),
           PointsOf(sway->GetOutputDataObject(0), "Low")) == 0.0,
    "Low stands still");
}

/// Without wind the plant is at rest, and soft wood keeps its lengths.
void CheckCalmAndSoftWood(vtkBeamTreeDeformationFilter* sway, vtkDataObject* rest, WindSource* wind)
{
  sway->SetResponseToInterpolated();
  wind->SetStrength(0.0);
  Expect(PointsAt(sway, 2.0) == AllPoints(rest), "no wind, rest pose exactly");
  wind->SetStrength(8.0);
  sway->WoodFromPlantsOff();
  sway->SetYoungModulus(1e8);
  Expect(PointsAt(sway, 2.0) != AllPoints(rest) && Stretch(rest, sway->GetOutputDataObject(0)) < 5e-6,
    "soft wood keeps lengths");
  sway->SetYoungModulus(9e9);
  sway->WoodFromPlantsOn();
}

/// A scattered wood: each plant in the wind where it stands.
void CheckWood(vtkBeamTreeDeformationFilter* sway, vtkReevesTreeSource* tree, WindSource* wind)
{
  vtkDataObject* rest = tree->GetOutputDataObject(0);
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(0.0, 0.0, 100.0);
  places->InsertNextPoint(37.0, 5.0, 120.0);
  vtkNew<vtkPolyData> sites;
  sites->SetPoints(places);
  vtkNew<vtkPlantScatterFilter> wood;
  wood->SetInputData(sites);
  wood->AddPrototypeConnection(tree->GetOutputPort());
  wood->UseLevelsOff();
  wood->UseCullingOff();
  sway->SetInputConnection(wood->GetOutputPort());
  wood->Update();
  const std::vector<float> standing = PointsOf(wood->GetOutputDataObject(0), "High/Skeleton");
  Expect(standing.size() == 2 * PointsOf(rest, "High/Skeleton").size(), "two plants in full");
  PointsAt(sway, 2.0);
  const std::vector<float> bent = PointsOf(sway->GetOutputDataObject(0), "High/Skeleton");
  const std::size_t half = bent.size() / 2;
  const auto shift = [&](std::size_t i) { return double(bent[i]) - standing[i]; };
  Expect(Farthest(bent, standing) > 0.02, "a wood sways");
  Expect(Stretch(wood->GetOutputDataObject(0), sway->GetOutputDataObject(0)) < 5e-5, "a wood keeps its lengths");
  Expect(std::abs(shift(3 * 12) - shift(half + 3 * 12)) > 1e-6, "plants at two places sway differently");
  wind->SetStrength(0.0);
  Expect(PointsAt(sway, 2.0) == AllPoints(wood->GetOutputDataObject(0)), "a wood without wind stands still exactly");
  wind->SetStrength(8.0);
  sway->SetInputConnection(tree->GetOutputPort());
}

/// One error for each property or wind that cannot be.
void CheckBadProperties(vtkBeamTreeDeformationFilter* sway, WindSource* wind, ErrorCounter* errors)
{
  const auto complains = [&](const char* about) { Expect(errors->ExpectOneNaming(about), about); };
  sway->SetNumberOfModes(11);
  complains("NumberOfModes");
  sway->SetNumberOfModes(1);
  sway->SetDampingRatio(std::numeric_limits<double>::quiet_NaN());
  complains("DampingRatio");
  sway->SetDampingRatio(0.08);
  sway->SetLiftCoefficient(11.0);
  complains("LiftCoefficient");
  sway->SetLiftCoefficient(0.0);
  wind->SetSide(100.0);
  complains("does not reach");
  wind->SetSide(-20.0);
  wind->SetStrength(std::numeric_limits<double>::quiet_NaN());
  complains("not finite");
  wind->SetStrength(8.0);
  wind->SetTop(4.0);
  complains("does not reach");
  wind->SetTop(17.0);
  wind->SetDuration(2);
  complains("duration");
  wind->SetDuration(Samples);
  wind->SetSpeed(0.0);
  complains("ConvectionSpeed");
  wind->SetSpeed(Convection);
  sway->SetNumberOfTextures(0);
  complains("NumberOfTextures");
  sway->SetNumberOfTextures(2);
  sway->SetTextureSize(256, 2);
  complains("TextureSize");
  sway->SetTextureSize(32, 16);
  sway->SetLeafFlutter(-0.1);
  complains("LeafFlutter");
  sway->SetLeafFlutter(1.0);
}

}

int TestBeamTreeDeformationFilter(int, char*[])
{
  vtkNew<vtkReevesTreeSource> tree;
  tree->SetMediumCrownToEnvelope();
  tree->SetTextureSize(32, 16);
  tree->Update();
  vtkDataObject* rest = tree->GetOutputDataObject(0);
  vtkNew<WindSource> wind;
  vtkNew<vtkBeamTreeDeformationFilter> sway;
  sway->SetTextureSize(32, 16); // small and few pictures cost less
  sway->SetNumberOfTextures(2);
  sway->SetInputConnection(tree->GetOutputPort());
  sway->SetWindConnection(wind->GetOutputPort());
  CheckMotion(sway, tree, wind);
  CheckCalmAndSoftWood(sway, rest, wind);
  CheckWood(sway, tree, wind);
  CheckLift(sway, rest);
  CheckFrequency(wind);
  sway->SetNumberOfTextures(8);
  CheckEnvelope(sway, tree);
  CheckPictures(sway);
  CheckMediumForest(tree, wind);
  sway->SetNumberOfTextures(2);
  CheckCards(wind);
  CheckArrival(tree);
  CheckThreadsAndPieces(tree, wind);
  CheckProgressAndAbort(sway, wind);

  vtkNew<ErrorCounter> errors;
  errors->Watch(sway);
  CheckBadProperties(sway, wind, errors);
  CheckBadPlants(sway, tree, errors);
  return Failures;
}
