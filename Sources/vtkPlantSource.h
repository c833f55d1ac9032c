// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlantSource
 * @brief   base class of the plant generators: one plant at three levels of detail
 *
 * Output 0: vtkMultiBlockDataSet with the blocks
 *
 * - `High`: `Skeleton` (a polyline per branch, which starts at a point of its parent; point arrays `ParentId`, the next
 *   node towards the root, -1 at the root, and `Radius` [m]; cell arrays `BranchId` and `Order`), `Skin` and `Leaves`
 *   (polygons);
 * - `Medium`: `Trunk`, the trunk and main limbs, and `Crown`: textured cards, each with a tuft that stands for many
 *   leaves, or a closed envelope with a cylindrical picture of the crown, see MediumCrown;
 * - `Low`: exactly four textured rectangles, three upright ones that cross in the axis and a flat one, with pictures of
 *   the plant in full. vtkPlantScatterFilter shows a far plant as one rectangle that faces the camera instead.
 *
 * Coordinates are in meters with z up and the foot of the plant at the origin. All blocks have point normals and the
 * point scalars `RGB`; `Skin` and `Leaves` have the skinning arrays `JointIds`[4] (nodes of `Skeleton`) and
 * `JointWeights`[4].
 *
 * `Leaves`, `Crown` and `Low` carry their textures as field data: `Texture` (RGBA bytes, rows from below) and
 * `TextureSize` (columns, rows); `Crown` and `Low` also `TextureMean` (3 numbers up to 1). A renderer draws RGB * texel
 * / TextureMean (without a mean: RGB * texel), and nothing where the texel's alpha is below a half; so the colors are
 * right without textures too. `Low` has in addition `NormalTexture` (RGB bytes, n / 2 + 1/2, in the frame of the
 * texture: along u, along v, towards the viewer), and, for the pictures from other directions that its texture holds,
 * `ImpostorExtent` (radius, lowest and highest z of the plant [m]) and `ImpostorAreas` (covered area of each picture
 * [m2]).
 *
 * Output 1: vtkImageData, the texture of `Crown`: two tufts of leaves side by side, or the crown as seen by a camera
 * that circles the plant (Setas et al., section 4.1.2). Output 2: vtkImageData, the texture of a leaf. Both can be
 * connected to a vtkTexture.
 *
 * The sizes of both textures are announced with the information of output 0, by the key TEXTURE_SIZES().
 *
 * A plant is not divided into pieces: the first piece holds all of it. A parameter out of range is reported as one
 * error, and the outputs stay empty.
 */
#ifndef vtkPlantSource_h
#define vtkPlantSource_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <array> // for the size of a picture

class vtkInformationDataObjectMetaDataKey;

namespace littoral
{
struct PlantLevelOptions;
struct PlantPrototype;
}

class LITTORALSOURCES_EXPORT vtkPlantSource : public vtkMultiBlockDataSetAlgorithm
{
public:
  vtkTypeMacro(vtkPlantSource, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  /// Sizes of the textures that the blocks of a plant will carry, before any data are made: a vtkDataObject whose field
  /// arrays `Crown` and `Leaves` hold columns and rows [texels]. The pipeline copies it to all filters downstream.
  static vtkInformationDataObjectMetaDataKey* TEXTURE_SIZES();

  ///@{
  /**
   * Seed of the random numbers, any integer; default 1. Another seed gives another individual of the same kind.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  enum MediumCrownType
  {
    Leaves = 0,
    Envelope = 1
  };

  ///@{
  /**
   * Crown of the level Medium: Leaves, cards with tufts of leaves that cover as much and have the
   * same mean color as the crown in full; or Envelope, a closed surface with a picture of the crown, on which
   * vtkBeamTreeDeformationFilter shows the moving crown (Setas et al., section 4.2). Default Leaves. Has no effect on
   * seaweed.
   */
  vtkSetMacro(MediumCrown, int);
  vtkGetMacro(MediumCrown, int);
  void SetMediumCrownToLeaves() { this->SetMediumCrown(Leaves); }
  void SetMediumCrownToEnvelope() { this->SetMediumCrown(Envelope); }
  ///@}

  ///@{
  /**
   * Columns and rows of the crown texture [texels], each 4 to 4096; default 256 128. Of an envelope, around the plant
   * and upwards.
   */
  vtkSetVector2Macro(TextureSize, int);
  vtkGetVector2Macro(TextureSize, int);
  ///@}

  ///@{
  /**
   * Maximum inward displacement of the vertices of the Medium crown's envelope, as a fraction of their radius, 0 to
   * 0.9; default 0. Values above 0 give a rougher outline where High is never shown.
   */
  vtkSetMacro(CrownJitter, double);
  vtkGetMacro(CrownJitter, double);
  ///@}

protected:
  vtkPlantSource();
  ~vtkPlantSource() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Generates the plant at all levels of detail. Throws littoral::InvalidInput if a parameter is out of range.
  virtual littoral::PlantPrototype Grow(const littoral::PlantLevelOptions& options) = 0;

  /// Columns and rows of the leaf texture [texels].
  virtual std::array<int, 2> LeafTextureSize() const;

  int Seed;
  int MediumCrown;
  int TextureSize[2];
  double CrownJitter;

private:
  vtkPlantSource(const vtkPlantSource&) = delete;
  void operator=(const vtkPlantSource&) = delete;

  littoral::PlantLevelOptions MakeOptions();
};

#endif
