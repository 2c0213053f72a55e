// SPDX-License-Identifier: GPL-3.0-or-later
// A workbench for Python: arrays over its memory, interrupts, and one thread at a time.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <mesecina/mesecina.h>

#include "arrays.h"

namespace mes_python {

/// Keeps a workbench, brings it up to date when results are read, and guards the arrays that show its memory.
///
/// Guarantees:
///  1. An array over a table or over instances keeps its values while it lives, also after the session: while such
///     arrays live, a run that could move memory throws `BufferError` and changes nothing. Edits and settings take
///     effect at the next reading, so live arrays never block them.
///  2. Reading more results never invalidates an array.
///  3. A call while another thread is in one throws `RuntimeError`.
///
/// Threads: calls hold the interpreter lock, and release it while they read, compute or write.
class Bench {
 public:
  Bench(const mesecina::Catalogue& catalogue, bool keeps_history);

  py::dict open(const std::string& path, const mesecina::ReadOptions& options);
  py::dict open_bytes(const py::bytes& bytes, const std::string& name, const mesecina::ReadOptions& options);
  py::bytes text(const std::string& format);
  void save(const std::string& path, const std::string& format);

  void load(const Doubles& samples, const std::vector<std::pair<bool, Numbers>>& contours, const Doubles& balls);
  py::tuple data();
  Numbers insert(const Doubles& points);
  Numbers insert_balls(const Doubles& balls);
  void move(const Numbers& ids, const Doubles& targets);
  void move_one(std::uint32_t id, double x, double y);
  void change_balls(const Numbers& ids, const Doubles& balls);
  void remove(const Numbers& ids);
  void remove_balls(const Numbers& ids);
  void set_contours(const std::vector<std::pair<bool, Numbers>>& contours);
  Doubles samples();
  Numbers sample_ids();
  Doubles balls();
  Numbers ball_ids();

  void begin_step(const std::string& name);
  void end_step();
  bool undo();
  bool redo();
  void forget_history();
  /// The number of changes of data and settings so far.
  std::uint64_t revision() const { return revision_; }
  bool can_undo();
  bool can_redo();

  void set(const std::string& parameter, double value);
  double value(const std::string& parameter);
  void set_precision(const std::string& id);
  std::string precision();
  void reset_settings();

  /// Brings all results read so far up to date.
  void run();
  /// Tables are named by id, as in "delaunay/faces".
  py::array column(const std::string& table, const std::string& column);
  Numbers live_rows(const std::string& table);
  std::size_t rows(const std::string& table);
  /// Two arrays of row numbers, touched and removed ones. No value if any row may differ.
  std::optional<py::tuple> changes(const std::string& table);
  py::dict statistics(const std::string& structure);
  py::array instances(const std::string& layer, mesecina::PrimitiveKind kind);
  std::string digest(const std::string& layer);
  std::vector<mesecina::StructureReport> reports();
  std::vector<mesecina::Finding> findings();
  mesecina::Light light();
  /// The number of live arrays over its memory.
  long views() const { return state_.use_count() - 1; }

 private:
  /// The part that arrays keep alive.
  struct State {
    mesecina::Workbench bench;
    bool is_changed = true;  ///< there was an edit or a setting since the last run that was not stopped
  };
  class Use;

  // Calls `work`, which changes data or settings.
  template <class Work>
  decltype(auto) change(Work work);
  void mark_changed();
  // Calls `work` without the interpreter lock.
  template <class Work>
  auto without_lock(Work work);
  template <class Work>
  auto interruptible(Work work);  // does the same, and Ctrl-C stops it
  void bring_up_to_date();
  void need(std::string_view structure);
  void show(std::string_view layer);
  mesecina::Table table(const std::string& id);

  std::shared_ptr<State> state_;
  bool is_busy_ = false;
  std::uint64_t revision_ = 0;
  std::set<std::string, std::less<>> structures_;  ///< ids of needed structures
  std::set<std::string, std::less<>> layers_;      ///< ids of shown layers
  bool wants_findings_ = false;
  bool has_more_demand_ = true;  ///< more results are needed than at the last run
};

}  // namespace mes_python
