# SPDX-License-Identifier: GPL-3.0-or-later
# embed_label_font(TARGET): compiles the font of labels into TARGET as `qrelief::kLabelFont` and its kerning beside it,
# declared in "label_font.h". Run as a script (OUT = folder, FONT = file), writes the two files.
#
# The font has only what outlines take: no hinting, no names, no features. Its pairs of kerning are three columns, since
# a download packs them to a seventh of the size of rows.
set(EMBED_LABEL_FONT_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(embed_label_font target)
  find_file(QRELIEF_LABEL_FONT OpenSans-Bold.ttf PATHS /usr/share/fonts/truetype/open-sans NO_DEFAULT_PATH
    NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  set(out ${PROJECT_BINARY_DIR}/generated)
  add_custom_command(
    OUTPUT ${out}/label_font.h ${out}/label_font.cpp
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DFONT=${QRELIEF_LABEL_FONT} -P ${EMBED_LABEL_FONT_SCRIPT}
    DEPENDS ${QRELIEF_LABEL_FONT} ${EMBED_LABEL_FONT_SCRIPT}
    VERBATIM)
  target_sources(${target} PRIVATE ${out}/label_font.h ${out}/label_font.cpp)
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE)
  return()
endif()

# Returns bytes as hex digits.
function(cut out hex begin bytes)
  math(EXPR begin "2 * ${begin}")
  math(EXPR digits "2 * ${bytes}")
  string(SUBSTRING "${hex}" ${begin} ${digits} cut)
  set(${out} "${cut}" PARENT_SCOPE)
endfunction()

# Returns an unsigned number of a few bytes.
function(number out hex begin bytes)
  cut(digits "${hex}" ${begin} ${bytes})
  math(EXPR number "0x${digits}")
  set(${out} ${number} PARENT_SCOPE)
endfunction()

# Returns a number as that many bytes.
function(bytes_of out number bytes)
  math(EXPR digits "2 * ${bytes}")
  math(EXPR padded "(1 << (8 * ${bytes})) + ${number}" OUTPUT_FORMAT HEXADECIMAL)
  string(SUBSTRING "${padded}" 3 ${digits} digits)
  set(${out} ${digits} PARENT_SCOPE)
endfunction()

file(READ ${FONT} font HEX)
number(count "${font}" 4 2)
foreach(table RANGE 1 ${count})
  math(EXPR entry "16 * ${table} - 4")
  cut(tag "${font}" ${entry} 4)
  math(EXPR at "${entry} + 8")
  number(offset "${font}" ${at} 4)
  math(EXPR at "${entry} + 12")
  number(length "${font}" ${at} 4)
  cut(table_${tag} "${font}" ${offset} ${length})
endforeach()
# cmap, glyf, head, hhea, hmtx, loca, maxp
set(kept 636d6170 676c7966 68656164 68686561 686d7478 6c6f6361 6d617870)
set(glyf "${table_676c7966}")
set(loca "${table_6c6f6361}")

# Drop the instructions of simple glyphs. A glyph begins with the count of its contours and its box (10 bytes), the last
# point of each contour, and the length of the instructions.
number(has_long_offsets "${table_68656164}" 50 2)
number(glyphs "${table_6d617870}" 4 2)
number(kern_tables "${table_6b65726e}" 2 2)
number(kern_format "${table_6b65726e}" 8 2)
if(has_long_offsets OR NOT kern_tables EQUAL 1 OR NOT kern_format EQUAL 1)
  message(FATAL_ERROR "${FONT} has tables of other formats: adapt ${CMAKE_CURRENT_LIST_FILE}")
endif()
set(table_676c7966 "")
set(table_6c6f6361 0000)
set(end 0)
math(EXPR last "${glyphs} - 1")
set(next 0)
foreach(glyph RANGE ${last})
  set(begin ${next})
  math(EXPR entry "2 * ${glyph} + 2")
  number(next "${loca}" ${entry} 2)
  math(EXPR length "2 * (${next} - ${begin})")
  if(length GREATER 0)
    math(EXPR begin "2 * ${begin}")
    cut(outline "${glyf}" ${begin} ${length})
    number(contours "${outline}" 0 2)
    if(contours LESS 32768)  # else composed of other glyphs
      math(EXPR instructions "10 + 2 * ${contours}")
      number(dropped "${outline}" ${instructions} 2)
      cut(head "${outline}" 0 ${instructions})
      math(EXPR points "${instructions} + 2 + ${dropped}")
      math(EXPR length "${length} - ${points}")
      cut(points "${outline}" ${points} ${length})
      set(outline "${head}0000${points}")
      math(EXPR length "${length} + ${instructions} + 2")
      math(EXPR is_odd "${length} % 2")
      if(is_odd)
        string(APPEND outline 00)
        math(EXPR length "${length} + 1")
      endif()
    endif()
    string(APPEND table_676c7966 "${outline}")
    math(EXPR end "${end} + ${length} / 2")
  endif()
  bytes_of(offset ${end} 2)
  string(APPEND table_6c6f6361 ${offset})
endforeach()

# FreeType reads neither checksums nor the sizes for a binary search of the directory.
list(LENGTH kept count)
bytes_of(digits ${count} 2)
set(directory "00010000${digits}000000000000")
set(tables "")
math(EXPR end "12 + 16 * ${count}")
foreach(tag ${kept})
  string(LENGTH "${table_${tag}}" length)
  math(EXPR length "${length} / 2")
  bytes_of(offset ${end} 4)
  bytes_of(digits ${length} 4)
  string(APPEND directory "${tag}00000000${offset}${digits}")
  string(APPEND tables "${table_${tag}}")
  math(EXPR end "${end} + ${length}")
  math(EXPR padding "-${length} & 3")
  string(REPEAT 00 ${padding} padding_bytes)
  string(APPEND tables "${padding_bytes}")
  math(EXPR end "${end} + ${padding}")
endforeach()

# A pair: left glyph, right glyph, signed kerning; sorted.
number(pairs "${table_6b65726e}" 10 2)
math(EXPR length "6 * ${pairs}")
cut(kern "${table_6b65726e}" 18 ${length})
string(REGEX REPLACE "(....)(....)(....)" "0x\\1," lefts "${kern}")
string(REGEX REPLACE "(....)(....)(....)" "0x\\2," rights "${kern}")
string(REGEX REPLACE "(....)(....)(....)" "0x\\3," units "${kern}")
string(REGEX REPLACE "(..)" "0x\\1," bytes "${directory}${tables}")
string(REPEAT "." 105 line)  # whole literals of either length
foreach(list lefts rights units bytes)
  string(REGEX REPLACE "(${line})" "\\1\n" ${list} "${${list}}")
endforeach()

file(WRITE ${OUT}/label_font.h "// Generated by script/cmake/embed_label_font.cmake
#pragma once

#include <cstddef>
#include <cstdint>

namespace qrelief {

extern const unsigned char kLabelFont[];
extern const std::size_t kLabelFontBytes;

/// Pairs of glyphs that are kerned, sorted by the left one, then by the right one.
inline constexpr std::size_t kKernedPairs = ${pairs};
extern const std::uint16_t kKernedLeft[kKernedPairs];
extern const std::uint16_t kKernedRight[kKernedPairs];
/// By how much the right glyph moves, font units, as the bits of a signed number.
extern const std::uint16_t kKerning[kKernedPairs];

}  // namespace qrelief
")
file(WRITE ${OUT}/label_font.cpp "// Generated by script/cmake/embed_label_font.cmake
#include \"label_font.h\"

namespace qrelief {

const unsigned char kLabelFont[] = {
${bytes}
};
const std::size_t kLabelFontBytes = sizeof(kLabelFont);
const std::uint16_t kKernedLeft[kKernedPairs] = {
${lefts}
};
const std::uint16_t kKernedRight[kKernedPairs] = {
${rights}
};
const std::uint16_t kKerning[kKernedPairs] = {
${units}
};

}  // namespace qrelief
")
