// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include <cstring>
#include <string>

namespace mes_python {
namespace {

template <class T>
std::span<const T> rows_of(const Doubles& array, py::ssize_t width) {
  static_assert(sizeof(T) % sizeof(double) == 0);
  if (array.ndim() != 2 || array.shape(1) != width)
    throw py::type_error("an array of shape (n, " + std::to_string(width) + ") is expected");
  return {reinterpret_cast<const T*>(array.data()), static_cast<std::size_t>(array.shape(0))};
}

template <class T>
Doubles rows_as_array(std::span<const T> rows) {
  constexpr std::size_t kWidth = sizeof(T) / sizeof(double);
  Doubles out({rows.size(), kWidth});
  if (!rows.empty()) std::memcpy(out.mutable_data(), rows.data(), rows.size_bytes());
  return out;
}

py::dtype dtype_of(mesecina::ColumnType type) {
  switch (type) {
    case mesecina::ColumnType::float64: return py::dtype::of<double>();
    case mesecina::ColumnType::uint32: return py::dtype::of<std::uint32_t>();
    case mesecina::ColumnType::uint8: return py::dtype::of<std::uint8_t>();
    case mesecina::ColumnType::int8: return py::dtype::of<std::int8_t>();
    case mesecina::ColumnType::boolean: break;
  }
  return py::dtype::of<bool>();
}

std::vector<std::size_t> shape_of(std::size_t rows, std::size_t width) {
  return width == 1 ? std::vector{rows} : std::vector{rows, width};
}

void make_read_only(py::array& array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
}

}  // namespace

std::span<const mesecina::Point> points_of(const Doubles& array) {
  return rows_of<mesecina::Point>(array, 2);
}

std::span<const mesecina::Ball> balls_of(const Doubles& array) {
  return rows_of<mesecina::Ball>(array, 3);
}

Doubles array_of(std::span<const mesecina::Point> points) {
  return rows_as_array(points);
}

Doubles array_of(std::span<const mesecina::Ball> balls) {
  return rows_as_array(balls);
}

Numbers array_of(std::span<const std::uint32_t> numbers) {
  Numbers out(static_cast<py::ssize_t>(numbers.size()));
  if (!numbers.empty()) std::memcpy(out.mutable_data(), numbers.data(), numbers.size_bytes());
  return out;
}

py::list contours_of(std::span<const mesecina::Contour> contours) {
  py::list out;
  for (const mesecina::Contour& contour : contours)
    out.append(py::make_tuple(contour.is_closed, array_of(std::span<const std::uint32_t>(contour.points))));
  return out;
}

std::vector<mesecina::Contour> contours_of(const std::vector<std::pair<bool, Numbers>>& pairs) {
  std::vector<mesecina::Contour> out;
  for (const auto& [is_closed, numbers] : pairs)
    out.push_back({is_closed, {numbers.data(), numbers.data() + numbers.size()}});
  return out;
}

py::tuple arrays_of(const mesecina::Data& data) {
  return py::make_tuple(array_of(std::span<const mesecina::Point>(data.samples)), contours_of(data.contours),
                        array_of(std::span<const mesecina::Ball>(data.balls)));
}

py::array view_of(const void* data, mesecina::ColumnType type, std::size_t rows, std::size_t width,
                  std::size_t stride, std::shared_ptr<const void> owner) {
  const std::size_t value = mesecina::size_of(type);
  std::vector<std::size_t> strides{stride};
  if (width != 1) strides.push_back(value);
  auto kept = std::make_unique<std::shared_ptr<const void>>(std::move(owner));
  const py::capsule base(kept.get(), [](void* of) { delete static_cast<std::shared_ptr<const void>*>(of); });
  kept.release();
  static constexpr double kNothing = 0.0;  // NumPy allocates memory for an array over a null pointer
  py::array out(dtype_of(type), shape_of(rows, width), strides, data == nullptr ? &kNothing : data, base);
  make_read_only(out);
  return out;
}

py::array copy_of(const mesecina::Column& column) {
  const mesecina::ColumnInfo& info = column.info();
  const std::size_t rows = column.rows();
  py::array out(dtype_of(info.type), shape_of(rows, info.width));
  auto* to = static_cast<std::byte*>(out.mutable_data());
  const std::size_t size = mesecina::size_of(info.type) * info.width;
  if (info.is_stored && rows != 0) {
    const auto* const from = static_cast<const std::byte*>(column.data());
    const std::size_t stride = column.stride();
    if (stride == size)
      std::memcpy(to, from, rows * size);
    else
      for (std::size_t row = 0; row < rows; ++row) std::memcpy(to + row * size, from + row * stride, size);
  } else {
    for (std::size_t row = 0; row < rows; ++row) column.read(static_cast<mesecina::Row>(row), to + row * size);
  }
  return out;
}

}  // namespace mes_python
