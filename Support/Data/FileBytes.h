// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportFileBytes_h
#define LittoralSupportFileBytes_h

// Files as a whole. Private: never installed, never wrapped.

#include <string>

namespace littoral
{

/// The bytes of a file; there must be memory for so many times of them, as `what` takes. Throws InvalidInput.
std::string BytesOfFile(const std::string& path, double bytesPerByte, const char* what);

}

#endif
