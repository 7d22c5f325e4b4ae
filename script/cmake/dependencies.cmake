# SPDX-License-Identifier: GPL-3.0-or-later
# Third-party libraries as targets qrelief::<name>, with the same names natively and for WebAssembly.

# A folder that links the headers of a few libraries, because a WASM build must not see /usr/include.
set(QRELIEF_HEADERS ${PROJECT_BINARY_DIR}/third_party)
file(MAKE_DIRECTORY ${QRELIEF_HEADERS})
foreach(name CGAL boost fast_float glm hwy tiny_obj_loader.h fmt nlohmann tl)
  find_path(${name}_parent NAMES ${name} PATHS /usr/include /usr/local/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH
    NO_CACHE REQUIRED)
  file(CREATE_LINK ${${name}_parent}/${name} ${QRELIEF_HEADERS}/${name} SYMBOLIC)
endforeach()

add_library(qrelief_headers INTERFACE)
target_include_directories(qrelief_headers SYSTEM INTERFACE $<BUILD_INTERFACE:${QRELIEF_HEADERS}>)
target_compile_definitions(qrelief_headers INTERFACE CGAL_DISABLE_GMP=1 CGAL_NO_GMP=1)
target_link_libraries(qrelief_headers INTERFACE qrelief::fmt)
if(EMSCRIPTEN)
  # WASM cannot switch the rounding mode; without this CGAL's interval filters are silently wrong.
  target_compile_definitions(qrelief_headers INTERFACE CGAL_ALWAYS_ROUND_TO_NEAREST)
endif()
add_library(qrelief::headers ALIAS qrelief_headers)

if(EMSCRIPTEN)
  # emcc's optimiser looks for the JavaScript parser acorn. Debian installs it where only its own Node looks.
  set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)
  include(wasm_sources)  # qrelief::fmt, qrencode, zlib, expat, csv, freetype and imgui from source
  add_library(qrelief_gles INTERFACE)
  add_library(qrelief_hwy INTERFACE)  # one instruction set, so there is nothing to choose at run time
else()
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(fmt REQUIRED IMPORTED_TARGET fmt)
  add_library(qrelief::fmt ALIAS PkgConfig::fmt)
  pkg_check_modules(qrencode REQUIRED IMPORTED_TARGET libqrencode)
  add_library(qrelief::qrencode ALIAS PkgConfig::qrencode)
  pkg_check_modules(zlib REQUIRED IMPORTED_TARGET zlib)
  add_library(qrelief::zlib ALIAS PkgConfig::zlib)
  pkg_check_modules(expat REQUIRED IMPORTED_TARGET expat)
  add_library(qrelief::expat ALIAS PkgConfig::expat)
  pkg_check_modules(freetype REQUIRED IMPORTED_TARGET freetype2)
  add_library(qrelief::freetype ALIAS PkgConfig::freetype)
  # libcsv comes without a .pc file.
  find_path(csv_include csv.h REQUIRED)
  find_library(csv_library csv REQUIRED)
  add_library(qrelief_csv INTERFACE)
  target_include_directories(qrelief_csv SYSTEM INTERFACE $<BUILD_INTERFACE:${csv_include}>)
  target_link_libraries(qrelief_csv INTERFACE ${csv_library})
  add_library(qrelief::csv ALIAS qrelief_csv)
  pkg_check_modules(hwy REQUIRED libhwy)
  add_library(qrelief_hwy INTERFACE)
  target_link_libraries(qrelief_hwy INTERFACE ${hwy_LIBRARIES})
  target_compile_definitions(qrelief_hwy INTERFACE HWY_SHARED_DEFINE)
  pkg_check_modules(gles REQUIRED IMPORTED_TARGET glesv2)
  pkg_check_modules(egl REQUIRED IMPORTED_TARGET egl)
  add_library(qrelief_gles INTERFACE)
  target_link_libraries(qrelief_gles INTERFACE PkgConfig::gles)
  find_package(ZXing REQUIRED)
  add_library(qrelief_zxing INTERFACE)
  target_link_libraries(qrelief_zxing INTERFACE ZXing::ZXing)
  target_compile_definitions(qrelief_zxing INTERFACE ZX_USE_UTF8)  # text() returns UTF-8, as in later releases
  add_library(qrelief::zxing ALIAS qrelief_zxing)
endif()
add_library(qrelief::gles ALIAS qrelief_gles)
add_library(qrelief::hwy ALIAS qrelief_hwy)
