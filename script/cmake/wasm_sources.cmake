# SPDX-License-Identifier: GPL-3.0-or-later
# qrelief::fmt, qrelief::qrencode, qrelief::zlib, qrelief::expat, qrelief::csv, qrelief::freetype and qrelief::imgui for
# WebAssembly, from the sources that script/fetch-sources puts into build/deps.
set(deps ${PROJECT_SOURCE_DIR}/build/deps)
foreach(folder fmtlib-9.1.0+ds1 qrencode-4.1.1 zlib-1.2.13.dfsg expat-2.5.0 libcsv-3.0.3+dfsg freetype-2.12.1+dfsg imgui-1.86)
  if(NOT IS_DIRECTORY ${deps}/${folder})
    message(FATAL_ERROR "build/deps/${folder} is missing: run script/setup (or script/fetch-sources alone)")
  endif()
endforeach()

set(folder ${deps}/fmtlib-9.1.0+ds1)
add_library(qrelief_fmt STATIC ${folder}/src/format.cc)
target_include_directories(qrelief_fmt SYSTEM PUBLIC ${folder}/include)
target_compile_options(qrelief_fmt PRIVATE -fwasm-exceptions -msimd128 -Oz)
add_library(qrelief::fmt ALIAS qrelief_fmt)

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
# Definitions that its configure script would put into config.h.
target_compile_definitions(qrelief_qrencode PRIVATE
  STATIC_IN_RELEASE=static HAVE_STRDUP=1 MAJOR_VERSION=4 MINOR_VERSION=1 MICRO_VERSION=1 VERSION="4.1.1")
add_library(qrelief::qrencode ALIAS qrelief_qrencode)

set(folder ${deps}/zlib-1.2.13.dfsg)
add_library(qrelief_zlib STATIC
  ${folder}/adler32.c
  ${folder}/crc32.c
  ${folder}/deflate.c
  ${folder}/inffast.c
  ${folder}/inflate.c
  ${folder}/inftrees.c
  ${folder}/trees.c
  ${folder}/zutil.c)
target_include_directories(qrelief_zlib SYSTEM PUBLIC ${folder})
target_compile_options(qrelief_zlib PRIVATE -w)  # function definitions in pre-1989 style
add_library(qrelief::zlib ALIAS qrelief_zlib)

set(folder ${deps}/expat-2.5.0/expat/lib)
add_library(qrelief_expat STATIC ${folder}/xmlparse.c ${folder}/xmlrole.c ${folder}/xmltok.c)
target_include_directories(qrelief_expat SYSTEM PUBLIC ${folder})
# Definitions that its configure script would put into expat_config.h.
target_compile_definitions(qrelief_expat PRIVATE
  BYTEORDER=1234 HAVE_MEMMOVE=1 XML_NS=1 XML_DTD=1 XML_CONTEXT_BYTES=1024 XML_POOR_ENTROPY=1)
file(WRITE ${PROJECT_BINARY_DIR}/expat/expat_config.h "")
target_include_directories(qrelief_expat PRIVATE ${PROJECT_BINARY_DIR}/expat)
target_compile_options(qrelief_expat PRIVATE -w)
add_library(qrelief::expat ALIAS qrelief_expat)

set(folder ${deps}/libcsv-3.0.3+dfsg)
add_library(qrelief_csv STATIC ${folder}/libcsv.c)
target_include_directories(qrelief_csv SYSTEM PUBLIC ${folder})
target_compile_options(qrelief_csv PRIVATE -w)
add_library(qrelief::csv ALIAS qrelief_csv)

# Only what outlines of a TrueType font take: no hinting, no bitmaps, no other formats.
set(folder ${deps}/freetype-2.12.1+dfsg)
set(config ${PROJECT_BINARY_DIR}/freetype)
file(WRITE ${config}/label_modules.h
  "FT_USE_MODULE(FT_Driver_ClassRec, tt_driver_class)\nFT_USE_MODULE(FT_Module_Class, sfnt_module_class)\n")
file(READ ${folder}/include/freetype/config/ftoption.h options)
foreach(option ENVIRONMENT_PROPERTIES USE_LZW USE_ZLIB POSTSCRIPT_NAMES ADOBE_GLYPH_LIST MAC_FONTS)
  string(REPLACE "#define FT_CONFIG_OPTION_${option}" "" options "${options}")
endforeach()
foreach(option TT_CONFIG_OPTION_EMBEDDED_BITMAPS TT_CONFIG_OPTION_COLOR_LAYERS TT_CONFIG_OPTION_BYTECODE_INTERPRETER
    TT_CONFIG_OPTION_GX_VAR_SUPPORT TT_CONFIG_OPTION_BDF TT_CONFIG_OPTION_POSTSCRIPT_NAMES)
  string(REPLACE "#define ${option}" "" options "${options}")
endforeach()
file(WRITE ${config}/label_options.h "${options}")
add_library(qrelief_freetype STATIC
  ${folder}/src/base/ftbase.c
  ${folder}/src/base/ftdebug.c
  ${folder}/src/base/ftinit.c
  ${folder}/src/base/ftsystem.c
  ${folder}/src/sfnt/sfnt.c
  ${folder}/src/truetype/truetype.c)
target_include_directories(qrelief_freetype SYSTEM PUBLIC ${folder}/include PRIVATE ${config})
target_compile_definitions(qrelief_freetype PRIVATE
  FT2_BUILD_LIBRARY FT_CONFIG_MODULES_H=<label_modules.h> FT_CONFIG_OPTIONS_H=<label_options.h>)
target_compile_options(qrelief_freetype PRIVATE -w)
add_library(qrelief::freetype ALIAS qrelief_freetype)

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
target_compile_options(qrelief_imgui PRIVATE -fwasm-exceptions -msimd128 -Oz)
add_library(qrelief::imgui ALIAS qrelief_imgui)
