// SPDX-License-Identifier: GPL-3.0-or-later
// The shared library consists of the adapter and the core folders that it uses; this source only makes it a C++
// library.
#include <mesecina/mesecina.h>
