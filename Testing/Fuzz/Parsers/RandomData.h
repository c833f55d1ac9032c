// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralFuzzRandomData_h
#define LittoralFuzzRandomData_h

// Arrays, tables and points that follow from libFuzzer's bytes.

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <limits>
#include <string>
#include <vector>

class RandomData : public FuzzedDataProvider
{
public:
  using FuzzedDataProvider::FuzzedDataProvider;

  /// A number: mostly a plain one, else an odd one or any bits.
  double Number()
  {
    constexpr double Infinity = std::numeric_limits<double>::infinity();
    switch (this->ConsumeIntegralInRange(0, 7))
    {
      case 0:
        return this->PickValueInArray({ 0.0, -0.0, -1.0, 1e-320, 1e-40, 1e16, 1e300, -1e300, Infinity, -Infinity,
          std::numeric_limits<double>::quiet_NaN(), 2147483648.0, 0.5 });
      case 1:
        return this->ConsumeFloatingPoint<double>();
      default:
        return this->ConsumeIntegralInRange(-2, 13);
    }
  }

  /// An array of one of the names, or of another one.
  vtkSmartPointer<vtkAbstractArray> Array(const std::vector<const char*>& names, vtkIdType tuples, int components)
  {
    vtkSmartPointer<vtkAbstractArray> array;
    switch (this->ConsumeIntegralInRange(0, 9))
    {
      case 0:
        array = vtkSmartPointer<vtkFloatArray>::New();
        break;
      case 1:
        array = vtkSmartPointer<vtkIntArray>::New();
        break;
      case 2:
        array = vtkSmartPointer<vtkUnsignedCharArray>::New();
        break;
      case 3:
        array = vtkSmartPointer<vtkIdTypeArray>::New();
        break;
      case 4:
        array = vtkSmartPointer<vtkStringArray>::New();
        break;
      default:
        array = vtkSmartPointer<vtkDoubleArray>::New();
    }
    array->SetName(
      this->ConsumeIntegralInRange(0, 15) == 0 ? this->ConsumeRandomLengthString(8).c_str() : this->OneOf(names));
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
    for (vtkIdType value = 0; value < array->GetNumberOfValues(); ++value)
    {
      const double number = this->Number();
      if (vtkStringArray::SafeDownCast(array))
      {
        array->SetVariantValue(value, vtkVariant(std::to_string(number)));
      }
      else if (vtkArrayDownCast<vtkDoubleArray>(array) || vtkArrayDownCast<vtkFloatArray>(array))
      {
        vtkDataArray::SafeDownCast(array)->SetComponent(
          value / components, static_cast<int>(value % components), number);
      }
      else
      {
        const double whole = number >= -2.0 && number <= 13.0 ? number : 255.0;
        vtkDataArray::SafeDownCast(array)->SetComponent(
          value / components, static_cast<int>(value % components), whole);
      }
    }
    return array;
  }

  /// Puts arrays of the names into a place of arrays: mostly all, and mostly of the sizes that fit.
  void Fill(
    vtkFieldData* place, const std::vector<const char*>& names, const std::vector<int>& components, vtkIdType tuples)
  {
    for (std::size_t index = 0; index < names.size(); ++index)
    {
      const int odd = this->ConsumeIntegralInRange(0, 15);
      if (odd != 0)
      {
        place->AddArray(this->Array(odd == 1 ? names : std::vector<const char*>{ names[index] },
          odd == 2 ? this->ConsumeIntegralInRange(0, 12) : tuples,
          odd == 3 ? this->ConsumeIntegralInRange(1, 9) : components[index]));
      }
    }
  }

  vtkIdType Count() { return this->ConsumeIntegralInRange(0, 9); }

private:
  const char* OneOf(const std::vector<const char*>& names)
  {
    return names[this->ConsumeIntegralInRange<std::size_t>(0, names.size() - 1)];
  }
};

#endif
