// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons that come with the program.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/store/sample_shapes.h"
#include "core/base/error.h"
#include "core/io/session/session.h"

namespace mes {

class Registry;

struct ShippedLesson {
  std::filesystem::path file{};  ///< empty: the demo, which the program generates
  std::string name{};            ///< name of the file without its extension
  std::string title{};
};

/// The lessons in `lessons/index.json`, followed by the demo; lessons whose file is missing are left out.
std::vector<ShippedLesson> read_shipped_lessons(const std::filesystem::path& assets);

/// The demo of the first of these shapes, with its scenes as steps of a lesson (app/playing/demo.h). Error:
/// `bad_input` if there is no shape; errors of reading it and of `demo_session`.
Expected<Session> demo_of(const Registry& registry, std::span<const SampleShape> shapes);

/// The session of a lesson. Error: its file cannot be read, or holds no session.
Expected<std::shared_ptr<const Session>> session_of(const Registry& registry, const ShippedLesson& lesson,
                                                    const std::filesystem::path& assets);

}  // namespace mes
