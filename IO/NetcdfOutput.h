// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralNetcdfOutput_h
#define LittoralNetcdfOutput_h

// A new file in netCDF's classic format by the netCDF library. The same calls give the same bytes.

#include <cstddef>
#include <string>
#include <vector>

namespace littoral
{

class NetcdfOutput
{
public:
  /// Number of the file itself, where one of a variable is asked for.
  static constexpr int File = -1;

  /// Creates a file over what is there, with places of 64 bits; with `isLarge` variables may exceed 4 GiB too. Throws
  /// InvalidInput, as all that follows.
  NetcdfOutput(const std::string& path, bool isLarge);
  ~NetcdfOutput();
  NetcdfOutput(const NetcdfOutput&) = delete;
  NetcdfOutput& operator=(const NetcdfOutput&) = delete;

  /// Adds a dimension of a length, of which 0 counts records. Its number.
  int AddDimension(const char* name, std::size_t length);

  /// Adds a variable of float32, the slowest dimension first. Its number.
  int AddFloats(const char* name, const std::vector<int>& dimensions);

  /// Adds a variable of float64.
  int AddDoubles(const char* name, const std::vector<int>& dimensions);

  void AddText(int variable, const char* attribute, const std::string& text);
  void AddNumber(int variable, const char* attribute, double number);
  void AddFloat(int variable, const char* attribute, float number);

  /// Ends the header: only numbers follow.
  void EndHeader();

  /// Writes a part of a variable.
  void Write(
    int variable, const std::vector<std::size_t>& start, const std::vector<std::size_t>& count, const float* values);

  /// Writes values of a variable of one dimension from a place on.
  void Write(int variable, std::size_t start, const std::vector<double>& values);

  /// Ends the file, whose last bytes go to the disk.
  void Close();

private:
  int AddVariable(const char* name, int type, const std::vector<int>& dimensions);

  int Id = -1;
  bool IsOpen = false;
};

}

#endif
