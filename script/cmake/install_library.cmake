# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install build/release --component library` installs the static libraries, their headers as <qrelief/...>, and
# the files for find_package(QRelief). A consumer needs the Debian packages in script/apt-packages.
# After add_subdirectory(), the targets have the same names and the headers the same paths.
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
install(DIRECTORY ${PROJECT_BINARY_DIR}/generated/message_codes DESTINATION ${headers} COMPONENT library)
foreach(folder native messages)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${headers} COMPONENT library FILES_MATCHING PATTERN *.h PATTERN cli EXCLUDE)
endforeach()

configure_file(${PROJECT_SOURCE_DIR}/script/cmake/QReliefConfig.cmake ${PROJECT_BINARY_DIR}/QReliefConfig.cmake COPYONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/QReliefConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/QReliefConfig.cmake ${PROJECT_BINARY_DIR}/QReliefConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/QRelief COMPONENT library)

# The tree of installed headers, as links. Our own targets do not see it: they include by the folders of the sources.
set(tree ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${tree}/qrelief)
foreach(folder ${QRELIEF_CORE_FOLDERS})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/core/${folder} ${tree}/qrelief/${folder} SYMBOLIC)
endforeach()
foreach(folder native messages)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${tree}/qrelief/${folder} SYMBOLIC)
endforeach()
file(CREATE_LINK ${PROJECT_BINARY_DIR}/generated/message_codes ${tree}/qrelief/message_codes SYMBOLIC)
foreach(name core messages native)
  add_library(qrelief_${name}_in_tree INTERFACE)
  target_include_directories(qrelief_${name}_in_tree INTERFACE ${tree})
  target_link_libraries(qrelief_${name}_in_tree INTERFACE qrelief_${name})
  add_library(QRelief::${name} ALIAS qrelief_${name}_in_tree)
endforeach()
