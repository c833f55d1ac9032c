// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoverShapes.h"

#include "Numerics/Constants.h"
#include "Numerics/RandomStream.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace littoral
{

namespace
{

using Color3 = std::array<double, 3>;
const glm::dvec3 Up(0.0, 0.0, 1.0);

constexpr double MeanUp = 0.75; // part of the blades' normal that is upward, as of the grass that they stand for

constexpr int StripPoints = 5;      // of an element
constexpr int MostStrips = 1 << 12; // that are cells

/// Names an array, makes room for some points, and returns the place of its first value.
template <typename Array>
typename Array::ValueType* Allocate(Array* array, const char* name, int components, vtkIdType points)
{
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(points);
  return array->GetPointer(0);
}

/// Arrays of the elements.
class Strips
{
public:
  explicit Strips(int count)
  {
    const vtkIdType points = static_cast<vtkIdType>(StripPoints) * count;
    vtkNew<vtkFloatArray> places;
    vtkNew<vtkFloatArray> feet;
    vtkNew<vtkFloatArray> normals;
    vtkNew<vtkUnsignedCharArray> shades;
    this->Places = Allocate(places.Get(), "Points", 3, points);
    this->Feet = Allocate(feet.Get(), "Foot", 2, points);
    this->Normals = Allocate(normals.Get(), "Normals", 3, points);
    this->Shades = Allocate(shades.Get(), "Shade", 3, points);
    this->Data->SetPoints(vtkNew<vtkPoints>());
    this->Data->GetPoints()->SetData(places);
    this->Data->GetPointData()->AddArray(feet);
    this->Data->GetPointData()->SetNormals(normals);
    this->Data->GetPointData()->SetScalars(shades);
    const vtkIdType numbered = static_cast<vtkIdType>(StripPoints) * std::min(count, MostStrips);
    vtkNew<vtkIdTypeArray> numbers;
    vtkIdType* number = Allocate(numbers.Get(), "Numbers", 1, numbered);
    std::iota(number, number + numbered, 0);
    this->Data->SetStrips(vtkNew<vtkCellArray>());
    this->Data->GetStrips()->SetData(StripPoints, numbers);
  }

  /// The next point; five make a strip.
  void AddPoint(const std::array<double, 2>& foot, const glm::dvec3& at, const glm::dvec3& normal, const Color3& color)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      *this->Places++ = static_cast<float>(at[axis]);
      *this->Normals++ = static_cast<float>(normal[axis]);
      *this->Shades++ = static_cast<unsigned char>(color[static_cast<std::size_t>(axis)]);
    }
    *this->Feet++ = static_cast<float>(foot[0]);
    *this->Feet++ = static_cast<float>(foot[1]);
  }

  vtkNew<vtkPolyData> Data;

private:
  float* Places;
  float* Feet;
  float* Normals;
  unsigned char* Shades;
};

Color3 Scaled(const Color3& color, double factor)
{
  return { factor * color[0], factor * color[1], factor * color[2] };
}

/// Random numbers of an element.
struct Chance
{
  std::array<double, 2> Foot;
  std::array<double, 2> Turn;
  std::array<double, 2> Form;
};

/// A blade as two quadrangles and a tip, bent over; its five points are relative to its foot.
void AddBlade(const CoverTile& tile, const Chance& chance, Strips& strips)
{
  const double around = TwoPi * chance.Turn[0];
  const double bend = 0.15 + 0.75 * chance.Turn[1];
  const double height = 0.45 + 0.55 * chance.Form[0];
  const glm::dvec3 ahead(std::cos(around), std::sin(around), 0.0);
  const glm::dvec3 aside(-ahead.y, ahead.x, 0.0);
  const glm::dvec3 normal = glm::normalize(MeanUp * Up + (1.0 - MeanUp) * ahead);
  const auto add = [&](double t, double side) {
    // A parabola from the foot upward and over
    const glm::dvec3 at = height * (t * glm::dvec3(0.0, 0.0, 1.0 - 0.35 * bend * t) + bend * t * t * ahead) +
      side * 0.5 * tile.Width * (1.0 - 0.4 * t) * aside;
    // Dark among the others at the foot; no two blades are of one age.
    const double shade = 255.0 * (0.76 + 0.24 * t) * (0.88 + 0.12 * chance.Form[1]);
    strips.AddPoint(chance.Foot, at, normal, { shade, shade, shade * (1.0 - 0.12 * chance.Form[1]) });
  };
  for (const double t : { 0.0, 0.55 })
  {
    add(t, -1.0);
    add(t, 1.0);
  }
  add(1.0, 0.0);
}

