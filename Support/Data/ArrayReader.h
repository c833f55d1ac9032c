// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportArrayReader_h
#define LittoralSupportArrayReader_h

// The one way to arrays of data that come from elsewhere. Private: never installed, never wrapped.

#include "Numerics/InvalidInput.h"

#include "vtkDataArray.h"
#include "vtkTypeTraits.h"

#include <string>
#include <type_traits>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkFieldData;
class vtkStringArray;
class vtkTable;

namespace littoral
{

/**
 * Finds arrays of numbers by name, and only those of the form that is asked for: so many components, a tuple for each
 * point, cell or row, and the type of number, if one is asked for. Throws InvalidInput where there is none: "The wind
 * has no point array Velocity of 3 components."
 *
 *   const ArrayReader points = ArrayReader::OfPoints(data, "The wind");
 *   vtkDataArray* velocity = points.Need("Velocity", 3);
 *   auto* weights = points.Find<vtkFloatArray>("Weights", 4); // null where there is no such array
 */
class ArrayReader
{
public:
  static ArrayReader OfPoints(vtkDataSet* data, const std::string& owner);
  static ArrayReader OfCells(vtkDataSet* data, const std::string& owner);
  static ArrayReader OfRows(vtkTable* table, const std::string& owner);
  /// Field arrays, of any number of tuples unless told otherwise.
  static ArrayReader OfFields(vtkDataObject* data, const std::string& owner, vtkIdType tuples = -1);

  /// The array. Throws if there is none, or one of another form.
  template <typename Array = vtkDataArray>
  Array* Need(const char* name, int components) const
  {
    return Array::SafeDownCast(this->Take(name, components, TypeOf<Array>(), true));
  }

  /// The array; null if there is none. Throws if there is one of another form.
  template <typename Array = vtkDataArray>
  Array* Find(const char* name, int components) const
  {
    return Array::SafeDownCast(this->Take(name, components, TypeOf<Array>(), false));
  }

  /// The array if it has the form, else null.
  template <typename Array = vtkDataArray>
  Array* Seek(const char* name, int components) const
  {
    return Array::SafeDownCast(this->IfFits(this->Named(name), components, TypeOf<Array>()));
  }

  /// Likewise of an array that was found otherwise.
  template <typename Array = vtkDataArray>
  Array* Seek(vtkDataArray* array, int components) const
  {
    return Array::SafeDownCast(this->IfFits(array, components, TypeOf<Array>()));
  }

  /// An array that was found otherwise, as the active normals; null is good. Throws if it has another form.
  template <typename Array = vtkDataArray>
  Array* Fit(vtkDataArray* array, int components) const
  {
    return Array::SafeDownCast(this->Check(array, array ? array->GetName() : nullptr, components, TypeOf<Array>()));
  }

  /// The array of texts of one component; null if there is none. Throws if it has another form.
  vtkStringArray* FindTexts(const char* name) const;

  /// All arrays of the form, in their order.
  std::vector<vtkDataArray*> All(int components) const;

  /// An array of any number of components; null where there is none.
  vtkDataArray* Any(const char* name) const;

  /// Whether there is an array of the name, be it of numbers or not.
  bool Has(const char* name) const;

  /// Throws if a number of an array is not finite or of no sensible magnitude; null is good.
  void NeedFinite(vtkDataArray* array) const;

  /// Throws if a number of an array is none of 0 ... count-1, or of `lowest` ... count-1, in the word for what it
  /// names; null is good.
  void NeedIds(vtkDataArray* array, vtkIdType count, const char* of, vtkIdType lowest = 0) const;

private:
  ArrayReader(vtkFieldData* arrays, vtkIdType tuples, const char* kind, const char* elements, const std::string& owner);

  vtkFieldData* Arrays;
  vtkIdType Tuples;
  const char* Kind;     ///< "point array"
  const char* Elements; ///< "points"
  std::string Owner;

  template <typename Array>
  static constexpr int TypeOf()
  {
    if constexpr (std::is_same_v<Array, vtkDataArray>)
    {
      return VTK_VOID; // any
    }
    else
    {
      return vtkTypeTraits<typename Array::ValueType>::VTK_TYPE_ID;
    }
  }

  vtkAbstractArray* Named(const char* name) const;
  vtkDataArray* Take(const char* name, int components, int type, bool isNeeded) const;
  vtkDataArray* Check(vtkAbstractArray* array, const char* name, int components, int type) const;
  vtkDataArray* IfFits(vtkAbstractArray* array, int components, int type) const;
  std::string WhyOther(vtkAbstractArray* array, int components, int type) const;
};

/// Whether a number is a whole one from `low` to `high`.
bool IsWhole(double number, long long low, long long high);

/// Throws InvalidInput unless a number is a whole one: "LawId is 1e+30; it must be a whole number from 0 to 3."
void RequireWhole(const std::string& name, double number, long long low, long long high);

/// A number as a whole one, an int or an enumeration. Throws as RequireWhole().
template <typename Whole>
void ReadWhole(const std::string& name, double number, long long low, long long high, Whole& whole)
{
  RequireWhole(name, number, low, high);
  whole = static_cast<Whole>(static_cast<long long>(number));
}

}

#endif
