// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReplacedFile.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace littoral
{

namespace
{

std::string TemporaryName(const std::filesystem::path& target)
{
  static std::atomic<unsigned> counter{ 0 };
  const std::string own =
    "." + target.filename().string() + "." + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part";
  return (target.parent_path() / own).string();
}

/// Where symbolic links lead, also if nothing is there yet.
std::string Followed(std::filesystem::path path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  for (int links = 0; links < 40 && fs::is_symlink(fs::symlink_status(path, error)); ++links)
  {
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path.string();
}

}

template <typename Result>
Result ReplacedFile::NotingBuffer::Note(Result result, bool failed)
{
  if (failed && this->Error == 0)
  {
    this->Error = errno;
  }
  return result;
}

std::filebuf::int_type ReplacedFile::NotingBuffer::overflow(int_type character)
{
  const int_type result = std::filebuf::overflow(character);
  return this->Note(result, traits_type::eq_int_type(result, traits_type::eof()));
}

std::streamsize ReplacedFile::NotingBuffer::xsputn(const char* bytes, std::streamsize count)
{
  const std::streamsize result = std::filebuf::xsputn(bytes, count);
  this->Written += static_cast<std::size_t>(count);
  if (this->Watch)
  {
    this->Watch(this->Written);
  }
  return this->Note(result, result != count);
}

int ReplacedFile::NotingBuffer::sync()
{
  const int result = std::filebuf::sync();
  return this->Note(result, result != 0);
}

ReplacedFile::ReplacedFile(const std::string& target)
  : Target(target)
  , Output(&this->Buffer)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status))
  {
    this->Fail(EISDIR);
    return;
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    this->Reason = "it is not a regular file"; // moving a file over a device would destroy the device
    return;
  }
  this->Target = Followed(target);
  this->Temporary = TemporaryName(this->Target);
  const int descriptor = ::open(this->Temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0)
  {
    this->Fail(errno);
    return;
  }
  this->Exists = true;
  ::close(descriptor);
  if (!this->Buffer.open(this->Temporary, std::ios_base::out | std::ios_base::binary | std::ios_base::trunc))
  {
    this->Fail(errno);
    return;
  }
  this->Output.exceptions(std::ios_base::badbit | std::ios_base::failbit);
}

ReplacedFile::~ReplacedFile()
{
  this->Output.exceptions(std::ios_base::goodbit);
  this->Buffer.Watch = nullptr;
  this->Buffer.close();
  if (this->Exists)
  {
    std::remove(this->Temporary.c_str());
  }
}

void ReplacedFile::Fail(int error)
{
  if (this->Reason.empty())
  {
    this->Reason = std::system_category().message(error);
  }
}

bool ReplacedFile::Close()
{
  this->Output.exceptions(std::ios_base::goodbit);
  const bool whole = this->Output.good() && this->Buffer.close();
  if (!whole)
  {
    this->Fail(this->Buffer.Error ? this->Buffer.Error : errno);
  }
  return whole;
}

bool ReplacedFile::Commit()
{
  if (std::rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
  {
    this->Fail(errno);
    return false;
  }
  this->Exists = false;
  return true;
}

}
