// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench.h"

#include <pybind11/stl.h>

#include <type_traits>
#include <utility>

#include "interrupts.h"
#include "lock.h"
#include "module.h"

namespace mes_python {

/// Guards a call, so that calls do not overlap. The caller holds the interpreter lock at construction and destruction.
class Bench::Use {
 public:
  explicit Use(Bench& of) : of_(of) {
    if (std::exchange(of_.is_busy_, true))
      throw std::runtime_error("the session is at work already, in this thread or in another one");
  }
  ~Use() { of_.is_busy_ = false; }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  Bench& of_;
};

namespace {

/// True if neither data nor settings have changed.
bool is_refusal(const mesecina::Error& error) {
  using enum mesecina::ErrorCode;
  return error.code() == usage || error.code() == bad_input || error.code() == cancelled;
}

}  // namespace

Bench::Bench(const mesecina::Catalogue& catalogue, bool keeps_history)
    : state_(std::make_shared<State>(State{mesecina::Workbench(catalogue, {.keeps_history = keeps_history})})) {}

void Bench::mark_changed() {
  state_->is_changed = true;
  ++revision_;
}

template <class Work>
decltype(auto) Bench::change(Work work) {
  const Use use(*this);
  struct Mark {
    Bench& of;
    bool is_refused = false;
    ~Mark() {
      if (!is_refused) of.mark_changed();
    }
  } mark{*this};
  try {
    if constexpr (std::is_same_v<decltype(work(state_->bench)), bool>) {
      mark.is_refused = true;
      mark.is_refused = !work(state_->bench);
      return !mark.is_refused;
    } else {
      return work(state_->bench);
    }
  } catch (const mesecina::Error& error) {
    mark.is_refused = is_refusal(error);
    throw;
  }
}

template <class Work>
auto Bench::without_lock(Work work) {
  const Unlocked unlocked;
  return work(state_->bench);
}

template <class Work>
auto Bench::interruptible(Work work) {
  mesecina::Job job;
  const StopsAtInterrupt stops(job);
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  try {
    const Unlocked unlocked;
    return work(state_->bench, job);
  } catch (const mesecina::Error& error) {
    // Python raises the exception of its handler. The job is stopped even if that handler raises none.
    if (error.code() == mesecina::ErrorCode::cancelled && PyErr_CheckSignals() != 0) throw py::error_already_set();
    throw;
  }
}

py::dict opened(const mesecina::OpenedFile& file) {
  py::dict out;
  out["format"] = file.format;
  for (const auto& [key, lines] : {std::pair("warnings", &file.warnings), std::pair("files", &file.files)}) {
    py::list texts;
    for (const std::string& line : *lines) texts.append(text_of(line));
    out[key] = texts;
  }
  return out;
}

py::dict Bench::open(const std::string& path, const mesecina::ReadOptions& options) {
  const Use use(*this);
  mark_changed();
  return opened(interruptible([&](auto& bench, auto& job) { return bench.open(path, options, job); }));
}

py::dict Bench::open_bytes(const py::bytes& bytes, const std::string& name, const mesecina::ReadOptions& options) {
  const Use use(*this);
  mark_changed();
  const auto view = static_cast<std::string_view>(bytes);
  return opened(interruptible([&](auto& bench, auto& job) { return bench.open_bytes(view, name, options, job); }));
}

py::bytes Bench::text(const std::string& format) {
  const Use use(*this);
  return py::bytes(without_lock([&](const auto& bench) { return bench.text(format); }));
}

void Bench::save(const std::string& path, const std::string& format) {
  const Use use(*this);
  without_lock([&](const auto& bench) { bench.save(path, format); });
}

void Bench::load(const Doubles& samples, const std::vector<std::pair<bool, Numbers>>& contours,
                 const Doubles& balls) {
  const auto points = points_of(samples);
  const auto disks = balls_of(balls);
  const mesecina::Data data{.samples = {points.begin(), points.end()},
                            .contours = contours_of(contours),
                            .balls = {disks.begin(), disks.end()}};
  const Use use(*this);
  mark_changed();
  without_lock([&](auto& bench) { bench.load(data); });
}

py::tuple Bench::data() {
  const Use use(*this);
  return arrays_of(without_lock([](const auto& bench) { return bench.data(); }));
}

// An empty edit changes nothing, so arrays stay valid.
Numbers Bench::insert(const Doubles& points) {
  if (points.size() == 0) return Numbers(0);
  return change([&](auto& bench) { return array_of_ids(bench.insert(points_of(points))); });
}

Numbers Bench::insert_balls(const Doubles& balls) {
  if (balls.size() == 0) return Numbers(0);
  return change([&](auto& bench) { return array_of_ids(bench.insert_balls(balls_of(balls))); });
}

void Bench::move(const Numbers& ids, const Doubles& targets) {
  const auto samples = ids_of<mesecina::SampleId>(ids);
  const auto places = points_of(targets);
  if (samples.size() != places.size()) throw py::value_error("there are as many positions as ids");
  if (samples.empty()) return;
  std::vector<mesecina::MovedSample> moved;
  moved.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) moved.push_back({samples[i], places[i]});
  change([&](auto& bench) { bench.move(moved); });
}

