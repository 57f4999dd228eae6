// What attributes of a Zarr array say in the words of CF, as xarray writes them, and the arrays beside it
// with the coordinates of its axes.
#pragma once

#include <memory>
#include <string>

#include "volume/read/chunks/array_statements.h"
#include "volume/read/chunks/cf_attributes.h"
#include "volume/read/zarr/zarr_array.h"

namespace isolux::volume {

// Numbers, texts and lists of numbers; all else is left out.
Attributes attributesOf(const ZarrArray& array);

// `array` is that of the folder `key`. Throws base::Error{input} for names of axes that are none.
ArrayStatements statementsOf(const std::shared_ptr<const ZarrStore>& store, const std::string& key,
                             const ZarrArray& array);

}  // namespace isolux::volume
