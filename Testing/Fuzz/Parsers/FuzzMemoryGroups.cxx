// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// What Linux tells of control groups: the list of a process's groups, and the numbers in the files of a group.

#include "Expect.h"
#include "Pipeline/Memory.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace
{

/// A folder of this process, as the root of all groups; in memory where that can be, as each run writes six files.
const std::filesystem::path& Root()
{
  static const std::filesystem::path root = [] {
    const std::filesystem::path memory = "/dev/shm";
    std::filesystem::path path =
      std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    path /= "littoral-groups-" + std::to_string(::getpid());
    std::filesystem::create_directories(path / "memory");
    return path;
  }();
  static const int removed = std::atexit([] { std::filesystem::remove_all(Root()); });
  static_cast<void>(removed);
  return root;
}

void Write(const char* name, const std::string& text)
{
  std::ofstream(Root() / name, std::ios::binary) << text;
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  FuzzedDataProvider data(bytes, size);
  for (const char* name : { "memory.max", "memory.current", "memory.stat", "memory/memory.limit_in_bytes",
         "memory/memory.usage_in_bytes", "memory/memory.stat" })
  {
    Write(name, data.ConsumeRandomLengthString(200));
  }
  const std::string groups = data.PickValueInArray({ "", "0::/\n", "7:memory:/\n", "0::/a/b\n" });
  const double left = littoral::GroupMemory(groups + data.ConsumeRemainingBytesAsString(), Root().string());
  Expect(left >= 0.0, "There are " + std::to_string(left) + " bytes left.");
  return 0;
}