void Bench::move_one(std::uint32_t id, double x, double y) {
  change([&](auto& bench) { bench.move(mesecina::SampleId{id}, mesecina::Point{x, y}); });
}

void Bench::change_balls(const Numbers& ids, const Doubles& balls) {
  const auto named = ids_of<mesecina::BallId>(ids);
  const auto targets = balls_of(balls);
  if (named.size() != targets.size()) throw py::value_error("there are as many balls as ids");
  if (named.empty()) return;
  std::vector<mesecina::ChangedBall> changed;
  changed.reserve(named.size());
  for (std::size_t i = 0; i < named.size(); ++i) changed.push_back({named[i], targets[i]});
  change([&](auto& bench) { bench.change_balls(changed); });
}

void Bench::remove(const Numbers& ids) {
  if (ids.size() == 0) return;
  change([&](auto& bench) { bench.remove(ids_of<mesecina::SampleId>(ids)); });
}

void Bench::remove_balls(const Numbers& ids) {
  if (ids.size() == 0) return;
  change([&](auto& bench) { bench.remove_balls(ids_of<mesecina::BallId>(ids)); });
}

void Bench::set_contours(const std::vector<std::pair<bool, Numbers>>& contours) {
  change([&](auto& bench) { bench.set_contours(contours_of(contours)); });
}

Doubles Bench::samples() {
  const Use use(*this);
  std::vector<mesecina::Point> out;
  for (const mesecina::SampleId id : state_->bench.sample_ids()) out.push_back(*state_->bench.position(id));
  return array_of(std::span<const mesecina::Point>(out));
}

Numbers Bench::sample_ids() {
  const Use use(*this);
  return array_of_ids(state_->bench.sample_ids());
}

Doubles Bench::balls() {
  const Use use(*this);
  std::vector<mesecina::Ball> out;
  for (const mesecina::BallId id : state_->bench.ball_ids()) out.push_back(*state_->bench.ball(id));
  return array_of(std::span<const mesecina::Ball>(out));
}

Numbers Bench::ball_ids() {
  const Use use(*this);
  return array_of_ids(state_->bench.ball_ids());
}

void Bench::begin_step(const std::string& name) {
  const Use use(*this);
  state_->bench.begin_step(name);
}

void Bench::end_step() {
  const Use use(*this);
  state_->bench.end_step();
}

bool Bench::undo() {
  return change([](auto& bench) { return bench.undo(); });
}

bool Bench::redo() {
  return change([](auto& bench) { return bench.redo(); });
}

void Bench::forget_history() {
  const Use use(*this);
  state_->bench.forget_history();
}

bool Bench::can_undo() {
  const Use use(*this);
  return state_->bench.can_undo();
}

bool Bench::can_redo() {
  const Use use(*this);
  return state_->bench.can_redo();
}

void Bench::set(const std::string& parameter, double value) {
  change([&](auto& bench) { bench.set(parameter, value); });
}

double Bench::value(const std::string& parameter) {
  const Use use(*this);
  return state_->bench.value(parameter);
}

void Bench::set_precision(const std::string& id) {
  change([&](auto& bench) { bench.set_precision(id); });
}

std::string Bench::precision() {
  const Use use(*this);
  return state_->bench.precision();
}

void Bench::reset_settings() {
  change([](auto& bench) { bench.reset_settings(); });
}

