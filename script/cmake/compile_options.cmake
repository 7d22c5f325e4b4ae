# SPDX-License-Identifier: GPL-3.0-or-later
# An interface target that every target of ours links, privately, so that the library's users keep their own options:
# warnings, and arithmetic that is the same everywhere.
add_library(qrelief_options INTERFACE)
target_compile_options(qrelief_options INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
  $<$<BOOL:${QRELIEF_WERROR}>:-Werror>
  -ffp-contract=off)  # fused multiply-adds would make results differ between machines
if(QRELIEF_SANITIZE OR QRELIEF_FUZZ)
  target_compile_options(qrelief_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(qrelief_options INTERFACE -fsanitize=address,undefined)
endif()
if(QRELIEF_FUZZ)
  target_compile_options(qrelief_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(EMSCRIPTEN)
  target_compile_options(qrelief_options INTERFACE -fwasm-exceptions -msimd128)
  target_link_options(qrelief_options INTERFACE -fwasm-exceptions)
else()
  target_compile_options(qrelief_options INTERFACE -frounding-math)  # CGAL's intervals switch the rounding mode
endif()
