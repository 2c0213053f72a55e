// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <optional>

#include "core/io/files/temporary.h"
#include "temporary_folder.h"

using namespace mes;
using test::contents_of;
namespace fs = std::filesystem;

namespace {

constexpr const char* kPartName = ".mesecina-0123456789abcdef.part";

/// For scratch folders.
class TemporaryDirectory {
 public:
  explicit TemporaryDirectory(const fs::path& value) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    setenv("TMPDIR", value.c_str(), 1);
  }
  ~TemporaryDirectory() {
    if (before_)
      setenv("TMPDIR", before_->c_str(), 1);
    else
      unsetenv("TMPDIR");
  }

 private:
  std::optional<std::string> before_;
};

/// Another process that has done its part and waits to be killed.
class Other {
 public:
  explicit Other(const std::function<void(const std::function<void()>& done)>& part) {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    pid_ = ::fork();
    REQUIRE(pid_ >= 0);
    if (pid_ == 0) {
      part([&] {
        static_cast<void>(!::write(ends[1], "x", 1));
        for (;;) ::pause();
      });
      ::_exit(1);
    }
    ::close(ends[1]);
    char c = 0;
    REQUIRE(::read(ends[0], &c, 1) == 1);
    ::close(ends[0]);
  }
  ~Other() { kill(); }
  void kill() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(std::exchange(pid_, -1), nullptr, 0);
  }

 private:
  pid_t pid_ = -1;
};

}  // namespace

TEST_CASE("a part of a file is removed when its process is gone, and not before") {
  const test::TemporaryFolder folder;
  Other other([&](const auto& done) {
    const auto part = PartFile::create_beside(folder / "a");
    if (part) done();
  });
  REQUIRE(folder.file_count() == 1);
  remove_abandoned_parts(folder.path());
  CHECK(folder.file_count() == 1);
  other.kill();
  remove_abandoned_parts(folder.path());
  CHECK(folder.file_count() == 0);
}

TEST_CASE("the first file made in a folder removes what others left there") {
  const test::TemporaryFolder folder;
  folder.write(kPartName, "half");
  const auto part = PartFile::create_beside(folder / "a");
  REQUIRE(part);
  CHECK_FALSE(fs::exists(folder / kPartName));
  CHECK(folder.file_count() == 1);
}

TEST_CASE("nothing but one's own files of that name is removed") {
  const test::TemporaryFolder folder;
  const fs::path precious = folder.write("precious", "all my work");
  folder.write(".mesecina-0123456789abcdeX.part", "another name");
  folder.write(".mesecina-0123.part", "another name");
  fs::create_symlink("precious", folder / kPartName);
  REQUIRE(::mkfifo((folder / ".mesecina-0000000000000001.part").c_str(), 0600) == 0);
  fs::create_directory(folder / ".mesecina-0000000000000002.part");
  std::size_t files = 6;
  if (::geteuid() == 0) {
    const fs::path foreign = folder.write(".mesecina-0000000000000003.part", "of another user");
    REQUIRE(::chown(foreign.c_str(), 12345, 12345) == 0);
    ++files;
  }
  remove_abandoned_parts(folder.path());
  CHECK(folder.file_count() == files);
  CHECK(contents_of(precious) == "all my work");
}

TEST_CASE("names of parts cannot be known before") {
  const test::TemporaryFolder folder;
  const auto first = PartFile::create_beside(folder / "a");
  const auto second = PartFile::create_beside(folder / "a");
  REQUIRE(first);
  REQUIRE(second);
  CHECK(first->path() != second->path());
  CHECK(first->path().filename().string().find(std::to_string(::getpid())) == std::string::npos);
}

TEST_CASE("a scratch folder is removed when its process is gone, and not before") {
  const test::TemporaryFolder folder;
  const TemporaryDirectory there(folder.path());
  const fs::path precious = folder.write("precious", "all my work");
  Other other([&](const auto& done) {
    const auto scratch = ScratchFolder::make();
    if (!scratch) return;
    std::ofstream(scratch->path() / "00001.png") << "frame";
    fs::create_symlink(precious, scratch->path() / "link");
    done();
  });
  REQUIRE(folder.file_count() == 2);
  {
    const auto mine = ScratchFolder::make();
    REQUIRE(mine);
    remove_abandoned_scratch();
    CHECK(folder.file_count() == 3);
  }
  CHECK(folder.file_count() == 2);
  other.kill();
  remove_abandoned_scratch();
  CHECK(folder.file_count() == 1);
  CHECK(contents_of(precious) == "all my work");
}

TEST_CASE("a folder that only has such a name stays") {
  const test::TemporaryFolder folder;
  const TemporaryDirectory there(folder.path());
  fs::create_directory(folder / "mesecina-film-frames");
  folder.write("mesecina-film-frames/00001.png", "kept");
  const fs::path elsewhere = folder / "elsewhere";
  fs::create_directory(elsewhere);
  std::ofstream(elsewhere / ".mesecina-owner") << "";
  std::ofstream(elsewhere / "work") << "kept";
  fs::create_symlink("elsewhere", folder / "mesecina-film-linked");
  fs::create_directory(folder / "mesecina-film-abcdef");
  fs::create_symlink("../elsewhere/.mesecina-owner", folder / "mesecina-film-abcdef" / ".mesecina-owner");
  remove_abandoned_scratch();
  CHECK(folder.file_count() == 4);
  CHECK(contents_of(folder / "mesecina-film-frames" / "00001.png") == "kept");
  CHECK(contents_of(elsewhere / "work") == "kept");
}

TEST_CASE("a process that ends at once removes what is its own and makes nothing more") {
  const test::TemporaryFolder folder;
  const TemporaryDirectory there(folder.path());
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    auto part = PartFile::create_beside(folder / "a");
    const auto scratch = ScratchFolder::make();
    if (!part || !scratch) ::_exit(1);
    std::ofstream(scratch->path() / "00001.png") << "frame";
    remove_own_temporaries(std::chrono::steady_clock::now() + std::chrono::hours(1));
    if (part->rename_to(folder / "a") == 0) ::_exit(2);
    if (PartFile::create_beside(folder / "b")) ::_exit(3);
    if (ScratchFolder::make()) ::_exit(4);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(folder.file_count() == 0);
}
