// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NetcdfFile.h"

#include "Data/Arrays.h"
#include "Numerics/InvalidInput.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <system_error>

#include <netcdf.h>

namespace littoral
{

namespace
{

constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

void Check(int status)
{
  if (status != NC_NOERR)
  {
    Refuse("netCDF says of it: ", nc_strerror(status));
  }
}

bool IsNumeric(int type)
{
  return type >= NC_BYTE && type <= NC_UINT64 && type != NC_CHAR;
}

double BytesOfType(int type)
{
  switch (type)
  {
    case NC_BYTE:
    case NC_CHAR:
    case NC_UBYTE:
      return 1.0;
    case NC_SHORT:
    case NC_USHORT:
      return 2.0;
    case NC_DOUBLE:
    case NC_INT64:
    case NC_UINT64:
      return 8.0;
    default:
      return 4.0;
  }
}

/// Bytes up to a whole number of four.
double Padded(double bytes)
{
  return 4.0 * std::ceil(bytes / 4.0);
}

/// Number that stands for a missing one where a file names none.
double DefaultFill(int type)
{
  switch (type)
  {
    case NC_SHORT:
      return NC_FILL_SHORT;
    case NC_INT:
      return NC_FILL_INT;
    case NC_FLOAT:
      return NC_FILL_FLOAT;
    case NC_DOUBLE:
      return NC_FILL_DOUBLE;
    default:
      return NoNumber;
  }
}

/// Conversion of stored numbers to those that are meant.
struct Packing
{
  double Scale = 1.0;
  double Offset = 0.0;
  std::vector<double> Missing;
  double Least = -std::numeric_limits<double>::infinity(); ///< of stored numbers
  double Most = std::numeric_limits<double>::infinity();
  double Wrap = 0.0; ///< added to stored numbers below 0

