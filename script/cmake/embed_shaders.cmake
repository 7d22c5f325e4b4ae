# SPDX-License-Identifier: GPL-3.0-or-later
# embed_shaders(TARGET file...): resolves the #include lines of shader files and compiles the files into TARGET as
# `qrelief::shaders::<name>_<kind>` (hbao.frag → hbao_frag), declared in "shaders.h".
set(EMBED_SHADERS_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_shaders_script.cmake)

function(embed_shaders target)
  set(out ${PROJECT_BINARY_DIR}/generated)
  file(GLOB includes CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*.glsl)
  add_custom_command(
    OUTPUT ${out}/shaders.h ${out}/shaders.cpp
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} "-DSHADERS=${ARGN}" -P ${EMBED_SHADERS_SCRIPT}
    DEPENDS ${ARGN} ${includes} ${EMBED_SHADERS_SCRIPT}
    VERBATIM)
  target_sources(${target} PRIVATE ${out}/shaders.h ${out}/shaders.cpp)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${out}>)
endfunction()
