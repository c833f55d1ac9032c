// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlantSource
 * @brief   base of the plant generators: one plant at three levels of detail
 *
 * Output 0: vtkMultiBlockDataSet with the blocks
 *
 * - `High`: `Skeleton` (polylines, a branch each, its first point on the parent; point arrays `ParentId`, the node
 *   towards the root, -1 at the root, and `Radius` [m]; cell arrays `BranchId` and `Order`), `Skin` and `Leaves`
 *   (polygons);
 * - `Medium`: `Trunk`, a cone, and `Crown`, a closed envelope with texture coordinates by cylindrical projection;
 * - `Low`: exactly four untextured polygons.
 *
 * Points are in metres with z up, the plant's foot at the origin. All blocks have `RGB` as point scalars and normals;
 * Skin and Leaves have `JointIds`[4] (nodes of Skeleton) and `JointWeights`[4].
 *
 * Output 1: the picture of the crown, RGBA, as seen by an eye that circles around it (Setas et al., section 4.1.2);
 * it is transparent where there is no leaf. Output 2: the picture on a leaf, to be multiplied with its color. Both can
 * be connected to a vtkTexture. They also travel as field data `Texture` and `TextureSize` of Crown and Leaves.
 *
 * The sizes of both pictures are announced with the information of output 0, by the key TEXTURE_SIZES().
 *
 * A plant has no pieces: the first piece holds all of it.
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

  /// Sizes of the textures that the blocks of a plant will carry, before any data are made: a vtkDataObject whose field
  /// arrays `Crown` and `Leaves` hold columns and rows [texels]. The pipeline copies it to all filters downstream.
  static vtkInformationDataObjectMetaDataKey* TEXTURE_SIZES();

  ///@{
  /// Any whole number; another seed gives another individual of the same kind. Default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// Columns and rows of the crown's picture, around the plant and upwards [texels], each from 4 to 4096. Default 256
  /// 128.
  vtkSetVector2Macro(TextureSize, int);
  vtkGetVector2Macro(TextureSize, int);
  ///@}

  ///@{
  /// By how much of its radius a vertex of the Medium crown lies further in at most, 0 to 0.9. Some is good where High
  /// is never shown. Default 0.
  vtkSetMacro(CrownJitter, double);
  vtkGetMacro(CrownJitter, double);
  ///@}

protected:
  vtkPlantSource();
  ~vtkPlantSource() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Grows the plant at all levels. False, with an error message, if a parameter is bad.
  virtual bool Grow(const littoral::PlantLevelOptions& options, littoral::PlantPrototype& prototype) = 0;

  /// Columns and rows of the picture on a leaf [texels].
  virtual std::array<int, 2> LeafTextureSize() const;

  int Seed;
  int TextureSize[2];
  double CrownJitter;

private:
  vtkPlantSource(const vtkPlantSource&) = delete;
  void operator=(const vtkPlantSource&) = delete;

  bool MakeOptions(littoral::PlantLevelOptions& options);
};

#endif
