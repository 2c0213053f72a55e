// SPDX-License-Identifier: GPL-3.0-or-later
// The shared library is the adapter and the rooms that it uses; this source only makes it one of C++.
#include <mesecina/mesecina.h>
