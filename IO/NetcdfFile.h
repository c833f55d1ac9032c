// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNetcdfFile_h
#define LittoralNetcdfFile_h

// Variables of netCDF files by the netCDF library, with packed numbers unpacked and missing ones NaN.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace littoral
{

struct NetcdfDimension
{
  std::string Name;
  std::size_t Length = 0;
};

struct NetcdfVariable
{
  std::string Name;
  int Id = -1;
  int Type = 0;                ///< an nc_type
  std::vector<int> Dimensions; ///< numbers of dimensions, the slowest first
};

/// Size and time of a file, which tell whether it is still the same.
struct FileStamp
{
  std::uintmax_t Size = 0;
  std::filesystem::file_time_type Changed;

  bool operator==(const FileStamp& other) const { return this->Size == other.Size && this->Changed == other.Changed; }
};

/// The stamp of a file that is there. Throws InvalidInput.
FileStamp StampOf(const std::string& path);

class NetcdfFile
{
public:
  /// Opens a file of any of netCDF's formats. Throws InvalidInput, also where a classic one is shorter than its header
  /// says.
  explicit NetcdfFile(const std::string& path);
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  const std::vector<NetcdfDimension>& Dimensions() const { return this->AllDimensions; }

  /// Variables of numbers, in the order of the file.
  const std::vector<NetcdfVariable>& Variables() const { return this->AllVariables; }

  /// The variable of a name; null for none.
  const NetcdfVariable* Find(const std::string& name) const;

  std::size_t LengthOf(const NetcdfVariable& variable, std::size_t dimension) const;

  /// Number of values.
  std::size_t SizeOf(const NetcdfVariable& variable) const;

  /// An attribute that is a text; empty for none. A variable of Id -1 (NC_GLOBAL) is the file itself.
  std::string TextOf(const NetcdfVariable& variable, const char* attribute) const;

  /// All numbers of an attribute.
  std::vector<double> NumbersOf(const NetcdfVariable& variable, const char* attribute) const;

  /// The first number of an attribute, if it has one.
  std::optional<double> NumberOf(const NetcdfVariable& variable, const char* attribute) const;

  /// Reads a part of a variable; missing values are NaN. Throws InvalidInput.
  void Read(const NetcdfVariable& variable, const std::vector<std::size_t>& start,
    const std::vector<std::size_t>& count, double* values) const;

  /// All values of a variable. Throws InvalidInput, also for want of memory.
  std::vector<double> ReadAll(const NetcdfVariable& variable) const;

  /// Throws InvalidInput if the file has changed since it was opened.
  void RequireUnchanged() const;

  const FileStamp& Stamp() const { return this->Opened; }

private:
  void RequireWhole() const;
  double BytesOfHeader(bool isLarge, bool isClassic) const;
  double BytesOfAttributes(int variable, double word) const;

  std::string Path;
  FileStamp Opened;
  int Id = -1;
  int Unlimited = -1;
  std::vector<NetcdfDimension> AllDimensions;
  std::vector<NetcdfVariable> AllVariables;
  std::vector<NetcdfVariable> Others; ///< of texts
};

}

#endif
