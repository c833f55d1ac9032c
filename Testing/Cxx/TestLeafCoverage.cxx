// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// The area of an oak in full without mip levels, as ParaView shows merged plants: pixels hit leaves by chance, so that
// small pictures have noise but no bias.
#include "ImpostorWood.h"

#include "vtkActorCollection.h"
#include "vtkTexture.h"

#include <numeric>

namespace
{

void LeaveLevelsOut(vtkRenderer* renderer)
{
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    if (actor->GetTexture())
    {
      actor->GetTexture()->MipmapOff();
    }
  }
}

/// Area of the crowns from three elevations, over that of their pictures, in the mean of pictures of about a size.
double AreaOf(Row& row, int pixels, int others)
{
  double area = 0.0;
  for (int size = pixels - others; size <= pixels + others; ++size)
  {
    row.Resize(size);
    for (const double elevation : { 5.0, 20.0, 45.0 })
    {
      row.LookFrom(elevation, true);
      const std::vector<double> there = row.Covered(1);
      area += std::accumulate(there.begin(), there.end(), 0.0) / (row.Rows * row.Rows);
    }
  }
  return area / (1 + 2 * others);
}

}

//----------------------------------------------------------------------------
int TestLeafCoverage(int, char*[])
{
  vtkNew<vtkReevesTreeSource> oak;
  Row row;
  row.AddHigh(oak);
  row.SetShadows(false);
  LeaveLevelsOut(row.Renderer);
  const double whole = AreaOf(row, 256, 0);
  bool good = Check(whole > 0.5, "There is no crown.");
  for (const int pixels : { 128, 64, 32, 16 })
  {
    const double share = AreaOf(row, pixels, pixels > 32 ? 0 : 2) / whole;
    std::cout << "Area at " << pixels << " pixels: " << share << "\n";
    good &= Check(std::abs(share - 1.0) <= 0.03, "Without mip levels the oak covers " + std::to_string(share));
  }
  return good ? 0 : 1;
}
