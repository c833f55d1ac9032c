// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FolderOfFiles.h"

#include "Numerics/InvalidInput.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace littoral
{

namespace
{

namespace fs = std::filesystem;

constexpr std::uint64_t FirstHash = 14695981039346656037ULL; // FNV-1a
constexpr std::uint64_t HashFactor = 1099511628211ULL;
constexpr std::size_t Digits = 16;

std::string DigitsOf(std::uint64_t hash)
{
  char digits[Digits + 1];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

void RequireDone(const std::error_code& error)
{
  Require(error ? error.message() : std::string());
}

}

//----------------------------------------------------------------------------
FolderOfFiles::FolderOfFiles(const std::string& beside)
  : Hidden(beside)
  , Hash(FirstHash)
{
  const fs::path file(beside);
  this->Folder = file.has_parent_path() ? file.parent_path().string() : ".";
  this->Prefix = file.stem().string() + "-tiles-";
  Require(this->Hidden.WhyFailed());
}

//----------------------------------------------------------------------------
void FolderOfFiles::Add(const std::string& name, const std::string& bytes)
{
  Require(WhyNotWritten((fs::path(this->Hidden.Path()) / name).string(), bytes));
  for (const std::string* text : { &name, &bytes })
  {
    for (const char letter : *text)
    {
      this->Hash = (this->Hash ^ static_cast<unsigned char>(letter)) * HashFactor;
    }
  }
}

//----------------------------------------------------------------------------
std::string FolderOfFiles::Name() const
{
  return this->Prefix + DigitsOf(this->Hash);
}

//----------------------------------------------------------------------------
void FolderOfFiles::Commit()
{
  const fs::path named = fs::path(this->Folder) / this->Name();
  this->WasThere = fs::exists(named);
  if (!this->WasThere)
  {
    std::error_code error;
    fs::rename(this->Hidden.Path(), named, error);
    RequireDone(error);
  }
  this->IsNamed = true;
}

//----------------------------------------------------------------------------
void FolderOfFiles::Withdraw()
{
  if (this->IsNamed && !this->WasThere)
  {
    std::error_code ignored;
    fs::remove_all(fs::path(this->Folder) / this->Name(), ignored);
  }
}

//----------------------------------------------------------------------------
void FolderOfFiles::RemoveOthers() const
{
  std::error_code error;
  std::vector<fs::path> others;
  for (fs::directory_iterator entry(this->Folder, error), end; !error && entry != end; entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    const bool isOfThis = name.rfind(this->Prefix, 0) == 0 && name.size() == this->Prefix.size() + Digits &&
      name.find_first_not_of("0123456789abcdef", this->Prefix.size()) == std::string::npos;
    if (isOfThis && name != this->Name())
    {
      others.push_back(entry->path());
    }
  }
  for (const fs::path& other : others)
  {
    fs::remove_all(other, error);
  }
}

}
