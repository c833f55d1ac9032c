# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Rscript TestPatternsAgainstSpatstat.R FOLDER writes spatstat's patterns and what it finds for them into a folder.
suppressMessages(library(spatstat))
folder <- commandArgs(TRUE)[1]

# The density estimate of R on a grid, of which pcf is made, is off by more than a percent at some distances: here the
# kernel is summed pair by pair, with spatstat's weights.
exact_g <- function(pattern, r, correction) {
  n <- npoints(pattern)
  h <- 0.15 / sqrt(intensity(pattern))
  pairs <- closepairs(pattern, max(r) + h)
  if (correction == "isotropic") {
    from <- ppp(pairs$xi, pairs$yi, window = Window(pattern), check = FALSE)
    weights <- as.vector(edge.Ripley(from, matrix(pairs$d, ncol = 1)))
  } else {
    weights <- edge.Trans(dx = pairs$dx, dy = pairs$dy, W = Window(pattern), paired = TRUE)
  }
  sapply(r, function(at) {
    sum(weights * 0.75 / h * pmax(0, 1 - ((at - pairs$d) / h)^2)) * area(Window(pattern)) / (2 * pi * at * n * (n - 1))
  })
}

for (name in c("redwood", "japanesepines", "cells", "longleaf", "lansing")) {
  pattern <- get(name)
  points <- unmark(pattern)
  table <- data.frame(x = pattern$x, y = pattern$y)
  if (name == "longleaf") table$DBH <- marks(pattern)
  if (name == "lansing") table$Species <- as.character(marks(pattern))
  write.csv(format(table, digits = 17), file.path(folder, paste0(name, ".csv")), row.names = FALSE, quote = FALSE)
  box <- Frame(pattern)
  # Not a length that rounded coordinates have.
  r <- seq(0, max(Kest(points)$r) * 0.9973, length.out = 513)
  found <- data.frame(r = r)
  for (correction in c("border", "isotropic", "translate")) {
    found[[paste0("K.", correction)]] <- Kest(points, r = r, correction = correction)[[3]]
    found[[paste0("L.", correction)]] <- Lest(points, r = r, correction = correction)[[3]]
    if (correction == "border") next
    found[[paste0("g.", correction)]] <- pcf(points, r = r, correction = correction)[[3]]
    found[[paste0("exact.", correction)]] <- exact_g(points, r, correction)
    if (name == "longleaf") found[[paste0("m.", correction)]] <- markcorr(pattern, r = r, correction = correction)[[3]]
  }
  if (name == "lansing") {
    for (correction in c("isotropic", "translate")) {
      found[[paste0("crossK.", correction)]] <-
        Kcross(pattern, "maple", "hickory", r = r, correction = correction)[[3]]
      found[[paste0("crossg.", correction)]] <-
        pcfcross(pattern, "maple", "hickory", r = r, correction = correction)[[3]]
    }
  }
  write.csv(format(found, digits = 17), file.path(folder, paste0(name, "-pairs.csv")), row.names = FALSE, quote = FALSE)
  # Distances are binned by spatstat: fine bins.
  fine <- seq(0, 0.4 / sqrt(intensity(points)) * 0.9973, length.out = 512 * 32 + 1)
  rows <- seq(1, length(fine), by = 32)
  found <- data.frame(r = fine[rows])
  for (correction in c("rs", "km")) {
    found[[paste0("G.", correction)]] <- Gest(points, r = fine, correction = correction)[[3]][rows]
    found[[paste0("F.", correction)]] <- Fest(points, r = fine, correction = correction)[[3]][rows]
    found[[paste0("J.", correction)]] <- Jest(points, r = fine, correction = correction)[[3]][rows]
  }
  write.csv(format(found, digits = 17), file.path(folder, paste0(name, "-nearest.csv")), row.names = FALSE, quote = FALSE)
  cat(name, box$xrange, box$yrange, "\n")
}
# The fit of redwood as Thomas clusters; that of cells with a soft core is in Testing/Common/Patterns/TestSoftCore.cxx.
thomas <- parameters(kppm(redwood, ~1, "Thomas", statistic = "K"))
cat("redwood-as-thomas", thomas$kappa, thomas$scale, thomas$mu, "\n")
# Three patterns with trends: composite likelihood, and K of weighted points. Kinhom divides by |W| and by the sum of the
# weights; Littoral by that sum's square less the sum of squares, as here. The difference of kappa is printed too.
for (name in c("longleaf", "redwoodfull", "finpines")) {
  pattern <- unmark(get(name))
  write.csv(format(data.frame(x = pattern$x, y = pattern$y), digits = 17), file.path(folder, paste0(name, "-trend.csv")),
            row.names = FALSE, quote = FALSE)
  box <- Frame(pattern)
  for (trend in list(~polynom(x, y, 1), ~polynom(x, y, 2))) {
    weights <- 1 / fitted(do.call(ppm, list(pattern, trend, nd = 256)), dataonly = TRUE)
    estimate <- Kinhom(pattern, 1 / weights, normpower = 2, correction = "isotropic")
    estimate$iso <- estimate$iso / (1 - sum(weights^2) / sum(weights)^2)
    own <- kppm(pattern, trend, "Thomas", statistic = "K")$modelpar[1]
    cat("trend", name, box$xrange, box$yrange, thomas.estK(estimate)$modelpar[1:2], matclust.estK(estimate)$modelpar[1:2],
        lgcp.estK(estimate)$modelpar[1:2], own, "\n")
  }
}
places <- expand.grid(x = c(10, 70, 130, 190), y = c(10, 70, 130, 190))
fit <- ppm(unmark(longleaf), ~polynom(x, y, 2), nd = 256)
cat("longleaf-trend", predict(fit, locations = ppp(places$x, places$y, window = Window(longleaf))), "\n")
curve <- markcorr(longleaf, correction = "translate")
cat("published", as.function(curve, value = "trans")(c(2, 5, 10, 20)), max(curve$r), "\n")
