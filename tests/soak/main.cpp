// SPDX-License-Identifier: GPL-3.0-or-later
// Random edits without end: lives of documents, each of a few hundred edits of all kinds, whose pictures are compared
// with fresh computations all along.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/io/text/text_numbers.h"
#include "tests/soak/life.h"
#include "tests/soak/replay.h"

namespace {

using namespace mes;
using namespace mes::test;

constexpr std::uint64_t kEditsOfLife = 300;
constexpr std::uint64_t kEditsBetweenChecks = 20;
constexpr std::uint64_t kEditsBetweenNews = 30'000;
constexpr int kMostFindings = 10;
constexpr int kTriesToShorten = 400;

struct Request {
  std::uint64_t edits = 100'000;
  std::uint64_t first_seed = 1;
  std::uint64_t between = kEditsBetweenChecks;
  std::string folder = ".";
};

int usage() {
  std::fprintf(stderr,
               "soak [EDITS] [--seed FIRST] [--every N] [--folder DIR]\n"
               "  EDITS   in all, 100000 unless given; a life of one seed has %llu\n"
               "  FIRST   seed of the first life\n"
               "  N       edits between two comparisons with a fresh computation\n"
               "  DIR     where sessions of findings are written\n",
               static_cast<unsigned long long>(kEditsOfLife));
  return 2;
}

bool understand(int count, char** words, Request& request) {
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--folder" && i + 1 < count) {
      request.folder = words[++i];
      continue;
    }
    std::uint64_t* target = &request.edits;
    if (word == "--seed" || word == "--every") {
      if (++i == count) return false;
      target = word == "--seed" ? &request.first_seed : &request.between;
    }
    const auto number = parse_count(words[i]);
    if (!number || *number == 0) return false;
    *target = *number;
  }
  return true;
}

/// Lives until there is trouble or the edits are used up; says what the trouble is.
std::string live(Life& life, std::uint64_t edits, std::uint64_t between, std::uint64_t& done) {
  try {
    for (std::uint64_t i = 1; i <= edits; ++i) {
      life.step();
      ++done;
      if (i % between != 0 && i != edits) continue;
      if (std::string trouble = life.check(); !trouble.empty()) return trouble;
    }
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

void report(const Life& life, std::uint64_t seed, std::uint64_t edit, const std::string& trouble,
            const std::string& folder) {
  const Session session = shortened(life.session(), kTriesToShorten);
  const std::string file = folder + "/soak-" + std::to_string(seed) + ".json";
  std::ofstream(file) << write_session(session);
  const std::string replayed = trouble_of(session);
  std::printf("soak: finding: seed %llu, edit %llu: %s\n  %s, %zu entries: %s\n",
              static_cast<unsigned long long>(seed), static_cast<unsigned long long>(edit), trouble.c_str(),
              file.c_str(), session.entries.size(),
              replayed.empty() ? "shows nothing when replayed; stopped runs matter" : replayed.c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  Request request;
  if (!understand(count, words, request)) return usage();
  const auto start = std::chrono::steady_clock::now();
  std::uint64_t done = 0;
  std::uint64_t seed = request.first_seed;
  int findings = 0;
  for (; done < request.edits && findings < kMostFindings; ++seed) {
    const std::uint64_t before = done;
    Life life(seed);
    const std::string trouble = live(life, std::min(kEditsOfLife, request.edits - done), request.between, done);
    if (done / kEditsBetweenNews != before / kEditsBetweenNews)
      std::fprintf(stderr, "soak: %llu edits, %d findings\n", static_cast<unsigned long long>(done), findings);
    if (trouble.empty()) continue;
    ++findings;
    report(life, seed, done - before, trouble, request.folder);
  }
  std::printf("soak: %llu edits, seeds %llu to %llu, %.0f s, %d findings\n", static_cast<unsigned long long>(done),
              static_cast<unsigned long long>(request.first_seed), static_cast<unsigned long long>(seed - 1),
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), findings);
  return findings == 0 ? 0 : 1;
}
