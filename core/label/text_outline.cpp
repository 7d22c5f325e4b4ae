// SPDX-License-Identifier: GPL-3.0-or-later
#include "label/text_outline.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "base/unicode.h"
#include "base/utf8.h"
#include "label_font.h"
#include "message_codes/text.h"
#include "projection/plane_shapes.h"

namespace qrelief {
namespace {

/// The font, opened. Everything is in font units.
class Font {
 public:
  Font() {
    FT_Library library = nullptr;
    [[maybe_unused]] int failed = FT_Init_FreeType(&library);
    assert(!failed);
    library_.reset(library);
    FT_Face face = nullptr;
    failed = FT_New_Memory_Face(library, kLabelFont, static_cast<FT_Long>(kLabelFontBytes), 0, &face);
    assert(!failed);
    face_.reset(face);
  }

  FT_UInt glyph(char32_t character) const { return FT_Get_Char_Index(face_.get(), character); }

  /// Loads a glyph. The outline is valid until the next call.
  FT_GlyphSlot load(FT_UInt glyph) const {
    [[maybe_unused]] const int failed = FT_Load_Glyph(face_.get(), glyph, FT_LOAD_NO_SCALE);
    assert(!failed);
    return face_->glyph;
  }

  /// Returns by how much the right glyph moves.
  static double kerning(FT_UInt left, FT_UInt right) {
    const auto [begin, end] = std::equal_range(std::begin(kKernedLeft), std::end(kKernedLeft), left);
    const auto* first = kKernedRight + (begin - kKernedLeft);
    const auto* last = kKernedRight + (end - kKernedLeft);
    const auto* found = std::lower_bound(first, last, right);
    return found == last || *found != right ? 0 : static_cast<std::int16_t>(kKerning[found - kKernedRight]);
  }

  double capitalHeight() const {
    FT_BBox box;
    FT_Outline_Get_CBox(&load(glyph(U'H'))->outline, &box);
    return static_cast<double>(box.yMax);
  }

 private:
  struct Close {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
  };
  std::unique_ptr<std::remove_pointer_t<FT_Library>, Close> library_;
  std::unique_ptr<std::remove_pointer_t<FT_Face>, Close> face_;
};

/// Collects the curves of a glyph as polygons.
struct Flattened {
  std::vector<Ring> rings;
  double tolerance = 1;

  static Flattened& of(void* user) { return *static_cast<Flattened*>(user); }
  static Vec2 at(const FT_Vector* v) { return {static_cast<double>(v->x), static_cast<double>(v->y)}; }

  void to(Vec2 p) {
    if (rings.back().empty() || rings.back().back() != p) rings.back().push_back(p);
  }

  /// Adds a curve in equal steps of its parameter. A chord of step h is at most h²/8 of the greatest second derivative
  /// away.
  template <class Curve>
  void curve(double secondDerivative, Curve at) {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::sqrt(secondDerivative / (8 * tolerance)))));
    for (int k = 1; k <= steps; ++k) to(at(static_cast<double>(k) / steps));
  }

  static int moveTo(const FT_Vector* p, void* user) {
    of(user).rings.push_back({at(p)});
    return 0;
  }
  static int lineTo(const FT_Vector* p, void* user) {
    of(user).to(at(p));
    return 0;
  }
  static int conicTo(const FT_Vector* control, const FT_Vector* end, void* user) {
    const Vec2 a = of(user).rings.back().back(), b = at(control), c = at(end);
    of(user).curve(2 * glm::length(a - 2.0 * b + c),
                   [&](double t) { return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c; });
    return 0;
  }
  static int cubicTo(const FT_Vector* first, const FT_Vector* second, const FT_Vector* end, void* user) {
    const Vec2 a = of(user).rings.back().back(), b = at(first), c = at(second), d = at(end);
    of(user).curve(6 * std::max(glm::length(a - 2.0 * b + c), glm::length(b - 2.0 * c + d)), [&](double t) {
      const double s = 1 - t;
      return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
    });
    return 0;
  }
};