/// A leaf of a length in a direction, which rises and falls by a parabola, widest at its middle.
void AddLeaf(const std::array<double, 2>& foot, double around, double length, double width, double rise, double lift,
  const Color3& color, Strips& strips)
{
  const glm::dvec3 ahead(std::cos(around), std::sin(around), 0.0);
  const glm::dvec3 aside(-ahead.y, ahead.x, 0.0);
  const auto add = [&](double t, double side) {
    const glm::dvec3 at = length * (t * ahead + rise * t * (1.5 - t) * Up) +
      0.5 * side * width * length * (aside + 0.3 * std::abs(side) * Up) + lift * Up;
    const glm::dvec3 normal = glm::normalize(Up - rise * (1.5 - 2.0 * t) * ahead - 0.3 * side * aside);
    strips.AddPoint(foot, at, normal, Scaled(color, 0.8 + 0.2 * t));
  };
  add(0.0, -0.3);
  add(0.0, 0.3);
  add(0.5, -1.0);
  add(0.5, 1.0);
  add(1.0, 0.0);
}

/// A leaf of a rosette of five, darker than grass.
void AddHerb(const CoverTile& tile, int number, const Chance& plant, const Chance& leaf, Strips& strips)
{
  const double around = TwoPi * (plant.Turn[0] + (number + 0.5 * leaf.Turn[1]) / tile.Group());
  const double shade = 255.0 * (0.55 + 0.25 * plant.Form[1]);
  AddLeaf(plant.Foot, around, (0.4 + 0.4 * plant.Form[0]) * (0.8 + 0.2 * leaf.Form[0]), tile.Width,
    0.5 + 0.9 * leaf.Form[1], 0.0, { 0.8 * shade, shade, 0.9 * shade }, strips);
}

/// The head of a flower among the tips of the grass: a disk that looks up and aside. Those of a cell are of one kind.
void AddFlower(const CoverTile& tile, const Chance& chance, Strips& strips)
{
  constexpr Color3 Kinds[4] = { { 236, 232, 222 }, { 232, 190, 48 }, { 142, 108, 178 }, { 236, 232, 222 } };
  const auto cell = static_cast<int>(4.0 * chance.Foot[0]) + 3 * static_cast<int>(4.0 * chance.Foot[1]);
  const double around = TwoPi * chance.Turn[0];
  const glm::dvec3 ahead(std::cos(around), std::sin(around), 0.0);
  const glm::dvec3 normal = glm::normalize(Up + 0.6 * chance.Turn[1] * ahead);
  const glm::dvec3 right = glm::normalize(glm::cross(normal, glm::dvec3(ahead.y, -ahead.x, 0.2)));
  const glm::dvec3 top = glm::cross(normal, right);
  const glm::dvec3 middle = 0.15 * ahead + (0.6 + 0.25 * chance.Form[0]) * Up;
  for (const int corner : { 0, 1, 4, 2, 3 }) // of a pentagon, as a strip
  {
    const double a = TwoPi * corner / 5.0;
    const glm::dvec3 at =
      middle + tile.Width * (0.7 + 0.3 * chance.Form[1]) * (std::cos(a) * right + std::sin(a) * top);
    strips.AddPoint(chance.Foot, at, normal, Scaled(Kinds[cell % 4], 0.85 + 0.15 * chance.Form[1]));
  }
}

/// A fallen leaf [m].
void AddFallenLeaf(const CoverTile& tile, const Chance& chance, Strips& strips)
{
  constexpr Color3 Kinds[3] = { { 132, 98, 62 }, { 160, 120, 72 }, { 104, 78, 54 } };
  const Color3 color = Scaled(Kinds[static_cast<std::size_t>(2.999 * chance.Form[1])], 0.7 + 0.3 * chance.Turn[1]);
  AddLeaf(chance.Foot, TwoPi * chance.Turn[0], 0.05 + 0.06 * chance.Form[0], tile.Width, 0.4 * chance.Turn[1] - 0.1,
    0.01 + 0.02 * chance.Form[1], color, strips);
}

