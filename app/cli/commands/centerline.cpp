// SPDX-License-Identifier: GPL-3.0-or-later
// `mesecina centerline`: the centre line of each shape, or stations along it with widths.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/commands/commands.h"
#include "app/cli/console/messages.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress.h"
#include "app/cli/requests/feature_list.h"
#include "app/cli/requests/input.h"
#include "app/cli/requests/names.h"
#include "app/insight/center_line_run.h"
#include "app/store/texts/center_line_text.h"
#include "core/base/jobs/parallel.h"
#include "core/base/lower_case.h"
#include "core/graph/registry.h"
#include "core/io/systems/coordinate_system.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

constexpr std::uint64_t kMostBranches = 100'000;
constexpr double kMostStations = 1e7;
const std::string kStationColumns = "shape,line,station,x,y,width,left_x,left_y,right_x,right_y,direction\n";

/// The parsed options of the command.
struct CenterlineJob {
  CenterLineWish wish{};
  std::optional<std::pair<Vec2, Vec2>> between{};  ///< in the coordinates of the file
  double every = 0.0;                              ///< 0: the lines themselves
  const LineTextFormat* format = nullptr;
};

/// Prefix of a column of ours if a feature has a property of its name.
constexpr std::string_view kPrefix = "centerline_";

/// Everything that will be written, with counts for the summary.
struct CenterlineResult {
  std::vector<TextLine> lines{};
  std::string table{};  ///< of stations
  std::size_t stations = 0;
  CenterLineTotals totals{};
  std::optional<MapPlane> map{};  ///< of the first lines, whose unit all lengths have
  PropertyNames names{};
  std::string failure{};  ///< counts features without a line; empty if there are none
};

Expected<Vec2> point_between(const std::string& text) {
  const std::vector<std::string_view> parts = split_list(text);
  if (parts.size() == 2) {
    const auto x = parse_number(parts[0]);
    const auto y = parse_number(parts[1]);
    if (x && y) return Vec2{*x, *y};
  }
  return usage_error("--between expects two points X,Y, not " + in_quotes(text));
}

Expected<double> positive_length(std::string_view option, std::string_view text, bool may_be_zero) {
  const auto value = parse_number(text);
  if (value && (*value > 0.0 || (may_be_zero && *value == 0.0))) return *value;
  return usage_error(fmt::format("{} expects a {}, not {}", option,
                                 may_be_zero ? "length or a percentage of 0 or more" : "length above 0",
                                 in_quotes(text)));
}

Expected<SmoothingTolerance> parse_smooth(std::string_view text) {
  const bool is_share = text.ends_with('%');
  const auto value = positive_length("--smooth", is_share ? text.substr(0, text.size() - 1) : text, true);
  if (!value) return std::unexpected(value.error());
  return is_share ? SmoothingTolerance{.length = 0.0, .share = 0.01 * *value}
                  : SmoothingTolerance{.length = *value, .share = 0.0};
}

Expected<const LineTextFormat*> centerline_format(const CenterlineRequest& request) {
  std::string name = request.format;
  if (name.empty() && !is_standard_output(request.output)) {
    const std::string extension = lower_case_extension(request.output);
    name = extension == ".json" ? "geojson" : extension.substr(std::min<std::size_t>(1, extension.size()));
    if (find_line_text_format(name) == nullptr)
      return usage_error(
          fmt::format("the name of the output tells no format; --format expects {}", one_of(centerline_formats())));
  }
  if (name.empty()) name = "geojson";
  if (const LineTextFormat* const format = find_line_text_format(name)) return format;
  return usage_error(fmt::format("--format expects {}, not {}", one_of(centerline_formats()), in_quotes(name)));
}

