# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# Cases that take more than half a second of processor time, by their programs: what is not named here is in the tier
# `quick`, where a program may take 1 s. A filter of GoogleTest, * for all cases.
