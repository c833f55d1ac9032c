// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// A walk towards oaks, through the distances at which impostors are exchanged for oaks in full: from picture to picture
// little changes but by the motion, which enlarges the picture.
#include "ImpostorWood.h"
#include "InstanceMapper.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace
{

constexpr double Step = 0.12;                   // of the walk from picture to picture [m]
constexpr double FadeRange[2] = { 48.0, 64.0 }; // distances of the oaks [m]

/// Points of oaks as of vtkPlantScatterFilter.
vtkSmartPointer<vtkPolyData> Places()
{
  vtkNew<vtkPoints> places;
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(places);
  const auto add = [&points](const char* name, int components) {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    points->GetPointData()->AddArray(array);
    return array.Get();
  };
  vtkFloatArray* prototypes = add("Prototype", 1);
  vtkFloatArray* rotations = add("Rotation", 4);
  vtkFloatArray* scales = add("Scale", 1);
  vtkFloatArray* tints = add("Tint", 3);
  vtkFloatArray* fades = add("Fades", 1);
  for (int oak = 0; oak < Oaks; ++oak)
  {
    const double half = vtkMath::RadiansFromDegrees(0.5 * Turns[oak]);
    places->InsertNextPoint(9.0 * (oak - 0.5 * (Oaks - 1)), 0.0, 0.0);
    prototypes->InsertNextValue(1.0F);
    rotations->InsertNextTuple4(std::cos(half), 0.0, 0.0, std::sin(half));
    scales->InsertNextValue(0.8F);
    tints->InsertNextTuple3(0.9, 1.0, 0.9);
    fades->InsertNextValue(1.0F);
  }
  return points;
}

/// Oaks in full, as instances in a view of ParaView.
void AddFull(Picture& picture, const std::vector<vtkSmartPointer<vtkActor>>& parts, vtkPolyData* places)
{
  for (vtkActor* part : parts)
  {
    vtkNew<vtkPolyData> block;
    block->ShallowCopy(vtkPolyDataMapper::SafeDownCast(part->GetMapper())->GetInput());
    vtkNew<vtkFloatArray> index;
    index->SetName("Prototype");
    index->InsertNextValue(1.0F);
    block->GetFieldData()->AddArray(index);
    vtkNew<littoral::InstanceMapper> mapper;
    mapper->SetInputData(block);
    mapper->SetInstances(littoral::BatchOf({ places, block }));
    mapper->SetFadeRange(FadeRange[0], FadeRange[1]);
    part->SetMapper(mapper);
    picture.Renderer->AddActor(part);
  }
}

/// Number of a byte of a picture between its pixels.
double Between(const std::vector<unsigned char>& picture, double x, double y, int channel)
{
  const int column = std::clamp(static_cast<int>(x), 0, Width - 2);
  const int row = std::clamp(static_cast<int>(y), 0, Height - 2);
  const double right = x - column;
  const double up = y - row;
  const auto at = [&](int c, int r) { return static_cast<double>(picture[4 * (r * Width + c) + channel]); };
  return (1.0 - up) * ((1.0 - right) * at(column, row) + right * at(column + 1, row)) +
    up * ((1.0 - right) * at(column, row + 1) + right * at(column + 1, row + 1));
}

/// A picture, and where it shows oaks.
struct Shot
{
  std::vector<unsigned char> Pixels;
  std::vector<bool> AreOaks;
};

/// Pixels by their change [1/255].
using Counts = std::vector<double>;

double MeanOf(const Counts& counts)
{
  double all = 0.0;
  double sum = 0.0;
  for (std::size_t change = 0; change < counts.size(); ++change)
  {
    all += counts[change];
    sum += static_cast<double>(change) * counts[change];
  }
  return sum / all;
}

/// The least change that all but a hundredth of the pixels do not exceed.
std::size_t HighOf(const Counts& counts)
{
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  double below = counts[0];
  std::size_t change = 0;
  while (below < 0.99 * all)
  {
    below += counts[++change];
  }
  return change;
}

/// What changed from a picture to the next, which is larger by a factor, where there is an oak or everywhere.
Counts ChangesOf(const Shot& last, const Shot& next, double larger, bool areOaks)
{
  Counts counts(256);
  for (int row = 2; row < Height - 2; ++row)
  {
    for (int column = 2; column < Width - 2; ++column)
    {
      const double x = 0.5 * (Width - 1) + (column - 0.5 * (Width - 1)) / larger;
      const double y = 0.5 * (Height - 1) + (row - 0.5 * (Height - 1)) / larger;
      const int pixel = row * Width + column;
      if (areOaks && !next.AreOaks[pixel] && !last.AreOaks[pixel])
      {
        continue;
      }
      double change = 0.0;
      for (int channel = 0; channel < 3; ++channel)
      {
        change += std::abs(next.Pixels[4 * pixel + channel] - Between(last.Pixels, x, y, channel)) / 3.0;
      }
      counts[static_cast<std::size_t>(change + 0.5)] += 1.0;
    }
  }
  return counts;
}

/// A view of oaks and their impostors.
struct Walk : Picture
{
  vtkNew<vtkImpostorMapper> Impostors;

  Walk()
  {
    vtkNew<vtkReevesTreeSource> oak;
    const auto places = Places();
    for (vtkActor* part : PartsOf(oak))
    {
      this->Impostors->AddPart(part);
    }
    this->Impostors->SetInputData(places);
    this->Impostors->SetFadeRange(FadeRange);
    vtkNew<vtkActor> actor;
    actor->SetMapper(this->Impostors);
    this->Renderer->AddActor(actor);
    AddFull(*this, PartsOf(oak), places);
    this->Pass->SetQualityToBest();
    this->Pass->FilmCurveOn();
    this->Pass->SetMapSize(512);
  }

  Shot From(double away)
  {
    this->Look({ 0.0, -away, 5.0 }, { 0.0, 0.0, 5.0 }, { 0.0, 0.0, 1.0 });
    this->Draw();
    const unsigned char* first = this->Pixels->GetPointer(0);
    Shot shot{ { first, first + this->Pixels->GetNumberOfValues() }, {} };
    vtkNew<vtkFloatArray> depths;
    this->Window->GetZbufferData(0, 0, Width - 1, Height - 1, depths);
    for (vtkIdType pixel = 0; pixel < depths->GetNumberOfValues(); ++pixel)
    {
      shot.AreOaks.push_back(depths->GetValue(pixel) < 0.99999F); // the sky is farther
    }
    return shot;
  }
};

/// Changes of all pixels of a walk are small, and oaks do not pop: no step changes much more of them than others do.
bool TestWalk(int pictures)
{
  Walk walk;
  double away = 0.5 * (FadeRange[0] + FadeRange[1]) + 0.5 * Step * pictures;
  Shot last = walk.From(away);
  Counts all(256);
  Counts ofOaks(256);
  double largest = 0.0;
  for (int picture = 1; picture < pictures; ++picture)
  {
    away -= Step;
    const Shot next = walk.From(away);
    const Counts changes = ChangesOf(last, next, (away + Step) / away, false);
    const Counts changesOfOaks = ChangesOf(last, next, (away + Step) / away, true);
    largest = std::max(largest, MeanOf(changesOfOaks));
    std::transform(all.begin(), all.end(), changes.begin(), all.begin(), std::plus<>());
    std::transform(ofOaks.begin(), ofOaks.end(), changesOfOaks.begin(), ofOaks.begin(), std::plus<>());
    last = next;
  }
  const double mean = MeanOf(all);
  std::cout << "Changes: mean " << mean << ", 99th percentile " << HighOf(all) << "; of oaks: mean " << MeanOf(ofOaks)
            << ", 99th percentile " << HighOf(ofOaks) << ", largest mean of a step " << largest << "\n";
  bool good = Check(mean > 0.1 && mean <= 2.0 && HighOf(all) <= 24, "Pictures change by more than the motion.");
  return good & Check(largest < 1.6 * MeanOf(ofOaks), "Oaks pop: a step changes " + std::to_string(largest));
}

}

int TestImpostorWalk(int argc, char* argv[])
{
  const bool isLong = argc > 1 && std::string(argv[argc - 1]) == "--long";
  return TestWalk(isLong ? 200 : 30) ? EXIT_SUCCESS : EXIT_FAILURE;
}
