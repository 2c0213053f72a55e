// SPDX-License-Identifier: GPL-3.0-or-later
// A workbench: samples and balls, and the geometry that follows them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <mesecina/catalogue.h>
#include <mesecina/error.h>
#include <mesecina/geometry.h>
#include <mesecina/table.h>
#include <mesecina/version.h>

namespace mesecina {
inline namespace v1 {

/// Stops a long call and reports its progress.
///
/// Guarantees: once stopped, it stays stopped; a call with a stopped job throws `cancelled` and changes no
/// data, except `get_ready`, which just ends. A stop takes effect within a moment, except while a library reads XML or
/// decodes a picture. One job may serve several calls in sequence.
///
/// Threads: all functions may be called from any thread while another one does the job. A signal handler may call
/// `stop`, unless the job was made with a token.
class MESECINA_API Job {
 public:
  Job();
  /// Also stops when the token is asked to stop.
  explicit Job(std::stop_token token);
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  void stop() noexcept;
  bool is_stopped() const noexcept;
  /// Fraction of the current task, from 0 to 1.
  double progress() const noexcept;
  /// Id of the structure being computed, or "layers"; empty before the first.
  std::string task() const;

 private:
  friend struct JobAccess;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

struct WorkbenchOptions {
  bool keeps_history = true;    ///< false: nothing can be undone, and edits take less memory
  bool keeps_instances = true;  ///< false: tables only; `instances` and `digest` are refused
};

struct ReadOptions {
  std::string format{};          ///< id; empty: by content, then by extension
  bool keeps_vertices = false;   ///< the vertices of curves are the samples; else curves are sampled
  bool projects_degrees = true;  ///< longitude and latitude become metres; else they stay degrees
  std::string system{};          ///< coordinate system, as "EPSG:25832"; empty: that of the file
};

struct OpenedFile {
  std::string format{};                 ///< id of the format it was read as
  std::vector<std::string> warnings{};  ///< one line each, with file, line and column
  std::vector<std::string> files{};     ///< all files that were read, such as contours beside the samples
};

enum class State : std::uint8_t {
  inactive = 0,  ///< not requested
  up_to_date = 1,
  failed = 2,      ///< `reason` tells why
  blocked = 3,     ///< an input failed
  unfinished = 4,  ///< the run was stopped
};

/// A counter or a measure. A double that is not finite stands for no value.
using StatisticValue = std::variant<std::int64_t, double, std::vector<std::int64_t>, std::string>;

struct Statistic {
  std::string key{};  ///< snake case, with the unit as suffix
  StatisticValue value{};
};

enum class FindingLevel : std::uint8_t {
  note = 0,   ///< says nothing about the theorem
  doubt = 1,  ///< the result is exact, but a condition of the theorem does not hold somewhere
  wrong = 2,  ///< the number type gave a wrong or inconsistent result
};

/// A reason not to trust the one-step axis.
struct Finding {
  std::string structure{};  ///< id of the structure that found it
  FindingLevel level = FindingLevel::note;
  std::string text{};           ///< one line, no full stop, without the count
  std::int64_t count = 0;       ///< number of locations
  std::vector<Point> places{};  ///< some of these locations, at most 64
};

/// The verdict on the one-step axis: does it deserve to be called the medial axis?
enum class Light : std::uint8_t {
  none = 0,    ///< no findings were requested, or there is nothing to judge
  green = 1,   ///< proved for this input
  yellow = 2,  ///< exact, but not proved
  red = 3,     ///< the number type gave a wrong result, or a structure failed
};

struct StructureReport {
  std::string id{};
  State state = State::inactive;
  std::string reason{};                 ///< one line, when failed or blocked
  std::vector<SampleId> witnesses{};    ///< samples that a failed structure blames
  double milliseconds = 0.0;            ///< time of its last computation, without its inputs
  std::uint64_t touched_rows = 0;       ///< rows touched by its last update
  bool is_rebuilt = false;              ///< its last computation was not an update
  std::string number_type{};            ///< number type of its decisions; empty: it makes none
  std::vector<Statistic> statistics{};  ///< if requested
};

struct LayerReport {
  std::string id{};
  State state = State::inactive;
  std::string reason{};
  std::uint64_t lost = 0;  ///< primitives left out because their coordinates are not finite
};

/// A request for `make_shape`. Missing parameters have their defaults.
struct ShapeRequest {
  std::vector<std::pair<std::string, double>> parameters{};     ///< ids and values
  std::vector<std::pair<std::string, std::string>> formulas{};  ///< ids and texts
  std::optional<std::size_t> samples{};                         ///< not together with `spacing`
  std::optional<double> spacing{};                              ///< along curves
  double jitter = 0.0;  ///< each sample moves by up to this many mean spacings
  std::uint64_t seed = 1;
};

/// Samples a shape of the catalogue. The same request gives the same samples on every machine. Error: `usage` for an
/// unknown id, a value out of range or a meaningless request; `bad_input` for a formula without values. O(samples).
MESECINA_API Data make_shape(const Catalogue& catalogue, std::string_view shape, const ShapeRequest& request = {});
MESECINA_API Data make_shape(const Catalogue& catalogue, std::string_view shape, const ShapeRequest& request,
                             Job& job);

/// Keeps samples, balls, their history and settings, and computes the structures and layers that the caller requests.
/// An edit changes the data at once; `run` brings the results up to date, in time that depends on the change, not on
/// the size of the data.
///
/// Guarantees:
///  1. After a `run` that returns, every needed structure and every shown layer is that of the current data and
///     settings. A run computes only what has changed since the previous run. Results do not depend on the edits that
///     led to the data, except the numbering of rows and instances.
///  2. Every combinatorial decision about the samples is exact, except with the number type `naive`.
///  3. A call that fails with `usage`, `bad_input` or `cancelled` changes neither data nor settings.
///  4. After a `run` with the error `cannot_compute`, everything that does not depend on the failed structures is up to
///     date, and `structure_reports` has the reasons. The next run that changes their inputs tries them again.
///  5. After a `run` with the error `cancelled`, instances and digests are as before it, and no table can be read. The
///     next run completes the work.
///  6. Results are never outdated: a result read by id is that of the last run, or the call throws.
///  7. A run that follows no edit and no change of settings moves no table of a structure that stays needed and no
///     instances of a layer that stays shown, whatever other demand is new.
///  8. After an edit, `load` or `open` with the error `out_of_memory`, the workbench can only be destroyed. After a run
///     with this error, results are errors until a later run succeeds.
///
/// Smallest use:
///     mesecina::Workbench bench;
///     bench.insert(points);
///     bench.show({"medial-axis"});
///     bench.run();
///     edges = bench.instances("medial-axis", mesecina::PrimitiveKind::segment).size();
///
/// Cost: an edit takes O(what it changes), and so does the run after it. A first run takes O(n log n) for the one-step
/// pipeline; the Delaunay triangulation of a million samples of a curve, for instance, takes 0.4 s on two cores.
/// Lookups by id take O(structures or layers).
/// Threads: one thread at a time may use a workbench. Several may call const functions while none calls another one. A
/// run uses several threads inside, none of which outlives it. Any thread may use the `Job` of a run.
/// Inside: the workbench wraps the document, history and geometry graph of the program; none of these appears in this
/// header, and they may change freely.
/// Source: the one-step crust and medial axis are those of the theorem in docs/union_of_balls.md, with its references.
class MESECINA_API Workbench {
 public:
  /// Uses the catalogue of the program.
  Workbench();
  explicit Workbench(const Catalogue& catalogue, const WorkbenchOptions& options = {});
  ~Workbench();
  /// A moved-from workbench can be assigned to and destroyed; every other call throws `usage`.
  Workbench(Workbench&&) noexcept;
  Workbench& operator=(Workbench&&) noexcept;
  const Catalogue& catalogue() const;

  // Files. Formats are those of `Catalogue::formats`; paths are those of the system, in its encoding.

  /// Replaces the data by those of a file. A session sets the settings, too. Error: `bad_input` with file, line and
  /// column; `usage` for options that do not fit; `cancelled`.
  OpenedFile open(const std::string& path, const ReadOptions& options = {});
  OpenedFile open(const std::string& path, const ReadOptions& options, Job& job);
  /// Does the same for bytes in memory; `name` stands for the file in messages.
  OpenedFile open_bytes(std::string_view bytes, const std::string& name, const ReadOptions& options = {});
  OpenedFile open_bytes(std::string_view bytes, const std::string& name, const ReadOptions& options, Job& job);
  /// Returns the text of a file: "poff" with samples and contours, "wpoff" with balls, or "session" with all data and
  /// settings, but without the history. Every double reads back bit for bit. Error: `usage` for another format.
  std::string text(std::string_view format) const;
  /// Writes that text; an empty format follows from the extension .poff, .wpoff or .json. The file appears complete or
  /// not at all. Error: `usage`; `cannot_write`.
  void save(const std::string& path, std::string_view format = {}) const;

  // Data. Error of edits: `usage` for an id that is not alive or is named twice, and `bad_input` or `usage` for a
  // number out of range; see geometry.h.

  /// Replaces all data. All ids are new; the history records it as a step.
  void load(const Data& data);
  /// Copies all data, samples and balls in input order. O(n log n).
  Data data() const;
  /// Return the new ids, in the order of the arguments.
  std::vector<SampleId> insert(std::span<const Point> positions);
  std::vector<BallId> insert_balls(std::span<const Ball> balls);
  SampleId insert(Point position);
  BallId insert_ball(const Ball& ball);
  void move(std::span<const MovedSample> targets);
  void move(SampleId id, Point to);
  void change_balls(std::span<const ChangedBall> targets);
  void remove(std::span<const SampleId> ids);
  void remove(SampleId id);
  void remove_balls(std::span<const BallId> ids);
  void remove_ball(BallId id);
  /// Replaces the contours. Their points are indices of samples in input order. Error: `bad_input` for an index out of
  /// range.
  void set_contours(std::span<const Contour> contours);

  std::size_t sample_count() const;
  std::size_t ball_count() const;
  /// All ids in input order. O(n log n).
  std::vector<SampleId> sample_ids() const;
  std::vector<BallId> ball_ids() const;
  /// Nothing if the sample or ball is not alive.
  std::optional<Point> position(SampleId id) const;
  std::optional<Ball> ball(BallId id) const;

  // History. A step of undo is one edit, or all edits between `begin_step` and `end_step` (see `Step`).

  /// Error: `usage` inside another step.
  void begin_step(const std::string& name);
  /// Does nothing outside a step.
  void end_step() noexcept;
  /// Return false if there is nothing to undo or redo, or a step is open.
  bool undo();
  bool redo();
  bool can_undo() const;
  bool can_redo() const;
  /// Makes the current data the beginning of the history. Error: `usage` inside a step.
  void forget_history();

  // Settings. They take effect at the next run.

  /// Clamps a value beyond the range of a limit. Error: `usage` for an unknown parameter, any other value out of range,
  /// or a fraction for a parameter of whole numbers.
  void set(std::string_view parameter, double value);
  /// Error: `usage` for an unknown parameter.
  double value(std::string_view parameter) const;
  /// Error: `usage` for an unknown number type.
  void set_precision(std::string_view id);
  std::string precision() const;
  /// Resets all parameters and the number type to their defaults.
  void reset_settings();

  // Demand. Each call replaces the previous one. Nothing is computed without demand.

  /// Chooses the layers whose instances are computed. Error: `usage` for an unknown layer.
  void show(std::initializer_list<std::string_view> layers);
  void show(std::span<const std::string> layers);
  /// Chooses structures that are computed even if no shown layer reads them. Error: `usage` for an unknown structure.
  void need(std::initializer_list<std::string_view> structures);
  void need(std::span<const std::string> structures);
  /// Makes later runs collect counters and measures, some of which take O(n).
  void want_statistics(bool wanted = true);
  /// Makes later runs judge the one-step axis, too.
  void want_findings(bool wanted = true);

  // Computing.

  /// Brings all demanded results up to date. Error: `cannot_compute` with the first cause, `out_of_memory`,
  /// `cancelled`.
  void run();
  void run(Job& job);
  /// Prepares data that only the next edit needs, so that the edit takes less time; tables and instances stay valid.
  /// Optional, after a run. Ends early, without an error, when the job is stopped.
  void get_ready();
  void get_ready(Job& job);

  // Results of the last run. Error: `usage` for an unknown id or a result that was not requested, `cannot_compute` for
  // a failed one, `cancelled` after a run that was stopped.

  std::vector<Table> tables(std::string_view structure) const;
  /// The table with an id, as in "delaunay/faces".
  Table table(std::string_view id) const;
  /// The instances of one kind of a shown layer, none if the layer does not draw that kind.
  Instances instances(std::string_view layer, PrimitiveKind kind) const;
  /// 32 hexadecimal digits that depend on the drawn things, but not on ids, rows, the order of instances or the
  /// direction of edges. Equal to those of `mesecina compute --digest`.
  std::string digest(std::string_view layer) const;
  StatisticValue statistic(std::string_view structure, std::string_view key) const;
  /// The same for a statistic that is one number. Error: `usage` if it is not a number.
  double number(std::string_view structure, std::string_view key) const;
  /// One report for each structure of the catalogue, in its order; empty before the first run.
  std::vector<StructureReport> structure_reports() const;
  std::vector<LayerReport> layer_reports() const;
  std::vector<Finding> findings() const;
  Light light() const;

 private:
  struct Impl;
  Impl& impl();
  const Impl& impl() const;
  std::unique_ptr<Impl> impl_;
};

/// Makes all edits of a block one step of undo.
///
///     const mesecina::Step step(bench, "Straighten");
class Step {
 public:
  Step(Workbench& bench, const std::string& name) : bench_(bench) { bench_.begin_step(name); }
  ~Step() { bench_.end_step(); }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

 private:
  Workbench& bench_;
};

}  // namespace v1
}  // namespace mesecina
