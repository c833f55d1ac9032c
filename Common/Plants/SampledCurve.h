// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSampledCurve_h
#define LittoralSampledCurve_h

#include <glm/vec4.hpp>

#include <vector>

namespace littoral
{

/// Sampling of a motion, and interpolation between the samples.
struct Sampling
{
  int Stride = 1;        ///< frames from a sample to the next one; the last frame has one in any case
  bool IsSmooth = false; ///< cubic curves instead of lines between the samples
};

/// Every so manieth frame from the first one on, and the last one.
std::vector<int> SampledFrames(int frames, int stride);

/// The numbers that a curve keeps: one a sample of lines; three of cubic curves, the slope before the sample, its
/// value, and the slope after it.
int CountOf(const Sampling& sampling, int frames);

/**
 * The curve through samples with the least sum of squared distances to the values of all frames. Slopes are changes a
 * frame. Where a cubic curve has fewer than two frames between two samples, a line is there.
 */
std::vector<glm::dvec4> CurveThrough(const std::vector<glm::dvec4>& values, const Sampling& sampling);

/// The value of a curve at a frame.
glm::dvec4 CurveAt(const std::vector<glm::dvec4>& curve, const Sampling& sampling, int frames, int frame);

}

#endif
