// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVDBVolumeWriter
 * @brief   write images as volumes of an OpenVDB file (.vdb)
 *
 * The input is a vtkImageData or a composite of images. Each point array and cell array becomes a grid with the name of
 * the array; where several blocks have an array of that name, the name of the block and an underscore come before it.
 * Point (i, j, k) of an image becomes voxel (i, j, k), and the transform of the grid maps it to the world coordinates
 * of the point for any spacing, origin and direction. Cell values are at the centers of the cells.
 *
 * - One component: a float grid of the class fog volume.
 * - Three components: a vec3s grid. Its vectors are contravariant and relative, as velocities are; normals are
 *   covariant, colors (unsigned char) and texture coordinates invariant.
 * - Any other number: one float grid per component, with the name or number of the component after that of the array.
 *
 * Values are written in single or half precision. Each grid has these metadata: `unit`, from the array's
 * vtkDataArray::UNITS_LABEL() or else from a field data string with the name of the array and "Unit" after it; `time`,
 * from the data; and all strings, single numbers and triples of the field data of the block. Those of the input as a
 * whole are also metadata of the file.
 *
 * Blanked points and cells are not stored. Values that are not finite are an error, as renderers would show them as
 * black or not at all.
 *
 * The file is written under another name in the same folder and renamed when it is complete. On failure, an existing
 * file of this name is unchanged, one error names file and reason, and Write() returns 0. The same input gives the same
 * bytes.
 *
 * On several ranks the first one writes one file, with the bytes of one rank: it makes the grids of the parts that it
 * asks the others for, 16 MiB at a time. What one rank cannot do ends on all of them, with one error on the first.
 * Write() must be called on all of them.
 */
#ifndef vtkVDBVolumeWriter_h
#define vtkVDBVolumeWriter_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkNew.h"           // for the selections
#include "vtkWriter.h"

#include <string> // for GridName

class vtkDataArraySelection;
class vtkMultiProcessController;

namespace littoral
{
struct FileOutcome;
struct VolumeInput;
}

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
   * Name of the output file; default null, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Half precision of the values: 16 bits, 11 of them significant, at most 65504; default off. A larger value is an
   * error.
   */
  vtkSetMacro(HalfFloat, bool);
  vtkGetMacro(HalfFloat, bool);
  vtkBooleanMacro(HalfFloat, bool);
  ///@}

  ///@{
  /**
   * Maximum magnitude of values that count as 0 and are not stored, in the unit of the array, at least 0; default 0,
   * lossless. For vectors it holds for each component.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Name of the grid in the file; default ``, the name of the array. Renderers know smoke and fog by the name
   * `density`. Only an input with one volume, of one array, may have it; more are an error.
   */
  vtkSetMacro(GridName, std::string);
  vtkGetMacro(GridName, std::string);
  ///@}

  ///@{
  /**
   * Compression of the file, a CompressionType; default Blosc. NoCompression; Zip: small and slow; Blosc: fast,
   * replaced by Zip where OpenVDB was built without it. Values that are not stored take no space in any case.
   */
  vtkSetClampMacro(Compression, int, NoCompression, Blosc);
  vtkGetMacro(Compression, int);
  void SetCompressionToNoCompression() { this->SetCompression(NoCompression); }
  void SetCompressionToZip() { this->SetCompression(Zip); }
  void SetCompressionToBlosc() { this->SetCompression(Blosc); }
  ///@}

  ///@{
  /**
   * One file per time step of the input, with FileNameSuffix and the index of the step in its name; default off. An
   * input without time steps gives one file named FileName. (Save Data of ParaView has its own option.)
   */
  vtkSetMacro(WriteAllTimeSteps, bool);
  vtkGetMacro(WriteAllTimeSteps, bool);
  vtkBooleanMacro(WriteAllTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Suffix of the file name in a time series, with one `%d`, `%Nd` or `%0Nd` for the index of the step; default
   * `_%04d`, as in wind_0007.vdb. `%0Nd` pads the index with zeros to N digits.
   */
  vtkSetMacro(FileNameSuffix, std::string);
  vtkGetMacro(FileNameSuffix, std::string);
  ///@}

  ///@{
  /**
   * Selection of the arrays to write: those that are enabled or not in the selection; default empty, all arrays.
   */
  vtkDataArraySelection* GetPointDataArraySelection();
  vtkDataArraySelection* GetCellDataArraySelection();
  ///@}

  ///@{
  /**
   * Controller of the ranks that write together; default the global controller. With null each rank writes by itself.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  /**
   * Writes the file; 0 where that fails, after a message.
   */
  int Write() override;

  /**
   * Modification time, including that of the array selections.
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
  void NoteExtent(vtkInformation* input, bool isOfSeries);
  bool WriteStep(bool hasInput);
  void WritePart(vtkDataObject* data, bool hasFailed);
  littoral::FileOutcome WriteGathered(littoral::VolumeInput& input);

  char* FileName = nullptr;
  bool HalfFloat = false;
  double Tolerance = 0.0;
  std::string GridName;
  int Compression = Blosc;
  bool WriteAllTimeSteps = false;
  std::string FileNameSuffix = "_%04d";
  vtkNew<vtkDataArraySelection> PointDataArraySelection;
  vtkNew<vtkDataArraySelection> CellDataArraySelection;
  vtkMultiProcessController* Controller = nullptr;
  int NumberOfSteps = 0; ///< of a series; 0 where there is none
  int CurrentStep = 0;
  bool IsStepping = false;                    ///< by Write()
  bool IsAwaited = false;                     ///< by other ranks, for what this one has to write
  int Announced[6] = { 0, -1, 0, -1, 0, -1 }; ///< extent of the image whose part was asked for
};

#endif
