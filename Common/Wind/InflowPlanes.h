// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralInflowPlanes_h
#define LittoralInflowPlanes_h

#include <array>
#include <cstddef>
#include <string>

namespace littoral
{

/// Grid of a wind as codes for wind turbines hold it: planes across the wind, one a time, that pass a place one by one.
struct InflowGrid
{
  std::array<int, 3> Count{ 2, 1, 1 }; ///< times; points across and up
  int TowerPoints = 0;                 ///< below the grid, on the middle line, a vertical spacing apart
  double TimeStep = 0.1;               ///< between planes [s], positive
  double LateralSpacing = 4.0;         ///< [m], positive
  double VerticalSpacing = 2.0;        ///< [m], positive
  double Speed = 10.0;                 ///< that carries the planes [m/s], positive
  double HubHeight = 1.0;              ///< above the ground [m]
  double BottomHeight = 1.0;           ///< of the lowest points of the grid above the ground [m]
  bool IsPeriodic = false;             ///< whether the first plane follows on the last
  std::string Description;

  std::size_t PointsOfGrid() const { return static_cast<std::size_t>(this->Count[1]) * this->Count[2]; }
  /// Points of a plane: those of the grid, across (to the left) fastest, then up; then those of the tower, downwards.
  std::size_t PointsOfPlane() const { return this->PointsOfGrid() + this->TowerPoints; }
};

/// Why a grid that was read, or is to be written, is none, in words for a user; empty when it is one.
std::string WhyInvalid(const InflowGrid& grid);

/// Smallest and largest number and sums of each component (along, across, up).
struct InflowRange
{
  std::array<float, 3> Low{ 0.0f, 0.0f, 0.0f };
  std::array<float, 3> High{ 0.0f, 0.0f, 0.0f };

  /// Takes in velocities, three numbers each. Throws InvalidInput if one is not finite.
  void Add(const float* velocities, std::size_t points);

  /// Root of the mean square of a component less a number.
  double DeviationFrom(double number, int component) const;

private:
  std::size_t Points = 0;
  std::array<double, 3> Sum{ 0.0, 0.0, 0.0 }; ///< less the first point, as the next
  std::array<double, 3> Square{ 0.0, 0.0, 0.0 };
  std::array<float, 3> First{ 0.0f, 0.0f, 0.0f };
};

/// Planes of a wind as bytes of a file, or of several that hold a part of each plane.
class InflowPlanes
{
public:
  virtual ~InflowPlanes() = default;

  const InflowGrid& GetGrid() const { return this->Grid; }
  virtual int NumberOfFiles() const { return 1; }
  /// Bytes before the first plane of a file.
  virtual std::string Header() const { return {}; }
  virtual std::size_t BytesOfHeader() const { return 0; }
  /// Bytes of a plane in each of the files.
  virtual std::size_t BytesOfPlane() const = 0;
  /// The time of the plane that lies at a place in the file.
  virtual int TimeAt(int place) const { return place; }
  /// Velocities of a plane, (along, across, up) of each point, from the bytes of each file.
  virtual void Decode(const char* const* bytes, float* velocities) const = 0;
  virtual void Encode(const float* velocities, char* const* bytes) const = 0;

protected:
  InflowPlanes() = default;

  InflowGrid Grid;
};

/// Why files of a size [bytes] do not hold their planes, in words for a user; empty when they do.
std::string WhyOtherSize(const InflowPlanes& planes, double size);

}

#endif