Expected<CenterlineJob> centerline_job(const CenterlineRequest& request) {
  CenterlineJob out;
  const auto prune = parse_number(request.prune);
  if (!prune || *prune < 0.0)
    return usage_error("--prune expects a number of 0 or more, not " + in_quotes(request.prune));
  out.wish.request.least_salience = *prune;
  const auto tolerance = parse_smooth(request.smooth);
  if (!tolerance) return std::unexpected(tolerance.error());
  out.wish.tolerance = *tolerance;
  out.wish.is_extended = request.is_extended;
  out.wish.is_exact = request.is_exact;
  const auto branches = whole_number("--branches", request.branches, 1, kMostBranches);
  if (!branches) return std::unexpected(branches.error());
  out.wish.request.most = static_cast<std::size_t>(*branches);
  if (!request.between.empty()) {
    const auto from = point_between(request.between.front());
    if (!from) return std::unexpected(from.error());
    const auto to = point_between(request.between.back());
    if (!to) return std::unexpected(to.error());
    out.between = {*from, *to};
    if (*branches != 1) return usage_error("--between asks for one line, and --branches for more");
    if (request.are_features_apart) return usage_error("--between asks for one line, and --each for one a feature");
  }
  if (!request.every.empty()) {
    const auto every = positive_length("--every", request.every, false);
    if (!every) return std::unexpected(every.error());
    out.every = *every;
    if (request.is_extended)
      return usage_error("--every measures the balls of the axis, and --extend goes beyond them");
  }
  const auto format = centerline_format(request);
  if (!format) return std::unexpected(format.error());
  out.format = *format;
  if (request.are_features_apart && !request.from.empty() &&
      std::ranges::find(feature_formats(), request.from) == feature_formats().end())
    return usage_error("--each reads features of " + one_of(feature_formats()) + ", not " + in_quotes(request.from));
  if (out.format->name == "dxf-3d" && (request.is_extended || !request.every.empty()))
    return usage_error("dxf-3d has the radii along the lines; it goes with neither --extend nor --every");
  if (request.are_features_apart && !out.format->is_of_features)
    return usage_error(
        fmt::format("--each writes properties, which {} cannot hold; geojson, gpkg and fgb can", out.format->name));
  return out;
}

/// Positions of a map are in its coordinate system; the direction is that of the plane. A station lies on the axis, where
/// its width is measured, and not on the smoothed line.
void add_station_rows(std::string& table, std::size_t shape, std::size_t line, const std::vector<Station>& stations,
                      double unit, const std::optional<MapConversion>& conversion) {
  for (const Station& at : stations) {
    table += fmt::format("{},{}", shape, line);
    std::array places{at.axis, at.left, at.right};
    if (conversion) conversion->from_plane(places);
    const auto& [place, left, right] = places;
    for (const double x :
         {unit * at.along, place.x, place.y, unit * at.width, left.x, left.y, right.x, right.y, at.direction})
      append_number(table += ',', x);
    table += '\n';
  }
}

/// Formats without ids of their own get the id as a property.
void add_numbers(TextLine& line, const Feature& feature, std::vector<TextNumber> numbers, const CenterlineJob& job,
                 const CenterlineResult& out) {
  for (TextNumber& number : numbers) {
    number.name = out.names.free_name(std::move(number.name), kPrefix);
    line.numbers.push_back(std::move(number));
  }
  line.id = feature.id;
  line.properties = feature.properties;
  if (feature.id.empty() || job.format->name == "geojson") return;
  if (!line.properties.empty()) line.properties += ',';
  line.properties += fmt::format("\"{}\":{}", out.names.free_name("feature_id", kPrefix), feature.id);
}

/// Size of a length of the plane in the unit that lengths of the first map are written in. Error: `bad_input`, if one of
/// the units has no size in metres.
Expected<double> written_size(const std::optional<MapPlane>& map, const std::optional<MapPlane>& first) {
  if (!map || !first) return 1.0;
  if (map->written_unit() == first->written_unit()) return map->written_size();
  const auto metres = [](const MapPlane& plane) -> std::optional<double> {
    if (plane.projection != MapProjection::none) return 1.0;
    const auto system = find_coordinate_system(plane.system);
    if (!is_on_earth(plane) || !system || system->is_geographic) return std::nullopt;
    return system->unit_size;
  };
  const auto own = metres(*map);
  const auto wanted = metres(*first);
  if (!own || !wanted)
    return std::unexpected(Error{ErrorCode::bad_input, fmt::format("its lengths are in {}, and those before it in {}",
                                                                   map->plane_unit(), first->plane_unit())});
  return *own / *wanted * map->written_size();
}

