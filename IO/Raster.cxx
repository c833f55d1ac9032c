// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster.h"

#include "CoordinateSystem.h"
#include "GdalMessages.h"
#include "Geometry/PlaceUnits.h"
#include "Numerics/ParameterCheck.h"
#include "Pipeline/Memory.h"
#include "RasterAxes.h"
#include "RasterTiles.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <system_error>
#include <vector>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

namespace littoral
{

namespace
{

struct CloseDataset
{
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

/// Throws where a classic netCDF file is shorter than its numbers: the library reads zeros there.
void CheckLength(const std::string& path, void* dataset)
{
  const GDALDriverH driver = GDALGetDatasetDriver(dataset);
  std::ifstream file(path, std::ios_base::binary);
  char magic[3] = {};
  file.read(magic, sizeof(magic));
  if (!driver || std::string(GDALGetDriverShortName(driver)) != "netCDF" || std::string(magic, 3) != "CDF")
  {
    return;
  }
  const int size = GDALGetDataTypeSizeBytes(GDALGetRasterDataType(GDALGetRasterBand(dataset, 1)));
  const double needed =
    1.0 * size * GDALGetRasterXSize(dataset) * GDALGetRasterYSize(dataset) * GDALGetRasterCount(dataset);
  file.seekg(0, std::ios_base::end);
  if (static_cast<double>(file.tellg()) < needed)
  {
    throw RasterError("it is cut off or damaged (shorter than its heights)");
  }
}

/// Arguments of a program of GDAL.
class Arguments
{
public:
  Arguments& Add(const std::string& argument)
  {
    this->List.AddString(argument.c_str());
    return *this;
  }
  Arguments& Add(const char* name, const std::string& value) { return this->Add(name).Add(value); }
  char** Get() { return this->List.List(); }

private:
  CPLStringList List;
};

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
constexpr int RowsAtOnce = 64;

/// Part of the free memory that GDAL may fill with blocks: its own bound is a part of the machine's.
constexpr double CacheShare = 0.1;

// --- Opening --------------------------------------------------------------------------------------------------------

Dataset OpenDataset(const std::string& name)
{
  return Dataset(
    GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr));
}

/// Names of the rasters within a file, as GDAL opens them.
std::vector<std::string> InnerNames(void* dataset)
{
  std::vector<std::string> names;
  const auto list = GDALGetMetadata(dataset, "SUBDATASETS");
  for (int number = 1;; ++number)
  {
    const char* name = CSLFetchNameValue(list, ("SUBDATASET_" + std::to_string(number) + "_NAME").c_str());
    if (!name)
    {
      return names;
    }
    names.emplace_back(name);
  }
}

/// The variable in the name of a raster within a file: z of NETCDF:"hills.nc":z.
std::string VariableOf(const std::string& name)
{
  const std::size_t colon = name.find_last_of(':');
  return colon == std::string::npos ? name : name.substr(colon + 1);
}

/// The raster of a name, or the first one, where a file holds several.
Dataset OpenInner(Dataset outer, const std::string& wanted)
{
  const std::vector<std::string> names = InnerNames(outer.get());
  if (names.empty() || (wanted.empty() && GDALGetRasterCount(outer.get()) > 0))
  {
    return outer;
  }
  std::string variables;
  for (const std::string& name : names)
  {
    if (wanted.empty() || wanted == name || wanted == VariableOf(name))
    {
      return OpenDataset(name);
    }
    variables += (variables.empty() ? "" : ", ") + VariableOf(name);
  }
  throw RasterError("it holds no dataset '" + wanted + "'; it has " + variables);
}

/// Hint to add to GDAL's words about a file that it does not know.
std::string HintFor(const std::string& path)
{
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  return suffix == ".hgt" ? "; a whole SRTM tile is called by its southwestern corner, as N36W085.hgt" : "";
}

Dataset OpenRaster(const RasterOptions& options, GdalMessages& messages)
{
  GDALAllRegister();
  GDALSetCacheMax64(
    std::min(GDALGetCacheMax64(), static_cast<GIntBig>(CacheShare * std::min(AvailableMemory(), 0x1p50))));
  std::error_code error;
  const bool isVirtual = options.Path.rfind("/vsi", 0) == 0;
  if (!isVirtual && !std::filesystem::exists(options.Path, error))
  {
    throw RasterError("there is no such file");
  }
  Dataset dataset = OpenDataset(options.Path);
  if (dataset)
  {
    dataset = OpenInner(std::move(dataset), options.Dataset);
  }
  if (!dataset)
  {
    throw RasterError("GDAL finds no whole raster in it (" + messages.ErrorOr("of no kind that it knows") +
      HintFor(options.Path) + ")");
  }
  const int bands = GDALGetRasterCount(dataset.get());
  if (bands == 0)
  {
    throw RasterError("it holds no raster");
  }
  if (options.Band < 1 || options.Band > bands)
  {
    throw RasterError("Band is " + std::to_string(options.Band) + "; it must be from 1 to " + std::to_string(bands));
  }
  CheckLength(options.Path, dataset.get());
  return dataset;
}

// --- Place ----------------------------------------------------------------------------------------------------------

/// Map coordinates of pixels: x = T0 + T1 i + T2 j, y = T3 + T4 i + T5 j. Without a place pixels are units, the first
/// row at the top.
struct Transform
{
  std::array<double, 6> T{};
  bool IsKnown = false;

