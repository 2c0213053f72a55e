// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds a fuzz target: with given inputs, or with changed ones, of which those are kept that reach something new.
//
// Of the classic design of AFL: edge coverage in orders of magnitude, stacked random changes, a corpus that grows.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/driver/corpus.h"
#include "tests/fuzz/driver/coverage.h"
#include "tests/fuzz/driver/mutation.h"
#include "tests/fuzz/driver/watched_run.h"

using namespace mes::fuzz;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kUsage = R"(usage: fuzzer TARGET replay PATH...
       fuzzer TARGET fuzz FOLDER [--from PATH] [--seconds N] [--runs N] [--seed N] [--longest N]
                                 [--words FILE] [--findings FOLDER] [--most-findings N]
       fuzzer TARGET distil FOLDER PATH... [--least-new N]
       fuzzer TARGET shrink FILE
       fuzzer list

replay   runs the files, and those in the folders, once each.
fuzz     runs changed inputs of FOLDER and PATH; puts those that reach something new into FOLDER, and those that end
         the process into the folder of findings. Ends after 60 seconds, after so many runs if they are given, or at
         the first finding.
distil   copies inputs to FOLDER, short ones rather than long ones, each of which takes N edges, or
         one, that those before it do not take.
shrink   leaves out what an input can do without and still end the process; writes the rest beside it.
list     prints the names of the targets.
The exit code is 1 when an input ended the process, 2 for wrong usage.
)";

using Options = std::map<std::string, std::string, std::less<>>;

/// What stands on the command line.
struct Request {
  const Target& target;
  std::vector<fs::path> places;
  Options options;

  std::string text(std::string_view option, std::string_view otherwise = {}) const {
    const auto found = options.find(option);
    return found == options.end() ? std::string(otherwise) : found->second;
  }
  std::uint64_t number(std::string_view option, std::uint64_t otherwise) const {
    const auto found = options.find(option);
    if (found == options.end()) return otherwise;
    std::uint64_t out = 0;
    const char* const end = found->second.data() + found->second.size();
    if (std::from_chars(found->second.data(), end, out).ptr == end) return out;
    std::fprintf(stderr, "--%s takes a whole number\n", found->first.c_str());
    std::exit(2);
  }
};

std::optional<Request> read_request(const Target& target, int count, char** words) {
  constexpr std::string_view kOptions[] = {"from",  "seconds",  "runs",          "seed",     "longest",
                                           "words", "findings", "most-findings", "least-new"};
  Request out{.target = target, .places = {}, .options = {}};
  for (int i = 3; i < count; ++i) {
    const std::string_view word = words[i];
    if (!word.starts_with("--")) {
      out.places.emplace_back(word);
    } else if (i + 1 < count && std::ranges::count(kOptions, word.substr(2)) != 0) {
      out.options[std::string(word.substr(2))] = words[++i];
    } else {
      return std::nullopt;
    }
  }
  return out;
}

/// Says what an input did. Returns the exit code.
int tell_end(const WatchedRun& watched, const std::string& reason) {
  std::fprintf(stderr, "%s ended the process: %s\n", watched.name().c_str(), reason.c_str());
  return 1;
}

int replay(const Request& request) {
  WatchedRun watched(request.target);
  const std::vector<Input> inputs = read_inputs(request.places);
  if (inputs.empty()) {
    std::fprintf(stderr, "there are no inputs\n");
    return 1;
  }
  const std::string reason = watched.watch([&] {
    for (const Input& input : inputs) watched.run(input.bytes, input.name);
  });
  if (!reason.empty()) return tell_end(watched, reason);
  std::printf("%zu inputs\n", inputs.size());
  return 0;
}

class Fuzzing {
 public:
  Fuzzing(const Request& request, WatchedRun& watched)
      : request_(request),
        watched_(watched),
        deadline_(std::chrono::steady_clock::now() + std::chrono::seconds(request.number("seconds", 60))),
        most_runs_(request.number("runs", 0)) {}

  bool is_over() const {
    return (most_runs_ != 0 && watched_.report().runs >= most_runs_) || std::chrono::steady_clock::now() >= deadline_;
  }

  /// Runs changed inputs until the end.
  void work(std::uint64_t seed) {
    Mutator mutator(seed, std::min(request_.number("longest", 4096), std::uint64_t{kLongestInput}));
    if (const std::string words = request_.text("words"); !words.empty() && !mutator.read_dictionary(words)) {
      std::fprintf(stderr, "%s is not a dictionary\n", words.c_str());
      std::exit(2);
    }
    read_corpus();
    while (!is_over()) {
      const std::string& chosen = corpus_[mutator.pick(corpus_.size())];
      const std::string input = mutator.changed(chosen, corpus_[mutator.pick(corpus_.size())]);
      if (!runs_somewhere_new(input, "a changed input")) continue;
      keep_input(request_.places[0], {}, input);
      corpus_.push_back(input);
      watched_.report().inputs = corpus_.size();
    }
  }

 private:
  void read_corpus() {
    std::vector<fs::path> places{request_.places[0]};
    if (const std::string from = request_.text("from"); !from.empty()) places.emplace_back(from);
    for (const Input& input : read_inputs(places))
      if (runs_somewhere_new(input.bytes, input.name) || blocks_entered() == 0) corpus_.push_back(input.bytes);
    if (corpus_.empty()) corpus_.emplace_back();
    watched_.report().inputs = corpus_.size();
  }

