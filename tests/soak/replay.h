// SPDX-License-Identifier: GPL-3.0-or-later
// A finding as a session, as short as it gets.
#pragma once

#include <string>

#include "core/io/session/session.h"

namespace mes::test {

/// How the picture after the last entry differs from a fresh computation; empty where it does not, or where the
/// entries make no sense.
std::string trouble_of(const Session& session);

/// Leaves out entries as long as there is trouble, trying `most` times at most.
Session shortened(Session session, int most);

}  // namespace mes::test