  explicit Transform(void* dataset)
    : IsKnown(GDALGetGeoTransform(dataset, T.data()) == CE_None)
  {
    if (!this->IsKnown)
    {
      this->T = { 0.0, 1.0, 0.0, static_cast<double>(GDALGetRasterYSize(dataset)), 0.0, -1.0 };
    }
  }
  std::array<double, 2> At(double i, double j) const
  {
    return { this->T[0] + this->T[1] * i + this->T[2] * j, this->T[3] + this->T[4] * i + this->T[5] * j };
  }
  void Scale(double factor)
  {
    std::transform(this->T.begin(), this->T.end(), this->T.begin(), [=](double part) { return factor * part; });
  }
  bool IsUpright() const { return this->T[2] == 0.0 && this->T[4] == 0.0 && this->T[1] > 0.0 && this->T[5] != 0.0; }
};

std::array<double, 2> CenterOf(void* dataset)
{
  return Transform(dataset).At(0.5 * GDALGetRasterXSize(dataset), 0.5 * GDALGetRasterYSize(dataset));
}

/// The box of a dataset along an axis of its map.
PlaceAxis AxisOf(void* dataset, int axis)
{
  const Transform transform(dataset);
  const double columns = GDALGetRasterXSize(dataset);
  const double rows = GDALGetRasterYSize(dataset);
  const std::array<double, 2> ends[2] = { transform.At(0.0, 0.0), transform.At(columns, rows) };
  return { {}, {}, std::min(ends[0][axis], ends[1][axis]), std::max(ends[0][axis], ends[1][axis]) };
}

/// The name of the variable of netCDF that a dataset shows; empty for none.
std::string VariableIn(void* dataset, int band)
{
  const GDALDriverH driver = GDALGetDatasetDriver(dataset);
  const bool isNetcdf = driver && std::string(GDALGetDriverShortName(driver)) == "netCDF";
  const char* name =
    isNetcdf ? GDALGetMetadataItem(GDALGetRasterBand(dataset, band), "NETCDF_VARNAME", nullptr) : nullptr;
  return name ? name : "";
}

/// Measure of the coordinates of a dataset without a system. Throws RasterError.
PlaceUnit UnitOf(void* dataset, const std::optional<RasterAxes>& axes)
{
  const Transform transform(dataset);
  const PlaceAxis x = axes ? axes->X : AxisOf(dataset, 0);
  const PlaceAxis y = axes ? axes->Y : AxisOf(dataset, 1);
  PlaceUnit unit;
  try
  {
    unit = transform.IsKnown ? UnitOfPlaces(x, y, FarForFile) : unit;
  }
  catch (const InvalidInput& refusal)
  {
    throw RasterError(refusal.what());
  }
  // Cells this small are of degrees wherever they lie on earth.
  const bool isOnEarth = x.Low >= -360.0 && x.High <= 360.0 && y.Low >= -90.0 - 1e-6 && y.High <= 90.0 + 1e-6;
  const double step = std::max(std::abs(transform.T[1]), std::abs(transform.T[5]));
  if (transform.IsKnown && !unit.IsSaid && isOnEarth && step < 0.3)
  {
    unit.Kind = PlaceKind::Degrees;
  }
  return unit;
}

/// Whether a file of a coordinate system lies beside a raster.
bool HasSystemBeside(const std::string& path)
{
  std::error_code error;
  for (const char* suffix : { ".prj", ".PRJ" })
  {
    if (std::filesystem::exists(std::filesystem::path(path).replace_extension(suffix), error))
    {
      return true;
    }
  }
  return false;
}

/// The coordinate system of a file whose coordinates are metres of no map.
constexpr const char* PlainMetres = "metres";

constexpr const char* NameTheSystem = "; set FileCoordinateSystem to the one it has, as EPSG:32632";

/// The horizontal coordinate system of a raster; empty for none.
OGRSpatialReference SystemOf(void* dataset, const RasterOptions& options, GdalMessages& messages)
{
  OGRSpatialReference system;
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (options.FileSystem == PlainMetres)
  {
    return system;
  }
  if (!options.FileSystem.empty())
  {
    if (!ReadCoordinateSystem(options.FileSystem, system))
    {
      throw RasterError("FileCoordinateSystem is '" + options.FileSystem +
        "', which is no coordinate system; it must be a code as EPSG:32632, WKT, or metres");
    }
    DropHeights(system);
    return system;
  }
  const OGRSpatialReferenceH named = GDALGetSpatialRef(dataset);
  if (named)
  {
    system = *OGRSpatialReference::FromHandle(named);
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    DropHeights(system);
  }
  const std::string said = messages.About({ "PROJ", "proj_", "crs", "CRS", "EPSG", "SRS" });
  const bool isLost = (system.IsEmpty() || system.IsLocal()) && !said.empty();
  if (isLost || (system.IsEmpty() && HasSystemBeside(options.Path)))
  {
    throw RasterError("its coordinate system cannot be read" + (said.empty() ? "" : " (" + said + ")") + NameTheSystem);
  }
  return system;
}

/// The coordinate system to read in: that of the file, or the one that was asked for.
OGRSpatialReference TargetOf(void* dataset, const OGRSpatialReference& system, const RasterOptions& options)
{
  if (options.Projection == RasterProjection::AsInFile)
  {
    return system;
  }
  if (system.IsEmpty())
  {
    throw RasterError(std::string("it names no coordinate system to project from") + NameTheSystem);
  }
  OGRSpatialReference target;
  if (options.Projection == RasterProjection::Utm)
  {
    const std::array<double, 2> center = CenterOf(dataset);
    if (!SetUtmZone(system, center[0], center[1], target))
    {
      throw RasterError("its center lies in no zone of UTM, which ends at 84 degrees north and 80 south; set "
                        "Projection to Given System, and CoordinateSystem to one of the region, as EPSG:3413");
    }
    return target;
  }
  if (!ReadCoordinateSystem(options.GivenSystem, target))
  {
    throw RasterError("CoordinateSystem is '" + options.GivenSystem +
      "', which is no coordinate system; it must be a code as EPSG:32632, or WKT");
  }
  DropHeights(target);
  if (!target.IsProjected())
  {
    throw RasterError("CoordinateSystem is " + NameOf(target) + ", which is no projection; lengths need one, as UTM");
  }
  return target;
}

/// Lengths may be this much too long or too short on a map that is taken for the ground.
constexpr double MostStretch = 0.05;

/// Throws where the coordinates of a file without a system are no lengths.
void CheckUnit(const PlaceUnit& unit)
{
  if (unit.Kind == PlaceKind::TurnedDegrees)
  {
    throw RasterError("its coordinates are degrees about a turned pole, and it does not say which; project it first");
  }
  if (unit.Kind == PlaceKind::Degrees)
  {
    throw RasterError(
      "it names no coordinate system, and its coordinates look like degrees; set FileCoordinateSystem to "
      "EPSG:4326 and Projection to UTM, or FileCoordinateSystem to metres if they are metres");
  }
}

/// Throws where a raster is too wide for the one meridian of a UTM zone.
void CheckWidth(void* dataset, const OGRSpatialReference& utm)
{
  const Transform transform(dataset);
  const double columns = GDALGetRasterXSize(dataset);
  for (const double column : { 0.0, columns })
  {
    const std::array<double, 2> edge = transform.At(column, 0.5 * GDALGetRasterYSize(dataset));
    const auto scale = MapScale(utm, edge[0], edge[1]);
    if (!scale || !(std::abs((*scale)[0] - 1.0) <= MostStretch))
    {
      throw RasterError("it is so wide that lengths at its edges on the map of " + NameOf(utm) +
        " differ by more than 5 % from those on the ground; cut it, or set Projection to Given System, and "
        "CoordinateSystem to one of the region, as EPSG:3035");
    }
  }
}

/// Throws where coordinates are no lengths.
void CheckLengths(void* dataset, const OGRSpatialReference& system, bool isProjectedNow)
{
  if (system.IsEmpty())
  {
    return;
  }
  if (system.IsGeographic())
  {
    throw RasterError("its coordinates are degrees, not lengths; set Projection to UTM, or project the file to metres");
  }
  if (system.IsLocal())
  {
    return;
  }
  if (!system.IsProjected())
  {
    throw RasterError("its coordinate system, " + NameOf(system) + ", is no projection of the ground");
  }
  const std::array<double, 2> center = CenterOf(dataset);
  const auto scale = MapScale(system, center[0], center[1]);
  for (int axis = 0; scale && axis < 2; ++axis)
  {
    const double stretch = (*scale)[axis];
    if (!(std::abs(stretch - 1.0) <= MostStretch))
    {
      const std::string factor = TextOf(0.01 * std::round(100.0 * stretch));
      throw RasterError("lengths on the map of " + NameOf(system) + " are " + factor + " times those on the ground; " +
        (isProjectedNow ? "choose another CoordinateSystem, or UTM" : "set Projection to UTM"));
    }
  }
}

// --- What stands between the file and the grid ----------------------------------------------------------------------

/// One band of a dataset, as a dataset that reads it on demand.
Dataset OnlyBand(void* dataset, int band)
{
  Arguments arguments;
  arguments.Add("-of", "VRT").Add("-b", std::to_string(band));
  GDALTranslateOptions* options = GDALTranslateOptionsNew(arguments.Get(), nullptr);
  Dataset result(GDALTranslate("", dataset, options, nullptr));
  GDALTranslateOptionsFree(options);
  return result;
}

const char* NameOf(RasterResampling resampling)
{
  switch (resampling)
  {
    case RasterResampling::Nearest:
      return "near";
    case RasterResampling::Bilinear:
      return "bilinear";
    default:
      return "cubic";
  }
}

/// A dataset on a grid of a coordinate system whose rows run from west to east, which resamples another on demand.
Dataset Warped(void* dataset, const OGRSpatialReference& from, const OGRSpatialReference& to,
  const RasterOptions& raster, bool hasNoData)
{
  Arguments arguments;
  // -et 0: each pixel at its exact place
  arguments.Add("-of", "VRT").Add("-ot", "Float32").Add("-dstnodata", "nan").Add("-et", "0").Add("-novshift");
  arguments.Add("-r", NameOf(raster.Resampling));
  if (hasNoData)
  {
    arguments.Add("-srcnodata", CPLSPrintf("%.17g", raster.NoData));
  }
  if (!from.IsEmpty())
  {
    arguments.Add("-s_srs", WktOf(from)).Add("-t_srs", WktOf(to));
  }
  if (raster.Spacing > 0.0)
  {
    const std::string spacing = CPLSPrintf("%.17g", raster.Spacing / (to.IsEmpty() ? 1.0 : to.GetLinearUnits()));
    arguments.Add("-tr").Add(spacing).Add(spacing);
  }
  GDALWarpAppOptions* options = GDALWarpAppOptionsNew(arguments.Get(), nullptr);
  GDALDatasetH source = dataset;
  Dataset result(GDALWarp("", nullptr, 1, &source, options, nullptr));
  GDALWarpAppOptionsFree(options);
  return result;
}

// --- Heights --------------------------------------------------------------------------------------------------------

/// The unit in which a file says its heights are: by the band, in GRIB in brackets, else by a vertical coordinate
/// system; empty for none.
std::string NamedHeightUnit(void* dataset, void* band)
{
  const char* own = GDALGetRasterUnitType(band);
  if (own && *own && std::string(own) != "unspecified") // as Idrisi calls none
  {
    return own;
  }
  const char* bracketed = GDALGetMetadataItem(band, "GRIB_UNIT", nullptr);
  const std::string unit = bracketed ? bracketed : "";
  if (unit.size() > 2 && unit.front() == '[' && unit.back() == ']' && unit != "[-]")
  {
    return unit.substr(1, unit.size() - 2);
  }
  const OGRSpatialReferenceH system = GDALGetSpatialRef(dataset);
  if (!system || !OSRIsCompound(system))
  {
    return {};
  }
  char* name = nullptr;
  OSRGetTargetLinearUnits(system, "VERT_CS", &name);
  return name ? name : "";
}

/// Heights in metres: value times Scale plus Offset.
struct HeightScale
{
  double Scale = 1.0;
  double Offset = 0.0;
  std::string Words;
};

HeightScale ScaleOf(void* dataset, void* band, double metresPerHeight)
{
  HeightScale scale;
  double metres = metresPerHeight;
  scale.Words = "heights times " + std::string(CPLSPrintf("%.6g", metres));
  if (metresPerHeight <= 0.0)
  {
    const std::string name = NamedHeightUnit(dataset, band);
    const UnitOfLength* unit = FindUnitOfHeight(name.empty() ? "m" : name);
    if (!unit)
    {
      throw RasterError("its values are in '" + name + "', which is no unit of heights; set HeightUnit");
    }
    metres = unit->Metres;
    scale.Words = name.empty() ? "no unit of heights named: metres" : std::string("heights in ") + unit->Words;
  }
  // Value = scale * stored + offset, in the unit of the file
  scale.Scale = GDALGetRasterScale(band, nullptr) * metres;
  scale.Offset = GDALGetRasterOffset(band, nullptr) * metres;
  return scale;
}

}

// --- The raster -----------------------------------------------------------------------------------------------------

class Raster::Internals
{
public:
  explicit Internals(const RasterOptions& options)
    : Options(options)
  {
  }

