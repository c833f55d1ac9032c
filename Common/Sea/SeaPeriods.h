// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSeaPeriods_h
#define LittoralSeaPeriods_h

#include "Sea/SeaSpectrum.h"
#include "Sea/WaveTrains.h"

#include <vector>

namespace littoral
{

/// Height and periods of a sea by moments m_n of its spectrum over frequency [Hz].
struct SeaPeriods
{
  double Height;       ///< 4 m0^0.5 [m]
  double Peak;         ///< Tp, of the most energy; of trains that of the highest [s]
  double Energy;       ///< Tm-1,0 = m-1 / m0 [s]
  double Mean;         ///< Tm01 = m0 / m1 [s]
  double ZeroCrossing; ///< Tm02 = (m0 / m2)^0.5 [s]
};

/// Periods of a spectrum, with its part above all frequencies that are summed as w^-5; of a table from a thousandth of
/// its peak frequency on, as m-1 has no bound where the density is not 0 at frequency 0.
SeaPeriods PeriodsOf(const SeaSpectrum& spectrum);

/// Periods of trains, which must be some.
SeaPeriods PeriodsOf(const std::vector<WaveTrain>& trains);

}

#endif
