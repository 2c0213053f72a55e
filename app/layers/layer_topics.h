// SPDX-License-Identifier: GPL-3.0-or-later
// The subjects under which the window lists layers, by what one studies with them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/draw/layer_descriptor.h"

namespace mes {

struct LayerTopic {
  std::string_view title;
  std::string_view names;    ///< ids separated by spaces, in listing order; of a union, those common to all families
  bool is_of_union = false;  ///< layers of the union of a family of balls, listed for one family at a time
  std::optional<LayerGroup> rest{};  ///< the group whose layers belong here if no topic names them
};

/// In listing order.
std::span<const LayerTopic> layer_topics();

/// The position of a layer in the list of a topic, whatever its family.
struct TopicPlace {
  std::size_t topic = 0;
  std::size_t row = 0;  ///< layers that the topic does not name follow those that it names
  friend auto operator<=>(const TopicPlace&, const TopicPlace&) = default;
};
TopicPlace topic_place_of(const LayerDescriptor& descriptor);

}  // namespace mes