  double operator()(double stored) const
  {
    const bool isMissing = !(stored >= this->Least && stored <= this->Most) ||
      std::find(this->Missing.begin(), this->Missing.end(), stored) != this->Missing.end();
    return isMissing ? NoNumber : this->Scale * (stored < 0.0 ? stored + this->Wrap : stored) + this->Offset;
  }
};

}

FileStamp StampOf(const std::string& path)
{
  std::error_code problem;
  Require(path.empty() ? "FileName is empty" : "");
  Require(std::filesystem::is_directory(path, problem) ? "it is a folder" : "");
  FileStamp stamp;
  stamp.Size = std::filesystem::file_size(path, problem);
  Require(problem ? problem.message() : "");
  stamp.Changed = std::filesystem::last_write_time(path, problem);
  Require(problem ? problem.message() : "");
  return stamp;
}

NetcdfFile::NetcdfFile(const std::string& path)
  : Path(path)
  , Opened(StampOf(path))
{
  Check(nc_open(path.c_str(), NC_NOWRITE, &this->Id));
  try
  {
    int dimensions = 0, variables = 0;
    Check(nc_inq(this->Id, &dimensions, &variables, nullptr, &this->Unlimited));
    for (int d = 0; d < dimensions; ++d)
    {
      char name[NC_MAX_NAME + 1] = {};
      std::size_t length = 0;
      Check(nc_inq_dim(this->Id, d, name, &length));
      this->AllDimensions.push_back({ name, length });
    }
    for (int v = 0; v < variables; ++v)
    {
      char name[NC_MAX_NAME + 1] = {};
      int count = 0;
      NetcdfVariable variable;
      Check(nc_inq_varndims(this->Id, v, &count));
      variable.Dimensions.resize(static_cast<std::size_t>(count));
      Check(nc_inq_var(this->Id, v, name, &variable.Type, nullptr, variable.Dimensions.data(), nullptr));
      variable.Name = name;
      variable.Id = v;
      (IsNumeric(variable.Type) ? this->AllVariables : this->Others).push_back(variable);
    }
    this->RequireWhole();
  }
  catch (...)
  {
    nc_close(this->Id);
    throw;
  }
}

NetcdfFile::~NetcdfFile()
{
  nc_close(this->Id);
}

double NetcdfFile::BytesOfAttributes(int variable, double word) const
{
  double bytes = 4.0 + word;
  int count = 0;
  Check(nc_inq_varnatts(this->Id, variable, &count));
  for (int a = 0; a < count; ++a)
  {
    char name[NC_MAX_NAME + 1] = {};
    nc_type type = 0;
    std::size_t length = 0;
    Check(nc_inq_attname(this->Id, variable, a, name));
    Check(nc_inq_att(this->Id, variable, name, &type, &length));
    bytes += word + Padded(static_cast<double>(std::strlen(name))) + 4.0 + word +
      Padded(static_cast<double>(length) * BytesOfType(type));
  }
  return bytes;
}

double NetcdfFile::BytesOfHeader(bool isLarge, bool isClassic) const
{
  // The format: magic, number of records, lists of dimensions, attributes and variables.
  const double word = isLarge ? 8.0 : 4.0;
  const double place = isClassic ? 4.0 : 8.0;
  double bytes = 4.0 + word + 2.0 * (4.0 + word) + this->BytesOfAttributes(NC_GLOBAL, word);
  for (const NetcdfDimension& dimension : this->AllDimensions)
  {
    bytes += word + Padded(static_cast<double>(dimension.Name.size())) + word;
  }
  for (const auto* variables : { &this->AllVariables, &this->Others })
  {
    for (const NetcdfVariable& variable : *variables)
    {
      bytes += word + Padded(static_cast<double>(variable.Name.size())) + word +
        word * static_cast<double>(variable.Dimensions.size()) + this->BytesOfAttributes(variable.Id, word) + 4.0 +
        word + place;
    }
  }
  return bytes;
}

void NetcdfFile::RequireWhole() const
{
  // The library reads zeros behind the end of a classic file.
  int format = 0;
  Check(nc_inq_format(this->Id, &format));
  if (format != NC_FORMAT_CLASSIC && format != NC_FORMAT_64BIT_OFFSET && format != NC_FORMAT_64BIT_DATA)
  {
    return;
  }
  double fixed = 0.0, record = 0.0, unpadded = 0.0;
  int records = 0;
  for (const auto* variables : { &this->AllVariables, &this->Others })
  {
    for (const NetcdfVariable& variable : *variables)
    {
      const bool isRecord = !variable.Dimensions.empty() && variable.Dimensions[0] == this->Unlimited;
      double bytes = BytesOfType(variable.Type);
      for (std::size_t d = isRecord ? 1 : 0; d < variable.Dimensions.size(); ++d)
      {
        bytes *= static_cast<double>(this->LengthOf(variable, d));
      }
      (isRecord ? record : fixed) += Padded(bytes);
      records += isRecord ? 1 : 0;
      unpadded = isRecord ? bytes : unpadded;
    }
  }
  // A single variable of records has no padding between them.
  record = records == 1 ? unpadded : record;
  const double times = this->Unlimited < 0 ? 0.0 : static_cast<double>(this->AllDimensions[this->Unlimited].Length);
  const double wanted =
    this->BytesOfHeader(format == NC_FORMAT_64BIT_DATA, format == NC_FORMAT_CLASSIC) + fixed + record * times - 3.0;
  if (static_cast<double>(this->Opened.Size) < wanted)
  {
    Refuse("it is cut off: ", this->Opened.Size, " bytes are there, and its header tells of ",
      static_cast<std::uintmax_t>(wanted + 3.0));
  }
}

const NetcdfVariable* NetcdfFile::Find(const std::string& name) const
{
  const auto found = std::find_if(this->AllVariables.begin(), this->AllVariables.end(),
    [&](const NetcdfVariable& variable) { return variable.Name == name; });
  if (found != this->AllVariables.end())
  {
    return &*found;
  }
  const auto other = std::find_if(
    this->Others.begin(), this->Others.end(), [&](const NetcdfVariable& variable) { return variable.Name == name; });
  return other != this->Others.end() ? &*other : nullptr;
}

std::size_t NetcdfFile::LengthOf(const NetcdfVariable& variable, std::size_t dimension) const
{
  return this->AllDimensions[static_cast<std::size_t>(variable.Dimensions[dimension])].Length;
}

std::size_t NetcdfFile::SizeOf(const NetcdfVariable& variable) const
{
  std::size_t size = 1;
  for (std::size_t d = 0; d < variable.Dimensions.size(); ++d)
  {
    size *= this->LengthOf(variable, d);
  }
  return size;
}

std::string NetcdfFile::TextOf(const NetcdfVariable& variable, const char* attribute) const
{
  nc_type type = 0;
  std::size_t length = 0;
  if (nc_inq_att(this->Id, variable.Id, attribute, &type, &length) != NC_NOERR || length == 0)
  {
    return {};
  }
  if (type == NC_CHAR)
  {
    std::string text(length, '\0');
    Check(nc_get_att_text(this->Id, variable.Id, attribute, text.data()));
    text.resize(std::strlen(text.c_str()));
    return text;
  }
  if (type == NC_STRING)
  {
    std::vector<char*> texts(length, nullptr);
    Check(nc_get_att_string(this->Id, variable.Id, attribute, texts.data()));
    std::string text = texts[0] ? texts[0] : "";
    nc_free_string(length, texts.data());
    return text;
  }
  return {};
}

std::vector<double> NetcdfFile::NumbersOf(const NetcdfVariable& variable, const char* attribute) const
{
  nc_type type = 0;
  std::size_t length = 0;
  if (nc_inq_att(this->Id, variable.Id, attribute, &type, &length) != NC_NOERR || !IsNumeric(type))
  {
    return {};
  }
  std::vector<double> numbers(length);
  Check(nc_get_att_double(this->Id, variable.Id, attribute, numbers.data()));
  return numbers;
}

std::optional<double> NetcdfFile::NumberOf(const NetcdfVariable& variable, const char* attribute) const
{
  const std::vector<double> numbers = this->NumbersOf(variable, attribute);
  return numbers.empty() ? std::nullopt : std::optional<double>(numbers[0]);
}

void NetcdfFile::Read(const NetcdfVariable& variable, const std::vector<std::size_t>& start,
  const std::vector<std::size_t>& count, double* values) const
{
  Require(IsNumeric(variable.Type) ? "" : "its variable " + variable.Name + " holds no numbers");
  Check(nc_get_vara_double(this->Id, variable.Id, start.data(), count.data(), values));
  Packing packing;
  packing.Scale = this->NumberOf(variable, "scale_factor").value_or(1.0);
  packing.Offset = this->NumberOf(variable, "add_offset").value_or(0.0);
  packing.Missing = this->NumbersOf(variable, "missing_value");
  packing.Missing.push_back(this->NumberOf(variable, "_FillValue").value_or(DefaultFill(variable.Type)));
  const std::vector<double> range = this->NumbersOf(variable, "valid_range");
  packing.Least = this->NumberOf(variable, "valid_min").value_or(range.size() == 2 ? range[0] : packing.Least);
  packing.Most = this->NumberOf(variable, "valid_max").value_or(range.size() == 2 ? range[1] : packing.Most);
  const bool isUnsigned = this->TextOf(variable, "_Unsigned") == "true";
  packing.Wrap = isUnsigned ? std::exp2(8.0 * BytesOfType(variable.Type)) : 0.0;
  std::size_t size = 1;
  for (const std::size_t one : count)
  {
    size *= one;
  }
  std::transform(values, values + size, values, packing);
}

std::vector<double> NetcdfFile::ReadAll(const NetcdfVariable& variable) const
{
  std::vector<std::size_t> count;
  for (std::size_t d = 0; d < variable.Dimensions.size(); ++d)
  {
    count.push_back(this->LengthOf(variable, d));
  }
  std::vector<double> values;
  SetSize(values, static_cast<vtkIdType>(this->SizeOf(variable)));
  this->Read(variable, std::vector<std::size_t>(count.size(), 0), count, values.data());
  return values;
}

void NetcdfFile::RequireUnchanged() const
{
  Require(StampOf(this->Path) == this->Opened ? "" : "it changed while it was read; open it again");
}

}
