// SPDX-License-Identifier: GPL-3.0-or-later
// What the GLFW of emscripten leaves out.
addToLibrary({
  glfwGetError: (description) => 0,
  // Keys are named by their codes, which follow the layout of the keyboard.
  glfwGetKeyName: (key, code) => 0,

  // The shape of the pointer. A shape is its own handle.
  glfwCreateStandardCursor: (shape) => shape,
  $pointerStyles: {
    0x36002: 'text', 0x36003: 'crosshair', 0x36004: 'pointer', 0x36005: 'ew-resize', 0x36006: 'ns-resize',
    0x36007: 'nwse-resize', 0x36008: 'nesw-resize', 0x36009: 'move', 0x3600A: 'not-allowed',
  },
  $pointer: {shape: 0, isHidden: false},
  $showPointer__deps: ['$pointer', '$pointerStyles'],
  $showPointer: () => {
    const style = pointer.isHidden ? 'none' : pointerStyles[pointer.shape] || 'default';
    if (Module.canvas.style.cursor !== style) Module.canvas.style.cursor = style;
  },
  glfwSetCursor__deps: ['$showPointer'],
  glfwSetCursor: (window, shape) => {
    pointer.shape = shape;
    showPointer();
  },
  glfwGetInputMode__deps: ['$pointer'],
  glfwGetInputMode: (window, mode) => mode === 0x33001 ? (pointer.isHidden ? 0x34002 : 0x34001) : 0,
  glfwSetInputMode__deps: ['$showPointer'],
  glfwSetInputMode: (window, mode, value) => {
    if (mode !== 0x33001) return;
    pointer.isHidden = value === 0x34002;
    showPointer();
  },

  // The page covers the screen. One monitor is shown, whose handle is 1.
  glfwGetWindowMonitor: (window) => document.fullscreenElement ? 1 : 0,
  $videoMode: {address: 0},
  glfwGetVideoMode__deps: ['$videoMode', 'malloc'],
  glfwGetVideoMode: (monitor) => {
    videoMode.address ||= _malloc(24);
    [screen.width, screen.height, 8, 8, 8, 60].forEach((value, i) => { HEAP32[(videoMode.address >> 2) + i] = value; });
    return videoMode.address;
  },
  glfwSetWindowMonitor: (window, monitor, x, y, width, height, rate) => {
    const change = monitor ? document.documentElement.requestFullscreen() : document.exitFullscreen();
    change.catch(() => {});
  },

  // Called for journals of unsaved work (home.js). Under node the files are those of the machine.
  __syscall_fdatasync: (fd) => globalThis.home ? globalThis.home.sync(FS.getStream(fd)) : 0,

  glfwSetClipboardString: (window, text) => {
    navigator.clipboard?.writeText(UTF8ToString(text)).catch(() => {});
  },
  // The text that the last event "paste" brought (page.js).
  $clipboard: {text: 0},
  glfwGetClipboardString__deps: ['$clipboard', '$stringToNewUTF8', 'free'],
  glfwGetClipboardString: (window) => {
    if (clipboard.text) _free(clipboard.text);
    clipboard.text = stringToNewUTF8(globalThis.pastedText || '');
    return clipboard.text;
  },
});
