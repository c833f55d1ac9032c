// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"

#include "Numerics/Constants.h"
#include "Numerics/PhiloxLanes.h"

#include <Random123/philox.h>

#include <cmath>

namespace littoral
{

namespace
{
/// The middle of one of 2^52 equal cells of (0, 1): never 0, never 1, exact in double precision.
double OpenUnitInterval(std::uint32_t high, std::uint32_t low)
{
  const std::uint64_t bits = (static_cast<std::uint64_t>(high) << 32 | low) >> 12;
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}
}

std::array<std::uint32_t, 4> RandomStream::Words(std::uint64_t object, std::uint64_t draw) const
{
  const r123::Philox4x32::ctr_type counter = { { static_cast<std::uint32_t>(object),
    static_cast<std::uint32_t>(object >> 32), static_cast<std::uint32_t>(draw),
    static_cast<std::uint32_t>(draw >> 32) } };
  const r123::Philox4x32::key_type key = { { this->Key[0], this->Key[1] } };
  const auto words = r123::Philox4x32()(counter, key);
  return { words[0], words[1], words[2], words[3] };
}

std::array<double, 2> RandomStream::UniformPair(std::uint64_t object, std::uint64_t draw) const
{
  const auto words = this->Words(object, draw);
  return { OpenUnitInterval(words[0], words[1]), OpenUnitInterval(words[2], words[3]) };
}

void RandomStream::UniformPairs(
  std::size_t count, const std::uint64_t* objects, const std::uint64_t* draws, double* first, double* second) const
{
  for (std::size_t n = PhiloxPairs(this->Key, count, objects, draws, first, second); n < count; ++n)
  {
    const auto pair = this->UniformPair(objects[n], draws[n]);
    first[n] = pair[0];
    second[n] = pair[1];
  }
}

std::array<double, 2> RandomStream::NormalPair(std::uint64_t object, std::uint64_t draw) const
{
  const auto uniform = this->UniformPair(object, draw);
  const double radius = std::sqrt(-2.0 * std::log(uniform[0]));
  const double angle = TwoPi * uniform[1];
  return { radius * std::cos(angle), radius * std::sin(angle) };
}

}
