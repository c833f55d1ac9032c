// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/FileBytes.h"

#include "Numerics/InvalidInput.h"
#include "Pipeline/Memory.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace littoral
{

std::string BytesOfFile(const std::string& path, double bytesPerByte, const char* what)
{
  std::error_code none;
  const auto size = static_cast<double>(std::filesystem::file_size(path, none));
  RequireMemory(none ? 0.0 : bytesPerByte * size, what, "take a smaller file");
  Require(std::filesystem::is_directory(path, none) ? "it is a folder." : "");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (!file)
  {
    Refuse(errno ? std::strerror(errno) : "it cannot be read", ".");
  }
  return bytes;
}

}