  bool runs_somewhere_new(std::string_view input, std::string_view name) {
    watched_.run(input, name);
    const bool is_new = reached_.add_run() != 0;
    if (is_new) watched_.report().edges = reached_.edges();
    return is_dearer(input.size()) || is_new;
  }

  // An input that takes more work for its bytes than any before is worth changing further.
  bool is_dearer(std::size_t bytes) {
    constexpr double kMore = 1.125;
    constexpr std::size_t kFewBytes = 64;
    double& dearest = watched_.report().dearest;
    const double work = static_cast<double>(blocks_entered()) / static_cast<double>(bytes + kFewBytes);
    if (work <= kMore * dearest) return false;
    dearest = work;
    return true;
  }

  const Request& request_;
  WatchedRun& watched_;
  std::chrono::steady_clock::time_point deadline_;
  std::uint64_t most_runs_;
  Reached reached_;
  std::vector<std::string> corpus_;
};

int fuzz(const Request& request) {
  const std::string program(request.target.name);
  WatchedRun watched(request.target);
  const fs::path findings = request.text("findings", "findings");
  const std::uint64_t most = request.number("most-findings", 1);
  const Fuzzing fuzzing(request, watched);
  std::uint64_t found = 0;
  for (std::uint64_t seed = request.number("seed", 1); found < most && !fuzzing.is_over(); ++seed) {
    const std::string reason = watched.watch([&] { Fuzzing(fuzzing).work(seed); });
    if (reason.empty()) break;
    if (reason == "exit code 2") return 2;
    ++found;
    tell_end(watched, reason);
    std::fprintf(stderr, "%s: a finding, %s\n", program.c_str(),
                 keep_input(findings, program + '-', watched.input()).c_str());
  }
  const Report& report = watched.report();
  std::printf("%s: %llu runs, %llu inputs reach %llu edges, at most %.0f blocks a byte, %llu findings\n",
              program.c_str(), static_cast<unsigned long long>(report.runs),
              static_cast<unsigned long long>(report.inputs), static_cast<unsigned long long>(report.edges),
              report.dearest, static_cast<unsigned long long>(found));
  if (report.edges == 0) std::printf("%s: this build counts no edges, so nothing is kept\n", program.c_str());
  return found == 0 ? 0 : 1;
}

int distil(Request request) {
  const fs::path to = request.places.front();
  request.places.erase(request.places.begin());
  std::vector<Input> inputs = read_inputs(request.places);
  std::ranges::stable_sort(inputs, {}, [](const Input& input) { return input.bytes.size(); });
  const std::uint64_t least = request.number("least-new", 1);
  WatchedRun watched(request.target);
  const std::string reason = watched.watch([&] {
    Reached reached;
    for (const Input& input : inputs) {
      const std::size_t before = reached.edges();
      watched.run(input.bytes, input.name);
      reached.add_run();
      if (reached.edges() < before + least) continue;
      keep_input(to, {}, input.bytes);
      ++watched.report().inputs;
    }
  });
  if (!reason.empty()) return tell_end(watched, reason);
  std::printf("%llu of %zu inputs\n", static_cast<unsigned long long>(watched.report().inputs), inputs.size());
  return 0;
}

int shrink(const Request& request) {
  std::vector<Input> inputs = read_inputs(request.places);
  if (inputs.size() != 1) return 2;
  WatchedRun watched(request.target);
  const auto ends_process = [&](const std::string& bytes) {
    return !watched.watch([&] { watched.run(bytes, "a shorter input"); }, true).empty();
  };
  std::string& bytes = inputs.front().bytes;
  if (!ends_process(bytes)) {
    std::printf("%s does not end the process\n", inputs.front().name.c_str());
    return 0;
  }
  for (std::size_t part = std::max(bytes.size() / 2, std::size_t{1}); part > 0; part /= 2)
    for (std::size_t at = 0; at < bytes.size();) {
      std::string shorter = bytes;
      shorter.erase(at, part);
      if (ends_process(shorter))
        bytes = std::move(shorter);
      else
        at += part;
    }
  const fs::path file = keep_input(fs::path(inputs.front().name).parent_path(), "small-", bytes);
  std::printf("%s: %zu bytes\n", file.c_str(), bytes.size());
  return 1;
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && std::string_view(words[1]) == "list") {
    for (const Target& target : kTargets) std::printf("%s\n", std::string(target.name).c_str());
    return 0;
  }
  const auto* const target = std::ranges::find(kTargets, std::string_view(count > 1 ? words[1] : ""), &Target::name);
  if (target != kTargets.end()) {
    const auto request = read_request(*target, count, words);
    const std::string_view command = count > 2 ? words[2] : "";
    if (request && !request->places.empty()) {
      if (command == "replay") return replay(*request);
      if (command == "fuzz") return fuzz(*request);
      if (command == "distil") return distil(*request);
      if (command == "shrink") return shrink(*request);
    }
  }
  std::fputs(kUsage.data(), stderr);
  return 2;
}
