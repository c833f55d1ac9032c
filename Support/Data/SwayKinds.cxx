// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/SwayKinds.h"

#include "Data/PlantForm.h"
#include "Data/SwayPrototype.h"
#include "Data/WindImage.h"
#include "Numerics/InvalidInput.h"
#include "Pipeline/Memory.h"
#include "Pipeline/Pipeline.h"
#include "Sway/CrownPictures.h"
#include "Sway/SwayScene.h"

#include "vtkMultiBlockDataSet.h"

#include <algorithm>

namespace littoral
{

namespace
{

/// Reads the prototypes of a scattered forest, or a plant that is its own.
std::vector<SwayPrototype> ReadPrototypes(
  const std::vector<vtkMultiBlockDataSet*>& plants, const SwaySettings& settings, bool areScattered)
{
  std::vector<SwayPrototype> read(plants.size());
  const auto readAll = [&] {
    for (std::size_t index = 0; index < read.size(); ++index)
    {
      if (areScattered)
      {
        RequirePlants(plants[index]);
      }
      read[index].Read(plants[index], settings);
      Require(areScattered && read[index].Species.Rest.Nodes.empty()
          ? "there is no block High/Skeleton, as plants have."
          : "");
    }
  };
  InContext(areScattered ? "Of Prototypes: " : "", readAll);
  return read;
}

/// Pictures of all species; still ones, of the announced size, where there is no species.
std::vector<TextureImage> PicturesOf(
  const SwayScene& scene, const std::vector<SwayPrototype>& prototypes, vtkImageData* wind, vtkAlgorithm* progress)
{
  const SwaySettings& settings = scene.GetSettings();
  const auto each = static_cast<std::size_t>(settings.Pictures);
  std::vector<TextureImage> pictures(each * std::max<std::size_t>(1, prototypes.size()));
  RunWithProgress(progress, prototypes.size(), 0.0, 0.3, [&](std::size_t index) {
    const SwaySpecies& species = scene.GetSpecies()[index];
    int node = 0;
    const double height = species.Rest.Nodes.empty() ? 0.0 : species.Rest.Along(0, 0.75, node).z;
    std::vector<TextureImage> own =
      CrownPictures(species, prototypes[index].MakeCrown(), scene.GetWind(), MiddleOfWind(wind, height), settings);
    std::move(own.begin(), own.end(), pictures.begin() + static_cast<std::ptrdiff_t>(index * each));
  });
  for (TextureImage& picture : pictures)
  {
    if (picture.Texels.empty())
    {
      picture = TextureImage(settings.TextureSize[0], settings.TextureSize[1]);
    }
  }
  return pictures;
}

}

//----------------------------------------------------------------------------
void RequireMemoryToSway(double bytes)
{
  RequireMemory(bytes, "The motion of the plants",
    "take fewer plants in full, fewer modes, Response Interpolated, or fewer and smaller pictures");
}

//----------------------------------------------------------------------------
void SwayKinds::Read(const std::vector<vtkMultiBlockDataSet*>& prototypes, bool areScattered, vtkImageData* wind,
  const SwaySettings& settings, vtkAlgorithm* progress)
{
  this->Wind = ReadWind(wind);
  const std::vector<SwayPrototype> read = ReadPrototypes(prototypes, settings, areScattered);
  for (const SwayPrototype& prototype : read)
  {
    this->Species.push_back(prototype.Species);
  }
  const double texels =
    static_cast<double>(read.size()) * settings.Pictures * settings.TextureSize[0] * settings.TextureSize[1];
  RequireMemoryToSway(2.0 * sizeof(Texel) * texels);
  const SwayScene scene(settings, this->Wind, {}, this->Species);
  std::vector<TextureImage> pictures = PicturesOf(scene, read, wind, progress);
  std::vector<ColorSum> means(pictures.size(), ColorSum{ 1.0f, 1.0f, 1.0f });
  for (std::size_t index = 0; index < pictures.size() && !read.empty(); ++index)
  {
    means[index] = ReadTextureMean(read[index / static_cast<std::size_t>(settings.Pictures)].Crown);
  }
  const ColorSum mean = ShareMean(pictures, means);
  const TextureAtlas atlas = StackTextures(pictures);
  this->Areas = atlas.Areas;
  this->PictureImage = vtkSmartPointer<vtkImageData>::New();
  CopyToImage(atlas.Image, this->PictureImage);
  this->PictureFields = vtkSmartPointer<vtkPolyData>::New();
  AttachTexture(this->PictureFields, atlas.Image);
  AttachTextureMean(this->PictureFields, mean);
}

//----------------------------------------------------------------------------
const ScatterPrototypes& SwayKinds::SurfacesOf(const std::vector<vtkMultiBlockDataSet*>& prototypes)
{
  Require(prototypes.empty() ? "connect the Prototypes that the plants were made from, or switch on PassSurfaces where "
                               "they are scattered: the plants have no surfaces."
                             : "");
  if (this->Surfaces.Parts.empty())
  {
    std::vector<PrototypeBlocks> blocks;
    for (vtkMultiBlockDataSet* prototype : prototypes)
    {
      blocks.push_back(PartsOf(prototype));
      InContext("Of Prototypes: ", [&] { RequirePrototype(blocks.back()); });
    }
    TakeParts(blocks, false, this->Surfaces);
  }
  return this->Surfaces;
}

}
