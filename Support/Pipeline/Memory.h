// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportMemory_h
#define LittoralSupportMemory_h

// Memory that a request may take: the least of what the machine has free, of the limits of the process, and of those of
// its control groups (containers, batch systems); and points, which take time. Private: never installed, never wrapped.

#include <functional>
#include <string>
#include <vector>

namespace littoral
{

/// Memory that can be taken without driving others out, or being refused [bytes]; infinite where the system does not
/// tell, as without /proc.
double AvailableMemory();

/**
 * Throws InvalidInput unless so many bytes can be taken: "A wind of 9 x 9 x 9 points needs 2.5 GiB of memory, and 1.2
 * GiB are free: take fewer." Whatever is about to take memory by what a file, an input or a property says asks here
 * first.
 */
void RequireMemory(double bytes, const std::string& what, const std::string& remedy);

/// Points that one update makes at most: 5e7, or the positive number in the environment variable
/// LITTORAL_MAXIMUM_POINTS. Two cores take at most two minutes for as many.
double MaximumPoints();

/**
 * Throws InvalidInput where a property asks for more than MaximumPoints(): "MeanPerQuadrat of 100000 gives 160 million
 * points, more than the bound of 50 million: at most 31250 do." The points are in proportion to the property. Whatever
 * makes points by what a property says asks here first.
 */
void RequirePoints(double points, const std::string& property, double value);

/**
 * The same for a grid by its points along each side: "A wind of Dimensions 20000 x 100 x 100 gives 200 million points,
 * more than the bound of 50 million: at most 5000 x 100 x 100 do." A point that takes longer than one of a terrain
 * counts as more, by `cost`. `suitable` is the largest number up to another that the first side can have.
 */
void RequireGridPoints(const std::string& property, std::vector<double> sides, double cost = 1.0,
  const std::function<double(double)>& suitable = {});

/// Throws std::bad_alloc where next to nothing is left: for the polls of what takes its memory bit by bit. Looks at
/// most twenty times a second.
void EndIfShortOfMemory();

/// Memory that the limits of the process leave of its address space and data [bytes]; infinite without a limit (ulimit
/// -v, -d).
double LimitedMemory();

/**
 * Memory that the control groups of the process and those around them leave [bytes]; infinite without a limit.
 * `membership` is the text of /proc/self/cgroup, `root` the folder that the groups are mounted at. Versions 1 and 2.
 */
double GroupMemory(const std::string& membership, const std::string& root);

}

#endif
