// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/system/desktop_dialog.h"

#include <gio/gio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace mes {
namespace {

using Kind = DesktopAnswer::Kind;
using Clock = std::chrono::steady_clock;

constexpr const char* kPortal = "org.freedesktop.portal.Desktop";
constexpr const char* kPortalPath = "/org/freedesktop/portal/desktop";
constexpr const char* kRequest = "org.freedesktop.portal.Request";
constexpr auto kLongestBeginning = std::chrono::seconds(10);

template <auto release>
struct Release {
  template <class T>
  void operator()(T* what) const {
    release(what);
  }
};
template <class T, auto release>
using Owned = std::unique_ptr<T, Release<release>>;
using Object = Owned<void, g_object_unref>;
using Text = Owned<char, g_free>;
using Value = Owned<GVariant, g_variant_unref>;

/// An event loop for this thread alone.
class Loop {
 public:
  Loop() : context_(g_main_context_new()) { g_main_context_push_thread_default(context_.get()); }
  ~Loop() { g_main_context_pop_thread_default(context_.get()); }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  void wake() const { g_main_context_wakeup(context_.get()); }
  /// Runs until `is_done`; returns false when the time, if limited, is over first.
  bool run_until(const std::function<bool()>& is_done, std::optional<Clock::time_point> end) const {
    Owned<GSource, g_source_unref> alarm;
    if (end) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(*end - Clock::now()).count();
      alarm.reset(g_timeout_source_new(static_cast<guint>(std::max<std::int64_t>(0, left) + 1)));
      g_source_set_callback(
          alarm.get(), [](gpointer) -> gboolean { return G_SOURCE_CONTINUE; }, nullptr, nullptr);
      g_source_attach(alarm.get(), context_.get());
    }
    while (!is_done() && (!end || Clock::now() < *end)) g_main_context_iteration(context_.get(), TRUE);
    if (alarm) g_source_destroy(alarm.get());
    return is_done();
  }

 private:
  Owned<GMainContext, g_main_context_unref> context_;
};

/// A pending call of GIO, or its result.
struct Pending {
  Object source;
  Owned<GAsyncResult, g_object_unref> result;
  bool has_ended() const { return result != nullptr; }
  static void end(GObject* source, GAsyncResult* result, gpointer self) {
    auto* const pending = static_cast<Pending*>(self);
    if (source != nullptr) pending->source.reset(g_object_ref(source));
    pending->result.reset(static_cast<GAsyncResult*>(g_object_ref(result)));
  }
};

/// One dialog, from the connection to the answer.
class Asking {
 public:
  Asking(const DesktopQuestion& question, std::stop_token stop)
      : question_(question),
        stop_(std::move(stop)),
        cancellable_(g_cancellable_new()),
        end_(Clock::now() + kLongestBeginning) {}
  ~Asking() {
    // Pending calls hold addresses of this object, so they must end before it does.
    g_cancellable_cancel(cancellable_.get());
    loop_.run_until([this] { return calls_ == ended_calls(); }, std::nullopt);
    if (bus_) g_dbus_connection_close_sync(bus_.get(), nullptr, nullptr);
  }
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;

  DesktopAnswer ask() {
    const std::stop_callback on_stop(stop_, [this] { loop_.wake(); });
    if (connect() && begin()) {
      loop_.run_until([this] { return answer_ || stop_.stop_requested() || is_lost(); }, std::nullopt);
      if (stop_.stop_requested() && !answer_) close();
    }
    if (stop_.stop_requested() && !answer_) return {.kind = Kind::cancelled};
    return answer_.value_or(DesktopAnswer{});
  }

 private:
  int ended_calls() const { return (connecting_.has_ended() ? 1 : 0) + (calling_.has_ended() ? 1 : 0); }
  bool is_lost() const { return is_portal_gone_ || g_dbus_connection_is_closed(bus_.get()); }
  bool wait_for(const Pending& pending) {
    return loop_.run_until([&] { return pending.has_ended() || stop_.stop_requested(); }, end_) &&
           pending.has_ended();
  }

  bool connect() {
    const Text address(g_dbus_address_get_for_bus_sync(G_BUS_TYPE_SESSION, nullptr, nullptr));
    if (!address) return false;
    constexpr auto kFlags = static_cast<GDBusConnectionFlags>(G_DBUS_CONNECTION_FLAGS_AUTHENTICATION_CLIENT |
                                                              G_DBUS_CONNECTION_FLAGS_MESSAGE_BUS_CONNECTION);
    ++calls_;
    g_dbus_connection_new_for_address(address.get(), kFlags, nullptr, cancellable_.get(), Pending::end, &connecting_);
    if (!wait_for(connecting_)) return false;
    bus_.reset(g_dbus_connection_new_for_address_finish(connecting_.result.get(), nullptr));
    return bus_ != nullptr;
  }

  void subscribe(const std::string& path) {
    g_dbus_connection_signal_subscribe(bus_.get(), kPortal, kRequest, "Response", path.c_str(), nullptr,
                                       G_DBUS_SIGNAL_FLAGS_NONE, on_response, this, nullptr);
  }

