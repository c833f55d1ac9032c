// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/Memory.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/ParameterCheck.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <limits>
#include <new>
#include <sstream>

#ifndef _WIN32
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace littoral
{

namespace
{

constexpr double Unlimited = std::numeric_limits<double>::infinity();

/// Part of the free memory that may be used: the rest is for what no estimate counts.
constexpr double UsableShare = 0.9;

double HostMemory()
{
  vtksys::SystemInformation system;
  const auto total = static_cast<double>(system.GetHostMemoryTotal());
  const auto used = static_cast<double>(system.GetHostMemoryUsed());
  return total > 0.0 ? 1024.0 * (total - used) : Unlimited;
}

/// Requests of less are granted unseen, and those of less than a large one by the limits of the process alone [bytes].
constexpr double Small = 0x1p20;
constexpr double Large = 0x1p24;

/// Memory that is left to others, and to the sentence that tells of the want [bytes].
constexpr double Reserve = 0x1p26;

/// A number of bytes in words, as "1.2 GiB".
std::string WordsFor(double bytes)
{
  std::ostringstream text;
  text << std::setprecision(3) << (bytes < 0x1p30 ? bytes / 0x1p20 : bytes / 0x1p30);
  return text.str() + (bytes < 0x1p30 ? " MiB" : " GiB");
}

/// A number of points in words, as "3600 million".
std::string MillionsOf(double points)
{
  std::ostringstream text;
  text << (points < 1e9 ? std::defaultfloat : std::fixed) << std::setprecision(points < 1e9 ? 3 : 0) << points / 1e6;
  return text.str() + " million";
}

[[noreturn]] void RefusePoints(const std::string& what, double points, const std::string& enough)
{
  Refuse(what, MillionsOf(points), " points, more than the bound of ", MillionsOf(MaximumPoints()), ": at most ",
    enough, " do.");
}

/// A number in words that is not above `value`: whole, or of three digits.
std::string Floor(double value)
{
  const double perUnit = std::pow(10.0, std::max(0.0, 2.0 - std::floor(std::log10(value))));
  return TextOf(std::floor(value * perUnit) / perUnit);
}

/// Points along the sides of a grid, as "60001 x 60001".
std::string Joined(const std::vector<double>& sides)
{
  std::string text;
  for (const double side : sides)
  {
    text += (text.empty() ? "" : " x ") + TextOf(side);
  }
  return text;
}

double Product(const std::vector<double>& sides, double longest = Unlimited)
{
  double product = 1.0;
  for (const double side : sides)
  {
    product *= std::min(side, longest);
  }
  return product;
}

/// The longest side, in whole points, of a part of a grid that has at most so many points.
double CommonBound(const std::vector<double>& sides, double points)
{
  double low = 1.0;
  double high = *std::max_element(sides.begin(), sides.end());
  while (high - low > 1.0)
  {
    const double middle = std::floor(0.5 * (low + high));
    (Product(sides, middle) <= points ? low : high) = middle;
  }
  return low;
}

/// The number in a file; `otherwise` if there is none, as in memory.max with its "max".
double NumberIn(const std::string& file, double otherwise)
{
  std::ifstream stream(file);
  double number = 0.0;
  return stream >> number ? number : otherwise;
}

/// The number behind a word that begins a line of a file; 0 if there is none.
double NumberAfter(const std::string& file, const std::string& wanted)
{
  std::ifstream stream(file);
  std::string word;
  double number = 0.0;
  while (stream >> word >> number)
  {
    if (word == wanted)
    {
      return number;
    }
  }
  return 0.0;
}

/// Memory that one group leaves; files that were read and can be dropped do not count as used.
double LeftIn(const std::string& folder, const char* limit, const char* usage, const char* droppable)
{
  const double most = NumberIn(folder + limit, Unlimited);
  const double used = NumberIn(folder + usage, 0.0) - NumberAfter(folder + "/memory.stat", droppable);
  return std::max(0.0, most - std::max(0.0, used));
}

}

double LimitedMemory()
{
  double left = Unlimited;
#ifndef _WIN32
  // Pages: size of the address space, ..., the sixth number is data and stack
  std::ifstream stream("/proc/self/statm");
  double pages[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  std::copy_n(std::istream_iterator<double>(stream), stream.good() ? 6 : 0, pages);
  const auto page = static_cast<double>(sysconf(_SC_PAGESIZE));
  const auto take = [&](auto resource, double used) {
    rlimit limit;
    if (getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    {
      left = std::min(left, std::max(0.0, static_cast<double>(limit.rlim_cur) - page * used));
    }
  };
  take(RLIMIT_AS, pages[0]);
  take(RLIMIT_DATA, pages[5]);
#endif
  return left;
}

double GroupMemory(const std::string& membership, const std::string& root)
{
  double left = Unlimited;
  std::istringstream lines(membership);
  std::string line;
  while (std::getline(lines, line))
  {
    // "0::/path" in version 2, "7:memory:/path" in version 1
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos)
    {
      continue;
    }
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const bool isOld = controllers.find(",memory,") != std::string::npos;
    if (!isOld && controllers != ",,")
    {
      continue;
    }
    // The group itself and all around it; in a container, the path may not be there, but the root is.
    for (std::string path = line.substr(second + 1);; path.resize(path.rfind('/')))
    {
      std::string folder = root;
      folder.append(isOld ? "/memory" : "").append(path);
      left = std::min(left,
        isOld ? LeftIn(folder, "/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_inactive_file")
              : LeftIn(folder, "/memory.max", "/memory.current", "inactive_file"));
      if (path.find('/') == std::string::npos)
      {
        break;
      }
    }
  }
  return left;
}

double AvailableMemory()
{
  std::ifstream groups("/proc/self/cgroup");
  const std::string membership{ std::istreambuf_iterator<char>(groups), std::istreambuf_iterator<char>() };
  return UsableShare * std::min({ HostMemory(), LimitedMemory(), GroupMemory(membership, "/sys/fs/cgroup") });
}

void RequireMemory(double bytes, const std::string& what, const std::string& remedy)
{
  const double left = bytes > Large ? AvailableMemory() : bytes > Small ? UsableShare * LimitedMemory() : Unlimited;
  if (!(bytes <= left))
  {
    Refuse(what, " needs ", WordsFor(bytes), " of memory, and ", WordsFor(left), " are free: ", remedy, ".");
  }
}

double MaximumPoints()
{
  const char* text = std::getenv("LITTORAL_MAXIMUM_POINTS");
  const double most = text ? std::strtod(text, nullptr) : 0.0;
  return most > 0.0 ? most : 5e7;
}

void RequirePoints(double points, const std::string& property, double value)
{
  const double most = MaximumPoints();
  if (!(points <= most))
  {
    RefusePoints(property + " of " + TextOf(value) + " gives ", points, Floor(value * (most / points)));
  }
}

void RequireGridPoints(
  const std::string& property, std::vector<double> sides, double cost, const std::function<double(double)>& suitable)
{
  const double most = MaximumPoints();
  const double points = cost * Product(sides);
  if (!(points <= most))
  {
    const std::string what = property + " " + Joined(sides) + (cost > 1.0 ? " takes the time of " : " gives ");
    const double side = CommonBound(sides, most / cost);
    std::for_each(sides.begin(), sides.end(), [=](double& own) { own = std::min(own, side); });
    sides[0] = suitable ? suitable(sides[0]) : sides[0];
    RefusePoints(what, points, Joined(sides));
  }
}

void EndIfShortOfMemory()
{
  using Clock = std::chrono::steady_clock;
  static std::atomic<Clock::rep> last{ 0 };
  const Clock::rep now = Clock::now().time_since_epoch().count();
  if (now - last > Clock::duration(std::chrono::milliseconds(50)).count())
  {
    last = now;
    if (AvailableMemory() < Reserve)
    {
      throw std::bad_alloc();
    }
  }
}

}
