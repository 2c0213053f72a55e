// SPDX-License-Identifier: GPL-3.0-or-later
// OpenGL as a browser has it: WebGL 2, whose functions are those of OpenGL ES 3.
#pragma once

#include <GLES3/gl3.h>
