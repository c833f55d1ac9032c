// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause

// OpenVDB stays on the thread that calls it: TBB's library hands work over to its threads by atomics, of which the
// sanitizer of threads knows nothing.
#include <tbb/global_control.h>

namespace
{

const tbb::global_control OneThread(tbb::global_control::max_allowed_parallelism, 1);

}