void Bench::bring_up_to_date() {
  if (!state_->is_changed && !has_more_demand_) return;
  if (state_->is_changed && views() > 0) {
    const std::string text =
        std::to_string(views()) + (views() == 1 ? " array shows" : " arrays show") +
        " tables of this session as they were before it was changed. Delete them, or keep "
        "copies (array.copy()), before the session is read again; a notebook keeps what it displays.";
    throw py::buffer_error(text);
  }
  // A stopped run does not reset `is_changed`. A run without changes outdates no array.
  try {
    interruptible([](auto& bench, auto& job) { bench.run(job); });
  } catch (const mesecina::Error& error) {
    // Everything independent of the failed structures is up to date. A reader of the failed ones gets the error.
    if (error.code() != mesecina::ErrorCode::cannot_compute) throw;
  }
  state_->is_changed = false;
  has_more_demand_ = false;
}

void Bench::run() {
  const Use use(*this);
  bring_up_to_date();
}

void Bench::need(std::string_view structure) {
  if (!structures_.contains(structure)) {
    std::vector<std::string> all(structures_.begin(), structures_.end());
    all.emplace_back(structure);
    state_->bench.need(all);
    structures_.emplace(structure);
    has_more_demand_ = true;
  }
  bring_up_to_date();
}

void Bench::show(std::string_view layer) {
  if (!layers_.contains(layer)) {
    std::vector<std::string> all(layers_.begin(), layers_.end());
    all.emplace_back(layer);
    state_->bench.show(all);
    layers_.emplace(layer);
    has_more_demand_ = true;
  }
  bring_up_to_date();
}

mesecina::Table Bench::table(const std::string& id) {
  need(std::string_view(id).substr(0, id.find('/')));
  return state_->bench.table(id);
}

py::array Bench::column(const std::string& table_id, const std::string& name) {
  const Use use(*this);
  const mesecina::Column column = table(table_id).column(name);
  const mesecina::ColumnInfo& info = column.info();
  if (!info.is_stored) return copy_of(column);
  return view_of(column.data(), info.type, column.rows(), info.width, column.stride(), state_);
}

Numbers Bench::live_rows(const std::string& id) {
  const Use use(*this);
  return array_of(std::span<const std::uint32_t>(table(id).live_rows()));
}

std::size_t Bench::rows(const std::string& id) {
  const Use use(*this);
  return table(id).rows();
}

std::optional<py::tuple> Bench::changes(const std::string& id) {
  const Use use(*this);
  const auto changes = table(id).changes();
  if (!changes) return {};
  return py::make_tuple(array_of(changes->touched), array_of(changes->removed));
}

py::dict Bench::statistics(const std::string& structure) {
  const Use use(*this);
  // Some statistics take O(n), so runs after edits do not collect them.
  state_->bench.want_statistics();
  has_more_demand_ = true;
  try {
    need(structure);
  } catch (...) {
    state_->bench.want_statistics(false);
    throw;
  }
  state_->bench.want_statistics(false);
  py::dict out;
  for (const mesecina::StructureReport& report : state_->bench.structure_reports()) {
    if (report.id != structure) continue;
    if (report.state == mesecina::State::failed || report.state == mesecina::State::blocked)
      (void)state_->bench.tables(structure);  // throws the error
    for (const mesecina::Statistic& statistic : report.statistics) out[py::str(statistic.key)] = statistic.value;
  }
  return out;
}

py::array Bench::instances(const std::string& layer, mesecina::PrimitiveKind kind) {
  const Use use(*this);
  show(layer);
  const mesecina::Instances found = state_->bench.instances(layer, kind);
  const std::size_t stride = mesecina::stride_of(kind);
  return view_of(found.values.data(), mesecina::ColumnType::float64, found.size(), stride, stride * sizeof(double),
                 state_);
}

std::string Bench::digest(const std::string& layer) {
  const Use use(*this);
  show(layer);
  return without_lock([&](const auto& bench) { return bench.digest(layer); });
}

std::vector<mesecina::StructureReport> Bench::reports() {
  const Use use(*this);
  bring_up_to_date();
  return state_->bench.structure_reports();
}

std::vector<mesecina::Finding> Bench::findings() {
  const Use use(*this);
  if (!std::exchange(wants_findings_, true)) {
    state_->bench.want_findings();
    has_more_demand_ = true;
  }
  bring_up_to_date();
  return state_->bench.findings();
}

mesecina::Light Bench::light() {
  (void)findings();
  const Use use(*this);
  return state_->bench.light();
}

}  // namespace mes_python