  RasterOptions Options;
  GdalMessages Messages;
  std::vector<Dataset> Chain; ///< from the file to the grid
  HeightScale Height;
  RasterGrid Grid;
  bool IsSouthFirst = false;

  ~Internals()
  {
    while (!this->Chain.empty())
    {
      this->Chain.pop_back(); // each reads from the one before it
    }
  }

  void* Last() const { return this->Chain.back().get(); }

  void Append(Dataset next, const char* otherwise)
  {
    if (!next)
    {
      throw RasterError(this->Messages.ErrorOr(otherwise));
    }
    this->Chain.push_back(std::move(next));
  }

  void Open()
  {
    this->Append(OpenRaster(this->Options, this->Messages), "it cannot be opened");
    const PlaceUnit unit = this->PlaceByAxes();
    void* file = this->Last();
    OGRSpatialReference system = SystemOf(file, this->Options, this->Messages);
    if (system.IsEmpty() && unit.IsSaid && unit.Kind == PlaceKind::Degrees)
    {
      ReadCoordinateSystem("EPSG:4326", system); // as longitudes and latitudes of models are
    }
    const bool isAsInFile = this->Options.Projection == RasterProjection::AsInFile;
    if (system.IsEmpty() && this->Options.FileSystem != PlainMetres &&
      (isAsInFile || unit.Kind == PlaceKind::TurnedDegrees))
    {
      CheckUnit(unit);
    }
    const OGRSpatialReference target = TargetOf(file, system, this->Options);
    this->Height = ScaleOf(file, GDALGetRasterBand(file, this->Options.Band), this->Options.MetresPerHeight);
    this->Messages.Forget();
    this->Append(OnlyBand(file, this->Options.Band), "its band cannot be read alone");
    Transform transform(file);
    if (transform.IsKnown && unit.IsSaid && unit.Kind == PlaceKind::Lengths)
    {
      transform.Scale(unit.Metres / (system.IsEmpty() ? 1.0 : system.GetLinearUnits()));
      GDALSetGeoTransform(this->Last(), transform.T.data());
    }
    if (!transform.IsKnown && GDALGetGCPCount(file) > 0)
    {
      throw RasterError("its place is told by ground control points alone; give it a grid first, as by gdalwarp");
    }
    if (isAsInFile)
    {
      CheckLengths(file, system, false);
    }
    if (!isAsInFile || (transform.IsKnown && !transform.IsUpright()))
    {
      this->Append(
        Warped(this->Last(), system, target, this->Options, this->Options.UsesNoData), "it cannot be projected");
      CheckLengths(this->Last(), target, !isAsInFile);
      if (this->Options.Projection == RasterProjection::Utm)
      {
        CheckWidth(this->Last(), target);
      }
    }
    this->Place(target);
  }

