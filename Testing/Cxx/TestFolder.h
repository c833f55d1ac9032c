// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TestFolder_h
#define TestFolder_h

#include "vtkTestUtilities.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/// Makes an empty folder for the files of a test, in the temporary folder of the arguments.
inline std::filesystem::path EmptyFolder(int argc, char* argv[], const std::string& test)
{
  char* temporary = vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::filesystem::path folder = std::filesystem::absolute(temporary) / test;
  delete[] temporary;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

/// Bytes of a file.
inline std::string BytesOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

#endif
