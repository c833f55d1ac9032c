// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Suspended particles: boxes, presets, pieces, squares, every bad input; and a picture of squares with their pictures.
#include "BaselinePicture.h"
#include "Check.h"
#include "ErrorCounter.h"
#include "vtkSuspendedParticleSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTexture.h"

#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace
{

using Source = vtkSuspendedParticleSource;

std::vector<char> BytesOf(vtkPolyData* data)
{
  std::vector<char> bytes;
  const auto add = [&](vtkDataArray* array) {
    const char* begin = static_cast<const char*>(array->GetVoidPointer(0));
    bytes.insert(bytes.end(), begin, begin + array->GetNumberOfValues() * array->GetDataTypeSize());
  };
  add(data->GetPoints()->GetData());
  for (const char* name : { "ParticleId", "BoxId", "ParticleType", "Radius", "RGB" })
  {
    add(data->GetPointData()->GetArray(name));
  }
  return bytes;
}

vtkNew<vtkPolyData> Piece(Source* source, int piece, int pieces)
{
  source->UpdateInformation();
  vtkInformation* info = source->GetOutputInformation(0);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), piece);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  source->GetExecutive()->Update();
  vtkNew<vtkPolyData> data;
  data->DeepCopy(source->GetOutput());
  return data;
}

bool CheckPresets()
{
  bool good = true;
  for (int preset = Source::CoastalSea; preset <= Source::StormyBed; ++preset)
  {
    vtkNew<Source> source;
    source->SetPreset(preset);
    source->Update();
    vtkPolyData* output = source->GetOutput();
    const vtkIdType count = output->GetNumberOfPoints();
    good &= Check(count > 3000 && output->GetNumberOfVerts() == count, "no particles");
    const double* b = output->GetBounds();
    good &= Check(b[0] > -10.0 && b[1] < 10.0 && b[4] > -10.0 && b[5] < 0.0, "particles out of their bounds");
    vtkDataArray* type = output->GetPointData()->GetArray("ParticleType");
    for (vtkIdType id = 0; id < count; ++id)
    {
      const double z = output->GetPoint(id)[2];
      const double kind = type->GetTuple1(id);
      good &= (kind != 2.0 || z < -4.9) &&
        output->GetPointData()->GetArray("ParticleId")->GetTuple1(id) == static_cast<double>(id);
      good &= kind != 0.0 || preset == Source::OpenOcean || z > -4.1;
    }
    Check(good, "kinds where they do not live");
  }
  return good;
}

bool CheckBoxes()
{
  vtkNew<Source> source;
  source->SetPreset(Source::Custom);
  const double first[12] = { 0.0, 10.0, 0.0, 1.0, -5.0, 5.0, 2.0, 0.01, 40.0, 0.5, 0.25, 1.0 };
  const double second[12] = { 1e6, 1e6 + 10.0, 0.0, 1.0, 449.0, 450.0, 1.0, 0.02, 3.0, 1.0, 1.0, 1.0 };
  source->AddBox(first);
  source->AddBox(second);
  source->SetBoxName(1, "Snow");
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkPolyData* output = source->GetOutput();
  bool good = Check(source->GetNumberOfBoxes() == 2 && output->GetNumberOfPoints() == 4030, "another number");
  auto* names = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("BoxNames"));
  auto* kinds = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("ParticleTypes"));
  good &= Check(names && names->GetValue(0) == "Grain0" && names->GetValue(1) == "Snow", "other names");
  good &= Check(kinds && kinds->GetNumberOfValues() == 4 && kinds->GetValue(3) == "Copepod", "other kinds");
  good &= Check(output->GetPoint(4029)[0] > 1e6 && output->GetPoint(4029)[2] > 449.0, "another place");
  good &= Check(output->GetPointData()->GetArray("BoxId")->GetTuple1(4000) == 1.0, "another box");
  const std::vector<char> wanted = BytesOf(output);
  source->SetAmountIs(Source::Count);
  source->Update();
  good &= Check(source->GetOutput()->GetNumberOfPoints() == 43, "counts are no counts");
  source->SetAmountIs(Source::Concentration);

  // Threads and pieces.
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<Source> again;
    again->SetPreset(Source::Custom);
    again->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    again->AddBox(first);
    again->AddBox(second);
    again->Update();
    good &= Check(BytesOf(again->GetOutput()) == wanted, "other particles on other threads");
  }
  vtkSMPTools::Initialize(0);
  source->Update();
  vtkNew<vtkPolyData> whole;
  whole->DeepCopy(source->GetOutput());
  vtkIdType count = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    vtkNew<vtkPolyData> part = Piece(source, piece, 3);
    for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id, ++count)
    {
      good &=
        std::memcmp(part->GetPoint(id), std::vector<double>(whole->GetPoint(count), whole->GetPoint(count) + 3).data(),
          3 * sizeof(double)) == 0;
    }
  }
  good &= Check(good && count == 4030, "pieces are other than the whole");
  source->RemoveAllBoxes();
  return good & Check(source->GetNumberOfBoxes() == 0, "boxes stay");
}

