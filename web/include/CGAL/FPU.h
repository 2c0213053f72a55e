// SPDX-License-Identifier: GPL-3.0-or-later
// Stands before the header of CGAL in the browser build. WebAssembly rounds to nearest only, for which CGAL would make
// each interval wider than need be, and numbers that are read off intervals other than those of other machines.
#pragma once

#include_next <CGAL/FPU.h>

#include "web/include/rounded_up.h"

#undef CGAL_IA_ADD
#undef CGAL_IA_SUB
#undef CGAL_IA_MUL
#undef CGAL_IA_DIV
#define CGAL_IA_ADD(a, b) mes::rounded_up::sum(a, b)
#define CGAL_IA_SUB(a, b) mes::rounded_up::difference(a, b)
#define CGAL_IA_MUL(a, b) mes::rounded_up::product(a, b)
#define CGAL_IA_DIV(a, b) mes::rounded_up::quotient(a, b)
#define CGAL_IA_SQUARE(a) mes::rounded_up::product(a, a)
#define IA_sqrt_up mes::rounded_up::square_root
#define IA_sqrt_toward_zero mes::rounded_up::square_root_down
