// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVDBVolumeWriter
 * @brief   Writes images as volumes of an OpenVDB file (.vdb).
 *
 * The input is a vtkImageData or a composite of images. Each point array and cell array becomes a grid of the array's
 * name; where several blocks carry an array of that name, the block's name and an underscore come before it. Point
 * (i, j, k) of an image becomes voxel (i, j, k), and the grid's transform puts that to the point's place in the world;
 * spacing, origin and direction may be any. Values of cells sit at the cells' centers.
 *
 * - One component: a float grid of the class fog volume.
 * - Three components: a vec3s grid. Its vectors are contravariant and relative, as velocities are; normals are
 * covariant, colors (unsigned char) and texture coordinates invariant.
 * - Any other number: one float grid a component, the component's name or number behind the array's.
 *
 * Values are written in single or half precision. Each grid has these remarks (OpenVDB calls them metadata): `unit`,
 * from the array's vtkDataArray::UNITS_LABEL() or else from a field data text of the array's name with "Unit" behind
 * it; `time`, from the data; and all texts, single numbers and triples of the block's field data. Those of the input as
 * a whole are remarks of the file as well.
 *
 * Blanked points and cells are not stored. Values that are not finite are an error, as renderers would show them as
 * black or as nothing at all.
 *
 * The file is written under another name in the same folder and moved into place when it is whole. When that fails, a
 * file of this name that was there before is untouched, one message names file and reason, and Write() gives 0. The
 * same input makes the same bytes.
 *
 * On several ranks each sends its part to rank 0, which writes one file. Write() must be called on all of them.
 */
#ifndef vtkVDBVolumeWriter_h
#define vtkVDBVolumeWriter_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkNew.h"           // for the selections
#include "vtkWriter.h"

#include <string> // for FileNameSuffix

class vtkDataArraySelection;
class vtkMultiProcessController;

class LITTORALIO_EXPORT vtkVDBVolumeWriter : public vtkWriter
{
public:
  static vtkVDBVolumeWriter* New();
  vtkTypeMacro(vtkVDBVolumeWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum CompressionType
  {
    NoCompression = 0,
    Zip = 1,
    Blosc = 2
  };

  ///@{
  /**
   * The file to write. Default: none, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Whether the file holds values in 16 bits: 11 significant bits, at most 65504. A value beyond that is an error.
   * Default: off.
   */
  vtkSetMacro(HalfFloat, bool);
  vtkGetMacro(HalfFloat, bool);
  vtkBooleanMacro(HalfFloat, bool);
  ///@}

  ///@{
  /**
   * Values of at most this magnitude count as 0 and are not stored, in the array's unit; of vectors, where each
   * component is. At least 0. Default: 0, which leaves out zeros only and so loses nothing.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * How the file is compressed: NoCompression (0), Zip (1, small and slow), Blosc (2, fast; where OpenVDB was built
   * without it, Zip). Values that are not stored take no room in any case. Default: Blosc.
   */
  vtkSetClampMacro(Compression, int, NoCompression, Blosc);
  vtkGetMacro(Compression, int);
  ///@}

  ///@{
  /**
   * Whether to write a file for each of the input's time steps, with FileNameSuffix and the number of the step in its
   * name. An input without time steps makes one file named FileName. Default: off. (ParaView's Save Data has its own
   * way to do the same.)
   */
  vtkSetMacro(WriteAllTimeSteps, bool);
  vtkGetMacro(WriteAllTimeSteps, bool);
  vtkBooleanMacro(WriteAllTimeSteps, bool);
  ///@}

  ///@{
  /**
   * What comes between name and extension in a series: a text with one %d, %Nd or %0Nd, of which the last pads the
   * number with zeros to N digits. Default: _%04d, as in wind_0007.vdb.
   */
  vtkSetMacro(FileNameSuffix, std::string);
  vtkGetMacro(FileNameSuffix, std::string);
  ///@}

  ///@{
  /**
   * The arrays to write: those that are not named here or that are switched on. Default: nothing named, hence all.
   */
  vtkDataArraySelection* GetPointDataArraySelection();
  vtkDataArraySelection* GetCellDataArraySelection();
  ///@}

  ///@{
  /**
   * The ranks that write together. Default: the global controller; null means that each writes by itself.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  /**
   * Also of the selections.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkVDBVolumeWriter();
  ~vtkVDBVolumeWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  void WriteData() override;

private:
  vtkVDBVolumeWriter(const vtkVDBVolumeWriter&) = delete;
  void operator=(const vtkVDBVolumeWriter&) = delete;

  bool HasFileName() const;
  std::string WhyInvalid() const;
  std::string StepFileName() const;
  /// One message naming the file, on the first rank.
  void Refuse(const std::string& reason);

  char* FileName = nullptr;
  bool HalfFloat = false;
  double Tolerance = 0.0;
  int Compression = Blosc;
  bool WriteAllTimeSteps = false;
  std::string FileNameSuffix = "_%04d";
  vtkNew<vtkDataArraySelection> PointDataArraySelection;
  vtkNew<vtkDataArraySelection> CellDataArraySelection;
  vtkMultiProcessController* Controller = nullptr;
  int NumberOfSteps = 0; ///< of a series; 0 where there is none
  int CurrentStep = 0;
};

#endif
