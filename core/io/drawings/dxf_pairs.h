// SPDX-License-Identifier: GPL-3.0-or-later
// DXF as pairs of lines, a group code and a value, and its units.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/io/text/read_job.h"

namespace mes {

struct DxfPair {
  int code = 0;
  std::string_view value;  ///< without blanks around it
  std::uint32_t line = 0;  ///< line of the value
};

/// The pairs from one code 0 up to the next.
using DxfEntity = std::span<const DxfPair>;

/// The pairs of a file, without comments. Error: `bad_input` for a code that is not a number, and for a file that ends
/// within a pair; with line and column. `job`, which may be null, follows the bytes; throws `Cancelled`.
Expected<std::vector<DxfPair>> read_dxf_pairs(std::string_view bytes, const std::string& name,
                                              ReadJob* job = nullptr);

/// The first value of a code; nothing if the entity lacks it.
std::optional<std::string_view> dxf_text(DxfEntity entity, int code);

/// The unit of a value of $INSUNITS, and the other way round; empty: there is none. Source: the reference of DXF.
std::string_view unit_of_dxf_number(std::string_view number);
std::string_view dxf_number_of_unit(std::string_view unit);

}  // namespace mes
