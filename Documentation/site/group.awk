# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Doxygen's filter: makes a group of what a header of Common has in the namespace littoral, so that a page can show it.
# Lines keep their numbers.
{ line[FNR] = $0 }
END {
  name = FILENAME
  if (name ~ /Common\//) {
    sub(/.*Common\//, "", name)
    group = name
    gsub(/[\/.]/, "_", group)
    line[1] = "/** @defgroup " group " " name " */"
    for (k = 1; k <= FNR; ++k) {
      if (line[k] == "namespace littoral" && line[k + 1] == "{" && !first)
        first = k + 1
      if (line[k] ~ /^}/)
        last = k
    }
    if (first && last) {
      line[first] = "{ /** @addtogroup " group " */ /**@{*/"
      line[last] = "/**@}*/ }"
    }
  }
  for (k = 1; k <= FNR; ++k)
    print line[k]
}
