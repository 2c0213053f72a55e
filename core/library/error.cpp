// SPDX-License-Identifier: GPL-3.0-or-later
#include <mesecina/error.h>

#include <fmt/core.h>

#include <new>

#include "core/base/assert.h"
#include "core/io/text/text_numbers.h"
#include "core/library/internal/adapter.h"

namespace mesecina {
inline namespace v1 {

struct Error::Impl {
  Details details;
  std::string message;
};

namespace {

ErrorCode outer(mes::ErrorCode code) {
  switch (code) {
    case mes::ErrorCode::usage: return ErrorCode::usage;
    case mes::ErrorCode::bad_input: return ErrorCode::bad_input;
    case mes::ErrorCode::cannot_write: return ErrorCode::cannot_write;
    case mes::ErrorCode::cannot_compute: return ErrorCode::cannot_compute;
    case mes::ErrorCode::out_of_memory: return ErrorCode::out_of_memory;
    case mes::ErrorCode::cancelled: return ErrorCode::cancelled;
    case mes::ErrorCode::no_display: break;
  }
  return ErrorCode::internal;
}

/// Made in advance, because there may be no memory for it later.
const Error& lack_of_memory() {
  static const Error error(ErrorCode::out_of_memory, "there is not enough memory");
  return error;
}
const bool is_lack_of_memory_made = (lack_of_memory(), true);

}  // namespace

std::string_view name_of(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::usage: return "usage";
    case ErrorCode::bad_input: return "bad input";
    case ErrorCode::cannot_write: return "cannot write";
    case ErrorCode::cannot_compute: return "cannot compute";
    case ErrorCode::out_of_memory: return "out of memory";
    case ErrorCode::cancelled: return "cancelled";
    case ErrorCode::internal: break;
  }
  return "internal";
}

Error::Error(Details details) {
  std::string message = mes::printable(
      mes::Error{mes::ErrorCode::usage, details.text, details.file, details.line, details.column}.message());
  impl_ = std::make_shared<const Impl>(Impl{std::move(details), std::move(message)});
}
Error::Error(ErrorCode code, std::string text) : Error(Details{.code = code, .text = std::move(text)}) {}
Error::Error(const Error&) noexcept = default;
Error& Error::operator=(const Error&) noexcept = default;
Error::~Error() = default;

const char* Error::what() const noexcept {
  return impl_->message.c_str();
}
ErrorCode Error::code() const noexcept {
  return impl_->details.code;
}
const std::string& Error::text() const noexcept {
  return impl_->details.text;
}
const std::string& Error::file() const noexcept {
  return impl_->details.file;
}
std::uint64_t Error::line() const noexcept {
  return impl_->details.line;
}
std::uint64_t Error::column() const noexcept {
  return impl_->details.column;
}
const std::string& Error::structure() const noexcept {
  return impl_->details.structure;
}
const std::vector<SampleId>& Error::witnesses() const noexcept {
  return impl_->details.witnesses;
}

void raise(const mes::Error& error) {
  throw Error(Error::Details{
      .code = outer(error.code), .text = error.text, .file = error.file, .line = error.line, .column = error.column});
}

void refuse(std::string text) {
  throw Error(ErrorCode::usage, std::move(text));
}

void refuse_unknown(std::string_view what, std::string_view id) {
  refuse(fmt::format("unknown {} {}", what, mes::in_quotes(std::string(id))));
}

void raise_current() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    throw lack_of_memory();
  } catch (const mes::Cancelled&) {
    throw Error(ErrorCode::cancelled, "the computation was stopped");
  } catch (const mes::GeometryError& error) {
    throw Error(Error::Details{
        .code = ErrorCode::cannot_compute, .text = error.what(), .witnesses = all_outer(error.witnesses)});
  } catch (const mes::AssertionFailure& error) {
    throw Error(ErrorCode::internal, error.what());
  } catch (const std::exception& error) {
    throw Error(ErrorCode::internal, error.what());
  }
}

}  // namespace v1
}  // namespace mesecina
