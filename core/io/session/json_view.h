// SPDX-License-Identifier: GPL-3.0-or-later
// Reads JSON in place: values are pieces of the text, and only requested ones are built.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace mes {

/// A value of a JSON text, or no value.
///
/// The text has passed `check_json` and outlives its views. A view keeps only the begin and the end of the value, so
/// memory does not depend on the text. A query costs a pass over the value: O(its length) for `find`, `members` and
/// `elements`; ask once for each large object, by `pick`.
///
/// Smallest use:
///     if (auto good = check_json(text, file); !good) return std::unexpected(good.error());
///     for (const JsonView entry : JsonView::whole(text).find("timeline").elements()) use(entry);
class JsonView {
 public:
  JsonView() = default;
  /// The single value of the text.
  static JsonView whole(std::string_view text);

  explicit operator bool() const { return !text_.empty(); }
  bool is_object() const { return begins_with('{'); }
  bool is_list() const { return begins_with('['); }
  bool is_text() const { return begins_with('"'); }
  bool is_flag() const { return begins_with('t') || begins_with('f'); }
  bool is_number() const { return *this && (text_.front() == '-' || (text_.front() >= '0' && text_.front() <= '9')); }

  /// A number without fraction and exponent.
  bool is_whole() const { return is_number() && text_.find_first_of(".eE") == std::string_view::npos; }

  /// Value of a flag.
  bool flag() const { return begins_with('t'); }
  /// Value of a number; zero when it is too small for a double.
  double number() const;
  /// Value of a number without sign, fraction and exponent that fits 64 bits; otherwise nothing.
  std::optional<std::uint64_t> count() const;
  /// Value of a text, escapes resolved.
  std::string text() const;
  /// Upper bound on the bytes of `text`.
  std::size_t text_length() const { return text_.size() - 2; }

  /// Offset of its first byte in `text`, which contains it.
  std::size_t offset_in(std::string_view text) const { return static_cast<std::size_t>(text_.data() - text.data()); }

  class Elements;
  class Members;
  /// Elements of a list; empty for anything else.
  Elements elements() const;
  /// Keys and values of an object; empty for anything else. A key may occur twice.
  Members members() const;
  /// Number of elements.
  std::size_t size() const;
  /// The value of a key of an object, the last one if it occurs repeatedly; no value for anything else.
  JsonView find(std::string_view key) const { return pick(std::array{key})[0]; }
  /// The same for several keys, in one pass.
  template <std::size_t N>
  std::array<JsonView, N> pick(const std::array<std::string_view, N>& keys) const;

 private:
  friend class JsonCursor;
  explicit JsonView(std::string_view text) : text_(text) {}
  bool begins_with(char c) const { return !text_.empty() && text_.front() == c; }
  bool is_text(std::string_view wanted) const;

  std::string_view text_;
};

/// Walks over the values within an object or a list.
class JsonCursor {
 public:
  explicit JsonCursor(std::string_view inner) : rest_(inner) {}
  /// The next value; no value at the end.
  JsonView next();

 private:
  std::string_view rest_;
};

class JsonView::Elements {
 public:
  explicit Elements(std::string_view inner) : inner_(inner) {}
  class Iterator {
   public:
    explicit Iterator(std::string_view inner) : cursor_(inner), value_(cursor_.next()) {}
    JsonView operator*() const { return value_; }
    Iterator& operator++() {
      value_ = cursor_.next();
      return *this;
    }
    bool operator==(std::default_sentinel_t /*end*/) const { return !value_; }

   private:
    JsonCursor cursor_;
    JsonView value_;
  };
  Iterator begin() const { return Iterator(inner_); }
  static std::default_sentinel_t end() { return {}; }

 private:
  std::string_view inner_;
};

class JsonView::Members {
 public:
  explicit Members(std::string_view inner) : inner_(inner) {}
  class Iterator {
   public:
    explicit Iterator(std::string_view inner) : cursor_(inner) { ++*this; }
    const std::pair<JsonView, JsonView>& operator*() const { return member_; }
    Iterator& operator++() {
      member_.first = cursor_.next();
      member_.second = cursor_.next();
      return *this;
    }
    bool operator==(std::default_sentinel_t /*end*/) const { return !member_.first; }

   private:
    JsonCursor cursor_;
    std::pair<JsonView, JsonView> member_;
  };
  Iterator begin() const { return Iterator(inner_); }
  static std::default_sentinel_t end() { return {}; }

 private:
  std::string_view inner_;
};

template <std::size_t N>
std::array<JsonView, N> JsonView::pick(const std::array<std::string_view, N>& keys) const {
  std::array<JsonView, N> out;
  for (const auto& [key, value] : members())
    for (std::size_t i = 0; i < N; ++i)
      if (key.is_text(keys[i])) out[i] = value;
  return out;
}

}  // namespace mes