Expected<void> add_lines(const CenterlineJob& job, const CenterLines& found, const std::optional<MapPlane>& map,
                         const Feature& feature, CenterlineResult& out) {
  std::optional<MapConversion> to_system;
  if (map && job.every > 0.0 && job.format->name == "csv") {
    auto conversion = MapConversion::of(*map, MapTarget::own_system);
    if (!conversion) return std::unexpected(conversion.error());
    to_system = *std::move(conversion);
  }
  if (map && !out.map) out.map = map;
  const auto unit = written_size(map, out.map);
  if (!unit) return std::unexpected(unit.error());
  out.totals.add(found, *unit);
  for (const CenterLine& line : found.lines) {
    if (job.every == 0.0) {
      TextLine whole = text_line_of(line, map, *unit);
      add_numbers(whole, feature, std::exchange(whole.numbers, {}), job, out);
      out.lines.push_back(std::move(whole));
      continue;
    }
    const double every = job.every / *unit;
    if (static_cast<double>(out.stations) + length_of(line) / every > kMostStations)
      return usage_error(fmt::format("--every {:g} asks for more than {:g} stations", job.every, kMostStations));
    const std::vector<Station> stations = stations_of(line, every);
    out.stations += stations.size();
    if (job.format->name == "csv") {
      add_station_rows(out.table, line.shape + 1, line.rank + 1, stations, *unit, to_system);
      continue;
    }
    for (const Station& at : stations) {
      TextLine& text = out.lines.emplace_back();
      text.points = {at.left, at.axis, at.right};
      text.map = map;
      add_numbers(text, feature,
                  {{"shape", static_cast<double>(line.shape + 1), true},
                   {"line", static_cast<double>(line.rank + 1), true},
                   {"station", *unit * at.along},
                   {"width", *unit * at.width},
                   {"direction", at.direction}},
                  job, out);
    }
  }
  return {};
}

/// The lines of one set of outlines, on the plane of their map.
struct FoundLines {
  CenterLines lines{};
  std::optional<MapPlane> map{};
};

std::unexpected<Error> in_file(Error error, const std::string& name) {
  if (error.file.empty() && error.code != ErrorCode::usage) error.file = name;
  return std::unexpected(std::move(error));
}

/// Samples that the user of a session or of an option has chosen stay.
CenterLineBasis basis_of(const CenterlineJob& job, bool keeps_samples) {
  return job.wish.is_exact ? CenterLineBasis::outlines
         : keeps_samples   ? CenterLineBasis::own_samples
                           : CenterLineBasis::new_samples;
}

/// Takes samples and computes the lines. Adds remarks on the outlines and their samples to `remarks`, also if there is
/// no line. Calls `on_task` with the id of each structure before it begins.
Expected<FoundLines> find_lines(CenterLineFinder& finder, const CenterlineJob& job, const SampleData& data,
                                CenterLineBasis basis, const std::string& name, std::vector<std::string>& remarks,
                                const std::function<void(std::string_view)>& on_task) {
  if (data.positions.empty()) return in_file({ErrorCode::bad_input, "there are no samples and no curves"}, name);
  JobControl control;
  FoundLines out;
  CenterLineWish wish = job.wish;
  const auto input = input_for_center_lines(data, basis, control);
  if (!input) return in_file(input.error(), name);
  wish.is_exact = input->is_exact;
  if (data.map) wish.tolerance.length /= data.map->written_size();
  remarks.insert(remarks.end(), input->remarks.begin(), input->remarks.end());
  // Ends that a session has count unless more lines are wanted.
  if (!job.between && wish.request.most == 1) wish.request.between = center_line_ends(data.annotations);
  if (job.between) {
    auto& [from, to] = wish.request.between.emplace_back(*job.between);
    if (data.map) {
      const auto to_system = MapConversion::of(*data.map, MapTarget::own_system);
      if (!to_system) return in_file(to_system.error(), name);
      from = to_system->to_plane(from);
      to = to_system->to_plane(to);
      for (const Vec2 end : {from, to})
        if (!is_finite(end)) return in_file({ErrorCode::usage, "--between has a point that is not on the map"}, name);
    }
  }
  auto found = finder.find(input->data, wish, control, on_task);
  if (!found) return in_file(found.error(), name);
  out.lines = *std::move(found);
  out.map = data.map;
  return out;
}

