// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTextTableReader
 * @brief   read a table of separated values from a text file as spreadsheets write them
 *
 * Output: a vtkTable with a row a line. Columns of numbers are double, with NaN where a cell is empty, NA, NaN, NULL, a
 * point or a dash; others, and numbers with leading zeros, are words.
 *
 * The separator is comma, semicolon or tab, whichever the line of names has most of, or that of a line `sep=;` before
 * it. The text is UTF-8, UTF-16 or Latin-1. Decimal commas and commas between thousands are known by the numbers of the
 * table; 1,234 stays a word if they do not tell. Lines of `#` before the names, blank lines and columns without a name
 * are left out.
 *
 * A file that cannot be read, a row with more cells than there are names, a quote that is not closed, two columns of
 * one name, and more than 10000 columns are reported as one error.
 *
 * @sa vtkStandInventoryFilter vtkSitePreferenceFilter vtkSeaStateSource
 */
#ifndef vtkTextTableReader_h
#define vtkTextTableReader_h

#include "LittoralSourcesModule.h" // for export macro
#include "vtkTableAlgorithm.h"

class LITTORALSOURCES_EXPORT vtkTextTableReader : public vtkTableAlgorithm
{
public:
  static vtkTextTableReader* New();
  vtkTypeMacro(vtkTextTableReader, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lets no exception leave a request, as for want of memory: it becomes an error.
  int ProcessRequest(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  ///@{
  /**
   * Name of the file; default none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkTextTableReader();
  ~vtkTextTableReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  char* FileName;

private:
  vtkTextTableReader(const vtkTextTableReader&) = delete;
  void operator=(const vtkTextTableReader&) = delete;
};

#endif
