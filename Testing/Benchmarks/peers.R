# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
# Times of R packages at work that Littoral does, too: lines of name and least time of seven runs (one of the slowest) [ms]. A package that is
# missing has no line.
least <- function(work, runs) {
  times <- sapply(seq_len(runs), function(run) {
    gc(FALSE)
    system.time(work())[["elapsed"]]
  })
  1000 * min(times)
}
report <- function(name, work, runs = 7) cat(sprintf("%s,%.1f\n", name, least(work, runs)))
has <- function(package) suppressWarnings(suppressPackageStartupMessages(require(package, character.only = TRUE, quietly = TRUE)))

if (has("RandomFields")) {
  RFoptions(spConform = FALSE, printlevel = 0, cores = 1L)
  side <- seq(0, 1023)
  model <- RPtbm(RMexp(var = 1, scale = 100), lines = 64)
  report("RandomFields", function() RFsimulate(model, x = side, y = side, grid = TRUE, n = 1))
}
if (has("spatstat.random")) {
  window <- spatstat.geom::owin(c(0, 1000), c(0, 1000))
  report("spatstat", function() rMatClust(0.25, 2, 4, win = window))
  report("spatstat Thomas", function() rThomas(0.2, 0.5, 5, win = window))
  if (requireNamespace("spatstat.explore", quietly = TRUE)) {
    square <- spatstat.geom::owin(c(0, 100), c(0, 100))
    points <- rpoispp(1, win = square)
    report("spatstat pcf", function() spatstat.explore::pcf(points, r = seq(0, sqrt(1000 / pi), length.out = 513),
      correction = "isotropic"), 1)
  }
}
