// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralTestWindAlong_h
#define LittoralTestWindAlong_h

#include "Numerics/Constants.h"
#include "Wind/FrozenWind.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace littoral::testing
{

/// A wind with gusts that waves carry along a direction: known at any place and time, and as the field of its samples.
struct WindAlong
{
  double Direction = 0.0; ///< from the axis x [rad]
  double Speed = 8.0;     ///< mean [m/s]
  double Gusts = 1.5;     ///< amplitude of each of three waves [m/s]
  double Spacing = 1.6;   ///< of samples along the wind [m]
  int Samples = 300;
  double HalfWidth = 60.0; ///< of the field across the wind [m]

  Vector3 Along() const { return { std::cos(this->Direction), std::sin(this->Direction), 0.0 }; }
  Vector3 Across() const { return { -std::sin(this->Direction), std::cos(this->Direction), 0.0 }; }
  WindTimes Times() const { return { this->Spacing / this->Speed, static_cast<std::size_t>(this->Samples) }; }

  /// Velocity at a distance along the wind [samples] when the field has not moved.
  Vector3 At(double sample) const
  {
    const double angle = TwoPi * sample / this->Samples;
    return (this->Speed + this->Gusts * std::sin(3.0 * angle)) * this->Along() +
      this->Gusts * std::sin(11.0 * angle + 1.0) * this->Across() +
      Vector3(0.0, 0.0, this->Gusts * std::cos(23.0 * angle));
  }

  /// The wind at a place by its formula.
  WindAtPlace Formula() const
  {
    return [wind = *this](const Vector3& place, double first, std::size_t count, Vector3* velocities) {
      for (std::size_t step = 0; step < count; ++step)
      {
        velocities[step] = wind.At(glm::dot(place, wind.Along()) / wind.Spacing - (first + static_cast<double>(step)));
      }
    };
  }

  /// The field of the samples: three lines across, two layers from 0 to 40 m.
  FrozenWind Field() const
  {
    FrozenWindGrid grid;
    grid.Size = { this->Samples, 3, 2 };
    const Vector3 along = this->Along() / this->Spacing;
    const Vector3 across = this->Across() / this->HalfWidth;
    grid.ToIndex = { { { along.x, along.y, 0.0, 0.0 }, { across.x, across.y, 0.0, 1.0 },
      { 0.0, 0.0, 1.0 / 40.0, 0.0 } } };
    grid.LayerSpacing = 40.0;
    std::vector<float> velocities;
    for (int line = 0; line < 6; ++line)
    {
      for (int sample = 0; sample < this->Samples; ++sample)
      {
        const Vector3 velocity = this->At(sample);
        for (int axis = 0; axis < 3; ++axis)
        {
          velocities.push_back(static_cast<float>(velocity[axis]));
        }
      }
    }
    return { grid, this->Times(), velocities.data() };
  }
};

}

#endif