  /// Throws where tiles of a mosaic are not those that it says: of those in a window, or after a projection of all.
  void CheckTiles(const std::array<int, 4>& window) const
  {
    void* file = this->Chain.front().get();
    PixelWindow pixels{ 0, GDALGetRasterXSize(file) - 1, 0, GDALGetRasterYSize(file) - 1 };
    if (this->Chain.size() < 3)
    {
      const int last = this->Grid.Points[1] - 1;
      pixels = this->IsSouthFirst ? window : PixelWindow{ window[0], window[1], last - window[3], last - window[2] };
    }
    const std::string reason = WhyOtherTiles(file, this->Options.Band, pixels);
    if (!reason.empty())
    {
      throw RasterError(reason);
    }
  }

  /// Measure of the coordinates where the file names no system. A variable of netCDF that GDAL leaves without a place
  /// takes it from its coordinate variables.
  PlaceUnit PlaceByAxes()
  {
    if (GDALGetSpatialRef(this->Last()) || GDALGetGCPCount(this->Last()) > 0)
    {
      return {};
    }
    const std::string variable = VariableIn(this->Last(), this->Options.Band);
    const std::optional<RasterAxes> axes = variable.empty() ? std::nullopt : AxesOf(this->Options.Path, variable);
    if (axes && !Transform(this->Last()).IsKnown)
    {
      if (!axes->AreEven)
      {
        throw RasterError("its rows or columns are not the same distance apart; resample it on a regular grid first");
      }
      Dataset placed(PlacedByAxes(this->Options.Path, variable));
      this->Chain.pop_back();
      this->Append(std::move(placed), "its variable cannot be read alone");
    }
    return UnitOf(this->Last(), axes);
  }

