# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Writes Testing/Data/PointPatterns/spatstat.csv: what spatstat finds for three synthetic patterns, which the C++ tests
# make anew from the same congruential generator (minstd_rand0 of the C++ standard). Run as
#   Rscript Testing/Common/Patterns/spatstat_reference.R > Testing/Data/PointPatterns/spatstat.csv
suppressMessages(library(spatstat))

state <- 1
uniform <- function() {
  state <<- (16807 * state) %% 2147483647 # exact in double precision
  state / 2147483647
}

# Parents and their offspring, uniform in squares about them; those outside the window are left out.
clusters <- function(seed, window, parents, offspring, reach) {
  state <<- seed
  box <- Frame(window)
  x <- y <- m <- numeric(0)
  for (parent in seq_len(parents)) {
    px <- box$xrange[1] + diff(box$xrange) * uniform()
    py <- box$yrange[1] + diff(box$yrange) * uniform()
    for (child in seq_len(offspring)) {
      cx <- px + reach * (2 * uniform() - 1)
      cy <- py + reach * (2 * uniform() - 1)
      mark <- 1 + 9 * uniform()
      if (inside.owin(cx, cy, window)) {
        x <- c(x, cx)
        y <- c(y, cy)
        m <- c(m, mark)
      }
    }
  }
  ppp(x, y, window = window, marks = m)
}

cat("# spatstat", as.character(packageVersion("spatstat")), "spatstat.explore",
    as.character(packageVersion("spatstat.explore")), "\n", sep = " ")
cat("pattern,function,correction,r,value\n")

put <- function(pattern, name, correction, fv, at) {
  value <- as.data.frame(fv)[[3]]
  r <- fv$r
  for (k in at) cat(sprintf("%s,%s,%s,%.17g,%.17g\n", pattern, name, correction, r[k + 1], value[k + 1]))
}

measure <- function(name, pattern) {
  points <- unmark(pattern)
  largest <- 0.2 * min(diff(Frame(pattern)$xrange), diff(Frame(pattern)$yrange))
  r <- seq(0, largest, length.out = 513)
  at <- seq(64, 512, by = 64)
  for (correction in c("none", "border", "isotropic", "translate")) {
    put(name, "K", correction, Kest(points, r = r, correction = correction), at)
  }
  for (correction in c("isotropic", "translate")) {
    put(name, "g", correction, pcf(points, r = r, correction = correction), at)
    put(name, "m", correction, markcorr(pattern, r = r, correction = correction), at)
  }
  # Distances to the nearest point are binned, as those of cross functions are: fine bins leave no difference.
  largest <- 0.5 * sqrt(log(1e5) / (pi * intensity(points)))
  fine <- seq(0, largest, length.out = 512 * 64 + 1)
  for (correction in c("none", "rs", "km")) {
    put(name, "G", correction, Gest(points, r = fine, correction = correction), at * 64)
    put(name, "F", correction, Fest(points, r = fine, correction = correction), at * 64)
  }
  # The first half of the points against the others.
  half <- npoints(points) %/% 2
  two <- points %mark% factor(rep(c("a", "b"), c(half, npoints(points) - half)))
  r <- seq(0, 0.2 * min(diff(Frame(pattern)$xrange), diff(Frame(pattern)$yrange)), length.out = 513)
  fine <- seq(0, max(r), length.out = 512 * 64 + 1)
  for (correction in c("none", "border", "isotropic", "translate")) {
    put(name, "crossK", correction, Kcross(two, "a", "b", r = fine, correction = correction), at * 64)
  }
  for (correction in c("isotropic", "translate")) {
    put(name, "crossg", correction, pcfcross(two, "a", "b", r = r, correction = correction), at)
  }
}

measure("clusters", clusters(11, owin(c(0, 100), c(-20, 60)), 40, 6, 4))
measure("scattered", clusters(12, owin(c(0, 1), c(0, 1)), 300, 1, 0))
measure("polygon", clusters(13, owin(poly = list(x = c(0, 90, 100, 60, 40, 5), y = c(10, 0, 80, 60, 95, 70))), 50, 5, 6))
