// SPDX-License-Identifier: GPL-3.0-or-later
// Files, data, history and settings of a workbench.
#include <mesecina/workbench.h>

#include <array>
#include <filesystem>
#include <utility>

#include "core/io/files/atomic_file.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
#include "core/library/internal/bench.h"

namespace mesecina {
inline namespace v1 {
namespace {

mes::ReadRequest inner(const ReadOptions& options) {
  mes::ReadRequest out;
  out.degrees = options.projects_degrees ? mes::MapDegrees::projected : mes::MapDegrees::kept;
  out.keeps_vertices = options.keeps_vertices;
  out.system = options.system;
  return out;
}

OpenedFile outer(const mes::LoadedFile& file) {
  OpenedFile out{.format = file.format, .warnings = file.warnings};
  for (const mes::SourceFile& source : file.sources) out.files.push_back(source.path.string());
  return out;
}

std::string session_of(const mes::Workbench& bench) {
  mes::Session session;
  session.data = std::make_shared<const mes::SampleData>(mes::data_of(bench.document()));
  session.settings = bench.settings();
  return mes::write_session(session);
}

std::string_view format_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".poff") return "poff";
  if (extension == ".wpoff") return "wpoff";
  if (extension == ".json") return "session";
  refuse("the name of a file that is saved without a format ends in .poff, .wpoff or .json");
}

}  // namespace

Workbench::Workbench() : Workbench(Catalogue::builtin()) {}

Workbench::Workbench(const Catalogue& catalogue, const WorkbenchOptions& options)
    : impl_(guarded([&] { return std::make_unique<Impl>(catalogue, options); })) {}

Workbench::~Workbench() = default;
Workbench::Workbench(Workbench&&) noexcept = default;
Workbench& Workbench::operator=(Workbench&&) noexcept = default;

Workbench::Impl& Workbench::impl() {
  if (!impl_) refuse("the workbench was moved from");
  return *impl_;
}

const Workbench::Impl& Workbench::impl() const {
  if (!impl_) refuse("the workbench was moved from");
  return *impl_;
}

const Catalogue& Workbench::catalogue() const {
  return impl().catalogue;
}

OpenedFile Workbench::open(const std::string& path, const ReadOptions& options) {
  Job job;
  return open(path, options, job);
}

OpenedFile Workbench::open(const std::string& path, const ReadOptions& options, Job& job) {
  mes::Workbench& bench = impl().bench;
  return guarded([&] {
    JobAccess::control(job).checkpoint();
    return outer(taken(bench.open(path, JobAccess::control(job), inner(options), options.format)));
  });
}

OpenedFile Workbench::open_bytes(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  Job job;
  return open_bytes(bytes, name, options, job);
}

OpenedFile Workbench::open_bytes(std::string_view bytes, const std::string& name, const ReadOptions& options,
                                 Job& job) {
  mes::Workbench& bench = impl().bench;
  return guarded([&] {
    JobAccess::control(job).checkpoint();
    return outer(taken(bench.open_bytes(bytes, name, JobAccess::control(job), inner(options), options.format)));
  });
}

std::string Workbench::text(std::string_view format) const {
  const mes::Workbench& bench = impl().bench;
  return guarded([&] {
    if (format == "poff") return mes::write_poff(bench.document());
    if (format == "wpoff") return mes::write_wpoff(bench.document());
    if (format == "session") return session_of(bench);
    refuse_unknown("format to save in", format);
  });
}

void Workbench::save(const std::string& path, std::string_view format) const {
  guarded([&] { taken(mes::write_file_atomically(path, text(format.empty() ? format_of(path) : format))); });
}

void Workbench::load(const Data& data) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { taken(bench.load(v1::inner(data))); });
}

Data Workbench::data() const {
  const mes::Workbench& bench = impl().bench;
  return guarded([&] { return v1::outer(mes::data_of(bench.document())); });
}

std::vector<SampleId> Workbench::insert(std::span<const Point> positions) {
  mes::Workbench& bench = impl().bench;
  return guarded([&] { return all_outer(taken(bench.insert(all_inner(positions)))); });
}

std::vector<BallId> Workbench::insert_balls(std::span<const Ball> balls) {
  mes::Workbench& bench = impl().bench;
  return guarded([&] { return all_outer(taken(bench.insert_balls(all_inner(balls)))); });
}

SampleId Workbench::insert(Point position) {
  return insert(std::span(&position, 1)).front();
}

BallId Workbench::insert_ball(const Ball& ball) {
  return insert_balls(std::span(&ball, 1)).front();
}

