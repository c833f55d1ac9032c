// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InflowFile.h"

#include "Data/FileBytes.h"
#include "InflowNetcdf.h"
#include "Numerics/InvalidInput.h"
#include "Wind/BladedPlanes.h"
#include "Wind/TurbSimPlanes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>

namespace littoral
{

namespace
{

constexpr double BytesPerByte = 8.0; // of lines and words in memory over those of a text
constexpr double BytesOfSlab = 32.0 * 1024.0 * 1024.0;

/// Planes and the files that they go to.
struct InflowTarget
{
  std::unique_ptr<InflowPlanes> Planes;
  std::vector<std::string> Paths; ///< as many as the planes have files
  std::string TextPath;           ///< of a text beside them; empty if there is none
  std::string Text;
};

std::ifstream Opened(const std::string& path)
{
  std::error_code none;
  Require(std::filesystem::is_directory(path, none) ? "it is a folder" : "");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    Refuse(errno ? std::strerror(errno) : "it cannot be read");
  }
  return file;
}

double SizeOf(std::ifstream& file)
{
  file.seekg(0, std::ios::end);
  const auto size = static_cast<double>(file.tellg());
  file.seekg(0);
  return size;
}

/// The first bytes of a file, at most so many.
std::string HeadOf(std::ifstream& file, std::size_t most)
{
  std::string bytes(most, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  return bytes;
}

/// Pointers to the bytes of a plane, file by file.
template <typename Byte>
std::vector<Byte*> BytesOfFiles(std::vector<std::string>& bytes)
{
  std::vector<Byte*> pointers;
  for (std::string& some : bytes)
  {
    pointers.push_back(some.data());
  }
  return pointers;
}

void WritePlanes(
  const InflowPlanes& planes, const std::vector<std::unique_ptr<ReplacedFile>>& files, const InflowSource& source)
{
  const InflowGrid& grid = planes.GetGrid();
  const auto count = static_cast<std::size_t>(planes.NumberOfFiles()); // the first ones
  const std::size_t values = 3 * grid.PointsOfPlane();
  std::vector<float> velocities(values * TimesAtOnce(grid));
  std::vector<std::string> bytes(count, std::string(planes.BytesOfPlane(), '\0'));
  const std::vector<char*> pointers = BytesOfFiles<char>(bytes);
  const bool isBackwards = planes.TimeAt(0) != 0;
  for (std::size_t f = 0; f < count; ++f)
  {
    files[f]->Stream() << planes.Header();
  }
  const bool isWhole = ForSlabs(grid, isBackwards, [&](int first, int times) {
    if (!source(first, times, velocities.data()))
    {
      return false;
    }
    for (int n = 0; n < times; ++n)
    {
      const std::size_t plane = isBackwards ? times - 1 - n : n;
      planes.Encode(velocities.data() + values * plane, pointers.data());
      for (std::size_t f = 0; f < count; ++f)
      {
        files[f]->Stream().write(bytes[f].data(), static_cast<std::streamsize>(bytes[f].size()));
      }
    }
    return true;
  });
  if (!isWhole)
  {
    throw WriteStopped();
  }
}

/// Why files could not take their places; empty when they have.
std::string Replace(const std::vector<std::unique_ptr<ReplacedFile>>& files)
{
  for (const auto& file : files)
  {
    if (!file->Close())
    {
      return file->WhyFailed();
    }
  }
  for (const auto& file : files)
  {
    if (!file->Commit())
    {
      return file->WhyFailed();
    }
  }
  return {};
}

/// The files of a path for a wind. Throws InvalidInput if the format cannot hold it.
InflowTarget TargetOf(const std::string& path, const InflowGrid& grid, const InflowRange& range, HawcOrder order)
{
  const std::filesystem::path file(path);
  InflowTarget target;
  switch (FormatOf(path))
  {
    case InflowFormat::TurbSim:
      target.Planes = std::make_unique<TurbSimPlanes>(grid, range);
      target.Paths = { path };
      break;
    case InflowFormat::Hawc:
    {
      target.Planes = std::make_unique<HawcPlanes>(grid, order);
      HawcText text{ grid, {}, order, true };
      for (int component = 0; component < 3; ++component)
      {
        text.Names[component] = file.stem().string() + "_" + "uvw"[component] + ".bin";
        target.Paths.push_back((file.parent_path() / text.Names[component]).string());
      }
      target.TextPath = path;
      target.Text = WriteHawcText(text);
      break;
    }
    case InflowFormat::Bladed:
    {
      auto planes = std::make_unique<BladedPlanes>(grid, range);
      target.Paths = { path };
      target.TextPath = std::filesystem::path(path).replace_extension(".sum").string();
      target.Text = planes->Summary();
      target.Planes = std::move(planes);
      break;
    }
    case InflowFormat::Netcdf:
      break; // no planes of ours
  }
  return target;
}

/// Writes planes to their files.
FileOutcome WriteTarget(const InflowTarget& target, const InflowSource& source)
{
  std::vector<std::unique_ptr<ReplacedFile>> files;
  std::vector<std::string> paths = target.Paths;
  if (!target.TextPath.empty())
  {
    paths.push_back(target.TextPath);
  }
  for (const std::string& path : paths)
  {
    files.push_back(std::make_unique<ReplacedFile>(path));
    if (!files.back()->WhyFailed().empty())
    {
      return { false, files.back()->WhyFailed() };
    }
  }
  try
  {
    WritePlanes(*target.Planes, files, source);
    if (!target.TextPath.empty())
    {
      files.back()->Stream() << target.Text;
    }
    const std::string reason = Replace(files);
    return { reason.empty(), reason };
  }
  catch (const WriteStopped&)
  {
    return { false, {} };
  }
  catch (const std::ios_base::failure& problem)
  {
    // What the system said of a file is clearer than what the stream made of it.
    std::string reason = problem.what();
    for (const auto& file : files)
    {
      file->Close();
      reason = file->WhyFailed().empty() ? reason : file->WhyFailed();
    }
    return { false, reason };
  }
}

}

InflowFile::InflowFile(const std::string& path, HawcOrder order)
{
  Require(path.empty() ? "FileName is empty" : "");
  switch (FormatOf(path))
  {
    case InflowFormat::TurbSim:
      this->OpenTurbSim(path);
      break;
    case InflowFormat::Hawc:
      this->OpenHawc(path, order);
      break;
    case InflowFormat::Bladed:
      this->OpenBladed(path);
      break;
    case InflowFormat::Netcdf:
      this->Records = OpenInflowNetcdf(path);
      break;
  }
}

InflowFile::~InflowFile() = default;

const InflowGrid& InflowFile::GetGrid() const
{
  return this->Records ? this->Records->GetGrid() : this->Planes->GetGrid();
}

void InflowFile::OpenTurbSim(const std::string& path)
{
  this->Files.push_back(Opened(path));
  const double size = SizeOf(this->Files[0]);
  this->Planes = std::make_unique<TurbSimPlanes>(HeadOf(this->Files[0], TurbSimPlanes::BytesToRead), size);
}

void InflowFile::OpenHawc(const std::string& path, HawcOrder order)
{
  const HawcText text = ReadHawcText(BytesOfFile(path, BytesPerByte, "A text of this size"));
  this->Planes = std::make_unique<HawcPlanes>(text.Grid, text.SaysOrder ? text.Order : order);
  for (const std::string& name : text.Names)
  {
    const std::string file = (std::filesystem::path(path).parent_path() / name).string();
    InContext("its file " + name + ": ", [&] {
      this->Files.push_back(Opened(file));
      Require(WhyOtherSize(*this->Planes, SizeOf(this->Files.back())));
    });
  }
}

void InflowFile::OpenBladed(const std::string& path)
{
  this->Files.push_back(Opened(path));
  const std::string beside = std::filesystem::path(path).replace_extension(".sum").string();
  const std::string text =
    InContext("its .sum: ", [&] { return BytesOfFile(beside, BytesPerByte, "A text of this size"); });
  const double size = SizeOf(this->Files[0]);
  this->Planes =
    std::make_unique<BladedPlanes>(HeadOf(this->Files[0], BladedPlanes::BytesToRead), size, ReadBladedSummary(text));
}

void InflowFile::Read(int first, int count, float* velocities)
{
  if (this->Records)
  {
    this->Records->Read(first, count, velocities);
    return;
  }
  const std::size_t values = 3 * this->GetGrid().PointsOfPlane();
  std::vector<std::string> bytes(this->Files.size(), std::string(this->Planes->BytesOfPlane(), '\0'));
  const std::vector<const char*> pointers = BytesOfFiles<const char>(bytes);
  for (int time = first; time < first + count; ++time)
  {
    for (std::size_t f = 0; f < this->Files.size(); ++f)
    {
      std::ifstream& file = this->Files[f];
      const auto place = static_cast<std::streamoff>(PlaceOf(*this->Planes, time));
      if (file.tellg() != std::streampos(place)) // a jump empties the buffer of the stream
      {
        file.seekg(place);
      }
      file.read(bytes[f].data(), static_cast<std::streamsize>(bytes[f].size()));
      Require(file ? "" : "it ends while it is read");
    }
    this->Planes->Decode(pointers.data(), velocities);
    velocities += values;
  }
}

double PlaceOf(const InflowPlanes& planes, int time)
{
  const bool isBackwards = planes.TimeAt(0) != 0;
  const int place = isBackwards ? planes.GetGrid().Count[0] - 1 - time : time;
  return static_cast<double>(planes.BytesOfHeader()) + static_cast<double>(planes.BytesOfPlane()) * place;
}

int TimesAtOnce(const InflowGrid& grid)
{
  const double planes = BytesOfSlab / (3.0 * sizeof(float) * static_cast<double>(grid.PointsOfPlane()));
  return static_cast<int>(std::clamp(planes, 1.0, static_cast<double>(grid.Count[0])));
}

bool ForSlabs(const InflowGrid& grid, bool isBackwards, const std::function<bool(int first, int count)>& use)
{
  const int times = grid.Count[0];
  const int atOnce = TimesAtOnce(grid);
  bool isGood = true;
  for (int done = 0; isGood && done < times; done += atOnce)
  {
    const int count = std::min(atOnce, times - done);
    isGood = use(isBackwards ? times - done - count : done, count);
  }
  return isGood;
}

InflowFormat FormatOf(const std::string& path)
{
  constexpr std::array<const char*, 4> extensions{ ".bts", ".hawc", ".wnd", ".nc" }; // by InflowFormat
  const std::string extension = std::filesystem::path(path).extension().string();
  const auto found = std::find(extensions.begin(), extensions.end(), extension);
  Require(
    found != extensions.end() ? "" : "its format is unknown; give a FileName that ends in .bts, .hawc, .wnd or .nc");
  return static_cast<InflowFormat>(found - extensions.begin());
}

FileOutcome WriteInflow(const std::string& path, const InflowGrid& grid, const InflowRange& range, HawcOrder order,
  const InflowSource& source)
{
  return FormatOf(path) == InflowFormat::Netcdf ? WriteInflowNetcdf(path, grid, source)
                                                : WriteTarget(TargetOf(path, grid, range, order), source);
}

}
