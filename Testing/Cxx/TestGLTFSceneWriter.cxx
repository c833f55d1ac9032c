// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes written as glTF: the chunks of the file, names, places and indices in it, every bad input with the old file
// untouched.
#include "Check.h"
#include "ErrorCounter.h"
#include "TestFolder.h"
#include "vtkGLTFSceneWriter.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

/// A triangle whose corners single precision has.
vtkSmartPointer<vtkPolyData> Triangle()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 3.0);
  points->InsertNextPoint(5.5, 2.0, 3.25);
  points->InsertNextPoint(1.0, 8.0, -4.0);
  vtkNew<vtkCellArray> polygons;
  const vtkIdType corners[3] = { 0, 1, 2 };
  polygons->InsertNextCell(3, corners);
  auto triangle = vtkSmartPointer<vtkPolyData>::New();
  triangle->SetPoints(points);
  triangle->SetPolys(polygons);
  return triangle;
}

vtkSmartPointer<vtkImageData> Terrain()
{
  auto terrain = vtkSmartPointer<vtkImageData>::New();
  terrain->SetDimensions(4, 3, 1);
  terrain->SetOrigin(10.0, 20.0, 0.0);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Elevation");
  for (int n = 0; n < 12; ++n)
  {
    heights->InsertNextValue(0.5f * static_cast<float>(n));
  }
  terrain->GetPointData()->SetScalars(heights);
  return terrain;
}

/// A number of 32 bits at a place of a file, lowest byte first.
std::uint32_t NumberAt(const std::string& bytes, std::size_t place)
{
  std::uint32_t number = 0;
  for (int byte = 3; byte >= 0; --byte)
  {
    number = 256 * number + static_cast<unsigned char>(bytes.at(place + static_cast<std::size_t>(byte)));
  }
  return number;
}

/// A file of glTF in its two chunks, by section 4.4 of the specification.
struct Chunks
{
  std::string Json;
  std::string Binary;
  bool AreGood = false;

  explicit Chunks(const std::string& bytes)
  {
    if (bytes.size() < 28 || bytes.compare(0, 4, "glTF") != 0 || NumberAt(bytes, 4) != 2 ||
      NumberAt(bytes, 8) != bytes.size() || bytes.compare(16, 4, "JSON") != 0)
    {
      return;
    }
    const std::size_t length = NumberAt(bytes, 12);
    const std::size_t next = 20 + length;
    this->AreGood = length % 4 == 0 && bytes.compare(next + 4, 4, std::string("BIN\0", 4)) == 0 &&
      next + 8 + NumberAt(bytes, next) == bytes.size();
    this->Json = bytes.substr(20, length);
    // Without blanks: what writes it may set some.
    this->Json.erase(std::remove(this->Json.begin(), this->Json.end(), ' '), this->Json.end());
    this->Binary = bytes.substr(next + 8);
  }

  bool Has(const std::string& text) const
  {
    return Check(this->Json.find(text) != std::string::npos, "The scene has no " + text);
  }

  bool HasFloats(const std::vector<float>& numbers) const
  {
    std::string wanted(numbers.size() * sizeof(float), '\0');
    std::memcpy(wanted.data(), numbers.data(), wanted.size());
    return Check(this->Binary.find(wanted) != std::string::npos, "Places are not in the file");
  }
};

