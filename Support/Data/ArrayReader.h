// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralSupportArrayReader_h
#define LittoralSupportArrayReader_h

// The one way to arrays of data that come from elsewhere. Private: never installed, never wrapped.

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
 * point, cell or row, and the type of number, if one is asked for. The first reason why there is none is kept, in words
 * for a user: "The wind has no point array Velocity of 3 components."
 *
 *   ArrayReader points = ArrayReader::OfPoints(data, "The wind");
 *   vtkDataArray* velocity = points.Need("Velocity", 3);
 *   auto* weights = points.Find<vtkFloatArray>("Weights", 4); // null also where there is no such array
 *   return points.Reason();
 */
class ArrayReader
{
public:
  static ArrayReader OfPoints(vtkDataSet* data, const std::string& owner);
  static ArrayReader OfCells(vtkDataSet* data, const std::string& owner);
  static ArrayReader OfRows(vtkTable* table, const std::string& owner);
  /// Field arrays, of any number of tuples unless told otherwise.
  static ArrayReader OfFields(vtkDataObject* data, const std::string& owner, vtkIdType tuples = -1);

  /// The array; null with a reason if there is none, or one of another form.
  template <typename Array = vtkDataArray>
  Array* Need(const char* name, int components)
  {
    return Array::SafeDownCast(this->Take(name, components, TypeOf<Array>(), true));
  }

  /// The array; null with a reason if there is one of another form, and without if there is none.
  template <typename Array = vtkDataArray>
  Array* Find(const char* name, int components)
  {
    return Array::SafeDownCast(this->Take(name, components, TypeOf<Array>(), false));
  }

  /// An array that was found otherwise, as the active normals, if it has the form; null without a reason for null.
  template <typename Array = vtkDataArray>
  Array* Fit(vtkDataArray* array, int components)
  {
    return Array::SafeDownCast(this->Check(array, array ? array->GetName() : nullptr, components, TypeOf<Array>()));
  }

  /// The array of texts of one component; null if there is none, with a reason if it has another form.
  vtkStringArray* FindTexts(const char* name);

  /// All arrays of the form, in their order.
  std::vector<vtkDataArray*> All(int components) const;

  /// An array of any number of components; null where there is none.
  vtkDataArray* Any(const char* name) const;

  /// Whether there is an array of the name, be it of numbers or not.
  bool Has(const char* name) const;

  /// Keeps a reason if a number of an array is not finite or of no sensible magnitude; null is good.
  void NeedFinite(vtkDataArray* array);

  /// Keeps a reason if a number of an array is none of 0 ... count-1, or of `lowest` ... count-1, in the word for what
  /// it names; null is good.
  void NeedIds(vtkDataArray* array, vtkIdType count, const char* of, vtkIdType lowest = 0);

  /// Why the first of the bad arrays is bad; empty if none is.
  const std::string& Reason() const { return this->First; }

  bool IsGood() const { return this->First.empty(); }

private:
  ArrayReader(vtkFieldData* arrays, vtkIdType tuples, const char* kind, const char* elements, const std::string& owner);

  vtkFieldData* Arrays;
  vtkIdType Tuples;
  const char* Kind;     ///< "point array"
  const char* Elements; ///< "points"
  std::string Owner;
  std::string First;

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

  vtkDataArray* Take(const char* name, int components, int type, bool isNeeded);
  vtkDataArray* Check(vtkAbstractArray* array, const char* name, int components, int type);
  void Complain(const std::string& predicate);
};

/**
 * A number as a whole one from `low` to `high`. Else false, with the reason unless there is one already: "LawId is
 * 1e+30; it must be a whole number from 0 to 3."
 */
bool ReadWhole(
  const std::string& name, double number, long long low, long long high, long long& whole, std::string& reason);

/// The same for an int or an enumeration.
template <typename Whole>
bool ReadWhole(const std::string& name, double number, long long low, long long high, Whole& whole, std::string& reason)
{
  long long found = 0;
  const bool isGood = ReadWhole(name, number, low, high, found, reason);
  whole = isGood ? static_cast<Whole>(found) : whole;
  return isGood;
}

}

#endif
