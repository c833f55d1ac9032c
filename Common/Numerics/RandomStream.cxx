// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/RandomStream.h"

#include "Numerics/Constants.h"
#include "Numerics/PhiloxLanes.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace littoral
{

namespace
{
std::uint64_t Joined(std::uint32_t high, std::uint32_t low)
{
  return static_cast<std::uint64_t>(high) << 32 | low;
}

/// The middle of one of 2^52 equal cells of (0, 1): never 0, never 1, exact in double precision. As 1 + b 2^-52, made
/// of its bits, less 1 and plus 2^-53, which rounds nothing.
double OpenUnitInterval(std::uint64_t bits)
{
  const std::uint64_t fromOne = bits >> 12 | 0x3FF0000000000000;
  double number = 0.0;
  std::memcpy(&number, &fromOne, sizeof(number));
  return number - 1.0 + 0x1p-53;
}

/// Counters whose words are made at a time.
constexpr std::size_t CountersAtOnce = 64;
using CounterBlock = std::array<std::uint64_t, CountersAtOnce>;
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

void RandomStream::FillBits(std::size_t count, const std::uint64_t* objects, const std::uint64_t* draws,
  std::uint64_t* first, std::uint64_t* second) const
{
  for (std::size_t n = PhiloxBits(this->Key, count, objects, draws, first, second); n < count; ++n)
  {
    const auto words = this->Words(objects[n], draws[n]);
    first[n] = Joined(words[0], words[1]);
    second[n] = Joined(words[2], words[3]);
  }
}

void RandomStream::FillWords(std::uint64_t object, std::uint64_t draw, std::size_t count, std::uint32_t* words) const
{
  CounterBlock objects;
  CounterBlock draws;
  CounterBlock first;
  CounterBlock second;
  objects.fill(object);
  for (std::size_t begin = 0; begin < count; begin += CountersAtOnce)
  {
    const std::size_t size = std::min(CountersAtOnce, count - begin);
    std::iota(draws.begin(), draws.end(), draw + begin);
    this->FillBits(size, objects.data(), draws.data(), first.data(), second.data());
    for (std::size_t n = 0; n < size; ++n)
    {
      std::uint32_t* four = words + 4 * (begin + n);
      four[0] = static_cast<std::uint32_t>(first[n] >> 32);
      four[1] = static_cast<std::uint32_t>(first[n]);
      four[2] = static_cast<std::uint32_t>(second[n] >> 32);
      four[3] = static_cast<std::uint32_t>(second[n]);
    }
  }
}

std::array<double, 2> RandomStream::UniformPair(std::uint64_t object, std::uint64_t draw) const
{
  const auto words = this->Words(object, draw);
  return { OpenUnitInterval(Joined(words[0], words[1])), OpenUnitInterval(Joined(words[2], words[3])) };
}

void RandomStream::UniformPairs(
  std::size_t count, const std::uint64_t* objects, const std::uint64_t* draws, double* first, double* second) const
{
  CounterBlock bits[2];
  for (std::size_t begin = 0; begin < count; begin += CountersAtOnce)
  {
    const std::size_t size = std::min(CountersAtOnce, count - begin);
    this->FillBits(size, objects + begin, draws + begin, bits[0].data(), bits[1].data());
    for (std::size_t n = 0; n < size; ++n)
    {
      first[begin + n] = OpenUnitInterval(bits[0][n]);
      second[begin + n] = OpenUnitInterval(bits[1][n]);
    }
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