struct Side {
  Vec2 from, to;
  std::vector<std::pair<double, Vec2>> cuts = {};  ///< where other sides cross it: fraction of the way, and point
};

/// Cuts two sides where they cross.
void cutEachOther(Side& s, Side& t) {
  const Vec2 alongS = s.to - s.from, alongT = t.to - t.from;
  const double turn = cross2(alongS, alongT);
  if (turn == 0) return;
  const double atS = cross2(t.from - s.from, alongT) / turn, atT = cross2(t.from - s.from, alongS) / turn;
  if (atS <= 0 || atS >= 1 || atT <= 0 || atT >= 1) return;
  const Vec2 at = s.from + atS * alongS;
  s.cuts.emplace_back(atS, at);
  t.cuts.emplace_back(atT, at);
}

int windingNumber(Vec2 p, const std::vector<Side>& sides) {
  int winding = 0;
  for (const Side& side : sides) {
    const bool isBelow = side.from.y <= p.y;
    if (isBelow == (side.to.y <= p.y)) continue;
    if ((cross2(side.to - side.from, p - side.from) > 0) == isBelow) winding += isBelow ? 1 : -1;
  }
  return winding;
}

/// Joins the parts of a glyph that overlap, such as a letter and its cedilla: cuts all sides where they cross, and
/// keeps the pieces with the fill on one side only. Cost: O(sides²).
std::vector<Ring> united(std::vector<Ring> rings) {
  std::vector<Side> sides;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) cutEachOther(sides[i], sides[j]);
  if (std::all_of(sides.begin(), sides.end(), [](const Side& side) { return side.cuts.empty(); })) return rings;

  constexpr double kNextTo = 0.01;  // in font units: far less than any stroke
  const auto key = [](Vec2 p) { return std::pair(p.x, p.y); };
  std::map<std::pair<double, double>, Vec2> next;
  for (Side& side : sides) {
    std::sort(side.cuts.begin(), side.cuts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    side.cuts.emplace_back(1, side.to);
    Vec2 from = side.from;
    for (const auto& [fraction, to] : side.cuts) {
      const Vec2 along = glm::normalize(to - from), left(-along.y, along.x), middle = (from + to) / 2.0;
      if (windingNumber(middle + kNextTo * left, sides) != 0 && windingNumber(middle - kNextTo * left, sides) == 0)
        next[key(from)] = to;
      from = to;
    }
  }
  std::vector<Ring> outlines;
  while (!next.empty()) {
    Ring ring;
    for (auto piece = next.begin(); piece != next.end(); piece = next.find(key(ring.back()))) {
      ring.push_back(piece->second);
      next.erase(piece);
    }
    outlines.push_back(std::move(ring));
  }
  return outlines;
}

/// Returns the rings of a glyph, filled on their left.
std::vector<Ring> ringsOf(FT_Outline& outline, double tolerance) {
  Flattened flat{{}, tolerance};
  const FT_Outline_Funcs functions{
      &Flattened::moveTo, &Flattened::lineTo, &Flattened::conicTo, &Flattened::cubicTo, 0, 0};
  FT_Outline_Decompose(&outline, &functions, &flat);
  const bool isFilledRight = FT_Outline_Get_Orientation(&outline) == FT_ORIENTATION_FILL_RIGHT;
  for (Ring& ring : flat.rings) {
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    if (isFilledRight) std::reverse(ring.begin(), ring.end());
  }
  std::erase_if(flat.rings, [](const Ring& ring) { return ring.size() < 3; });
  return united(std::move(flat.rings));
}

double ringDistance(const Ring& a, const Ring& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      least = std::min(least, distanceBetween(Segment2{a[i], a[(i + 1) % a.size()]}, {b[j], b[(j + 1) % b.size()]}));
  return least;
}

/// Moves a glyph to the right until it is clear of the one before: kerned pairs, such as VV, may touch.
/// @returns the distance
double spaced(std::span<const Ring> before, std::vector<Ring>& rings) {
  constexpr double kGap = 0.1, kEnough = 0.999 * kGap;
  double moved = 0;
  for (;;) {
    double least = kGap;
    for (const Ring& a : before)
      for (const Ring& b : rings) least = std::min(least, ringDistance(a, b));
    if (least >= kEnough) return moved;
    for (Ring& ring : rings)
      for (Vec2& corner : ring) corner.x += kGap - least;
    moved += kGap - least;
  }
}

