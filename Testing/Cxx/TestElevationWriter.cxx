// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Heights written as GeoTIFF and read back, byte by byte; every bad input, with the old file untouched.
#include "Check.h"
#include "ErrorCounter.h"
#include "TestFolder.h"
#include "vtkElevationReader.h"
#include "vtkElevationWriter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

constexpr int Columns = 7;
constexpr int Rows = 5;
constexpr vtkIdType Hole = 17;

/// Heights that single precision has not, one of them missing, in indices that do not begin at 0.
vtkSmartPointer<vtkImageData> Image()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(2, 1 + Columns, -1, Rows - 2, 0, 0);
  image->SetOrigin(400000.0, 5400000.0, 0.0);
  image->SetSpacing(12.5, 20.0, 1.0);
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Elevation");
  for (vtkIdType point = 0; point < Columns * Rows; ++point)
  {
    heights->InsertNextValue(
      point == Hole ? std::numeric_limits<double>::quiet_NaN() : 100.0 + 1.0 / (1.0 + static_cast<double>(point)));
  }
  image->GetPointData()->SetScalars(heights);
  return image;
}

bool RoundTrip(const std::string& path)
{
  const auto image = Image();
  vtkNew<vtkElevationWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->SetCoordinateSystem("EPSG:32632");
  bool good = Check(writer->Write() == 1, "Cannot write");
  const std::string bytes = BytesOf(path);
  good &= Check(writer->Write() == 1 && BytesOf(path) == bytes, "The same heights make other bytes");

  vtkNew<vtkElevationReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* read = reader->GetOutput();
  if (!Check(read->GetNumberOfPoints() == Columns * Rows, "There are other points than written"))
  {
    return false;
  }
  vtkDataArray* written = image->GetPointData()->GetScalars();
  for (vtkIdType point = 0; point < Columns * Rows; ++point)
  {
    double there[3];
    double here[3];
    image->GetPoint(point, there);
    read->GetPoint(point, here);
    good &= Check(std::abs(there[0] - here[0]) < 1e-6 && std::abs(there[1] - here[1]) < 1e-6, "A point moves");
    const double height = read->GetPointData()->GetScalars()->GetComponent(point, 0);
    good &= Check(point == Hole ? std::isnan(height) : height == static_cast<float>(written->GetComponent(point, 0)),
      "Height " + std::to_string(point) + " is read as " + std::to_string(height));
  }
  auto* system = vtkStringArray::SafeDownCast(read->GetFieldData()->GetAbstractArray("CoordinateSystem"));
  good &=
    Check(system && system->GetValue(0).find("UTM zone 32N") != std::string::npos, "The coordinate system is lost");

  // What was read is written as it was, and without compression with the same heights.
  const std::string again = path + ".again.tif";
  writer->SetInputData(read);
  writer->SetCoordinateSystem("");
  writer->SetCompressionToNoCompression();
  writer->SetFileName(again.c_str());
  good &= Check(writer->Write() == 1 && BytesOf(again) != bytes, "Cannot write without compression");
  reader->SetFileName(again.c_str());
  const double height = read->GetPointData()->GetScalars()->GetComponent(3, 0);
  reader->Update();
  return Check(reader->GetOutput()->GetPointData()->GetScalars()->GetComponent(3, 0) == height,
           "Heights differ without compression") &&
    good;
}

/// A setting, and a word of the one message that it must give.
struct Mistake
{
  std::function<void(vtkElevationWriter*)> Make;
  const char* Word;
};

bool BadInput(const std::string& path)
{
  const std::vector<Mistake> mistakes = {
    { [](vtkElevationWriter* writer) { writer->SetFileName(nullptr); }, "FileName is empty" },
    { [](vtkElevationWriter* writer) { writer->SetFileName("/no/such/folder/heights.tif"); },
      "Cannot write heights.tif: there is no folder /no/such/folder." },
    { [](vtkElevationWriter* writer) { writer->SetFileName(".."); },
      "Give the name of a file in it: cannot write .., it is a folder." },
    { [](vtkElevationWriter* writer) { writer->SetCompression(2); }, "Compression" },
    { [](vtkElevationWriter* writer) { writer->SetCoordinateSystem("nowhere"); }, "nowhere" },
    { [](vtkElevationWriter* writer) { writer->SetCoordinateSystem("EPSG:4326"); }, "projection" },
    { [](vtkElevationWriter* writer) {
       writer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nothing");
     },
      "'Nothing'" },
    { [](vtkElevationWriter* writer) { writer->SetInputData(vtkNew<vtkImageData>()); }, "image" },
  };
  const std::string bytes = BytesOf(path);
  bool good = true;
  for (const Mistake& mistake : mistakes)
  {
    vtkNew<vtkElevationWriter> writer;
    vtkNew<ErrorCounter> errors;
    errors->Watch(writer);
    writer->SetInputData(Image());
    writer->SetFileName(path.c_str());
    mistake.Make(writer);
    good &= errors->ExpectOneNaming(mistake.Word);
    good &= Check(BytesOf(path) == bytes, std::string("The old file changes by ") + mistake.Word);
  }
  vtkNew<vtkElevationWriter> writer;
  vtkNew<ErrorCounter> errors;
  errors->Watch(writer);
  writer->SetFileName(path.c_str());
  return Check(writer->Write() == 0 && errors->Count == 1, "Writes without an input") && good;
}

}

int TestElevationWriter(int argc, char* argv[])
{
  const fs::path folder = EmptyFolder(argc, argv, "TestElevationWriter");
  const std::string path = (folder / "heights.tif").string();
  bool good = RoundTrip(path);
  good &= BadInput(path);
  fs::remove_all(folder);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
