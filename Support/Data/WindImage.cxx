// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/WindImage.h"

#include "Data/ArrayReader.h"
#include "Data/Arrays.h"
#include "Data/Tables.h"
#include "Numerics/InvalidInput.h"
#include "Pipeline/Pipeline.h"
#include "Wind/WindVeer.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Parameters of the model of a wind and their names as field data.
template <typename Model, typename Visit>
void ForEachParameter(Model& model, const Visit& visit)
{
  visit("ReferenceSpeed", model.ReferenceSpeed);
  visit("ReferenceHeight", model.ReferenceHeight);
  visit("RoughnessLength", model.RoughnessLength);
  visit("TurbulenceIntensity", model.TurbulenceIntensity);
  const char* decays[WindComponents] = { "LongitudinalDecay", "LateralDecay", "VerticalDecay" };
  for (int component = 0; component < WindComponents; ++component)
  {
    visit(decays[component], model.Decay[component]);
  }
}

/// Sets parameters of a model from field data.
struct ParameterReader
{
  ArrayReader Fields;

  void operator()(const char* name, double& value) const
  {
    value = this->Take(name, "1 component", 1)->GetComponent(0, 0);
  }
  void operator()(const char* name, WindDecay& decay) const
  {
    vtkDataArray* found = this->Take(name, "2 components", 2);
    decay = { found->GetComponent(0, 0), found->GetComponent(0, 1) };
  }

  vtkDataArray* Take(const char* name, const char* form, int components) const
  {
    if (!this->Fields.Has(name))
    {
      Refuse("The wind has no field array ", name, " of ", form, "; it must be the output of Wind Field.");
    }
    return this->Fields.Need(name, components);
  }
};

struct ParameterWriter
{
  vtkDataObject* Data;

  void operator()(const char* name, double value) const { AddField(this->Data, name, { value }); }
  void operator()(const char* name, const WindDecay& decay) const
  {
    AddField(this->Data, name, { decay.Lateral, decay.Vertical });
  }
};

/// Reads the field data of WriteWindModel.
WindModel ReadModel(vtkImageData* image)
{
  WindModel model;
  const ParameterReader reader{ ArrayReader::OfFields(image, "The wind", 1) };
  ForEachParameter(model, reader);
  vtkDataArray* exponent = reader.Fields.Find("ShearExponent", 1);
  model.ShearExponent = exponent ? exponent->GetComponent(0, 0) : 0.0;
  vtkDataArray* veer = reader.Fields.Find("Veer", 1);
  model.Veer = veer ? veer->GetComponent(0, 0) : 0.0;
  double families[2] = { 0.0, 0.0 };
  reader("Spectrum", families[0]);
  reader("Coherence", families[1]);
  ReadWhole("Spectrum of the wind", families[0], 0, NumberOfWindSpectra - 1, model.Spectrum);
  ReadWhole("Coherence of the wind", families[1], 0, NumberOfWindCoherences - 1, model.Coherence);
  return model;
}

WindTimes ReadTimes(vtkImageData* image)
{
  const ArrayReader fields = ArrayReader::OfFields(image, "The wind", 1);
  vtkDataArray* speed = fields.Need("ConvectionSpeed", 1);
  vtkDataArray* told = fields.Find("Period", 1);
  const double convection = speed->GetComponent(0, 0);
  if (!(convection > 0.0) || !std::isfinite(convection))
  {
    Refuse("The wind has no field data ConvectionSpeed that is positive.");
  }
  const int samples = image->GetDimensions()[0];
  WindTimes times;
  times.Step = image->GetSpacing()[0] / convection;
  if (samples < 4 || !(times.Step > 0.0))
  {
    Refuse("The wind has no duration: it needs at least four samples along x, and a positive Spacing.");
  }
  times.Samples = static_cast<std::size_t>(samples);
  const double period = told ? told->GetComponent(0, 0) : 0.0;
  if (told && !(std::abs(period - times.Period()) < 1e-3 * times.Period()))
  {
    Refuse("Period of the wind is not the length of its image over ConvectionSpeed.");
  }
  return times;
}