/// Adds lines to the result. `found` may be an error, which is then returned.
Expected<void> take_lines(const CenterlineJob& job, const Expected<FoundLines>& found, const std::string& name,
                          const Feature& feature, CenterlineResult& out) {
  if (!found) return std::unexpected(found.error());
  if (auto done = add_lines(job, found->lines, found->map, feature, out); !done) return in_file(done.error(), name);
  return {};
}

/// Remarks on features, one for each kind: they are of one kind if they differ in names and numbers alone.
class FeatureRemarks {
 public:
  void add(const std::string& name, const std::string& remark) {
    const bool is_named = remark.starts_with(name);
    std::string kind;
    for (const char c : std::string_view(remark).substr(is_named ? name.size() : 0))
      if (!std::string_view("0123456789.-:").contains(c)) kind += c;
    const auto [number, is_new] = numbers_.try_emplace(std::move(kind), remarks_.size());
    if (is_new)
      remarks_.push_back({is_named ? remark : name + ": " + remark});
    else
      ++remarks_[number->second].others;
  }
  void say_all() const {
    for (const auto& [text, others] : remarks_)
      say(text + (others == 0   ? ""
                  : others == 1 ? "; likewise another feature"
                                : fmt::format("; likewise {} other features", others)));
  }

 private:
  struct Remark {
    std::string text;  // of the first feature
    std::size_t others = 0;
  };
  std::map<std::string, std::size_t> numbers_;
  std::vector<Remark> remarks_;
};

/// A finder for each task that runs at the same time.
class Finders {
 public:
  explicit Finders(const Registry& registry) : registry_(registry) {}
  /// A finder that is free, or a new one.
  std::unique_ptr<CenterLineFinder> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        auto out = std::move(free_.back());
        free_.pop_back();
        return out;
      }
    }
    return std::make_unique<CenterLineFinder>(registry_);
  }
  void give_back(std::unique_ptr<CenterLineFinder> finder) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(finder));
  }

 private:
  const Registry& registry_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<CenterLineFinder>> free_;
};

