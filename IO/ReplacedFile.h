// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralReplacedFile_h
#define LittoralReplacedFile_h

#include <exception>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>

namespace littoral
{

/**
 * A file that takes its place only when it is whole. It is written in the folder of the target, without a name where
 * the file system can do that, and else under a name of its own. Commit moves it to the target. Before that the target
 * is untouched, and the new file goes with this object. The new file has the mode and the owner of the old one, and
 * side files that tell of the old one go. A file of several hard links is written over in place. What a killed process
 * has left goes with the next file.
 */
class ReplacedFile
{
public:
  /// Creates the new file. Fails() tells whether that went well.
  explicit ReplacedFile(const std::string& target);
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  /// The first reason why something failed, as the system says it; empty if nothing has.
  const std::string& WhyFailed() const { return this->Reason; }
  /// Stream to write to. Throws std::ios_base::failure when the system refuses.
  std::ostream& Stream() { return this->Output; }
  /// Called with the bytes written from time to time; what it throws ends the write.
  void OnWrite(std::function<void(std::size_t)> watch) { this->Buffer.Watch = std::move(watch); }
  /// Called when a library could not write to Path() and keeps no reason: notes a disk without room, or a file
  /// without leave to grow, as the one.
  void NoteFullDisk();
  /// Ends the writing; the new file can then be read at Path(). False if it is not whole.
  bool Close();
  const std::string& Path() const { return this->Opened; }
  /// Moves the closed file to the target once the disk has it. False, with the target as it was, if that fails.
  bool Commit();

private:
  /// Keeps the system's error number, which a stream forgets.
  class NotingBuffer : public std::filebuf
  {
  public:
    int Error = 0;
    std::size_t Written = 0;
    std::function<void(std::size_t)> Watch;

  protected:
    int_type overflow(int_type character) override;
    std::streamsize xsputn(const char* bytes, std::streamsize count) override;
    int sync() override;

  private:
    template <typename Result>
    Result Note(Result result, bool failed);
  };

  /// Keeps the first error; false.
  bool Fail(int error);
  bool CreateWithoutName();
  bool CreateWithName();

  std::string Target;
  std::string Temporary; // name beside the target
  std::string Opened;    // where to open the new file: the same, or the descriptor of a file without a name
  std::string Reason;
  int Descriptor = -1;
  bool HasName = false;
  NotingBuffer Buffer;
  std::ostream Output;
};

/// A folder beside a file, under a hidden name, which goes with this object or, where the process was killed, with the
/// next new file there.
class HiddenFolder
{
public:
  /// Makes the folder. WhyFailed() tells whether that went well.
  explicit HiddenFolder(const std::string& beside);
  ~HiddenFolder();
  HiddenFolder(const HiddenFolder&) = delete;
  HiddenFolder& operator=(const HiddenFolder&) = delete;

  /// Why there is no folder, as the system says it; empty if there is one.
  const std::string& WhyFailed() const { return this->Reason; }
  const std::string& Path() const { return this->Name; }

private:
  std::string Name;
  std::string Reason;
  int Descriptor = -1; // which holds it
};

/// Writes a new file to the disk. Why that failed, as the system says it; empty if it did not.
std::string WhyNotWritten(const std::string& path, const std::string& bytes);

/// The outcome of writing a file.
struct FileOutcome
{
  bool Written = false;
  std::string Reason; ///< why it was not, in words for a user; empty where the user wanted it so
};

/// Thrown through a writer when the user asks to stop.
struct WriteStopped : std::exception
{
};

/// Writes a file that `write` fills and commits, which it tells; whatever it throws becomes an outcome.
FileOutcome WriteFile(const std::string& target, const std::function<bool(ReplacedFile&)>& write);

}

#endif
