// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <utility>

#include "render/figure/figure.h"
#include "render/figure/internal/grid.h"

namespace mes::figure {
namespace {

void move(std::vector<Run>& runs, Vec2 by) {
  for (Run& run : runs)
    for (Shape& shape : run.shapes)
      for (Vec2& p : shape.p) p = p + by;
}

void move(std::vector<Text>& texts, Vec2 by) {
  for (Text& text : texts) text.start = text.start + by;
}

template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

void place(Figure& page, Figure part, Vec2 corner, const std::string& id, const std::string& title) {
  page.decimals = std::max(page.decimals, part.decimals);
  const Grid grid(page.decimals);
  const Vec2 by{grid(corner.x), grid(corner.y)};
  for (FigureLayer& layer : part.layers) {
    layer.id = id + layer.id;
    layer.title = title + layer.title;
    if (layer.image) layer.image->corner = layer.image->corner + by;
    for (Group& group : layer.groups) move(group.runs, by);
    move(layer.texts, by);
    if (layer.clip)
      layer.clip->corner = layer.clip->corner + by;
    else
      layer.clip = PagePart{by, part.width, part.height};
    page.layers.push_back(std::move(layer));
  }
  for (Box& box : part.legend.boxes) box.corner = box.corner + by;
  move(part.legend.runs, by);
  move(part.legend.texts, by);
  append(page.legend.boxes, std::move(part.legend.boxes));
  append(page.legend.runs, std::move(part.legend.runs));
  append(page.legend.texts, std::move(part.legend.texts));
  if (!page.fonts) page.fonts = part.fonts;
}

}  // namespace mes::figure
