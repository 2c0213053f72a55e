// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/window/x_connection.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

namespace mes::test {
namespace {

using Image = std::unique_ptr<XImage, decltype([](XImage* image) { XDestroyImage(image); })>;
using Bytes = std::unique_ptr<unsigned char, decltype([](unsigned char* bytes) { XFree(bytes); })>;

std::string name_of(Display* display, Window window) {
  const Atom name = XInternAtom(display, "_NET_WM_NAME", True);
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

}  // namespace mes::test
