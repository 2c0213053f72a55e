# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed of libmesecina: the library as the component `library`, and the headers with what finds them as the
# component `development`. Neither is part of a plain `cmake --install`, which needs only the program.
include(CMakePackageConfigHelpers)
get_target_property(library_abi mesecina_library SOVERSION)
set(library_package libmesecina${library_abi})
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/Mesecina)
# Before 1.0.0 a minor version may break what uses it.
write_basic_package_version_file(MesecinaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
# From the folder of the file to the prefix, so that what is installed can be moved.
file(RELATIVE_PATH MESECINA_PREFIX_FROM_PC /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(mesecina.pc.in mesecina.pc @ONLY)

install(TARGETS mesecina_library EXPORT MesecinaTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development EXCLUDE_FROM_ALL
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT MesecinaTargets NAMESPACE Mesecina:: DESTINATION ${config} COMPONENT development EXCLUDE_FROM_ALL)
install(FILES MesecinaConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/MesecinaConfigVersion.cmake DESTINATION ${config}
  COMPONENT development EXCLUDE_FROM_ALL)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mesecina.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development EXCLUDE_FROM_ALL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/library/mesecina DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT development EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.h")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/library/ DESTINATION ${data}/doc/libmesecina-dev/examples
  COMPONENT development EXCLUDE_FROM_ALL)
# The rules of Debian ask each package for these.
set(papers copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian.gz)
install(FILES ${papers} DESTINATION ${data}/doc/${library_package} COMPONENT library EXCLUDE_FROM_ALL)
install(FILES ${papers} DESTINATION ${data}/doc/libmesecina-dev COMPONENT development EXCLUDE_FROM_ALL)
