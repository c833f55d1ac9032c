// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkElevationWriter
 * @brief   write an image of heights as a GeoTIFF in its place on earth
 *
 * The input is a vtkImageData of one layer with a scalar point array of heights [m] (SetInputArrayToProcess; default
 * `Elevation`, or else the active scalars). Each point becomes the center of a pixel, in single precision, or double
 * precision if the array has that. Heights that are not finite, and hidden points, become NaN, which the file names as
 * its value of no data. The first row is the northernmost. The file is cloud-optimized: blocks of at most 512 x 512
 * pixels, and overviews of half the size, the means of heights, until one is a block; BigTIFF where it may exceed 4 GB.
 *
 * Write() asks its input for rows of blocks, from the north, at most 32 MiB of heights at once or one row of blocks,
 * so that a source or filter that makes parts, as vtkElevationReader and vtkDrainageFilter with a TileSize, need not
 * have all in memory. The disk has room for the heights without compression, too, while the file is written.
 *
 * The place is that of the input's field data `CoordinateSystem`, `CoordinateUnit` and `CoordinateOffset`, as
 * vtkElevationReader and vtkTurningBandsTerrainSource set them, or CoordinateSystem. A file without either has
 * coordinates in metres and no coordinate system. Images turned in their plane are written as they are.
 *
 * It is written under another name in the same folder and renamed when it is complete. On failure, an existing file of
 * this name is unchanged, one error names file and reason, and Write() returns 0. The same input gives the same bytes.
 *
 * @sa vtkElevationReader
 */
#ifndef vtkElevationWriter_h
#define vtkElevationWriter_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkSingleFileWriter.h"

#include <string> // for the coordinate system

class vtkDataArray;
class vtkImageData;

namespace littoral
{
struct GeoTiffContent;
struct ImageParts;
}

class LITTORALIO_EXPORT vtkElevationWriter : public vtkSingleFileWriter
{
public:
  static vtkElevationWriter* New();
  vtkTypeMacro(vtkElevationWriter, vtkSingleFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum CompressionType
  {
    NoCompression = 0,
    Deflate = 1,
  };

  ///@{
  /**
   * Coordinate system of the input, as `EPSG:32632` or WKT, projected or local; default ``, the one in its field data.
   * It only names the system: nothing is projected.
   */
  vtkSetMacro(CoordinateSystem, std::string);
  vtkGetMacro(CoordinateSystem, std::string);
  ///@}

  ///@{
  /**
   * Compression of the file, a CompressionType; default Deflate. Both are lossless.
   */
  vtkSetMacro(Compression, int);
  vtkGetMacro(Compression, int);
  void SetCompressionToNoCompression() { this->SetCompression(NoCompression); }
  void SetCompressionToDeflate() { this->SetCompression(Deflate); }
  ///@}

  /**
   * Writes the file; 0 where that fails, after a message.
   */
  int Write() override;

protected:
  vtkElevationWriter();
  ~vtkElevationWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteInput() override;
  void WriteTogether(vtkDataObject* own) override;

private:
  vtkElevationWriter(const vtkElevationWriter&) = delete;
  void operator=(const vtkElevationWriter&) = delete;

  std::string WhyInvalid() const;
  /// Heights to write. Throws littoral::InvalidInput, as do the next two.
  vtkDataArray* FindHeights(vtkImageData* image);
  /// Positions of the points, in units of the coordinate system, of which an image has a part.
  void SetPlace(vtkImageData* image, const int whole[6], littoral::GeoTiffContent& content) const;
  /// Fills rows of the file from an image that has them.
  void FillRows(vtkImageData* image, const int whole[6], int first, int count, double* values);
  void WriteHeights(const littoral::ImageParts& parts);

  std::string CoordinateSystem;
  int Compression = Deflate;
};

#endif
