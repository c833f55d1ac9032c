// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RasterAxes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gdal_priv.h>

namespace littoral
{

namespace
{

using Array = std::shared_ptr<GDALMDArray>;

/// The variable of a name, with two dimensions at least; null for none. It keeps its file open.
Array OpenVariable(const std::string& path, const std::string& variable)
{
  const std::unique_ptr<GDALDataset> file(
    GDALDataset::Open(path.c_str(), GDAL_OF_MULTIDIM_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  const std::shared_ptr<GDALGroup> root = file ? file->GetRootGroup() : nullptr;
  const Array array = root ? root->OpenMDArrayFromFullname("/" + variable) : nullptr;
  return array && array->GetDimensionCount() >= 2 ? array : nullptr;
}

/// The coordinates of a dimension; null for none.
Array CoordinatesOf(const Array& array, std::size_t fromLast)
{
  const auto& dimensions = array->GetDimensions();
  const auto& dimension = dimensions[dimensions.size() - fromLast];
  const Array coordinates = dimension->GetIndexingVariable();
  return coordinates && coordinates->GetDimensionCount() == 1 && dimension->GetSize() > 1 ? coordinates : nullptr;
}

/// The values of coordinates; none where they cannot be read.
std::vector<double> ValuesOf(const Array& coordinates)
{
  std::vector<double> values(coordinates->GetDimensions()[0]->GetSize());
  const GUInt64 first = 0;
  const std::size_t count = values.size();
  const bool isRead =
    coordinates->Read(&first, &count, nullptr, nullptr, GDALExtendedDataType::Create(GDT_Float64), values.data());
  return isRead ? values : std::vector<double>();
}

/// Whether values are a step apart, but for the rounding of single precision.
bool AreEven(const std::vector<double>& values)
{
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  const double slack = 1e-3 * std::abs(step) + 1e-6 * std::max(std::abs(values.front()), std::abs(values.back()));
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    if (!(std::abs(values[k] - values.front() - static_cast<double>(k) * step) <= slack))
    {
      return false;
    }
  }
  return step != 0.0;
}

}

std::optional<RasterAxes> AxesOf(const std::string& path, const std::string& variable)
{
  const Array array = OpenVariable(path, variable);
  RasterAxes axes;
  for (const bool isX : { true, false })
  {
    const Array coordinates = array ? CoordinatesOf(array, isX ? 1 : 2) : nullptr;
    const std::vector<double> values = coordinates ? ValuesOf(coordinates) : std::vector<double>();
    if (values.empty())
    {
      return {};
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    PlaceAxis& axis = isX ? axes.X : axes.Y;
    axis = { coordinates->GetName(), coordinates->GetUnit(), *low, *high };
    axes.AreEven = axes.AreEven && AreEven(values);
  }
  return axes;
}

void* PlacedByAxes(const std::string& path, const std::string& variable)
{
  const Array array = OpenVariable(path, variable);
  const std::size_t count = array ? array->GetDimensionCount() : 0;
  return array ? GDALDataset::ToHandle(array->AsClassicDataset(count - 1, count - 2)) : nullptr;
}

}