char32_t decoded(std::string_view sequence) {
  const auto lead = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return lead;
  char32_t character = lead & (0x7Fu >> sequence.size());
  for (const char byte : sequence.substr(1)) character = character << 6 | (static_cast<unsigned char>(byte) & 0x3Fu);
  return character;
}

/// Returns true for characters that leave no mark of their own: controls, spaces, joiners, and selectors of variants.
bool isInvisible(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || isSpace(c) || isUnseen(c) || (c >= 0xFE00 && c <= 0xFE0F);
}

/// Returns a character to be shown: itself, or "U+0009" if it is invisible.
std::string named(std::string_view sequence) {
  const char32_t character = decoded(sequence);
  return isInvisible(character) ? fmt::format("U+{:04X}", static_cast<std::uint32_t>(character))
                                : std::string(sequence);
}

/// Splits a text into glyphs. @returns BadInput, see outlineText()
Result<std::vector<FT_UInt>> glyphsOf(std::string_view text, const Font& font) {
  if (const std::size_t byte = firstNoUtf8(text); byte != std::string_view::npos)
    return badInput(message<"text-no-utf8">(with::index<"byte">(byte)));
  std::vector<FT_UInt> glyphs;
  std::set<std::string_view> known;
  std::string lacking;
  while (!text.empty()) {
    const std::string_view sequence = text.substr(0, utf8SequenceLength(text));
    text.remove_prefix(sequence.size());
    glyphs.push_back(font.glyph(decoded(sequence)));
    if (glyphs.back() != 0 || !known.insert(sequence).second) continue;
    lacking += (lacking.empty() ? "" : " ") + named(sequence);
  }
  if (!lacking.empty()) return badInput(message<"label-lacks-characters">(with::quoted<"characters">(lacking)));
  return glyphs;
}

}  // namespace

double thinnestStroke() {
  const Font font;
  // The corners of an H lie at four heights: foot, both edges of the bar, and top.
  std::set<double> heights;
  for (const Ring& ring : ringsOf(font.load(font.glyph(U'H'))->outline, 1))
    for (const Vec2 corner : ring) heights.insert(corner.y);
  assert(heights.size() == 4);
  return (*std::next(heights.begin(), 2) - *std::next(heights.begin())) / *heights.rbegin();
}

Result<TextOutline> outlineText(std::string_view text, double tolerance) {
  const Font font;
  const std::string characters = composed(text);  // the font has ü, but not u and U+0308
  const auto glyphs = glyphsOf(characters, font);
  QRELIEF_TRY(glyphs);
  const double capital = font.capitalHeight();
  TextOutline result;
  std::size_t firstOfLast = 0;  // ring of the glyph before
  Vec2 low(std::numeric_limits<double>::infinity()), high(-low);
  double pen = 0;
  for (std::size_t i = 0; i < glyphs->size(); ++i) {
    if (i > 0) pen += Font::kerning((*glyphs)[i - 1], (*glyphs)[i]);
    FT_GlyphSlot slot = font.load((*glyphs)[i]);
    const auto advance = static_cast<double>(slot->metrics.horiAdvance);
    std::vector<Ring> rings = ringsOf(slot->outline, tolerance * capital);
    for (Ring& ring : rings)
      for (Vec2& corner : ring) corner = (corner + Vec2(pen, 0)) / capital;
    const double moved = spaced(std::span(result.rings).subspan(firstOfLast), rings);
    pen += moved * capital;
    if (!rings.empty()) firstOfLast = result.rings.size();
    for (Ring& ring : rings) {
      for (const Vec2 corner : ring) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
      }
      result.rings.push_back(std::move(ring));
    }
    pen += advance;
  }
  if (!result.rings.empty()) {
    result.low = low;
    result.high = high;
  }
  return result;
}

}  // namespace qrelief
