// SPDX-License-Identifier: GPL-3.0-or-later
// Conversions between arrays of NumPy and values of the library.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <mesecina/geometry.h>
#include <mesecina/table.h>

namespace mes_python {

namespace py = pybind11;

/// Arrays from the Python part of the module, which has checked and converted them.
using Doubles = py::array_t<double, py::array::c_style>;
using Numbers = py::array_t<std::uint32_t, py::array::c_style>;

/// The values of an array of shape (n, 2), or (n, 3) for balls, without a copy. Error: `TypeError`.
std::span<const mesecina::Point> points_of(const Doubles& array);
std::span<const mesecina::Ball> balls_of(const Doubles& array);
template <class Id>
std::span<const Id> ids_of(const Numbers& array) {
  static_assert(sizeof(Id) == sizeof(std::uint32_t));
  return {reinterpret_cast<const Id*>(array.data()), static_cast<std::size_t>(array.size())};
}

Doubles array_of(std::span<const mesecina::Point> points);
Doubles array_of(std::span<const mesecina::Ball> balls);
Numbers array_of(std::span<const std::uint32_t> numbers);
/// Pairs of a flag, whether the contour is closed, and indices.
py::list contours_of(std::span<const mesecina::Contour> contours);
std::vector<mesecina::Contour> contours_of(const std::vector<std::pair<bool, Numbers>>& pairs);
/// Samples, contours and balls.
py::tuple arrays_of(const mesecina::Data& data);
template <class Id>
Numbers array_of_ids(const std::vector<Id>& ids) {
  static_assert(sizeof(Id) == sizeof(std::uint32_t));
  return array_of(std::span(reinterpret_cast<const std::uint32_t*>(ids.data()), ids.size()));
}

/// A read-only array over memory that `owner` keeps alive. It has the shape (rows,), or (rows, width).
py::array view_of(const void* data, mesecina::ColumnType type, std::size_t rows, std::size_t width,
                  std::size_t stride, std::shared_ptr<const void> owner);
/// A copy of the values of a column.
py::array copy_of(const mesecina::Column& column);

}  // namespace mes_python