  /// Sets origin and spacing of the points: centers of pixels, in metres.
  void Place(const OGRSpatialReference& system)
  {
    const Transform transform(this->Last());
    RasterGrid& grid = this->Grid;
    grid.Points = { GDALGetRasterXSize(this->Last()), GDALGetRasterYSize(this->Last()) };
    grid.MetresPerUnit = system.IsEmpty() || system.IsGeographic() ? 1.0 : system.GetLinearUnits();
    grid.System = WktOf(system);
    grid.SystemName = system.IsEmpty() ? "no coordinate system named" : littoral::NameOf(system);
    this->IsSouthFirst = transform.T[5] > 0.0;
    const double southernmost = this->IsSouthFirst ? 0.5 : grid.Points[1] - 0.5;
    const std::array<double, 2> corner = transform.At(0.5, southernmost);
    for (int axis = 0; axis < 2; ++axis)
    {
      grid.Spacing[axis] = std::abs(axis == 0 ? transform.T[1] : transform.T[5]) * grid.MetresPerUnit;
      const double place = corner[axis] * grid.MetresPerUnit;
      grid.Offset[axis] = this->Options.HasLocalOrigin ? place : 0.0;
      grid.Origin[axis] = this->Options.HasLocalOrigin ? 0.0 : place;
    }
  }
};

Raster::Raster(const RasterOptions& options)
  : Own(std::make_unique<Internals>(options))
{
  this->Own->Open();
}

Raster::~Raster() = default;

const RasterGrid& Raster::Grid() const
{
  return this->Own->Grid;
}

const std::string& Raster::HeightWords() const
{
  return this->Own->Height.Words;
}

double Raster::WorkBytes(int width) const
{
  const auto blockOf = [](void* dataset) {
    std::array<int, 2> block{};
    GDALGetBlockSize(GDALGetRasterBand(dataset, 1), block.data(), block.data() + 1);
    return block;
  };
  const auto pixels = [](void* dataset) { return 1.0 * GDALGetRasterXSize(dataset) * GDALGetRasterYSize(dataset); };
  void* file = this->Own->Chain.front().get();
  const std::array<int, 2> block = blockOf(file);
  const double across = std::ceil(1.0 * GDALGetRasterXSize(file) / block[0]) * block[0];
  const double size = GDALGetDataTypeSizeBytes(GDALGetRasterDataType(GDALGetRasterBand(file, this->Own->Options.Band)));
  const double ofRows = RowsAtOnce * (sizeof(double) + 1.0) * width;
  if (this->Own->Chain.size() < 3)
  {
    return ofRows + 2.0 * size * across * block[1];
  }
  // A block of the projected grid takes all pixels under it, as 4 bytes with masks.
  const std::array<int, 2> projected = blockOf(this->Own->Last());
  const double share = std::min(1.0, 2.0 * projected[0] * projected[1] / pixels(this->Own->Last()));
  return ofRows + (12.0 + size) * share * pixels(file);
}

bool Raster::Read(const std::array<int, 4>& window, float* heights, const RasterProgress& progress)
{
  Internals& own = *this->Own;
  own.CheckTiles(window);
  own.Messages.Forget();
  // By blocks alone: GDAL 3.10 projects a whole grid of few rows at once, with kernels of other widths than its parts.
  const CPLConfigOptionSetter byBlocks("GDAL_VRT_WARP_USE_DATASET_RASTERIO", "NO", false);
  const GDALRasterBandH band = GDALGetRasterBand(own.Last(), 1);
  const GDALRasterBandH mask = GDALGetMaskBand(band);
  const bool hasHoles = (GDALGetMaskFlags(band) & GMF_ALL_VALID) == 0;
  const bool usesNoData = own.Options.UsesNoData && own.Chain.size() < 3; // else the projection has left them out
  const int width = window[1] - window[0] + 1;
  const int height = window[3] - window[2] + 1;
  std::vector<double> values(static_cast<std::size_t>(width) * RowsAtOnce);
  std::vector<unsigned char> valid(values.size(), 1);
  for (int done = 0; done < height; done += RowsAtOnce)
  {
    if (!progress(static_cast<double>(done) / height))
    {
      return false;
    }
    // Rows in the order of the file, which is that in which it can be read fast.
    const int rows = std::min(RowsAtOnce, height - done);
    const int first = own.IsSouthFirst ? window[2] + done : own.Grid.Points[1] - 1 - window[3] + done;
    bool isRead = GDALRasterIO(band, GF_Read, window[0], first, width, rows, values.data(), width, rows, GDT_Float64, 0,
                    0) == CE_None;
    isRead = isRead &&
      (!hasHoles ||
        GDALRasterIO(mask, GF_Read, window[0], first, width, rows, valid.data(), width, rows, GDT_Byte, 0, 0) ==
          CE_None);
    if (!isRead)
    {
      throw RasterError("it is cut off or damaged (" + own.Messages.ErrorOr("GDAL does not say how") + ")");
    }
    for (int row = 0; row < rows; ++row)
    {
      const int up = own.IsSouthFirst ? done + row : height - 1 - done - row;
      float* to = heights + static_cast<std::size_t>(up) * width;
      for (int i = 0; i < width; ++i)
      {
        const std::size_t from = static_cast<std::size_t>(row) * width + i;
        const double value = values[from];
        // z = scale * value + offset; no height is beyond 1e15, which files write for none
        const double z = own.Height.Scale * value + own.Height.Offset;
        const bool isHole =
          valid[from] == 0 || !(std::abs(z) <= MaximumMagnitude) || (usesNoData && value == own.Options.NoData);
        to[i] = isHole ? NaN : static_cast<float>(z);
      }
    }
  }
  return true;
}

namespace
{

/// Whether values of a dataset, the first band, can be heights by the unit that is named.
bool CanBeHeights(void* dataset)
{
  const std::string unit = NamedHeightUnit(dataset, GDALGetRasterBand(dataset, 1));
  return unit.empty() || FindUnitOfHeight(unit);
}

/// Whether one of the datasets in a netCDF file can be heights. Those of other files are not asked.
bool HoldsHeights(void* dataset, const std::vector<std::string>& names)
{
  const char* driver = GDALGetDriverShortName(GDALGetDatasetDriver(dataset));
  if (std::string(driver ? driver : "") != "netCDF")
  {
    return true;
  }
  if (names.empty())
  {
    return CanBeHeights(dataset);
  }
  return std::any_of(names.begin(), names.end(), [](const std::string& name) {
    const Dataset inner = OpenDataset(name);
    return inner && GDALGetRasterCount(inner.get()) > 0 && CanBeHeights(inner.get());
  });
}

}

bool IsPlacedRaster(const std::string& path)
{
  const GdalMessages quiet;
  GDALAllRegister();
  const Dataset dataset = OpenDataset(path);
  if (!dataset)
  {
    return false;
  }
  if (GDALGetRasterCount(dataset.get()) == 0)
  {
    const std::vector<std::string> names = InnerNames(dataset.get());
    return !names.empty() && HoldsHeights(dataset.get(), names);
  }
  const GDALColorInterp color = GDALGetRasterColorInterpretation(GDALGetRasterBand(dataset.get(), 1));
  const bool isPicture = color == GCI_PaletteIndex || color == GCI_RedBand || color == GCI_YCbCr_YBand;
  return Transform(dataset.get()).IsKnown && !isPicture && HoldsHeights(dataset.get(), {});
}

}
