# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(QRelief) defines
#   QRelief::core      parsing, projecting, carving and writing; uses the OpenGL ES 3 context of the program, if it has one
#   QRelief::messages  the words of errors and other messages (messages/sentences.h)
#   QRelief::native    both, with the GPU (without a window), files, a QR decoder and `Engraver`
include(CMakeFindDependencyMacro)
find_dependency(PkgConfig)
foreach(dependency fmt:fmt qrencode:libqrencode zlib:zlib expat:expat freetype:freetype2 gles:glesv2 egl:egl png:libpng zxing:zxing crypto:libcrypto)
  string(REPLACE ":" ";" parts ${dependency})
  list(GET parts 0 name)
  list(GET parts 1 module)
  pkg_check_modules(${name} REQUIRED IMPORTED_TARGET ${module})
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/QReliefTargets.cmake)
