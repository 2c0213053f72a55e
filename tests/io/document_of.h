// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/commands.h"

namespace mes::test {

inline Document document_of(const SampleData& data) {
  Document document;
  document.apply(replace_all(document, data).value());
  return document;
}

}  // namespace mes::test
