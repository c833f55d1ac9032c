// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReplacedFile.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace littoral
{

namespace
{

constexpr const char* PartPrefix = ".littoral-";
constexpr const char* PartSuffix = ".part";
constexpr const char* FolderSuffix = ".tiles";

/// A name beside the target, of its own and short: names of files end at 255 bytes.
std::string TemporaryName(const std::filesystem::path& target, const char* suffix)
{
  static std::atomic<unsigned> counter{ 0 };
  const std::string own = PartPrefix + std::to_string(::getpid()) + "-" + std::to_string(counter++) + suffix;
  return (target.parent_path() / own).string();
}

/// The folder of a file; the current one is ".".
std::string FolderOf(const std::filesystem::path& file)
{
  return file.has_parent_path() ? file.parent_path().string() : ".";
}

bool IsPart(const std::string& name)
{
  const auto endsIn = [&](const std::string& suffix) {
    return name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
  };
  return name.rfind(PartPrefix, 0) == 0 && (endsIn(PartSuffix) || endsIn(FolderSuffix));
}

/// Removes what killed processes have left in a folder: new files and folders that nobody holds.
void RemoveLeft(const std::string& folder)
{
  namespace fs = std::filesystem;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
  {
    if (!IsPart(entry->path().filename().string()))
    {
      continue;
    }
    const int descriptor = ::open(entry->path().c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    {
      std::error_code ignored;
      fs::remove_all(entry->path(), ignored);
    }
    if (descriptor >= 0)
    {
      ::close(descriptor);
    }
  }
}

/// Gives a new file the mode of the one that it replaces, and its owner as far as that is allowed.
void KeepRights(int descriptor, const std::string& target)
{
  struct stat old;
  if (::stat(target.c_str(), &old) != 0)
  {
    return;
  }
  struct stat own;
  const bool isOther = ::fstat(descriptor, &own) == 0 && (own.st_uid != old.st_uid || own.st_gid != old.st_gid);
  if (isOther && ::fchown(descriptor, old.st_uid, old.st_gid) != 0)
  {
    static_cast<void>(::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid)); // its group at least
  }
  ::fchmod(descriptor, old.st_mode & 07777); // a change of the owner takes some bits
}

/// Number of names of a file; 0 where there is none.
nlink_t NamesOf(const std::string& target)
{
  struct stat old;
  return ::stat(target.c_str(), &old) == 0 ? old.st_nlink : 0;
}

/// Writes the bytes of a file over those of another, whose other names keep it so; its room is made before any byte is
/// changed. Error number, 0 for none.
int WriteOver(int from, const std::string& target)
{
  struct stat own;
  const int to = ::fstat(from, &own) == 0 ? ::open(target.c_str(), O_WRONLY | O_CLOEXEC) : -1;
  if (to < 0)
  {
    return errno;
  }
  int error = own.st_size > 0 ? ::posix_fallocate(to, 0, own.st_size) : 0;
  std::vector<char> bytes(1 << 20);
  off_t at = 0;
  while (error == 0 && at < own.st_size)
  {
    const ssize_t some = ::pread(from, bytes.data(), bytes.size(), at);
    const ssize_t written = some > 0 ? ::pwrite(to, bytes.data(), static_cast<std::size_t>(some), at) : some;
    error = written > 0 ? 0 : written < 0 ? errno : EIO;
    at += std::max<ssize_t>(written, 0);
  }
  error = error != 0 || (::ftruncate(to, own.st_size) == 0 && ::fsync(to) == 0) ? error : errno;
  ::close(to);
  return error;
}

/// Removes what GDAL and programs on it have kept of the file before: statistics, overviews, masks.
void RemoveSideFiles(const std::string& target)
{
  for (const char* suffix : { ".aux.xml", ".ovr", ".msk" })
  {
    static_cast<void>(std::remove((target + suffix).c_str())); // mostly there is none
  }
}

/// Target of symbolic links, also if nothing is there yet.
std::string Followed(std::filesystem::path path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  while (fs::is_symlink(fs::symlink_status(path, error)))
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
  if (status.type() == fs::file_type::none) // such as a loop of links
  {
    this->Fail(error.value());
    return;
  }
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
  this->Temporary = TemporaryName(this->Target, PartSuffix);
  RemoveLeft(FolderOf(this->Target));
  if (!this->CreateWithoutName() && !this->CreateWithName())
  {
    return;
  }
  ::flock(this->Descriptor, LOCK_EX); // tells the new file from one that was left
  this->Output.exceptions(std::ios_base::badbit | std::ios_base::failbit);
}

ReplacedFile::~ReplacedFile()
{
  this->Output.exceptions(std::ios_base::goodbit);
  this->Buffer.Watch = nullptr;
  this->Buffer.close();
  if (this->Descriptor >= 0)
  {
    ::close(this->Descriptor);
  }
  if (this->HasName)
  {
    static_cast<void>(std::remove(this->Temporary.c_str())); // there is no one left to tell
  }
}

bool ReplacedFile::Fail(int error)
{
  if (this->Reason.empty())
  {
    this->Reason = std::system_category().message(error);
  }
  return false;
}

bool ReplacedFile::CreateWithoutName()
{
#ifdef O_TMPFILE
  this->Descriptor = ::open(FolderOf(this->Target).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
  this->Opened = "/proc/self/fd/" + std::to_string(this->Descriptor);
  return this->Descriptor >= 0 &&
    this->Buffer.open(this->Opened, std::ios_base::out | std::ios_base::binary | std::ios_base::trunc);
#else
  return false;
#endif
}

bool ReplacedFile::CreateWithName()
{
  if (this->Descriptor >= 0)
  {
    ::close(this->Descriptor);
  }
  this->Opened = this->Temporary;
  this->Descriptor = ::open(this->Opened.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  this->HasName = this->Descriptor >= 0;
  return (this->HasName &&
           this->Buffer.open(this->Opened, std::ios_base::out | std::ios_base::binary | std::ios_base::trunc)) ||
    this->Fail(errno);
}

void ReplacedFile::NoteFullDisk()
{
  constexpr off_t some = 1 << 16;
  const off_t end = ::lseek(this->Descriptor, 0, SEEK_END);
  const int error = ::posix_fallocate(this->Descriptor, end, some);
  if (error == ENOSPC || error == EDQUOT || error == EFBIG)
  {
    this->Fail(error);
  }
}

bool ReplacedFile::Close()
{
  this->Output.exceptions(std::ios_base::goodbit);
  const bool whole = this->Output.good() && (!this->Buffer.is_open() || this->Buffer.close());
  return whole || this->Fail(this->Buffer.Error ? this->Buffer.Error : errno);
}

bool ReplacedFile::Commit()
{
  // The file reaches the disk before its name does: after a power cut the name leads to a whole file.
  if (::fsync(this->Descriptor) != 0)
  {
    return this->Fail(errno);
  }
  if (NamesOf(this->Target) > 1)
  {
    const int error = WriteOver(this->Descriptor, this->Target);
    if (error == 0)
    {
      RemoveSideFiles(this->Target);
    }
    return error == 0 || this->Fail(error);
  }
  if (!this->HasName)
  {
    this->HasName = ::linkat(AT_FDCWD, this->Opened.c_str(), AT_FDCWD, this->Temporary.c_str(), AT_SYMLINK_FOLLOW) == 0;
    if (!this->HasName)
    {
      return this->Fail(errno);
    }
  }
  KeepRights(this->Descriptor, this->Target);
  if (std::rename(this->Temporary.c_str(), this->Target.c_str()) != 0)
  {
    return this->Fail(errno);
  }
  this->HasName = false;
  RemoveSideFiles(this->Target);
  const int folder = ::open(FolderOf(this->Target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0)
  {
    ::fsync(folder); // some file systems cannot; the file is whole in any case
    ::close(folder);
  }
  return true;
}

//----------------------------------------------------------------------------
HiddenFolder::HiddenFolder(const std::string& beside)
  : Name(TemporaryName(beside, FolderSuffix))
{
  std::error_code error;
  const bool isMade = std::filesystem::create_directory(this->Name, error);
  this->Reason = error ? error.message() : isMade ? "" : this->Name + " is there already";
  this->Descriptor = ::open(this->Name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (this->Descriptor >= 0)
  {
    ::flock(this->Descriptor, LOCK_EX); // tells the folder from one that was left
  }
}

//----------------------------------------------------------------------------
HiddenFolder::~HiddenFolder()
{
  if (this->Reason.empty())
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Name, ignored);
  }
  if (this->Descriptor >= 0)
  {
    ::close(this->Descriptor);
  }
}

//----------------------------------------------------------------------------
std::string WhyNotWritten(const std::string& path, const std::string& bytes)
{
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  int error = file < 0 ? errno : 0;
  std::size_t at = 0;
  while (error == 0 && at < bytes.size())
  {
    const ssize_t written = ::write(file, bytes.data() + at, bytes.size() - at);
    error = written > 0 ? 0 : written < 0 ? errno : EIO;
    at += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
  }
  error = error == 0 && ::fsync(file) != 0 ? errno : error;
  if (file >= 0)
  {
    ::close(file);
  }
  return error == 0 ? std::string() : std::system_category().message(error);
}

//----------------------------------------------------------------------------
FileOutcome WriteFile(const std::string& target, const std::function<bool(ReplacedFile&)>& write)
{
  ReplacedFile file(target);
  if (!file.WhyFailed().empty())
  {
    return { false, file.WhyFailed() };
  }
  try
  {
    return write(file) ? FileOutcome{ true, {} } : FileOutcome{ false, file.WhyFailed() };
  }
  catch (const WriteStopped&)
  {
    return { false, {} };
  }
  catch (const std::bad_alloc&)
  {
    return { false, "there is not enough memory" };
  }
  catch (const std::exception& problem)
  {
    // What the system said of the file is clearer than what the stream made of it.
    file.Close();
    return { false, file.WhyFailed().empty() ? problem.what() : file.WhyFailed() };
  }
}

}
