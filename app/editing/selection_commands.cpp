// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/selection_commands.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/counted.h"
#include "core/document/live_corners.h"
#include "core/edit/degenerate_places.h"
#include "core/formula/formula.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"
#include "core/kernel/circumcircle.h"

namespace mes {
namespace {

constexpr std::size_t kFormulaVariables = 7;
const std::vector<std::string>& formula_names() {
  static const std::vector<std::string> names{"x", "y", "r", "i", "n", "cx", "cy"};
  return names;
}

/// Returns nothing for an empty text.
Expected<std::optional<Formula>> formula_of(const std::string& text, std::string_view named) {
  if (text.find_first_not_of(" \t") == std::string::npos) return std::nullopt;
  auto formula = Formula::parse(text, formula_names());
  if (!formula)
    return std::unexpected(Error{ErrorCode::bad_input, fmt::format("{}: {}", named, formula.error().text)});
  return std::optional<Formula>(*std::move(formula));
}

Error not_finite(std::string_view named, std::size_t place) {
  return {ErrorCode::bad_input, fmt::format("{} is not a finite number for number {}", named, place)};
}

std::string noun_of_kind(bool is_ball, std::size_t count) {
  return fmt::format("{}{}", is_ball ? "ball" : "sample", count == 1 ? "" : "s");
}

std::string noun(std::size_t samples, std::size_t balls) {
  if (balls == 0) return noun_of_kind(false, samples);
  if (samples == 0) return noun_of_kind(true, balls);
  return noun_of_kind(false, samples) + " and " + noun_of_kind(true, balls);
}

std::string what_is_left_out(const SampleData& pasted) {
  std::string out;
  if (!pasted.contours.empty()) out = "their order along " + counted(pasted.contours.size(), "contour");
  if (pasted.annotations.empty()) return out;
  return (out.empty() ? "" : out + " and ") + counted(pasted.annotations.size(), "annotation");
}

}  // namespace

SelectionCommands::Places SelectionCommands::places() const {
  const Document& document = editor_.document();
  const Selection& selection = editor_.selection();
  Places out;
  for (const SampleSlot slot : selection.slots()) out.samples.push_back(document.id(slot));
  for (const BallSlot slot : selection.ball_slots()) out.balls.push_back(document.ball_id(slot));
  std::ranges::sort(out.samples);
  std::ranges::sort(out.balls);
  out.at.reserve(out.samples.size() + out.balls.size());
  for (const SampleId id : out.samples) out.at.push_back(document.position(document.slot_of(id)));
  for (const BallId id : out.balls) {
    const Disk& disk = document.disk(document.ball_slot_of(id));
    out.at.push_back(disk.center);
    out.radius.push_back(disk.radius);
  }
  return out;
}

const SelectionCommands::Numbers& SelectionCommands::numbers() const {
  const std::pair now{editor_.selection().revision(), editor_.document().revision()};
  if (numbers_of_ == now) return numbers_;
  const Places all = places();
  numbers_ = {all.samples.size(), all.balls.size(), middle_of(all.at),
              all.radius.empty() ? 0.0 : *std::ranges::max_element(all.radius)};
  for (const Vec2 p : all.at) numbers_.box.add(p);
  numbers_of_ = now;
  return numbers_;
}

Expected<void> SelectionCommands::put(const Places& from, std::vector<Vec2> at, const std::string& verb) {
  return put(from, std::move(at), from.radius, verb);
}

Expected<void> SelectionCommands::put(const Places& from, std::vector<Vec2> at, std::vector<double> radius,
                                      const std::string& verb) {
  std::vector<std::pair<SampleId, Vec2>> samples;
  std::vector<std::pair<BallId, Disk>> balls;
  const std::size_t count = from.samples.size();
  for (std::size_t i = 0; i < count; ++i)
    if (at[i] != from.at[i]) samples.emplace_back(from.samples[i], at[i]);
  for (std::size_t i = 0; i < from.balls.size(); ++i)
    if (at[count + i] != from.at[count + i] || radius[i] != from.radius[i])
      balls.emplace_back(from.balls[i], Disk{at[count + i], radius[i]});
  if (samples.empty() && balls.empty()) return {};
  return editor_.move(samples, balls, verb + ' ' + noun(from.samples.size(), from.balls.size()));
}

Expected<void> SelectionCommands::move_middle_to(Vec2 place) {
  Places all = places();
  // A single point is put exactly at its target, without the rounding of a difference.
  if (all.at.size() == 1) return put(all, {place}, "Move");
  const Vec2 middle = middle_of(all.at);
  std::vector<Vec2> at = all.at;
  for (Vec2& p : at) p = {place.x + (p.x - middle.x), place.y + (p.y - middle.y)};
  return put(all, std::move(at), "Move");
}

Expected<void> SelectionCommands::move_by(Vec2 step) {
  const Places all = places();
  std::vector<Vec2> at = all.at;
  for (Vec2& p : at) p = p + step;
  return put(all, std::move(at), "Move");
}

Expected<void> SelectionCommands::set_radius(double radius) {
  const Places all = places();
  if (radius < 0.0) return std::unexpected(Error{ErrorCode::bad_input, "a radius cannot be below zero"});
  return put(all, all.at, std::vector<double>(all.radius.size(), radius), "Set radius of");
}

Expected<void> SelectionCommands::turn(double degrees) {
  const Places all = places();
  return put(all, turned(all.at, middle_of(all.at), degrees), "Turn");
}

Expected<void> SelectionCommands::scale(double factor) {
  if (!(factor > 0.0)) return std::unexpected(Error{ErrorCode::bad_input, "a factor to scale by must be above zero"});
  const Places all = places();
  std::vector<double> radius = all.radius;
  for (double& r : radius) r *= factor;
  return put(all, scaled(all.at, middle_of(all.at), factor), std::move(radius), "Scale");
}

Expected<void> SelectionCommands::mirror(Axis coordinate) {
  const Places all = places();
  return put(all, mirrored(all.at, middle_of(all.at), coordinate), "Mirror");
}

Expected<void> SelectionCommands::align(Alignment where) {
  const Places all = places();
  return put(all, aligned(all.at, where), "Align");
}

Expected<void> SelectionCommands::distribute(Axis coordinate) {
  const Places all = places();
  return put(all, distributed(all.at, coordinate), "Distribute");
}

Expected<void> SelectionCommands::place_each(const EachFormula& formulas) {
  const auto x = formula_of(formulas.x, "x");
  if (!x) return std::unexpected(x.error());
  const auto y = formula_of(formulas.y, "y");
  if (!y) return std::unexpected(y.error());
  const auto r = formula_of(formulas.r, "r");
  if (!r) return std::unexpected(r.error());
  const Places all = places();
  std::vector<Vec2> at = all.at;
  std::vector<double> radius = all.radius;
  const Vec2 middle = middle_of(all.at);
  const std::size_t samples = all.samples.size();
  for (std::size_t i = 0; i < at.size(); ++i) {
    const bool is_ball = i >= samples;
    const double values[kFormulaVariables]{all.at[i].x,
                                           all.at[i].y,
                                           is_ball ? all.radius[i - samples] : 0.0,
                                           static_cast<double>(i),
                                           static_cast<double>(at.size()),
                                           middle.x,
                                           middle.y};
    if (*x) at[i].x = (*x)->value(values);
    if (*y) at[i].y = (*y)->value(values);
    if (*r && is_ball) radius[i - samples] = (*r)->value(values);
    if (!std::isfinite(at[i].x)) return std::unexpected(not_finite("x", i));
    if (!std::isfinite(at[i].y)) return std::unexpected(not_finite("y", i));
    if (is_ball && !std::isfinite(radius[i - samples])) return std::unexpected(not_finite("r", i));
  }
  return put(all, std::move(at), std::move(radius), "Place");
}

Expected<std::string> SelectionCommands::put_on_line() {
  const Places all = places();
  auto line = on_one_line(all.at);
  if (!line) return std::unexpected(line.error());
  if (auto done = put(all, std::move(line->places), "Put on a line:"); !done) return std::unexpected(done.error());
  return fmt::format("Exactly on one line; moved by {:.3g} at most", line->largest_shift);
}

Expected<std::string> SelectionCommands::put_on_circle() {
  const Places all = places();
  auto circle = on_one_circle(all.at);
  if (!circle) return std::unexpected(circle.error());
  if (auto done = put(all, std::move(circle->places), "Put on a circle:"); !done)
    return std::unexpected(done.error());
  return fmt::format("Exactly on one circle; moved by {:.3g} at most", circle->largest_shift);
}

Expected<void> SelectionCommands::add_circle() {
  const Places all = places();
  if (all.at.size() != 3) return std::unexpected(Error{ErrorCode::bad_input, "select three points for a circle"});
  const Circle circle = circumcircle(all.at[0], all.at[1], all.at[2]);
  if (!std::isfinite(circle.radius))
    return std::unexpected(Error{ErrorCode::bad_input, "the three points are on one line"});
  return add({}, {{circle.center, circle.radius}}, {}, "Circle through three");
}

std::string SelectionCommands::text() const {
  const Document& document = editor_.document();
  const Places all = places();
  std::vector<Disk> balls;
  for (const BallId id : all.balls) balls.push_back(document.disk(document.ball_slot_of(id)));
  if (all.samples.empty()) return balls.empty() ? std::string() : write_wpoff(balls);
  const std::span<const Vec2> samples = std::span(all.at).first(all.samples.size());
  if (!balls.empty()) {
    Session session;
    session.data = std::make_shared<const SampleData>(
        SampleData{.positions = {samples.begin(), samples.end()}, .balls = std::move(balls)});
    return write_session(session);
  }
  std::string out;
  for (const Vec2 p : samples) {
    append_number(out, p.x);
    out += '\t';
    append_number(out, p.y);
    out += '\n';
  }
  return out;
}

Expected<void> SelectionCommands::add_contours(const std::vector<SampleData::Contour>& contours,
                                               const std::vector<SampleSlot>& rows, const std::string& name) {
  if (contours.empty()) return {};
  const Document& document = editor_.document();
  CurveOrder all = *document.curve_order();
  for (const SampleData::Contour& contour : contours) {
    CurveOrder::Contour& out = all.contours.emplace_back(CurveOrder::Contour{contour.closed, {}});
    for (const std::uint32_t place : contour.points) out.samples.push_back(document.id(rows[place]));
  }
  return editor_.set_contours(std::move(all), name);
}

Expected<void> SelectionCommands::add(std::vector<Vec2> samples, std::vector<Disk> balls, Vec2 shift,
                                      const std::string& verb, const std::vector<SampleData::Contour>& contours) {
  for (Vec2& p : samples) p = p + shift;
  for (Disk& disk : balls) disk.center = disk.center + shift;
  const std::string name = verb.ends_with(' ') ? verb + noun(samples.size(), balls.size()) : verb;
  editor_.begin_gesture(name);
  const auto rows = editor_.insert(samples, name);
  const auto ball_rows =
      rows ? editor_.insert_balls(balls, name) : Expected<std::vector<BallSlot>>(std::unexpected(rows.error()));
  if (!rows || !ball_rows) {
    editor_.cancel_gesture();
    return std::unexpected(rows ? ball_rows.error() : rows.error());
  }
  if (auto done = add_contours(contours, *rows, name); !done) {
    editor_.cancel_gesture();
    return done;
  }
  editor_.end_gesture();
  Selection& selection = editor_.selection();
  selection.clear();
  for (const SampleSlot slot : *rows) selection.add(slot);
  for (const BallSlot slot : *ball_rows) selection.add_ball(slot);
  return {};
}

Expected<LoadedFile> SelectionCommands::read(std::string_view text, MapDegrees degrees) const {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return std::unexpected(Error{ErrorCode::bad_input, "There is no text on the clipboard"});
  return read_sample_bytes(text, "clipboard", {}, {.degrees = degrees, .formats = &registry_.now().formats()});
}

bool SelectionCommands::begins_document(std::string_view text, MapDegrees degrees) const {
  if (!editor_.document().is_empty()) return false;
  const auto read = this->read(text, degrees);
  return read && (read->session || read->data.source || read->data.map || !what_is_left_out(read->data).empty());
}

Expected<SelectionCommands::Pasted> SelectionCommands::paste(std::string_view text, Vec2 step, MapDegrees degrees) {
  auto read = this->read(text, degrees);
  if (!read) return std::unexpected(read.error());
  SampleData& data = read->data;
  if (data.positions.empty() && data.balls.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "there is nothing in it", "clipboard"});
  const Document& document = editor_.document();
  const auto is_of_map = [](const std::optional<MapPlane>& plane) { return plane && is_on_earth(*plane); };
  if (is_of_map(data.map) && is_of_map(document.map()) && *data.map != *document.map()) {
    const auto target = data.map->system == document.map()->system ? MapTarget::own_system : MapTarget::wgs84;
    const auto there = MapConversion::of(*data.map, target);
    if (!there) return std::unexpected(there.error());
    const auto here = MapConversion::of(*document.map(), target);
    if (!here) return std::unexpected(here.error());
    there->from_plane(data.positions);
    here->to_plane(data.positions);
    if (std::ranges::any_of(data.positions, [](Vec2 p) { return !is_finite(p); }))
      return std::unexpected(
          Error{ErrorCode::bad_input, "a position is not on the map of the document", "clipboard"});
  }
  const auto is_taken = [&](Vec2 shift) {
    return std::ranges::any_of(data.positions,
                               [&](Vec2 p) { return editor_.index().nearest(p + shift, 0.0) != kNoSlot; }) ||
           std::ranges::any_of(data.balls, [&](const Disk& ball) {
             const Vec2 center = ball.center + shift;
             return std::ranges::any_of(editor_.centers().in_box({center, center}),
                                        [&](BallSlot slot) { return document.disk(slot).radius == ball.radius; });
           });
  };
  constexpr int kMostSteps = 1000;
  Vec2 shift;
  for (int i = 0; i < kMostSteps && is_taken(shift); ++i) shift = shift + step;
  Pasted out{std::move(read->warnings), what_is_left_out(data)};
  if (auto done = add(std::move(data.positions), std::move(data.balls), shift, "Paste "); !done)
    return std::unexpected(done.error());
  return out;
}

