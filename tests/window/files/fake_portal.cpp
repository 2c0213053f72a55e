// SPDX-License-Identifier: GPL-3.0-or-later
// A desktop's file dialog for tests: answers each question as its arguments say, and writes to its standard output what
// it was asked.
//
//   fake_portal choose FILE | cancel | fail | refuse | silent | deaf
#include <gio/gio.h>

#include <cstdio>
#include <string>

namespace {

constexpr const char* kInterfaces = R"(<node>
  <interface name="org.freedesktop.portal.FileChooser">
    <method name="OpenFile">
      <arg type="s" direction="in"/><arg type="s" direction="in"/><arg type="a{sv}" direction="in"/>
      <arg type="o" direction="out"/>
    </method>
    <method name="SaveFile">
      <arg type="s" direction="in"/><arg type="s" direction="in"/><arg type="a{sv}" direction="in"/>
      <arg type="o" direction="out"/>
    </method>
  </interface>
  <interface name="org.freedesktop.portal.Request">
    <method name="Close"/>
    <signal name="Response"><arg type="u"/><arg type="a{sv}"/></signal>
  </interface>
</node>)";

std::string mode;
std::string file;
GDBusNodeInfo* interfaces = nullptr;

void say(const std::string& line) {
  std::puts(line.c_str());
  std::fflush(stdout);
}

std::string text_option(GVariant* options, const char* key) {
  const char* text = "";
  g_variant_lookup(options, key, "&s", &text);
  return text;
}

void closed(GDBusConnection*, const gchar*, const gchar*, const gchar*, const gchar*, GVariant*,
            GDBusMethodInvocation* call, gpointer) {
  say("Close");
  g_dbus_method_invocation_return_value(call, nullptr);
}

void respond(GDBusConnection* bus, const std::string& sender, const std::string& path) {
  GVariantBuilder results;
  g_variant_builder_init(&results, G_VARIANT_TYPE_VARDICT);
  if (mode == "choose") {
    gchar* const uri = g_filename_to_uri(file.c_str(), nullptr, nullptr);
    const gchar* const uris[] = {uri, nullptr};
    g_variant_builder_add(&results, "{sv}", "uris", g_variant_new_strv(uris, -1));
    g_free(uri);
  }
  const guint32 code = mode == "choose" ? 0 : mode == "cancel" ? 1 : 2;
  g_dbus_connection_emit_signal(bus, sender.c_str(), path.c_str(), "org.freedesktop.portal.Request", "Response",
                                g_variant_new("(ua{sv})", code, &results), nullptr);
}

void asked(GDBusConnection* bus, const gchar* sender, const gchar*, const gchar*, const gchar* method,
           GVariant* arguments, GDBusMethodInvocation* call, gpointer) {
  const char* window = nullptr;
  const char* heading = nullptr;
  GVariant* options = nullptr;
  g_variant_get(arguments, "(&s&s@a{sv})", &window, &heading, &options);
  const char* folder = "";
  g_variant_lookup(options, "current_folder", "^&ay", &folder);
  say(std::string(method) + '|' + window + '|' + heading + '|' + folder + '|' + text_option(options, "current_name"));
  if (mode == "deaf") return;
  if (mode == "refuse") {
    g_dbus_method_invocation_return_dbus_error(call, "org.freedesktop.portal.Error.Failed", "no dialog today");
    return;
  }
  std::string name = sender + 1;
  for (char& c : name)
    if (c == '.') c = '_';
  const std::string path =
      "/org/freedesktop/portal/desktop/request/" + name + '/' + text_option(options, "handle_token");
  static const GDBusInterfaceVTable request{closed, nullptr, nullptr, {}};
  g_dbus_connection_register_object(bus, path.c_str(), interfaces->interfaces[1], &request, nullptr, nullptr,
                                    nullptr);
  g_dbus_method_invocation_return_value(call, g_variant_new("(o)", path.c_str()));
  if (mode != "silent") respond(bus, sender, path);
}

void connected(GDBusConnection* bus, const gchar*, gpointer) {
  static const GDBusInterfaceVTable chooser{asked, nullptr, nullptr, {}};
  g_dbus_connection_register_object(bus, "/org/freedesktop/portal/desktop", interfaces->interfaces[0], &chooser,
                                    nullptr, nullptr, nullptr);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return 2;
  mode = arguments[1];
  if (count > 2) file = arguments[2];
  interfaces = g_dbus_node_info_new_for_xml(kInterfaces, nullptr);
  g_bus_own_name(
      G_BUS_TYPE_SESSION, "org.freedesktop.portal.Desktop", G_BUS_NAME_OWNER_FLAGS_NONE, connected,
      [](GDBusConnection*, const gchar*, gpointer) { say("ready"); }, nullptr, nullptr, nullptr);
  g_main_loop_run(g_main_loop_new(nullptr, FALSE));
}
