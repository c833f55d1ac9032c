// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kriging/KrigingModel.h"

#include "Numerics/ParameterCheck.h"

#include <algorithm>
#include <numeric>

namespace littoral
{

namespace
{

/// "(3, 4)"
std::string PlaceText(const KrigingPlace& place)
{
  return "(" + TextOf(place.X) + ", " + TextOf(place.Y) + ")";
}

/// Why two data at one place are too many; empty if no two exact ones are.
std::string WhyTwice(const KrigingData& data)
{
  std::vector<std::size_t> order(data.Places.size());
  std::iota(order.begin(), order.end(), 0);
  const auto before = [&](std::size_t a, std::size_t b) {
    const KrigingPlace& p = data.Places[a];
    const KrigingPlace& q = data.Places[b];
    // Exact ones first, so that two of them stand side by side.
    const bool exactA = data.ErrorVariance(a) == 0.0;
    const bool exactB = data.ErrorVariance(b) == 0.0;
    return p.X != q.X ? p.X < q.X : p.Y != q.Y ? p.Y < q.Y : exactA != exactB ? exactA : a < b;
  };
  std::sort(order.begin(), order.end(), before);
  for (std::size_t n = 1; n < order.size(); ++n)
  {
    const std::size_t a = order[n - 1];
    const std::size_t b = order[n];
    const KrigingPlace& p = data.Places[a];
    const KrigingPlace& q = data.Places[b];
    if (p.X == q.X && p.Y == q.Y && data.ErrorVariance(a) == 0.0 && data.ErrorVariance(b) == 0.0)
    {
      const bool same = data.Values[a] == data.Values[b];
      return "Data " + std::to_string(a) + " and " + std::to_string(b) + " are both at " + PlaceText(p) +
        (same ? ", with the same value"
              : ", with the values " + TextOf(data.Values[a]) + " and " + TextOf(data.Values[b]) +
              ", which contradict each other") +
        "; leave one of them out, or give them a measurement error or a nugget.";
    }
  }
  return "";
}

}

std::string WhyInvalid(const KrigingModel& model)
{
  ParameterCheck check;
  check.Require(WhyInvalid(model.Field));
  check.Require(model.Field.Variance > 0.0, "Variance", model.Field.Variance, "", "positive");
  check.NotNegative("Nugget", model.Nugget);
  check.Within("AnisotropyRatio", model.AnisotropyRatio, ValueInterval::AtLeast(1.0));
  check.Finite("AnisotropyAngle", model.AnisotropyAngle);
  return check.Reason();
}

std::string WhyInvalid(const KrigingData& data, const KrigingModel& model)
{
  if (data.Places.empty())
  {
    return "There are no data; at least one is needed.";
  }
  for (std::size_t n = 0; n < data.Places.size(); ++n)
  {
    const KrigingPlace& place = data.Places[n];
    const bool isGood = IsSensible(place.X) && IsSensible(place.Y) && IsSensible(place.External);
    const double error = data.ErrorVariance(n);
    if (!isGood || !IsSensible(data.Values[n]))
    {
      return "Datum " + std::to_string(n) + " at " + PlaceText(place) + " has " +
        (isGood ? "the value " + TextOf(data.Values[n]) : "the drift " + TextOf(place.External)) +
        "; places, values and drifts must be finite.";
    }
    if (!IsSensible(error) || error < 0.0)
    {
      return "Datum " + std::to_string(n) + " has the error variance " + TextOf(error) + "; it must be at least 0.";
    }
  }
  return model.Nugget > 0.0 ? "" : WhyTwice(data);
}

}