Expected<void> SelectionCommands::duplicate(Vec2 step) {
  const Places all = places();
  if (all.at.empty()) return {};
  std::vector<Disk> balls;
  const std::size_t samples = all.samples.size();
  for (std::size_t i = 0; i < all.balls.size(); ++i) balls.push_back({all.at[samples + i], all.radius[i]});
  // Samples are sorted by id.
  const auto place_of = [&](SampleId id) -> std::optional<std::uint32_t> {
    const auto found = std::ranges::lower_bound(all.samples, id);
    if (found == all.samples.end() || *found != id) return std::nullopt;
    return static_cast<std::uint32_t>(found - all.samples.begin());
  };
  std::vector<SampleData::Contour> contours;
  for (const CurveOrder::Contour& contour : editor_.document().curve_order()->contours) {
    SampleData::Contour copy{contour.closed, {}};
    bool is_whole = true;
    for (const SampleId id : live_corners(editor_.document(), contour)) {
      const auto place = place_of(id);
      is_whole = is_whole && place;
      if (!is_whole) break;
      copy.points.push_back(*place);
    }
    if (is_whole && copy.points.size() > 1) contours.push_back(std::move(copy));
  }
  return add({all.at.begin(), all.at.begin() + static_cast<std::ptrdiff_t>(samples)}, std::move(balls), step,
             "Duplicate ", contours);
}

}  // namespace mes
