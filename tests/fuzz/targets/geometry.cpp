// SPDX-License-Identifier: GPL-3.0-or-later
// Every layer of some samples and balls, with any number type: nothing fails, and order, translation and scaling by
// powers of two change nothing but places.
#include <functional>
#include <optional>
#include <string_view>

#include "tests/fuzz/graph_run.h"
#include "tests/fuzz/scene.h"

using namespace mes;
using namespace mes::fuzz;

namespace {

/// p becomes shift + scale * p. Both keep the lexicographic order.
struct Image {
  double scale = 1.0;
  Vec2 shift{};
  Vec2 operator()(Vec2 p) const { return shift + scale * p; }
};

Image read_image(ByteSource& bytes) {
  if (bytes.flag()) return {std::ldexp(1.0, static_cast<int>(bytes.small_integer()) / 2), {}};
  return {1.0, {std::ldexp(bytes.small_integer(), bytes.byte() % 40), std::ldexp(bytes.small_integer(), 20)}};
}

/// The image of the data; nothing when it is not exact.
std::optional<SampleData> image_of(const SampleData& data, const Image& image) {
  const auto is_exact = [&](Vec2 p) {
    const Vec2 q = image(p);
    return q - image.shift == image.scale * p && (1.0 / image.scale) * (q - image.shift) == p;
  };
  SampleData out = data;
  for (Vec2& p : out.positions) {
    if (!is_exact(p)) return std::nullopt;
    p = image(p);
  }
  for (Disk& ball : out.balls) {
    if (!is_exact(ball.center) || (ball.radius * image.scale) / image.scale != ball.radius) return std::nullopt;
    ball = {image(ball.center), ball.radius * image.scale};
  }
  return out;
}

/// What the state of the image must be.
test::GeometryState image_of(test::GeometryState state, const Image& image) {
  for (Vec2& p : state.sites) p = image(p);
  for (auto& edge : state.edges) {
    edge.a = image(edge.a);
    edge.b = image(edge.b);
  }
  for (auto& node : state.nodes)
    for (Vec2& p : node.corners) p = image(p);
  for (auto* lists : {&state.chains, &state.poles})
    for (auto& list : *lists)
      for (Vec2& p : list) p = image(p);
  for (auto& ball : state.balls) {
    const Vec2 center = image({ball[0], ball[1]});
    ball = {center.x, center.y, ball[2] * image.scale};
  }
  state.normals.clear();  // anchored at places, of a length of their own
  return state;
}

/// Whether a count may differ after a translation. Balls are sampled and v-points triangulated in doubles, rounded
/// where they lie, and so are the balls along what a filter keeps. So are circumcentres in `fast`, where unions of own
/// balls alone are of the numbers given.
bool may_depend_on_place(std::string_view key, Precision precision) {
  const auto has = [key](std::string_view word) { return key.find(word) != std::string_view::npos; };
  if (has("-sampling ") || has("-v-diagram ") || has("-difference ")) return true;
  if (has("-scale-union ") || has("-skeleton-union ")) return true;
  if (key.starts_with("lambda-union ") || key.starts_with("angle-union ") || key.starts_with("cover-union "))
    return true;
  if (precision != Precision::fast || key.starts_with("b-")) return false;
  return has("-union ") || has("-diagram ") || has("power-crust ");
}

void require_same(const std::map<std::string, std::int64_t>& a, const std::map<std::string, std::int64_t>& b,
                  const std::function<bool(std::string_view)>& may_differ, const std::string& promise) {
  for (const auto& [key, count] : a) {
    if (may_differ(key)) continue;
    const auto other = b.find(key);
    require(other != b.end() && other->second == count,
            promise + ": " + key + ' ' + std::to_string(count) + " or " +
                (other == b.end() ? "nothing" : std::to_string(other->second)));
  }
}

SampleData read_data(ByteSource& bytes, Precision precision) {
  // Signs of nested roots can take seconds each.
  const std::size_t most = precision == Precision::fast ? 40 : 8;
  const std::size_t balls = bytes.below(most / 2);
  // ... and hours where magnitudes are far apart.
  PlaceSource places(bytes, static_cast<Places>(bytes.below(precision == Precision::exact_roots ? 3 : 4)));
  SampleData out;
  for (std::size_t i = 0; i < balls; ++i) out.balls.push_back(places.disk());
  while (!bytes.is_at_end() && out.positions.size() < most) out.positions.push_back(places.point());
  return out;
}

}  // namespace

void mes::fuzz::run_geometry(std::string_view input) try {
  ByteSource bytes(input);
  const ComputationSettings settings = read_settings(bytes);
  const Image image = read_image(bytes);
  const bool is_about_order = bytes.flag();
  const SampleData scene = read_data(bytes, settings.precision);
  Document document;
  if (const auto delta = replace_all(document, scene); delta) {
    document.apply(*delta);
  } else {
    require_message(delta.error().text);
    return;
  }

  constexpr std::size_t kFew = 8;
  const bool is_small = document.sample_count() <= kFew && document.ball_count() <= kFew;
  const WorkLimit limit;
  const auto original = fresh_run(data_of(document, false), settings, is_small, limit);
  const std::string broken = test::broken_row(original->graph());
  require(broken.empty(), "rows refer to each other as they should: " + broken);
  if (settings.precision == Precision::naive) return;  // may lie
  if (is_about_order) {
    const auto reversed = fresh_run(data_of(document, true), settings, is_small, limit);
    const std::string differs = test::difference(reversed->state(), original->state());
    require(differs.empty(), "the order of the samples does not matter: " + differs);
    require_same(
        original->counts(), reversed->counts(), [](std::string_view) { return false; },
        "the order of the samples does not matter");
  } else if (const auto moved = image_of(data_of(document, false), image); moved) {
    Document other;
    if (!replace_all(other, *moved)) return;  // out of the range of coordinates
    ComputationSettings as_large = settings;
    for (const Parameter& length : {Parameter::lambda_limit, Parameter::alpha_radius})
      as_large[length] *= image.scale;
    const auto run = fresh_run(*moved, as_large, is_small, limit);
    test::GeometryState state = run->state();
    state.normals.clear();
    const std::string differs = test::difference(state, image_of(original->state(), image));
    require(differs.empty(), "places and size do not matter: " + differs);
    const auto may_differ = [&](std::string_view key) {
      return image.shift != Vec2{} && may_depend_on_place(key, settings.precision);
    };
    require_same(original->counts(), run->counts(), may_differ, "places and size do not matter");
  }
} catch (const TooMuchWork&) {
  return;  // nothing is known
}