vtkSmartPointer<vtkFloatArray> ReadVelocity(vtkImageData* image)
{
  const ArrayReader points = ArrayReader::OfPoints(image, "The wind");
  const auto floats = WithType<vtkFloatArray>(points.Need("Velocity", WindComponents));
  points.NeedFinite(floats);
  return floats;
}

FrozenWindGrid GridOf(vtkImageData* image)
{
  FrozenWindGrid grid;
  const int* extent = image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Size[axis] = image->GetDimensions()[axis];
    grid.FirstIndex[axis] = extent[2 * axis];
    for (int column = 0; column < 4; ++column)
    {
      grid.ToIndex[axis][column] = image->GetPhysicalToIndexMatrix()->GetElement(axis, column);
    }
  }
  grid.LayerSpacing = image->GetSpacing()[2];
  grid.Bottom = image->GetOrigin()[2] + extent[4] * grid.LayerSpacing;
  return grid;
}

}

std::shared_ptr<const FrozenWind> ReadWind(vtkImageData* image)
{
  const vtkSmartPointer<vtkFloatArray> velocity = ReadVelocity(image);
  const WindTimes times = ReadTimes(image);
  const FrozenWindGrid grid = GridOf(image);
  RequireMemory(WindLines::BytesOf(grid.Size), "The waves of the wind", "take a smaller wind");
  return std::make_shared<const FrozenWind>(grid, times, velocity->GetPointer(0), SmpFor);
}

void WriteWindModel(const WindModel& model, vtkDataObject* data)
{
  ForEachParameter(model, ParameterWriter{ data });
  if (model.ShearExponent > 0.0)
  {
    AddField(data, "ShearExponent", { model.ShearExponent });
  }
  if (model.Veer != 0.0)
  {
    AddField(data, "Veer", { model.Veer });
  }
  AddField(data, "Spectrum", { static_cast<double>(model.Spectrum) });
  AddField(data, "Coherence", { static_cast<double>(model.Coherence) });
}

ModelledWind ReadModelledWind(vtkImageData* image)
{
  const vtkSmartPointer<vtkFloatArray> floats = ReadVelocity(image);
  ModelledWind wind;
  wind.Model = ReadModel(image);
  const WindTimes times = ReadTimes(image);
  std::copy_n(image->GetDimensions(), 3, wind.Grid.Count.begin());
  wind.Grid.TimeStep = times.Step;
  wind.Grid.LateralSpacing = image->GetSpacing()[1];
  wind.Grid.VerticalSpacing = image->GetSpacing()[2];
  wind.Grid.BottomHeight = image->GetOrigin()[2] + image->GetExtent()[4] * image->GetSpacing()[2];
  Require(WhyInvalid(wind.Model, wind.Grid));
  // Velocities in world axes are turned back into those of the wind.
  const vtkMatrix3x3* axes = image->GetDirectionMatrix();
  const double cosine = axes->GetElement(0, 0);
  const double sine = axes->GetElement(1, 0);
  wind.Velocities = ListOf(floats.Get());
  for (std::size_t n = 0; n < wind.Velocities.size(); n += WindComponents)
  {
    float* v = wind.Velocities.data() + n;
    const double x = v[0];
    v[0] = static_cast<float>(cosine * x + sine * v[1]);
    v[1] = static_cast<float>(cosine * v[1] - sine * x);
  }
  TurnWithHeight(wind.Model, wind.Grid, VeerTurn::ToLocal, wind.Velocities.data());
  return wind;
}

Vector3 MiddleOfWind(vtkImageData* image, double height)
{
  double bounds[6];
  image->GetBounds(bounds);
  return { bounds[0], 0.5 * (bounds[2] + bounds[3]), height };
}

}