  // Subscribes before it asks, so that no answer is missed; the path of the answer follows from the token.
  bool begin() {
    std::string sender = g_dbus_connection_get_unique_name(bus_.get()) + 1;
    std::ranges::replace(sender, '.', '_');
    static std::atomic<int> count = 0;
    token_ = "mesecina" + std::to_string(++count);
    request_ = kPortalPath + ("/request/" + sender) + '/' + token_;
    subscribe(request_);
    g_dbus_connection_signal_subscribe(bus_.get(), "org.freedesktop.DBus", "org.freedesktop.DBus", "NameOwnerChanged",
                                       "/org/freedesktop/DBus", kPortal, G_DBUS_SIGNAL_FLAGS_NONE, on_owner, this,
                                       nullptr);
    ++calls_;
    g_dbus_connection_call(bus_.get(), kPortal, kPortalPath, "org.freedesktop.portal.FileChooser",
                           question_.is_saving ? "SaveFile" : "OpenFile", arguments(), G_VARIANT_TYPE("(o)"),
                           G_DBUS_CALL_FLAGS_NONE, -1, cancellable_.get(), Pending::end, &calling_);
    if (!wait_for(calling_)) {
      // The dialog may still appear.
      close();
      return false;
    }
    const Value reply(g_dbus_connection_call_finish(bus_.get(), calling_.result.get(), nullptr));
    if (!reply) return false;
    const char* path = nullptr;
    g_variant_get(reply.get(), "(&o)", &path);
    // Portals before version 0.9 choose the path themselves.
    if (request_ != path) subscribe(request_ = path);
    return true;
  }

  void close() {
    g_dbus_connection_call(bus_.get(), kPortal, request_.c_str(), kRequest, "Close", nullptr, nullptr,
                           G_DBUS_CALL_FLAGS_NO_AUTO_START, -1, nullptr, nullptr, nullptr);
    g_dbus_connection_flush_sync(bus_.get(), cancellable_.get(), nullptr);
  }

  // The call that receives the arguments owns them.
  GVariant* arguments() const {
    GVariantBuilder options;
    g_variant_builder_init(&options, G_VARIANT_TYPE_VARDICT);
    const auto add = [&](const char* key, GVariant* value) { g_variant_builder_add(&options, "{sv}", key, value); };
    add("handle_token", g_variant_new_string(token_.c_str()));
    if (!question_.folder.empty()) add("current_folder", g_variant_new_bytestring(question_.folder.c_str()));
    if (question_.is_saving && g_utf8_validate(question_.name.c_str(), -1, nullptr) != FALSE)
      add("current_name", g_variant_new_string(question_.name.c_str()));
    if (!question_.filters.empty()) add("filters", filters());
    return g_variant_new("(ssa{sv})", question_.window.c_str(), question_.heading.c_str(), &options);
  }

  GVariant* filters() const {
    GVariantBuilder all;
    g_variant_builder_init(&all, G_VARIANT_TYPE("a(sa(us))"));
    for (const DesktopQuestion::Filter& filter : question_.filters) {
      GVariantBuilder patterns;
      g_variant_builder_init(&patterns, G_VARIANT_TYPE("a(us)"));
      for (const std::string& pattern : filter.patterns)
        g_variant_builder_add(&patterns, "(us)", guint32{0}, pattern.c_str());
      g_variant_builder_add(&all, "(sa(us))", filter.name.c_str(), &patterns);
    }
    return g_variant_builder_end(&all);
  }

  static void on_response(GDBusConnection*, const gchar*, const gchar*, const gchar*, const gchar*, GVariant* values,
                          gpointer self) {
    static_cast<Asking*>(self)->take(values);
  }

  static void on_owner(GDBusConnection*, const gchar*, const gchar*, const gchar*, const gchar*, GVariant* values,
                       gpointer self) {
    const char* now = nullptr;
    g_variant_get(values, "(&s&s&s)", nullptr, nullptr, &now);
    static_cast<Asking*>(self)->is_portal_gone_ = now[0] == '\0';
  }

  // Code 0: done; 1: cancelled; anything else: failed.
  void take(GVariant* values) {
    if (!g_variant_is_of_type(values, G_VARIANT_TYPE("(ua{sv})"))) return;
    guint32 code = 2;
    GVariant* results = nullptr;
    g_variant_get(values, "(u@a{sv})", &code, &results);
    const Value owned(results);
    if (code == 1) answer_ = {.kind = Kind::cancelled};
    if (code > 1) answer_.emplace();
    if (code != 0) return;
    answer_.emplace();
    const Value uris(g_variant_lookup_value(results, "uris", G_VARIANT_TYPE("as")));
    if (!uris || g_variant_n_children(uris.get()) == 0) return;
    const char* uri = nullptr;
    g_variant_get_child(uris.get(), 0, "&s", &uri);
    const Text file(g_filename_from_uri(uri, nullptr, nullptr));
    if (file) answer_ = {.kind = Kind::chosen, .file = file.get()};
  }

  const DesktopQuestion& question_;
  std::stop_token stop_;
  Loop loop_;
  Owned<GCancellable, g_object_unref> cancellable_;
  Clock::time_point end_;
  Owned<GDBusConnection, g_object_unref> bus_;
  int calls_ = 0;
  Pending connecting_;
  Pending calling_;
  std::string token_;
  std::string request_;
  std::optional<DesktopAnswer> answer_;
  bool is_portal_gone_ = false;
};

}  // namespace

// Checks first, because GIO would start a bus where none is named.
bool may_have_desktop_dialog() {
  if (const char* const named = std::getenv("DBUS_SESSION_BUS_ADDRESS"); named != nullptr && named[0] != '\0')
    return true;
  const char* const folder = std::getenv("XDG_RUNTIME_DIR");
  return folder != nullptr && folder[0] == '/' && access((std::string(folder) + "/bus").c_str(), R_OK | W_OK) == 0;
}

DesktopAnswer ask_desktop(const DesktopQuestion& question, const std::stop_token& stop) {
  return Asking(question, stop).ask();
}

}  // namespace mes
