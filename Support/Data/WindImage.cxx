// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/WindImage.h"

#include "Data/ArrayReader.h"
#include "Data/Tables.h"
#include "Pipeline/Pipeline.h"

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

vtkSmartPointer<vtkFloatArray> FloatsOf(vtkDataArray* array)
{
  vtkSmartPointer<vtkFloatArray> floats = vtkFloatArray::SafeDownCast(array);
  if (!floats)
  {
    floats = vtkSmartPointer<vtkFloatArray>::New();
    floats->DeepCopy(array);
  }
  return floats;
}

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
  ArrayReader& Fields;

  void operator()(const char* name, double& value) const
  {
    vtkDataArray* found = this->Fields.Need(name, 1);
    value = found ? found->GetComponent(0, 0) : value;
  }
  void operator()(const char* name, WindDecay& decay) const
  {
    vtkDataArray* found = this->Fields.Need(name, 2);
    decay = found ? WindDecay{ found->GetComponent(0, 0), found->GetComponent(0, 1) } : decay;
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
std::string ReadModel(vtkImageData* image, WindModel& model)
{
  ArrayReader fields = ArrayReader::OfFields(image, "The wind", 1);
  const ParameterReader reader{ fields };
  ForEachParameter(model, reader);
  double families[2] = { 0.0, 0.0 };
  reader("Spectrum", families[0]);
  reader("Coherence", families[1]);
  std::string reason = fields.Reason();
  if (reason.find(" no ") != std::string::npos)
  {
    reason.back() = ';';
    return reason + " it must be the output of Wind Field.";
  }
  ReadWhole("Spectrum of the wind", families[0], 0, NumberOfWindSpectra - 1, model.Spectrum, reason);
  ReadWhole("Coherence of the wind", families[1], 0, NumberOfWindCoherences - 1, model.Coherence, reason);
  return reason;
}

std::string ReadTimes(vtkImageData* image, WindTimes& times)
{
  ArrayReader fields = ArrayReader::OfFields(image, "The wind", 1);
  vtkDataArray* speed = fields.Need("ConvectionSpeed", 1);
  vtkDataArray* told = fields.Find("Period", 1);
  if (!fields.IsGood())
  {
    return fields.Reason();
  }
  const double convection = speed->GetComponent(0, 0);
  if (!(convection > 0.0) || !std::isfinite(convection))
  {
    return "The wind has no field data ConvectionSpeed that is positive.";
  }
  const int samples = image->GetDimensions()[0];
  times.Step = image->GetSpacing()[0] / convection;
  if (samples < 4 || !(times.Step > 0.0))
  {
    return "The wind has no duration: it needs at least four samples along x, and a positive Spacing.";
  }
  times.Samples = static_cast<std::size_t>(samples);
  const double period = told ? told->GetComponent(0, 0) : 0.0;
  if (told && !(std::abs(period - times.Period()) < 1e-3 * times.Period()))
  {
    return "Period of the wind is not the length of its image over ConvectionSpeed.";
  }
  return {};
}

/// The velocities of a wind; null with a reason if there are none, or some that are not finite.
vtkSmartPointer<vtkFloatArray> ReadVelocity(vtkImageData* image, std::string& reason)
{
  ArrayReader points = ArrayReader::OfPoints(image, "The wind");
  vtkDataArray* velocity = points.Need("Velocity", WindComponents);
  const vtkSmartPointer<vtkFloatArray> floats = velocity ? FloatsOf(velocity) : nullptr;
  points.NeedFinite(floats);
  reason = points.Reason();
  return reason.empty() ? floats : nullptr;
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

std::string ReadWind(vtkImageData* image, std::shared_ptr<const FrozenWind>& wind)
{
  std::string reason;
  const vtkSmartPointer<vtkFloatArray> velocity = ReadVelocity(image, reason);
  if (!velocity)
  {
    return reason;
  }
  WindTimes times;
  reason = ReadTimes(image, times);
  if (!reason.empty())
  {
    return reason;
  }
  const FrozenWindGrid grid = GridOf(image);
  const double bytes = WindLines::BytesOf(grid.Size);
  if (bytes > AvailableMemory())
  {
    return "The waves of the wind need " + std::to_string(static_cast<long long>(bytes / 1e6)) +
      " MB, more than this machine has free.";
  }
  wind = std::make_shared<const FrozenWind>(grid, times, velocity->GetPointer(0), SmpFor);
  return {};
}

void WriteWindModel(const WindModel& model, vtkDataObject* data)
{
  ForEachParameter(model, ParameterWriter{ data });
  AddField(data, "Spectrum", { static_cast<double>(model.Spectrum) });
  AddField(data, "Coherence", { static_cast<double>(model.Coherence) });
}

std::string ReadModelledWind(vtkImageData* image, ModelledWind& wind)
{
  std::string reason;
  const vtkSmartPointer<vtkFloatArray> floats = ReadVelocity(image, reason);
  reason = reason.empty() ? ReadModel(image, wind.Model) : reason;
  WindTimes times;
  reason = reason.empty() ? ReadTimes(image, times) : reason;
  if (!reason.empty())
  {
    return reason;
  }
  std::copy_n(image->GetDimensions(), 3, wind.Grid.Count.begin());
  wind.Grid.TimeStep = times.Step;
  wind.Grid.LateralSpacing = image->GetSpacing()[1];
  wind.Grid.VerticalSpacing = image->GetSpacing()[2];
  wind.Grid.BottomHeight = image->GetOrigin()[2] + image->GetExtent()[4] * image->GetSpacing()[2];
  reason = WhyInvalid(wind.Model, wind.Grid);
  if (!reason.empty())
  {
    return reason;
  }
  // Velocities in world axes are turned back into those of the wind.
  const vtkMatrix3x3* axes = image->GetDirectionMatrix();
  const double cosine = axes->GetElement(0, 0);
  const double sine = axes->GetElement(1, 0);
  const float* values = floats->GetPointer(0);
  wind.Velocities.assign(values, values + floats->GetNumberOfValues());
  for (std::size_t n = 0; n < wind.Velocities.size(); n += WindComponents)
  {
    float* v = wind.Velocities.data() + n;
    const double x = v[0];
    v[0] = static_cast<float>(cosine * x + sine * v[1]);
    v[1] = static_cast<float>(cosine * v[1] - sine * x);
  }
  return {};
}

Vector3 MiddleOfWind(vtkImageData* image, double height)
{
  double bounds[6];
  image->GetBounds(bounds);
  return { bounds[0], 0.5 * (bounds[2] + bounds[3]), height };
}

}
