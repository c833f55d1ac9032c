// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Hides instruction sets of the processor from a library: GCC's choice between versions of a function begins with
// __cpu_indicator_init, which the linker replaces by what is here (--wrap).

extern "C"
{

  /// What GCC knows of the processor, in each library for itself (libgcc, cpuinfo.h).
  struct ProcessorModel
  {
    unsigned int Vendor;
    unsigned int Type;
    unsigned int Subtype;
    unsigned int Features;
  };

  // Names that GCC has given. They are hidden: the choice is made before the library is linked to others.
  // NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming)
  extern ProcessorModel __cpu_model __attribute__((visibility("hidden")));
  int __attribute__((visibility("hidden"))) __real___cpu_indicator_init();

  int __attribute__((visibility("hidden"))) __wrap___cpu_indicator_init()
  {
    constexpr unsigned int avx2 = 1u << 10;
    constexpr unsigned int avx512f = 1u << 15;
    const int result = __real___cpu_indicator_init();
    __cpu_model.Features &= ~(LITTORAL_MOST_IS_AVX2 ? avx512f : avx2 | avx512f);
    return result;
  }
  // NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
}
