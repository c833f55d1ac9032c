// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFolderOfFiles_h
#define LittoralFolderOfFiles_h

#include "ReplacedFile.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace littoral
{

/**
 * A folder of files that gets its name when it is whole: STEM-tiles-DIGITS beside a file STEM.json, where the digits
 * tell the content. Before that it is a hidden one, which goes with this object.
 */
class FolderOfFiles
{
public:
  /// Makes the folder. Throws InvalidInput with the words of the system.
  explicit FolderOfFiles(const std::string& beside);

  /// Adds a file. Throws InvalidInput with the words of the system.
  void Add(const std::string& name, const std::string& bytes);
  /// Name of the folder with all files so far.
  std::string Name() const;
  /// Gives the folder its name, once the disk has its files. One that is there has the same content.
  void Commit();
  /// Removes the folders of other contents beside the file.
  void RemoveOthers() const;
  /// Takes the name back, where the folder was new.
  void Withdraw();

private:
  std::string Folder; // beside which
  std::string Prefix; // of the name
  HiddenFolder Hidden;
  std::uint64_t Hash;
  bool IsNamed = false;
  bool WasThere = false;
};

}

#endif
