// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/window/x_connection.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <utility>

#include "tests/support/eventually.h"

namespace mes::test {
namespace {

using Image = std::unique_ptr<XImage, decltype([](XImage* image) { XDestroyImage(image); })>;
using Bytes = std::unique_ptr<unsigned char, decltype([](unsigned char* bytes) { XFree(bytes); })>;

std::string text_of(Display* display, Window window, Atom name) {
  Atom type = 0;
  int bits = 0;
  unsigned long count = 0;
  unsigned long rest = 0;
  unsigned char* found = nullptr;
  constexpr long kMost = 1024;
  if (XGetWindowProperty(display, window, name, 0, kMost, False, AnyPropertyType, &type, &bits, &count, &rest,
                         &found) != Success)
    return {};
  const Bytes bytes(found);
  return bits == 8 ? std::string(reinterpret_cast<const char*>(found), count) : std::string();
}

std::string name_of(Display* display, Window window) {
  return text_of(display, window, XInternAtom(display, "_NET_WM_NAME", True));
}

void add_names(Display* display, Window window, std::vector<std::string>& out) {
  if (std::string name = name_of(display, window); !name.empty()) out.push_back(std::move(name));
  Window root = 0;
  Window parent = 0;
  Window* children = nullptr;
  unsigned int count = 0;
  if (XQueryTree(display, window, &root, &parent, &children, &count) == 0 || children == nullptr) return;
  const Bytes bytes(reinterpret_cast<unsigned char*>(children));
  for (const Window child : std::span(children, count)) add_names(display, child, out);
}

Window find_window(Display* display, Window from, const std::string& words) {
  if (name_of(display, from).contains(words)) return from;
  Window root = 0;
  Window parent = 0;
  Window* children = nullptr;
  unsigned int count = 0;
  if (XQueryTree(display, from, &root, &parent, &children, &count) == 0 || children == nullptr) return None;
  const Bytes bytes(reinterpret_cast<unsigned char*>(children));
  for (const Window child : std::span(children, count))
    if (const Window found = find_window(display, child, words); found != None) return found;
  return None;
}

/// A window of the test's own, which talks to others by selections.
class Talker {
 public:
  explicit Talker(Display* display)
      : display_(display), window_(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0)) {}
  ~Talker() { XDestroyWindow(display_, window_); }
  Talker(const Talker&) = delete;
  Talker& operator=(const Talker&) = delete;

  Window window() const { return window_; }
  Atom atom(const char* name) const { return XInternAtom(display_, name, False); }
  void tell(Window to, const char* type, std::array<long, 4> data) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = to;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(window_);
    std::ranges::copy(data, event.xclient.data.l + 1);
    XSendEvent(display_, to, False, NoEventMask, &event);
    XFlush(display_);
  }
  /// Until an event satisfies the condition.
  bool hear(const std::function<bool(const XEvent&)>& condition) const {
    return eventually([&] {
      while (XPending(display_) > 0) {
        XEvent event;
        XNextEvent(display_, &event);
        if (condition(event)) return true;
      }
      return false;
    });
  }
  /// Gives the text to the one who asks for the selection.
  void answer(const XSelectionRequestEvent& asked, const std::string& text) const {
    XChangeProperty(display_, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    XEvent event{};
    event.xselection = {.type = SelectionNotify,
                        .serial = 0,
                        .send_event = False,
                        .display = display_,
                        .requestor = asked.requestor,
                        .selection = asked.selection,
                        .target = asked.target,
                        .property = asked.property,
                        .time = asked.time};
    XSendEvent(display_, asked.requestor, False, NoEventMask, &event);
    XFlush(display_);
  }

 private:
  Display* display_;
  Window window_;
};

}  // namespace

XConnection::XConnection(const std::string& display)
    : display_(XOpenDisplay(display.c_str()), [](Display* open) {
        if (open != nullptr) XCloseDisplay(open);
      }) {
  // A window may close while it is asked for its name.
  XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
}

Screenshot XConnection::shoot() const {
  const int screen = DefaultScreen(display_.get());
  const int width = DisplayWidth(display_.get(), screen);
  const int height = DisplayHeight(display_.get(), screen);
  const Image image(XGetImage(display_.get(), RootWindow(display_.get(), screen), 0, 0,
                              static_cast<unsigned int>(width), static_cast<unsigned int>(height), AllPlanes,
                              ZPixmap));
  // Xvfb has pixels of four bytes: blue, green, red and nothing.
  constexpr std::size_t kBytes = 4;
  if (image == nullptr || image->bits_per_pixel != 8 * kBytes) return {0, 0, {}};
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    const char* const row = image->data + static_cast<std::ptrdiff_t>(y) * image->bytes_per_line;
    for (int x = 0; x < width; ++x) {
      std::uint8_t pixel[kBytes];
      std::memcpy(pixel, row + static_cast<std::size_t>(x) * kBytes, kBytes);
      rgb.insert(rgb.end(), {pixel[2], pixel[1], pixel[0]});
    }
  }
  return {width, height, std::move(rgb)};
}

std::vector<std::string> XConnection::window_names() const {
  std::vector<std::string> out;
  add_names(display_.get(), DefaultRootWindow(display_.get()), out);
  return out;
}

// By the XDND protocol, version 5.
bool XConnection::drop(const std::string& words, const std::string& file) const {
  const Window target = find_window(display_.get(), DefaultRootWindow(display_.get()), words);
  if (target == None) return false;
  const Talker talker(display_.get());
  const Atom selection = talker.atom("XdndSelection");
  XSetSelectionOwner(display_.get(), selection, talker.window(), CurrentTime);
  talker.tell(target, "XdndEnter", {5L << 24, static_cast<long>(talker.atom("text/uri-list")), 0, 0});
  const long middle = (DisplayWidth(display_.get(), 0) / 2) << 16 | DisplayHeight(display_.get(), 0) / 2;
  talker.tell(target, "XdndPosition", {0, middle, CurrentTime, static_cast<long>(talker.atom("XdndActionCopy"))});
  const Atom status = talker.atom("XdndStatus");
  if (!talker.hear(
          [&](const XEvent& event) { return event.type == ClientMessage && event.xclient.message_type == status; }))
    return false;
  talker.tell(target, "XdndDrop", {0, CurrentTime, 0, 0});
  const Atom finished = talker.atom("XdndFinished");
  return talker.hear([&](const XEvent& event) {
    if (event.type == SelectionRequest && event.xselectionrequest.selection == selection)
      talker.answer(event.xselectionrequest, "file://" + file + "\r\n");
    return event.type == ClientMessage && event.xclient.message_type == finished;
  });
}

std::string XConnection::clipboard() const {
  const Talker talker(display_.get());
  const Atom property = talker.atom("MESECINA_TEST");
  XConvertSelection(display_.get(), talker.atom("CLIPBOARD"), talker.atom("UTF8_STRING"), property, talker.window(),
                    CurrentTime);
  bool is_given = false;
  if (!talker.hear([&](const XEvent& event) {
        is_given = event.type == SelectionNotify && event.xselection.property != None;
        return event.type == SelectionNotify;
      }) ||
      !is_given)
    return {};
  return text_of(display_.get(), talker.window(), property);
}

}  // namespace mes::test