bool CheckSquares()
{
  vtkNew<Source> points;
  vtkNew<Source> squares;
  squares->SetMode(Source::Quads);
  points->Update();
  squares->Update();
  vtkPolyData* output = squares->GetOutput();
  const vtkIdType count = points->GetOutput()->GetNumberOfPoints();
  bool good = Check(output->GetNumberOfPolys() == count && output->GetNumberOfPoints() == 5 * count, "another number");
  vtkDataArray* uv = output->GetPointData()->GetTCoords();
  vtkDataArray* type = output->GetPointData()->GetArray("ParticleType");
  for (vtkIdType id = 0; id < count; ++id)
  {
    const std::vector<double> center(output->GetPoint(5 * id), output->GetPoint(5 * id) + 3);
    good &= std::memcmp(center.data(), points->GetOutput()->GetPoint(id), 3 * sizeof(double)) == 0;
    for (int corner = 1; corner < 5; ++corner)
    {
      // Its picture is the part of the atlas for its kind, from the foot.
      const double v = 4.0 * uv->GetComponent(5 * id + corner, 1) - type->GetTuple1(5 * id);
      good &= v > 0.0 && v < 1.0;
    }
  }
  Check(good, "squares are elsewhere, or have another picture");
  vtkImageData* pictures = vtkImageData::SafeDownCast(squares->GetOutputDataObject(1));
  return good &
    Check(pictures->GetPointData()->GetScalars()->GetNumberOfComponents() == 4 && pictures->GetDimensions()[1] == 400,
      "no pictures");
}

bool Fails(const char* word, const std::function<void(Source*)>& spoil)
{
  vtkNew<Source> source;
  spoil(source);
  vtkNew<ErrorCounter> errors;
  errors->Watch(source);
  return errors->ExpectOneNaming(word) && Check(source->GetOutput()->GetNumberOfPoints() == 0, "output not empty");
}

bool BoxFails(const char* word, int place, double value)
{
  return Fails(word, [=](Source* source) {
    double box[12] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.01, 5.0, 0.5, 0.5, 0.5 };
    source->SetPreset(Source::Custom);
    source->AddBox(box);
    box[place] = value;
    source->AddBox(box);
  });
}

bool CheckBadInput()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bool good = true;
  good &= Fails("Preset", [](Source* s) { s->SetPreset(5); });
  good &= Fails("Mode", [](Source* s) { s->SetMode(2); });
  good &= Fails("AmountIs", [](Source* s) { s->SetAmountIs(-1); });
  good &= Fails("SizeSpread", [](Source* s) { s->SetSizeSpread(-0.1); });
  good &= Fails("Density", [=](Source* s) { s->SetDensity(nan); });
  good &= Fails("OutputPointsPrecision", [](Source* s) { s->SetOutputPointsPrecision(2); });
  good &= Fails("Bounds", [](Source* s) { s->SetBounds(0.0, 1.0, 0.0, 1.0, 0.0, -5.0); });
  good &= Fails("Bounds", [=](Source* s) { s->SetBounds(0.0, 1.0, nan, 1.0, -5.0, 0.0); });
  good &= Fails("no boxes", [](Source* s) { s->SetPreset(Source::Custom); });
  good &= Fails("points, more than the bound", [](Source* s) { s->SetDensity(1e5); });
  good &= Fails("1e11", [](Source* s) { s->SetDensity(1e14); });
  good &= Fails("Density is 1e+30", [](Source* s) { s->SetDensity(1e30); });
  good &= BoxFails("box 1", 5, -1.0); // upside down
  good &= BoxFails("bounds", 0, nan);
  good &= BoxFails("kind", 6, 4.0);
  good &= BoxFails("kind", 6, 0.5);
  good &= BoxFails("kind", 6, nan);
  good &= BoxFails("diameter", 7, -0.01);
  good &= BoxFails("amount", 8, -1.0);
  good &= BoxFails("color", 10, 2.0);
  return good;
}

}

int TestSuspendedParticles(int argc, char* argv[])
{
  bool good = CheckPresets();
  good &= CheckBoxes();
  good &= CheckSquares();
  good &= CheckBadInput();
  if (!good)
  {
    return EXIT_FAILURE;
  }

  // Four boxes side by side, one of each kind, drawn far too large.
  vtkNew<Source> source;
  source->SetPreset(Source::Custom);
  source->SetAmountIs(Source::Count);
  source->SetMode(Source::Quads);
  source->SetSizeSpread(0.15);
  const double colors[4][3] = { { 0.62, 0.78, 0.36 }, { 0.92, 0.92, 0.86 }, { 0.85, 0.68, 0.45 }, { 1.0, 0.72, 0.52 } };
  for (int kind = 0; kind < 4; ++kind)
  {
    const double box[12] = { 3.0 * kind - 6.0, 3.0 * kind - 3.2, -1.5, 1.5, -4.0, 4.0, 1.0 * kind, 1.1, 14.0,
      colors[kind][0], colors[kind][1], colors[kind][2] };
    source->AddBox(box);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(source->GetOutputPort(1));
  texture->InterpolateOn();
  texture->MipmapOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  actor->ForceTranslucentOn();
  actor->GetProperty()->LightingOff();
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.02, 0.13, 0.20);
  renderer->SetBackground2(0.10, 0.38, 0.46);
  renderer->GradientBackgroundOn();
  renderer->UseDepthPeelingOn();
  renderer->SetMaximumNumberOfPeels(20);
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(300, 200);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -18.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  return IsAsBaseline(window, argc, argv) ? EXIT_SUCCESS : EXIT_FAILURE;
}