/// Half of a stone [m]: three of its six sides, from a rim in the ground to its top. Few are large, P(r > R) ~ R^-2.
void AddStone(int half, const Chance& chance, Strips& strips)
{
  const double radius = std::min(0.03 / std::sqrt(1.0 - chance.Form[0]), 0.2);
  const double shade = 0.72 + 0.28 * chance.Form[1];
  const Color3 color = Scaled({ 138, 131, 120 }, shade);
  const auto addRim = [&](int corner) {
    const double a = TwoPi * (chance.Turn[0] + corner / 6.0);
    const double wide = radius * (1.0 + 0.3 * std::cos(2.0 * a + 9.0 * chance.Turn[1]));
    const glm::dvec3 out(std::cos(a), std::sin(a), 0.0);
    strips.AddPoint(chance.Foot, wide * out - 0.15 * radius * Up, glm::normalize(out + 0.5 * Up), Scaled(color, 0.8));
  };
  addRim(3 * half);
  addRim(3 * half + 1);
  const glm::dvec3 top(0.2 * radius * std::cos(9.0 * chance.Turn[1]), 0.2 * radius * std::sin(9.0 * chance.Turn[1]),
    (0.45 + 0.4 * chance.Turn[1]) * radius);
  strips.AddPoint(chance.Foot, top, Up, color);
  addRim(3 * half + 2);
  addRim(3 * half + 3);
}

std::array<double, 2> FootOf(const RandomStream& random, int element)
{
  return random.UniformPair(static_cast<std::uint64_t>(element), 0);
}

Chance ChanceOf(const RandomStream& random, int element)
{
  const auto object = static_cast<std::uint64_t>(element);
  return { FootOf(random, element), random.UniformPair(object, 1), random.UniformPair(object, 2) };
}

void AddElement(const CoverTile& tile, const RandomStream& random, int element, Strips& strips)
{
  const int number = element % tile.Group();
  const Chance first = ChanceOf(random, element - number);
  switch (tile.Kind)
  {
    case CoverKind::Grass:
      return AddBlade(tile, first, strips);
    case CoverKind::Herb:
      return AddHerb(tile, number, first, ChanceOf(random, element), strips);
    case CoverKind::Flower:
      return AddFlower(tile, first, strips);
    case CoverKind::Litter:
      return AddFallenLeaf(tile, first, strips);
    case CoverKind::Stone:
      return AddStone(number, first, strips);
  }
}

/// The elements of a tile by the cells that are made, with the ends of all cells among them.
std::vector<int> ByCells(
  const CoverTile& tile, const CoverCells& made, const RandomStream& random, std::vector<int>& ends)
{
  constexpr int Cells = CoverTile::Cells;
  std::array<std::vector<int>, Cells * Cells> cells;
  for (int element = 0; element < tile.Count; ++element)
  {
    const std::array<double, 2> foot = FootOf(random, element - element % tile.Group());
    const int cell = static_cast<int>(Cells * foot[0]) + Cells * static_cast<int>(Cells * foot[1]);
    if (made[static_cast<std::size_t>(cell)])
    {
      cells[static_cast<std::size_t>(cell)].push_back(element);
    }
  }
  std::vector<int> elements;
  ends = { 0 };
  for (const std::vector<int>& cell : cells)
  {
    elements.insert(elements.end(), cell.begin(), cell.end());
    ends.push_back(static_cast<int>(elements.size()));
  }
  return elements;
}

}

vtkSmartPointer<vtkPolyData> CoverShapes(const CoverTile& tile, const CoverCells& made, std::vector<int>& ends)
{
  const RandomStream random(tile.Count, RandomPurpose::GrassBlades);
  const std::vector<int> elements = ByCells(tile, made, random, ends);
  Strips strips(static_cast<int>(elements.size()));
  for (const int element : elements)
  {
    AddElement(tile, random, element, strips);
  }
  return strips.Data;
}

}