bool WritesScene(const std::string& path)
{
  vtkNew<vtkGLTFSceneWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetSceneName("Bay");
  writer->AddInputDataObject(0, Triangle());
  writer->AddInputDataObject(0, Terrain());
  writer->SetSourceName(0, "Sail");
  writer->SetSourceKind(0, vtkGLTFSceneWriter::Plain);
  writer->WriteCameraOn();
  writer->SetCameraPosition(0.0, -10.0, 2.0);
  writer->SetExtras("{\"tide\": 1.5}");
  bool good = Check(writer->Write() == 1, "Cannot write a scene");
  const std::string bytes = BytesOf(path);
  const Chunks chunks(bytes);
  if (!Check(chunks.AreGood, "The file is not of glTF 2.0"))
  {
    return false;
  }
  for (const char* text : { "\"version\":\"2.0\"", "\"Bay\"", "\"Sail\"", "\"Source1\"", "\"ground\"", "\"plain\"",
         "\"perspective\"", "\"tide\":1.5", "\"max\":[5.5,8.0,3.25]", "\"min\":[1.0,2.0,-4.0]" })
  {
    good &= chunks.Has(text);
  }
  // Three corners; the terrain has 12 points and 6 cells of two triangles each.
  good &= chunks.HasFloats({ 1.0f, 2.0f, 3.0f, 5.5f, 2.0f, 3.25f, 1.0f, 8.0f, -4.0f });
  good &= chunks.HasFloats({ 10.0f, 20.0f, 0.0f, 11.0f, 20.0f, 0.5f });
  for (const char* text : { "\"count\":3,", "\"count\":12,", "\"count\":36," })
  {
    good &= chunks.Has(text);
  }
  return Check(writer->Write() == 1 && BytesOf(path) == bytes, "The same scene makes other bytes") && good;
}

/// A block without points among others does not keep a motion from being written.
bool WritesMotionBesideNothing(const std::string& path)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Triangle());
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  vtkNew<vtkGLTFSceneWriter> writer;
  writer->SetFileName(path.c_str());
  writer->WriteMotionOn();
  writer->SetInputDataObject(0, blocks);
  return Check(writer->Write() == 1 && Chunks(BytesOf(path)).AreGood, "Cannot write a motion beside nothing");
}

/// A setting, and a word of the one message that it must give.
struct Mistake
{
  std::function<void(vtkGLTFSceneWriter*)> Make;
  const char* Word;
};

bool BadInput(const std::string& path)
{
  using Writer = vtkGLTFSceneWriter;
  const std::vector<Mistake> mistakes = {
    { [](Writer* writer) { writer->SetFileName(nullptr); }, "FileName is empty" },
    { [](Writer* writer) { writer->SetFileName("/no/such/folder/scene.glb"); },
      "Cannot write scene.glb: there is no folder /no/such/folder." },
    { [](Writer* writer) { writer->SetInstanceForm(2); }, "InstanceForm" },
    { [](Writer* writer) { writer->SetLevelForm(-1); }, "LevelForm" },
    { [](Writer* writer) { writer->SetSourceKind(0, 10); }, "source 0" },
    { [](Writer* writer) { writer->SetExtras("{tide"); }, "Extras" },
    { [](Writer* writer) {
       writer->WriteCameraOn();
       writer->SetCameraFocalPoint(writer->GetCameraPosition());
     },
      "CameraFocalPoint" },
    { [](Writer* writer) {
       writer->WriteSunOn();
       writer->SetSunDirection(0.0, 0.0, 0.0);
     },
      "SunDirection" },
    { [](Writer* writer) {
       writer->WriteMotionOn();
       writer->SetEndTime(writer->GetStartTime());
     },
      "EndTime" },
    { [](Writer* writer) { writer->SetInputDataObject(0, vtkNew<vtkTable>()); }, "vtkTable" },
  };
  const std::string bytes = BytesOf(path);
  bool good = true;
  for (const Mistake& mistake : mistakes)
  {
    vtkNew<Writer> writer;
    vtkNew<ErrorCounter> errors;
    errors->Watch(writer);
    writer->SetInputDataObject(0, Triangle());
    writer->SetFileName(path.c_str());
    mistake.Make(writer);
    good &= errors->ExpectOneNaming(mistake.Word);
    good &= Check(BytesOf(path) == bytes, std::string("The old file changes by ") + mistake.Word);
  }
  return good;
}

}

int TestGLTFSceneWriter(int argc, char* argv[])
{
  const fs::path folder = EmptyFolder(argc, argv, "TestGLTFSceneWriter");
  const std::string path = (folder / "scene.glb").string();
  bool good = WritesScene(path);
  good &= WritesMotionBesideNothing(path);
  good &= BadInput(path);
  fs::remove_all(folder);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
