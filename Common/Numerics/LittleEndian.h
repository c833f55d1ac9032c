// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralLittleEndian_h
#define LittoralLittleEndian_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace littoral
{

/// Unsigned integer as wide as a number of 2, 4 or 8 bytes.
template <typename Number>
using BitsOf = std::conditional_t<sizeof(Number) == 2, std::uint16_t,
  std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>;

template <typename Number>
inline constexpr bool HasBits = sizeof(BitsOf<Number>) == sizeof(Number);

/// Puts a number of 2, 4 or 8 bytes, its lowest byte first, on any machine.
template <typename Number>
void PutLittleEndian(Number number, char* to)
{
  static_assert(HasBits<Number>, "a number of 2, 4 or 8 bytes");
  BitsOf<Number> bits;
  std::memcpy(&bits, &number, sizeof bits);
  for (std::size_t n = 0; n < sizeof bits; ++n)
  {
    to[n] = static_cast<char>(static_cast<unsigned char>(bits >> 8 * n));
  }
}

/// Takes a number of 2, 4 or 8 bytes, its lowest byte first.
template <typename Number>
Number TakeLittleEndian(const char* from)
{
  static_assert(HasBits<Number>, "a number of 2, 4 or 8 bytes");
  BitsOf<Number> bits = 0;
  for (std::size_t n = 0; n < sizeof bits; ++n)
  {
    bits =
      static_cast<BitsOf<Number>>(bits | static_cast<BitsOf<Number>>(static_cast<unsigned char>(from[n])) << 8 * n);
  }
  Number number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

/// Appends a number of 2, 4 or 8 bytes, its lowest byte first.
template <typename Number>
void AppendLittleEndian(Number number, std::string& bytes)
{
  bytes.resize(bytes.size() + sizeof number);
  PutLittleEndian(number, &bytes[bytes.size() - sizeof number]);
}

}

#endif
