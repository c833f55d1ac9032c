// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSingleFileWriter
 * @brief   base class of the writers of one file
 *
 * A subclass writes in WriteInput() under another name in the same folder and renames the file when it is complete. On
 * failure, an existing file of this name is unchanged, one error names file and reason, and Write() returns 0. An abort
 * is no error: Write() returns 0, and the error code is vtkErrorCode::UserError.
 *
 * On several ranks each makes its part of the input, and the first one writes what it gathers of them: the bytes that
 * one rank writes. The others receive nothing of it. What one rank cannot do ends on all of them, with one error on the
 * first. Write() must be called on all of them.
 */
#ifndef vtkSingleFileWriter_h
#define vtkSingleFileWriter_h

#include "LittoralIOModule.h" // for the export macro
#include "vtkSmartPointer.h"  // for the whole input
#include "vtkWriter.h"

#include <functional> // for what writes
#include <string>     // for the name

class vtkDataObject;
class vtkMultiProcessController;

namespace littoral
{
struct FileOutcome;
struct ImageParts;
}

class LITTORALIO_EXPORT vtkSingleFileWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkSingleFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the output file, with an extension of the class; default null, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Controller of the ranks that write together; default the global controller, and null of vtkGLTFSceneWriter. With
   * null each rank writes by itself.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  /**
   * Writes the file; 0 where that fails, after a message.
   */
  int Write() override;

protected:
  /// The content of a file with its article, for messages: a wind.
  explicit vtkSingleFileWriter(const char* content);
  ~vtkSingleFileWriter() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  void WriteData() override;

  /// Writes the input, and tells the outcome to Conclude(). Throws littoral::InvalidInput.
  virtual void WriteInput() = 0;
  /// Write() of a subclass that has its image part by part; what it throws becomes one error.
  int WriteParts(const std::function<void(const littoral::ImageParts&)>& write);
  /// Writes on several ranks, each of which calls this with its part of the input, or null: what WriteInput() finds by
  /// GetWholeInput() on the first. Throws littoral::InvalidInput.
  virtual void WriteTogether(vtkDataObject* own);
  /// The same for a subclass that has its image part by part.
  void WritePartsTogether(vtkDataObject* own, const std::function<void(const littoral::ImageParts&)>& write);
  /// The input of all ranks on the first one, from the parts that each has. Throws littoral::InvalidInput.
  virtual vtkSmartPointer<vtkDataObject> GatherInput(vtkDataObject* own);
  /// The input, of all ranks where they write together.
  vtkDataObject* GetWholeInput();
  /// FileName. Throws littoral::InvalidInput where there is none.
  std::string NeedFileName() const;
  /// Notes whether the file was written. Throws its reason if it was not.
  void Conclude(const littoral::FileOutcome& outcome);
  /// Calls what writes. What it throws becomes one error that names the file.
  void WriteOrRefuse(const std::function<void()>& write);
  /// The result of a request that wrote: an abort is no failure.
  int Answer();

  char* FileName = nullptr;
  vtkMultiProcessController* Controller = nullptr;
  bool IsWritten = false; ///< by the last Write()

private:
  vtkSingleFileWriter(const vtkSingleFileWriter&) = delete;
  void operator=(const vtkSingleFileWriter&) = delete;

  int WriteOwnParts(const std::function<vtkDataObject*()>& ownPart);
  void NoteExtent(vtkInformation* input);
  void ShareOutcome();

  const char* const Content;
  vtkSmartPointer<vtkDataObject> Whole;       ///< the input of all ranks, while it is written
  int Announced[6] = { 0, -1, 0, -1, 0, -1 }; ///< extent of the image whose part was asked for
};

#endif
