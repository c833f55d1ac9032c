// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Impostors of an oak beside the oak in full, from directions off the grid of their pictures: the same silhouettes, the
// same light at three hours, and the same area at any distance.
#include "ImpostorWood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

namespace
{

constexpr double Elevations[] = { -8.0, -2.0, 4.0, 10.0, 17.0, 26.0, 38.0, 50.0, 63.0, 77.0 }; // of four oaks each

/// Intersection over union of what covers half of a pixel or more, by 9 samples a pixel.
double OverlapOf(const std::vector<double>& a, const std::vector<double>& b)
{
  double both = 0.0;
  double either = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    both += a[k] >= 0.5 && b[k] >= 0.5;
    either += a[k] >= 0.5 || b[k] >= 0.5;
  }
  return both / either;
}

bool TestSilhouettes(Pair& pair, const std::vector<double>& elevations)
{
  double mean = 0.0;
  double least = 1.0;
  for (const double elevation : elevations)
  {
    for (Row* row : pair.Both())
    {
      row->SetShadows(false);
      row->Resize(3 * 64);
      row->LookFrom(elevation);
    }
    const double overlap = OverlapOf(pair.High.Covered(3), pair.Impostors.Covered(3));
    mean += overlap / static_cast<double>(elevations.size());
    least = std::min(least, overlap);
  }
  std::cout << "Silhouettes overlap by " << mean << ", at least by " << least << " of an elevation\n";
  return Check(mean >= 0.9 && least > 0.88, "Silhouettes overlap by " + std::to_string(mean));
}

/// The light at three hours, with shadows and what is open to the sky.
bool TestHours(Pair& pair)
{
  bool good = true;
  for (const auto& hour : { std::array<double, 2>{ 60.0, 180.0 }, { 25.0, 100.0 }, { 10.0, 250.0 } })
  {
    double mean[2] = { 0.0, 0.0 };
    for (const double elevation : Elevations)
    {
      for (Row* row : pair.Both())
      {
        row->SetShadows(true);
        row->Resize(64);
        row->Pass->SetSunElevation(hour[0]);
        row->Pass->SetSunAzimuth(hour[1]);
        row->LookFrom(elevation);
        mean[row == &pair.Impostors] += row->MeanLuminance() / std::size(Elevations);
      }
    }
    const double ratio = mean[1] / mean[0];
    std::cout << "Luminance with the sun at " << hour[0] << " degrees: " << ratio << "\n";
    good &= Check(mean[0] > 0.01 && std::abs(ratio - 1.0) <= 0.03,
      "Impostors are " + std::to_string(ratio) + " as bright with the sun at " + std::to_string(hour[0]) + " degrees.");
  }
  return good;
}

/// Area of the crown in a picture of about a size, in pixels of the largest one. Of small pictures, whose pixels hit
/// leaves by chance, the mean of three.
double AreaOf(Row& row, int pixels, double elevation)
{
  const int others = pixels <= 32 ? 1 : 0;
  double area = 0.0;
  for (int size = pixels - others; size <= pixels + others; ++size)
  {
    row.Resize(size);
    row.LookFrom(elevation, true);
    const std::vector<double> there = row.Covered(1);
    const double scale = row.Rows / 288.0;
    area += std::accumulate(there.begin(), there.end(), 0.0) / (scale * scale);
  }
  return area / (1 + 2 * others);
}

/// The area of the crown from near and far, in full and as impostors: that of the crown in full at its largest.
bool TestCoverage(Pair& pair)
{
  bool good = true;
  double whole = 0.0;
  for (const double scale : { 1.0, 0.5, 0.25, 0.125, 0.0625 })
  {
    double areas[2] = { 0.0, 0.0 };
    for (const double elevation : { 5.0, 20.0, 45.0 })
    {
      for (Row* row : pair.Both())
      {
        row->SetShadows(false);
        areas[row == &pair.Impostors] += AreaOf(*row, static_cast<int>(256 * scale), elevation);
      }
    }
    whole = scale == 1.0 ? areas[0] : whole;
    std::cout << "Areas at a scale of " << scale << ": " << areas[0] / whole << " " << areas[1] / whole << "\n";
    good &= Check(std::abs(areas[0] / whole - 1.0) <= 0.03 && std::abs(areas[1] / whole - 1.0) <= 0.03,
      "At a scale of " + std::to_string(scale) + " the oak covers " + std::to_string(areas[0] / whole) +
        " of its area, its impostors " + std::to_string(areas[1] / whole));
  }
  return good;
}

/// Sizes that are rounded, the memory that they take, and what there is nothing of.
bool TestSizes(vtkReevesTreeSource* oak)
{
  Row row;
  row.Resize(32);
  vtkSmartPointer<vtkImpostorMapper> mapper = row.AddImpostors(oak);
  mapper->SetFrames(4);
  mapper->SetFrameSize(33);
  bool good = Check(mapper->GetFrames() == 5 && mapper->GetFrameSize() == 32, "Sizes are not rounded.");
  // 32, 16 and 8 texels a side
  good &= Check(mapper->GetAtlasBytes() == 9 * 25 * (1024 + 256 + 64), "The atlas has a size of its own.");
  const double* bounds = mapper->GetBounds();
  good &= Check(std::abs(bounds[1] - bounds[0] - 3.0 * 2.25 * row.Radius) < 2.1 * row.Radius, "Bounds are wrong.");
  row.LookFrom(10.0);
  const auto count = [&row] {
    const std::vector<double> there = row.Covered(1);
    return std::accumulate(there.begin(), there.end(), 0.0);
  };
  good &= Check(count() > 500.0, "Impostors of few pictures are not there.");
  mapper->RemoveAllParts();
  good &= Check(count() == 0.0, "Impostors of nothing are there.");
  return good;
}

}

/// With the argument brief, where a driver draws them in another way, their places, from two elevations.
int TestLandscapeImpostors(int argc, char* argv[])
{
  vtkNew<vtkReevesTreeSource> oak;
  Pair pair(oak);
  if (argc > 1 && std::string(argv[1]) == "brief")
  {
    return TestSilhouettes(pair, { 4.0, 38.0 }) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  bool good = TestSizes(oak);
  good &= TestSilhouettes(pair, { std::begin(Elevations), std::end(Elevations) });
  good &= TestCoverage(pair);
  good &= TestHours(pair);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
