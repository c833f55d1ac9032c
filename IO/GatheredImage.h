// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralGatheredImage_h
#define LittoralGatheredImage_h

#include "ImageParts.h"
#include "WriterRanks.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;
class vtkImageData;
class vtkMultiProcessStream;

namespace littoral
{

/**
 * An image of which each rank has a part. The first rank gets it box by box, as a writer asks for rows or planes, and
 * the others hand over what lies in their parts, until this object of the first rank goes. No rank has more than its
 * part and a box. Parts may share points, and a rank may have none. Arrays are those that all parts have; marks of
 * ghosts those of any.
 */
class GatheredImage
{
public:
  /// Takes the part of a rank, or null. An extent that has no points, or the image that it belongs to, as was
  /// announced. Each rank must make one.
  GatheredImage(const WriterRanks& ranks, vtkImageData* own, const ImageParts::Extent& announced);
  ~GatheredImage();
  GatheredImage(const GatheredImage&) = delete;
  GatheredImage& operator=(const GatheredImage&) = delete;

  /// The image for the first rank, as long as this object is there. Throws InvalidInput where the parts are not those
  /// of an image.
  ImageParts Parts();
  /// Answers, on the others, until the first rank needs nothing more.
  void Serve();

private:
  using Box = ImageParts::Extent;

  struct Column
  {
    bool IsOfCells = false;
    bool IsActive = false; ///< the active scalars
    std::string Name;
    int Type = 0;
    int Components = 0;
  };

  /// The shape of a rank's part.
  struct Part
  {
    Box Announced{ { 0, -1, 0, -1, 0, -1 } };
    Box Extent{ { 0, -1, 0, -1, 0, -1 } };
    std::array<double, 15> Grid{}; ///< origin, spacing, axes
    std::vector<Column> Columns;
  };

  static Part PartOf(vtkImageData* own, const Box& announced);
  static void Put(vtkMultiProcessStream& stream, const std::vector<Column>& columns);
  static void Take(vtkMultiProcessStream& stream, std::vector<Column>& columns);
  static Part ReceivedPart(vtkMultiProcessStream& stream);
  static Column* Find(std::vector<Column>& columns, const Column& like);
  void SendPart();
  void ReceiveParts();
  void Join();
  void ShareColumns();
  void ShareFields();
  std::string WhyNoImage() const;
  vtkDataArray* Own(const Column& column) const;
  double BytesOf(const Box& box) const;
  void Answer(const Box& box);
  vtkSmartPointer<vtkDataArray> Packed(const Column& column, const Box& box) const;
  void ReceiveBox(int rank, const Box& box, vtkImageData* image);
  void TakeOwnBox(const Box& box, vtkImageData* image);
  vtkImageData* Get(const Box& asked);
  vtkSmartPointer<vtkImageData> Room(const Box& box) const;
  void RequireCovered(const Box& asked, const std::vector<Box>& boxes, bool isOfCells) const;

  WriterRanks Ranks;
  vtkImageData* Image; ///< of this rank
  Box Whole{ { 0, -1, 0, -1, 0, -1 } };
  std::vector<Part> AllParts; ///< on the first rank
  std::vector<Column> Columns;
  int FirstFilled = -1;                 ///< the first rank that has points
  vtkSmartPointer<vtkImageData> Fields; ///< what is not an array of points or cells
  vtkSmartPointer<vtkImageData> Last;   ///< the box that was asked for last
};

}

#endif
