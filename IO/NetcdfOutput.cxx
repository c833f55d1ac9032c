// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NetcdfOutput.h"

#include "Numerics/InvalidInput.h"

#include <netcdf.h>

namespace littoral
{

namespace
{

void Check(int status)
{
  Require(status == NC_NOERR ? "" : nc_strerror(status));
}

}

NetcdfOutput::NetcdfOutput(const std::string& path, bool isLarge)
{
  Check(nc_create(path.c_str(), NC_CLOBBER | (isLarge ? NC_64BIT_DATA : NC_64BIT_OFFSET), &this->Id));
  this->IsOpen = true;
  nc_set_fill(this->Id, NC_NOFILL, nullptr); // all of it is written
}

NetcdfOutput::~NetcdfOutput()
{
  if (this->IsOpen)
  {
    nc_abort(this->Id);
  }
}

int NetcdfOutput::AddDimension(const char* name, std::size_t length)
{
  int number = 0;
  Check(nc_def_dim(this->Id, name, length > 0 ? length : NC_UNLIMITED, &number));
  return number;
}

int NetcdfOutput::AddVariable(const char* name, int type, const std::vector<int>& dimensions)
{
  int number = 0;
  Check(nc_def_var(this->Id, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &number));
  return number;
}

int NetcdfOutput::AddFloats(const char* name, const std::vector<int>& dimensions)
{
  return this->AddVariable(name, NC_FLOAT, dimensions);
}

int NetcdfOutput::AddDoubles(const char* name, const std::vector<int>& dimensions)
{
  return this->AddVariable(name, NC_DOUBLE, dimensions);
}

void NetcdfOutput::AddText(int variable, const char* attribute, const std::string& text)
{
  Check(nc_put_att_text(this->Id, variable, attribute, text.size(), text.data()));
}

void NetcdfOutput::AddNumber(int variable, const char* attribute, double number)
{
  Check(nc_put_att_double(this->Id, variable, attribute, NC_DOUBLE, 1, &number));
}

void NetcdfOutput::AddFloat(int variable, const char* attribute, float number)
{
  Check(nc_put_att_float(this->Id, variable, attribute, NC_FLOAT, 1, &number));
}

void NetcdfOutput::EndHeader()
{
  Check(nc_enddef(this->Id));
}

void NetcdfOutput::Write(
  int variable, const std::vector<std::size_t>& start, const std::vector<std::size_t>& count, const float* values)
{
  Check(nc_put_vara_float(this->Id, variable, start.data(), count.data(), values));
}

void NetcdfOutput::Write(int variable, std::size_t start, const std::vector<double>& values)
{
  const std::size_t count = values.size();
  Check(nc_put_vara_double(this->Id, variable, &start, &count, values.data()));
}

void NetcdfOutput::Close()
{
  this->IsOpen = false;
  Check(nc_close(this->Id));
}

}
