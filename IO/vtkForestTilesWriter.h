// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkForestTilesWriter
 * @brief   write a forest as 3D Tiles 1.1 on its place on earth
 *
 * The input is a forest as instances: output 0 of vtkPlantScatterFilter with OutputForm Instances, and with UseCulling
 * off, so that all trees are there. CesiumJS, and other programs that know the extension EXT_mesh_gpu_instancing, show
 * it on the earth and load what is seen.
 *
 * Written are FileName (.json), the tileset, and beside it a folder named like it, by its content: tiles (.glb), places
 * of trees (.bin) that several tiles share, and the prototypes of each level (.bin) that all tiles share. The tiles are
 * a quadtree over the feet whose halves have as many trees; children replace their parent. Finest tiles have at most
 * TreesPerTile trees, as High; those above them the same trees as Medium, then as Low; and further up each tile has a
 * quarter of the trees of its children, as Low and twice as wide, so that they cover as much ground. A file of places
 * has 32 bytes a tree: translation, scales, and, where all trees are shown, a rotation in 16 bits. Tints are left out,
 * as no program shows them.
 *
 * The geometric error of a tile [m] is 0 for High; for Medium and Low e = d 2 tan(30 degrees) 16 / 1080 with d =
 * NearDistance and FarDistance, so that they give way at these distances where a viewer allows 16 pixels of 1080 in a
 * view of 60 degrees, as CesiumJS does; and where each s-th of n trees on an area A is shown, sqrt(s A / n) if that is
 * more.
 *
 * The place is that of the input's field data `CoordinateSystem`, `CoordinateUnit` and `CoordinateOffset`, which
 * vtkPlantScatterFilter passes on from its terrain or its sites, or of CoordinateSystem: PROJ takes the position of
 * each tree to longitude and latitude on WGS 84, and its height, plus HeightOffset, is that above the ellipsoid. Each
 * file of places has level axes of its own at its middle, with x along the x of the map: trees are upright, and
 * translations, in single precision, are within 0.1 mm up to a distance of 1.6 km. Trees keep their sizes, whatever the
 * scale of the map is.
 *
 * The files are written under other names and renamed when all are complete; the tileset comes last. On failure, an
 * existing tileset of this name is unchanged, one error tells why, and Write() returns 0. An older folder of this name
 * goes. The same input gives the same bytes. On several ranks the first one gathers the trees of all.
 *
 * @sa vtkGLTFSceneWriter vtkPlantScatterFilter
 */
#ifndef vtkForestTilesWriter_h
#define vtkForestTilesWriter_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkSingleFileWriter.h"

#include <string> // for the coordinate system

class vtkMultiBlockDataSet;

class LITTORALIO_EXPORT vtkForestTilesWriter : public vtkSingleFileWriter
{
public:
  static vtkForestTilesWriter* New();
  vtkTypeMacro(vtkForestTilesWriter, vtkSingleFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Projection of the positions, a code as `EPSG:32632`, WKT or a PROJ string; default ``, that of the input.
   */
  vtkSetMacro(CoordinateSystem, std::string);
  vtkGetMacro(CoordinateSystem, std::string);
  ///@}

  ///@{
  /**
   * Easting and northing of the origin of the positions [m], used with CoordinateSystem; default 0 0.
   */
  vtkSetVector2Macro(CoordinateOffset, double);
  vtkGetVector2Macro(CoordinateOffset, double);
  ///@}

  ///@{
  /**
   * Height of the zero of heights above the ellipsoid of WGS 84 [m], -1e4 to 1e4; default 0. For heights above the sea
   * it is the geoid's.
   */
  vtkSetMacro(HeightOffset, double);
  vtkGetMacro(HeightOffset, double);
  ///@}

  ///@{
  /**
   * Most trees of a finest tile, 1 to 65536; default 1024. A tile is shown as a whole: where it has fewer trees, fewer
   * are drawn in full near the eye, and there are more tiles.
   */
  vtkSetMacro(TreesPerTile, int);
  vtkGetMacro(TreesPerTile, int);
  ///@}

  ///@{
  /**
   * Distance of a tile up to which its trees are in full, above 0 [m]; default 30.
   */
  vtkSetMacro(NearDistance, double);
  vtkGetMacro(NearDistance, double);
  ///@}

  ///@{
  /**
   * Distance of a tile up to which its trees are Medium, not below NearDistance [m]; default 130.
   */
  vtkSetMacro(FarDistance, double);
  vtkGetMacro(FarDistance, double);
  ///@}

protected:
  vtkForestTilesWriter();
  ~vtkForestTilesWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteInput() override;
  vtkSmartPointer<vtkDataObject> GatherInput(vtkDataObject* own) override;

private:
  vtkForestTilesWriter(const vtkForestTilesWriter&) = delete;
  void operator=(const vtkForestTilesWriter&) = delete;

  std::string CoordinateSystem;
  double CoordinateOffset[2] = { 0.0, 0.0 };
  double HeightOffset = 0.0;
  int TreesPerTile = 1024;
  double NearDistance = 30.0;
  double FarDistance = 130.0;
};

#endif