/// Each feature by itself, on all cores, with lines and messages in the order of the features. Error: no feature has a
/// line.
Expected<void> process_features(const Registry& registry, const std::string& file, const ReadingOptions& reading,
                                const CenterlineJob& job, const FeatureList& list, Progress& progress,
                                CenterlineResult& out) {
  std::vector<Expected<FoundLines>> found(list.features.size());
  std::vector<std::vector<std::string>> warnings(found.size());
  out.names = PropertyNames(list.features);
  Finders finders(registry);
  std::mutex progress_mutex;
  std::size_t finished = 0;
  run_tasks(list.features.size(), [&](std::size_t i) {
    const Feature& feature = list.features[i];
    auto loaded = read_input_bytes(registry, feature.text, feature.name, feature.format, reading);
    if (loaded) {
      warnings[i] = std::move(loaded->warnings);
      auto finder = finders.take();
      found[i] = find_lines(*finder, job, loaded->data, basis_of(job, reading.keeps_vertices), feature.name,
                            warnings[i], {});
      finders.give_back(std::move(finder));
    } else {
      // Lines and columns would be those of the feature alone.
      Error error = loaded.error();
      error.line = error.column = 0;
      found[i] = std::unexpected(std::move(error));
    }
    const std::lock_guard lock(progress_mutex);
    progress.show("features", static_cast<double>(++finished) / static_cast<double>(found.size()));
  });
  const auto lies_on_earth = [](const Expected<FoundLines>& lines) {
    return lines && lines->map && is_on_earth(*lines->map);
  };
  const bool is_map = std::ranges::any_of(found, lies_on_earth);
  std::optional<Error> first;
  std::size_t without_line = 0;
  FeatureRemarks remarks;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Feature& feature = list.features[i];
    for (const std::string& warning : warnings[i]) remarks.add(feature.name, warning);
    // Numbers that are no degrees are read as positions in a plane.
    if (is_map && found[i] && !lies_on_earth(found[i]))
      found[i] = std::unexpected(
          Error{ErrorCode::bad_input, "its positions are not on the Earth, where other features are", feature.name});
    const auto done = take_lines(job, found[i], feature.name, feature, out);
    found[i] = FoundLines{};
    if (done) continue;
    if (done.error().code == ErrorCode::usage) return done;
    say(done.error().message());
    ++without_line;
    if (!first) first = done.error();
  }
  if (without_line != 0)
    out.failure = fmt::format("{} of {} features {} no line; the others are written", without_line, found.size(),
                              without_line == 1 ? "has" : "have");
  remarks.say_all();
  if (out.totals.lines != 0) return {};
  return std::unexpected(Error{first ? first->code : ErrorCode::bad_input, "no feature has a centre line", file});
}

}  // namespace

std::span<const std::string_view> centerline_formats() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out;
    for (const LineTextFormat& format : line_text_formats()) out.push_back(format.name);
    return out;
  }();
  return names;
}

Expected<void> run_centerline(const Registry& registry, const CenterlineRequest& request,
                              Interruption& interruption) {
  const auto job = centerline_job(request);
  if (!job) return std::unexpected(job.error());
  if (auto good = check_output(request.output); !good) return good;
  ReadingOptions reading = request.reading;
  reading.wants_curves = true;
  CenterlineResult result;
  std::vector<SourceFile> sources;
  {
    Progress progress;
    if (request.are_features_apart) {
      const auto list = read_features(registry, request.file, request.from, !reading.system.empty());
      if (!list) return std::unexpected(list.error());
      sources = list->sources;
      if (auto done = process_features(registry, request.file, reading, *job, *list, progress, result); !done)
        return done;
    } else {
      const auto input = read_input(registry, request.file, request.from, reading);
      if (!input) return std::unexpected(input.error());
      sources = input->sources;
      const CenterLineBasis basis = basis_of(*job, reading.keeps_vertices || input->session != nullptr);
      std::vector<std::string> remarks;
      const auto ids = registry.structures();
      progress.show("sampling", 0.0);
      CenterLineFinder finder(registry);
      const auto found =
          find_lines(finder, *job, input->data, basis, request.file, remarks, [&](std::string_view task) {
            const auto at = std::ranges::find(ids, task) - ids.begin();
            progress.show(task, static_cast<double>(at) / static_cast<double>(ids.size()));
          });
      for (const std::string& remark : remarks) say(request.file + ": " + remark);
      if (auto done = take_lines(*job, found, request.file, Feature{}, result); !done) return done;
    }
  }
  const bool is_table = job->every > 0.0 && job->format->name == "csv";
  const auto text =
      is_table ? Expected<LineText>(LineText{kStationColumns + result.table}) : job->format->write(result.lines);
  if (!text) return std::unexpected(text.error());
  auto done = write_output(request.output, text->text, interruption, {sources, request.force});
  if (!done) return done;
  say(result.totals.text(result.map, text->off_earth, result.stations));
  if (result.failure.empty()) return {};
  return std::unexpected(Error{ErrorCode::cannot_compute, result.failure, request.file});
}

}  // namespace mes::cli
