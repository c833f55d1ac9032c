// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportMemory_h
#define LittoralSupportMemory_h

// Memory that a request may take: the least of what the machine has free, of the limits of the process, and of those of
// its control groups (containers, batch systems). Private: never installed, never wrapped.

#include <string>

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
