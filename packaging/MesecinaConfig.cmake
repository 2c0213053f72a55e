# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(Mesecina) makes the target Mesecina::Mesecina, which asks for C++20.
include("${CMAKE_CURRENT_LIST_DIR}/MesecinaTargets.cmake")
