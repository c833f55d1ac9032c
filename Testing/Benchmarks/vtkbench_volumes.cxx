// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Time to write a volume, beside OpenVDB's own dense copy and write of the same values in the same run.
#include "vtkVDBVolumeWriter.h"
#include "vtkWindFieldSource.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace
{

std::string Path(const char* name)
{
  return (std::filesystem::temp_directory_path() / name).string();
}

/// A cloud of 256 x 256 x 256 samples, none of them 0.
vtkSmartPointer<vtkImageData> Cloud()
{
  static vtkSmartPointer<vtkImageData> image;
  if (!image)
  {
    constexpr int side = 256;
    image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(side, side, side);
    vtkNew<vtkFloatArray> density;
    density->SetName("density");
    density->SetNumberOfTuples(image->GetNumberOfPoints());
    for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
    {
      const double x = static_cast<double>(n % side);
      const double y = static_cast<double>(n / side % side);
      const double z = static_cast<double>(n / (side * side));
      density->SetValue(n,
        static_cast<float>(1.5 + std::sin(0.11 * x) * std::sin(0.07 * y) * std::sin(0.05 * z) +
          1e-3 * static_cast<double>(n * 7919 % 1009)));
    }
    image->GetPointData()->SetScalars(density);
  }
  return image;
}

/// A wind of 2000 x 64 x 24 samples.
vtkSmartPointer<vtkImageData> Wind()
{
  static vtkSmartPointer<vtkImageData> image;
  if (!image)
  {
    vtkNew<vtkWindFieldSource> wind;
    wind->SetDimensions(2000, 64, 24);
    wind->Update();
    image = wind->GetOutput();
  }
  return image;
}

template <typename Grid>
void OwnCopy(benchmark::State& state, vtkImageData* image)
{
  using Value = typename Grid::ValueType;
  openvdb::initialize();
  vtkDataArray* array = image->GetPointData()->GetArray(0);
  auto* values = static_cast<Value*>(array->GetVoidPointer(0));
  const int* size = image->GetDimensions();
  const openvdb::CoordBBox box(openvdb::Coord(0), openvdb::Coord(size[0] - 1, size[1] - 1, size[2] - 1));
  for (auto _ : state)
  {
    const openvdb::tools::Dense<Value, openvdb::tools::LayoutXYZ> dense(box, values);
    auto grid = Grid::create();
    openvdb::tools::copyFromDense(dense, *grid, openvdb::zeroVal<Value>());
    openvdb::io::File(Path("littoral-own.vdb")).write({ grid });
  }
  std::filesystem::remove(Path("littoral-own.vdb"));
}

void Writer(benchmark::State& state, vtkImageData* image)
{
  vtkNew<vtkVDBVolumeWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(Path("littoral-writer.vdb").c_str());
  for (auto _ : state)
  {
    writer->Write();
  }
  state.counters["MB"] = static_cast<double>(std::filesystem::file_size(Path("littoral-writer.vdb"))) / 1e6;
  std::filesystem::remove(Path("littoral-writer.vdb"));
}

void CloudByOpenVDB(benchmark::State& state)
{
  OwnCopy<openvdb::FloatGrid>(state, Cloud());
}
void CloudByWriter(benchmark::State& state)
{
  Writer(state, Cloud());
}
void WindByOpenVDB(benchmark::State& state)
{
  OwnCopy<openvdb::Vec3SGrid>(state, Wind());
}
void WindByWriter(benchmark::State& state)
{
  Writer(state, Wind());
}
BENCHMARK(CloudByOpenVDB)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(CloudByWriter)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(WindByOpenVDB)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(WindByWriter)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}

BENCHMARK_MAIN();
