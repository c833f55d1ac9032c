// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Every bad property of the terrain source gives one message that names it, a failed update and an empty output.
#include "ErrorCounter.h"
#include "vtkTurningBandsTerrainSource.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <climits>
#include <functional>
#include <iostream>
#include <limits>
#include <vector>

namespace
{

using Source = vtkTurningBandsTerrainSource;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

bool Fails(const char* word, const std::function<void(Source*)>& spoil)
{
  vtkNew<Source> source;
  source->SetWholeExtent(0, 20, 0, 20, 0, 0);
  spoil(source);
  vtkNew<ErrorCounter> errors;
  errors->Watch(source);
  bool good = errors->ExpectOneNaming(word);
  if (source->GetOutput()->GetNumberOfPoints() != 0)
  {
    std::cerr << "output is not empty for bad " << word << std::endl;
    good = false;
  }
  return good;
}

/// After a refusal the next valid request gives what a fresh object gives, also where sizes and lines change.
bool RefusedThenGrownAsFresh()
{
  vtkNew<Source> used;
  used->SetWholeExtent(0, 99, 0, 99, 0, 0);
  used->Update();
  {
    vtkNew<ErrorCounter> errors;
    used->SetNumberOfLines(-1);
    errors->Watch(used);
    errors->ExpectOneNaming("NumberOfLines");
  }
  vtkNew<Source> fresh;
  for (Source* source : { used.Get(), fresh.Get() })
  {
    source->SetNumberOfLines(0);
    source->SetWholeExtent(0, 9, 0, 9, 0, 0);
    source->Update();
  }
  const auto values = [](Source* source) {
    vtkDataArray* array = source->GetOutput()->GetPointData()->GetScalars();
    std::vector<double> copy;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      copy.push_back(array->GetComponent(i, 0));
    }
    return copy;
  };
  if (values(used).size() != 100 || values(used) != values(fresh))
  {
    std::cerr << "after a refusal the terrain is not that of a fresh source" << std::endl;
    return false;
  }
  return true;
}

/// Tables without fits, or without a model.
bool RefusesTables()
{
  vtkNew<vtkTable> empty;
  bool good = Fails("empty", [&](Source* s) { s->SetInputData(empty); });
  vtkNew<vtkTable> other;
  vtkNew<vtkDoubleArray> column;
  column->SetName("Distance");
  column->InsertNextValue(1.0);
  other->AddColumn(column);
  good &= Fails("ModelId", [&](Source* s) { s->SetInputData(other); });
  column->SetName("ModelId");
  column->SetValue(0, NaN);
  good &= Fails("ModelId", [&](Source* s) { s->SetInputData(other); });
  return good;
}

/// A part of an extent that as a whole would not fit is no trouble, also once the whole was refused.
bool GrowsAPartOfTheHuge()
{
  bool good = true;
  vtkNew<Source> huge;
  huge->SetWholeExtent(0, 3200000, 0, 3200000, 0, 0);
  {
    vtkNew<ErrorCounter> errors;
    errors->Watch(huge);
    good &= errors->ExpectOneNaming("more than the bound");
  }
  const int part[6] = { 50000, 50031, 70000, 70031, 0, 0 };
  huge->UpdateExtent(part);
  if (huge->GetOutput()->GetNumberOfPoints() != 32 * 32)
  {
    std::cerr << "a small part of a huge terrain was not grown" << std::endl;
    good = false;
  }
  return good;
}

}

int TestTerrainBadInput(int, char*[])
{
  const double inf = std::numeric_limits<double>::infinity();
  bool good = true;
  for (double bad : { 0.0, -3.0, NaN, inf })
  {
    good &= Fails("Range", [=](Source* s) { s->SetRange(bad); });
    good &= Fails("Spacing", [=](Source* s) { s->SetSpacing(bad, 1.0, 1.0); });
    good &= Fails("SecondRange", [=](Source* s) {
      s->SetModelToTelis();
      s->SetSecondRange(bad);
    });
    good &= Fails("Reflectance", [=](Source* s) {
      s->ReflectanceOn();
      s->SetReflectanceRange(bad);
    });
  }
  for (double bad : { 2.0, 3.0, 1.0, 4.0, NaN })
  {
    good &= Fails("FractalDimension", [=](Source* s) { s->SetFractalDimension(bad); });
  }
  for (int bad : { 0, -1, INT_MIN })
  {
    good &= Fails("NumberOfHarmonics", [=](Source* s) { s->SetNumberOfHarmonics(bad); });
  }
  for (int bad : { -1, INT_MIN }) // 0 asks for as many as are needed
  {
    good &= Fails("NumberOfLines", [=](Source* s) { s->SetNumberOfLines(bad); });
    good &= Fails("Range", [=](Source* s) { s->SetRange(bad); }); // found before lines are counted
  }
  good &= RefusedThenGrownAsFresh();
  good &= Fails("Model", [](Source* s) { s->SetModel(7); });
  good &= Fails("Model", [](Source* s) { s->SetModel(-1); });
  for (const double deviation : { NaN, -5.0, 1e300, 1e-20 })
  {
    good &= Fails("Elevation: StandardDeviation is ", [=](Source* s) { s->SetStandardDeviation(deviation); });
    good &= Fails("Reflectance: ReflectanceStandardDeviation is ",
      [=](Source* s) { s->ReflectanceOn(), s->SetReflectanceStandardDeviation(deviation); });
  }
  good &= Fails("ReflectanceModel is 7", [](Source* s) { s->ReflectanceOn(), s->SetReflectanceModel(7); });
  good &= Fails("ReflectanceRange is -1 m", [](Source* s) { s->ReflectanceOn(), s->SetReflectanceRange(-1.0); });
  good &= Fails("ReflectanceMean is nan", [=](Source* s) { s->ReflectanceOn(), s->SetReflectanceMean(NaN); });
  good &= Fails("Mean", [=](Source* s) { s->SetMean(NaN); });
  good &= Fails("Slope", [=](Source* s) { s->SetSlope(NaN, 0.0); });
  good &= Fails("Origin", [=](Source* s) { s->SetOrigin(NaN, 0.0, 0.0); });
  good &= Fails("AnisotropyRatio", [](Source* s) { s->SetAnisotropyRatio(0.5); });
  good &= Fails("AnisotropyRatio", [=](Source* s) { s->SetAnisotropyRatio(NaN); });
  good &= Fails("AnisotropyAngle", [=](Source* s) { s->SetAnisotropyAngle(NaN); });
  good &= Fails("MinimumWavelength", [](Source* s) { s->SetMinimumWavelength(-1.0); });
  good &= Fails("empty", [](Source* s) { s->SetWholeExtent(0, -1, 0, 5, 0, 0); });
  good &= Fails("layers", [](Source* s) { s->SetWholeExtent(0, 5, 0, 5, 0, 3); });
  // 40 TiB, beyond any machine of today: refused before memory is asked for.
  good &= Fails("more than the bound", [](Source* s) { s->SetWholeExtent(0, 3200000, 0, 3200000, 0, 0); });

  good &= RefusesTables();
  good &= GrowsAPartOfTheHuge();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
