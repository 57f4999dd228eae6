// Attributes by the conventions of netCDF (CF 1.11, sections 2.5 and 8.1; NUG, appendix A), wherever they
// stand: netCDF-4 and other HDF5 files, Zarr of xarray.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "volume/read/chunks/array_statements.h"
#include "volume/read/chunks/chunk_format.h"

namespace isolux::volume {

// A text, or numbers.
struct AttributeValue {
  std::string text;
  std::vector<double> numbers;
  bool whole = false;  // they are of an integer type
};
using Attributes = std::map<std::string, AttributeValue>;

// The text, "" where there is none.
std::string textIn(const Attributes& attributes, const std::string& name);

// `number` without a sign where _Unsigned says so: netCDF-3 had no such types.
FileNumber withSign(const Attributes& attributes, FileNumber number);

// scale_factor, add_offset, _FillValue, missing_value, valid_min, valid_max, valid_range and units of an
// array of such numbers, as withSign() gives them. What cannot be applied gets a warning.
void readCfValues(const Attributes& attributes, FileNumber number, ArrayStatements& statements);

// What an axis is by the attributes of its coordinates: axis, standard_name, units, positive. `name`: of the
// coordinates, where these do not say it.
AxisStatement cfAxis(const Attributes& attributes, const std::string& name);

// The number that netCDF fills new variables with where they name none; nothing for single bytes.
std::optional<double> netCdfFill(const FileNumber& number);

}  // namespace isolux::volume
