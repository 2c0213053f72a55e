// SPDX-License-Identifier: GPL-3.0-or-later
// Computes the Voronoi cells of samples from scratch, within a region, and writes them as text.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/store/texts/cell_text.h"
#include "core/base/jobs/job_control.h"
#include "core/document/sample_data.h"

namespace mes {

class Registry;

/// Where cells end.
enum class CellRegion : std::uint8_t {
  box,      ///< the box around samples and curves, wider on each side by a tenth of its longer side
  hull,     ///< the convex hull of the samples
  outline,  ///< what the curves of the data enclose, by the even-odd rule
};

/// The outline of data with closed curves and isolated points, else the box.
CellRegion usual_region_of(const SampleData& data);

/// The feature that a point belongs to.
struct CellOwner {
  std::string id{};          ///< JSON; empty: none
  std::string properties{};  ///< JSON members
};

/// The owners of all points with cells, in the order of the file, or of none; and names of columns that no owner has.
struct CellOwners {
  std::vector<CellOwner> of_point{};
  CellColumns columns{};
};

/// The points that have cells: those beside the curves if the region is their outline, else all samples.
const std::vector<Vec2>& points_with_cells(const SampleData& data, CellRegion region);

/// The cells in the order of their samples; of samples at one place, the first has it, and the others are counted.
/// Cells outside the region are left out. Data with curves and isolated points, such as wells in a county, have cells
/// of the points alone within their outline. Curved sides become chains of up to 96 sides a turn.
///
/// Error: `usage` if the region is the outline of data without curves, `cannot_compute` if it encloses nothing or so
/// many cells reach across it that clipping takes longer than 12 s. Throws `Cancelled`. `on_task` is called with the id
/// of each structure before it begins.
Expected<CellText> compute_cell_text(const Registry& registry, const SampleData& data, CellRegion region,
                                     std::string_view format, JobControl& job,
                                     const std::function<void(std::string_view)>& on_task = {},
                                     const CellOwners& owners = {});

}  // namespace mes
