# SPDX-License-Identifier: GPL-3.0-or-later
# qrelief::qrencode and qrelief::imgui for WebAssembly, from the sources that script/fetch-sources put into build/deps.
set(deps ${PROJECT_SOURCE_DIR}/build/deps)
foreach(folder qrencode-4.1.1 imgui-1.86)
  if(NOT IS_DIRECTORY ${deps}/${folder})
    message(FATAL_ERROR "build/deps/${folder} is missing: run script/setup (or script/fetch-sources alone)")
  endif()
endforeach()

set(folder ${deps}/qrencode-4.1.1)
add_library(qrelief_qrencode STATIC
  ${folder}/bitstream.c
  ${folder}/mask.c
  ${folder}/mmask.c
  ${folder}/mqrspec.c
  ${folder}/qrencode.c
  ${folder}/qrinput.c
  ${folder}/qrspec.c
  ${folder}/rsecc.c
  ${folder}/split.c)
target_include_directories(qrelief_qrencode SYSTEM PUBLIC ${folder})
# What its configure script would have put into config.h.
target_compile_definitions(qrelief_qrencode PRIVATE
  STATIC_IN_RELEASE=static HAVE_STRDUP=1 MAJOR_VERSION=4 MINOR_VERSION=1 MICRO_VERSION=1 VERSION="4.1.1")
add_library(qrelief::qrencode ALIAS qrelief_qrencode)

set(folder ${deps}/imgui-1.86)
add_library(qrelief_imgui STATIC
  ${folder}/imgui.cpp
  ${folder}/imgui_draw.cpp
  ${folder}/imgui_tables.cpp
  ${folder}/imgui_widgets.cpp
  ${folder}/backends/imgui_impl_opengl3.cpp)
target_include_directories(qrelief_imgui SYSTEM PUBLIC ${folder} ${folder}/backends)
target_compile_definitions(qrelief_imgui
  PUBLIC IMGUI_DISABLE_OBSOLETE_FUNCTIONS
  PRIVATE IMGUI_IMPL_OPENGL_ES3 IMGUI_DISABLE_FILE_FUNCTIONS)
target_compile_options(qrelief_imgui PRIVATE -fwasm-exceptions -msimd128)
add_library(qrelief::imgui ALIAS qrelief_imgui)
