// SPDX-License-Identifier: GPL-3.0-or-later
// Persistence pairs by definition: reduces the boundary matrix of a filtration column by column. An oracle for small
// inputs; its filtration values are rational numbers.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace mes::test {

/// Dimension, value of birth, whether it dies, value of death (0 if it does not die).
using ExactBar = std::tuple<int, mpq_class, bool, mpq_class>;

/// The bars of the complex of all corners, edges and triangles on `corners` corners, below dimension 2; only those of
/// positive length, sorted. `value` of one, two or three corners is their filtration value.
template <class Value>
std::vector<ExactBar> bars_by_reduction(std::size_t corners, const Value& value) {
  using Corners = std::vector<std::size_t>;
  std::vector<std::pair<mpq_class, Corners>> all;
  for (std::size_t i = 0; i < corners; ++i) {
    all.emplace_back(value(i), Corners{i});
    for (std::size_t j = i + 1; j < corners; ++j) {
      all.emplace_back(value(i, j), Corners{i, j});
      for (std::size_t k = j + 1; k < corners; ++k) all.emplace_back(value(i, j, k), Corners{i, j, k});
    }
  }
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.size() < b.second.size();
  });
  std::map<Corners, std::size_t> column_of;
  for (std::size_t i = 0; i < all.size(); ++i) column_of[all[i].second] = i;
  std::vector<std::vector<std::size_t>> columns(all.size());
  std::map<std::size_t, std::size_t> column_with_lowest;
  std::vector<bool> is_paired(all.size(), false);
  std::vector<ExactBar> out;
  for (std::size_t j = 0; j < all.size(); ++j) {
    const Corners& simplex = all[j].second;
    std::vector<std::size_t>& column = columns[j];
    for (std::size_t left_out = 0; left_out < simplex.size() && simplex.size() > 1; ++left_out) {
      Corners face = simplex;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(left_out));
      column.push_back(column_of.at(face));
    }
    std::ranges::sort(column);
    while (!column.empty()) {
      const auto other = column_with_lowest.find(column.back());
      if (other == column_with_lowest.end()) break;
      std::vector<std::size_t> sum;
      std::ranges::set_symmetric_difference(column, columns[other->second], std::back_inserter(sum));
      column = std::move(sum);
    }
    if (column.empty()) continue;
    const std::size_t born = column.back();
    column_with_lowest[born] = j;
    is_paired[j] = is_paired[born] = true;
    if (all[born].first != all[j].first)
      out.emplace_back(static_cast<int>(simplex.size()) - 2, all[born].first, true, all[j].first);
  }
  for (std::size_t j = 0; j < all.size(); ++j)
    if (!is_paired[j] && all[j].second.size() < 3)
      out.emplace_back(static_cast<int>(all[j].second.size()) - 1, all[j].first, false, mpq_class());
  std::ranges::sort(out);
  return out;
}

}  // namespace mes::test