void Workbench::move(std::span<const MovedSample> targets) {
  mes::Workbench& bench = impl().bench;
  guarded([&] {
    std::vector<std::pair<mes::SampleId, mes::Vec2>> moves;
    moves.reserve(targets.size());
    for (const MovedSample& target : targets) moves.emplace_back(v1::inner(target.id), v1::inner(target.to));
    taken(bench.move(moves));
  });
}

void Workbench::move(SampleId id, Point to) {
  move(std::array{MovedSample{id, to}});
}

void Workbench::change_balls(std::span<const ChangedBall> targets) {
  mes::Workbench& bench = impl().bench;
  guarded([&] {
    std::vector<std::pair<mes::BallId, mes::Disk>> changes;
    changes.reserve(targets.size());
    for (const ChangedBall& target : targets) changes.emplace_back(v1::inner(target.id), v1::inner(target.to));
    taken(bench.change_balls(changes));
  });
}

void Workbench::remove(std::span<const SampleId> ids) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { taken(bench.remove(all_inner(ids))); });
}

void Workbench::remove(SampleId id) {
  remove(std::span(&id, 1));
}

void Workbench::remove_ball(BallId id) {
  remove_balls(std::span(&id, 1));
}

void Workbench::remove_balls(std::span<const BallId> ids) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { taken(bench.remove_balls(all_inner(ids))); });
}

void Workbench::set_contours(std::span<const Contour> contours) {
  mes::Workbench& bench = impl().bench;
  guarded([&] {
    std::vector<mes::SampleData::Contour> all;
    for (const Contour& contour : contours) all.push_back({contour.is_closed, contour.points});
    taken(bench.set_contours(all));
  });
}

std::size_t Workbench::sample_count() const {
  return impl().bench.document().sample_count();
}

std::size_t Workbench::ball_count() const {
  return impl().bench.document().ball_count();
}

std::vector<SampleId> Workbench::sample_ids() const {
  const mes::Document& document = impl().bench.document();
  return guarded([&] {
    std::vector<SampleId> out;
    for (const mes::SampleSlot slot : document.slots_in_input_order()) out.push_back(v1::outer(document.id(slot)));
    return out;
  });
}

std::vector<BallId> Workbench::ball_ids() const {
  const mes::Document& document = impl().bench.document();
  return guarded([&] {
    std::vector<BallId> out;
    for (const mes::BallSlot slot : document.ball_slots_in_input_order())
      out.push_back(v1::outer(document.ball_id(slot)));
    return out;
  });
}

std::optional<Point> Workbench::position(SampleId id) const {
  const mes::Document& document = impl().bench.document();
  const mes::SampleSlot slot = document.slot_of(v1::inner(id));
  if (slot == mes::kNoSlot) return {};
  return v1::outer(document.position(slot));
}

std::optional<Ball> Workbench::ball(BallId id) const {
  const mes::Document& document = impl().bench.document();
  const mes::BallSlot slot = document.ball_slot_of(v1::inner(id));
  if (slot == mes::kNoSlot) return {};
  return v1::outer(document.disk(slot));
}

void Workbench::begin_step(const std::string& name) {
  mes::Workbench& bench = impl().bench;
  if (bench.history().in_gesture()) refuse("steps do not nest");
  guarded([&] { bench.begin_step(name); });
}

void Workbench::end_step() noexcept {
  if (impl_ && impl_->bench.history().in_gesture()) impl_->bench.end_step();
}

void Workbench::forget_history() {
  mes::Workbench& bench = impl().bench;
  if (bench.history().in_gesture()) refuse("a step is open");
  bench.forget_history();
}

bool Workbench::undo() {
  mes::Workbench& bench = impl().bench;
  return guarded([&] { return bench.history().can_undo() && bench.undo(); });
}

bool Workbench::redo() {
  mes::Workbench& bench = impl().bench;
  return guarded([&] { return bench.history().can_redo() && bench.redo(); });
}

bool Workbench::can_undo() const {
  return impl().bench.history().can_undo();
}

bool Workbench::can_redo() const {
  return impl().bench.history().can_redo();
}

void Workbench::set(std::string_view parameter, double value) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { taken(bench.set(parameter, value)); });
}

double Workbench::value(std::string_view parameter) const {
  const mes::Parameter* const known = impl().registry().find_parameter(parameter);
  if (known == nullptr) refuse_unknown("parameter", parameter);
  return guarded([&] { return impl().bench.settings()[*known]; });
}

void Workbench::set_precision(std::string_view id) {
  mes::Workbench& bench = impl().bench;
  guarded([&] { taken(bench.set_precision(id)); });
}

std::string Workbench::precision() const {
  return std::string(mes::id_of(impl().bench.settings().precision));
}

void Workbench::reset_settings() {
  mes::Workbench& bench = impl().bench;
  guarded([&] { bench.choose({}); });
}

}  // namespace v1
}  // namespace mesecina
