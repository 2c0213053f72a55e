// SPDX-License-Identifier: GPL-3.0-or-later
// Mesecina as a library: geometry that follows a set of samples, as in the program. This header includes all others.
//
//   version.h     versions of the library and of its binary interface
//   error.h       the one exception
//   geometry.h    points, balls, ids, primitives
//   table.h       tables of structures as typed columns
//   catalogue.h   available structures, layers, parameters, evolutions, shapes and formats
//   workbench.h   data, edits, settings, runs, and their results
//
// Guarantees: these headers compile as C++20 on their own, and include nothing but each other and the standard
// library.
//
// Threads: see each class.
#pragma once

#include <mesecina/catalogue.h>
#include <mesecina/error.h>
#include <mesecina/experiment.h>
#include <mesecina/geometry.h>
#include <mesecina/table.h>
#include <mesecina/version.h>
#include <mesecina/workbench.h>
