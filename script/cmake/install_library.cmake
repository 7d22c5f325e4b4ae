# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install build/release --component library` installs the static libraries, their headers as <qrelief/...>, and
# the files for find_package(QRelief). A consumer needs the Debian packages in script/apt-packages.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set_target_properties(qrelief_core PROPERTIES EXPORT_NAME core)
set_target_properties(qrelief_messages PROPERTIES EXPORT_NAME messages)
set_target_properties(qrelief_native PROPERTIES EXPORT_NAME native)
install(TARGETS qrelief_core qrelief_messages qrelief_native qrelief_headers qrelief_gles qrelief_hwy qrelief_csv
  EXPORT QReliefTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(EXPORT QReliefTargets NAMESPACE QRelief:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/QRelief COMPONENT library)

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/qrelief)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/ DESTINATION ${headers} COMPONENT library FILES_MATCHING PATTERN *.h)
install(FILES ${CMAKE_BINARY_DIR}/generated/message_codes.h DESTINATION ${headers} COMPONENT library)
foreach(folder native messages)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${headers} COMPONENT library FILES_MATCHING PATTERN *.h PATTERN cli EXCLUDE)
endforeach()

configure_file(${PROJECT_SOURCE_DIR}/script/cmake/QReliefConfig.cmake ${PROJECT_BINARY_DIR}/QReliefConfig.cmake COPYONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/QReliefConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/QReliefConfig.cmake ${PROJECT_BINARY_DIR}/QReliefConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/QRelief COMPONENT library)

add_library(QRelief::core ALIAS qrelief_core)
add_library(QRelief::native ALIAS qrelief_native)
