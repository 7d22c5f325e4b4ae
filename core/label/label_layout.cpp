// SPDX-License-Identifier: GPL-3.0-or-later
#include "label/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "message_codes/text.h"
#include "qr/symbol.h"

namespace qrelief {
namespace {

constexpr double kCapitalFraction = 1.0 / 8;  // of the symbol's edge
constexpr double kDescender = 0.35;           // room below the baseline, in capital heights
constexpr double kTextGapModules = 0.5;       // between quiet zone and text
constexpr double kFrameGapModules = 0.5;      // between quiet zone or text and frame
constexpr double kFrameModules = 1;           // width of the frame's line
constexpr double kCornerModules = 2.5;        // outer radius of a rounded frame; its inside clears the quiet zone
constexpr double kToleranceModules = 0.01;    // of chords: a hundredth of a millimetre in modules of one
constexpr double kBorderModules = 1;          // material outside the label, for a wall next to its pockets

// Of a text alone, in capital heights.
constexpr double kLinePitch = 1.6;        // from baseline to baseline
constexpr double kLineGap = 0.2;          // least distance of letters in two lines
constexpr double kTextFrameGap = 0.5;     // between text and frame
constexpr double kTextFrameRadius = 0.6;  // outer radius of a rounded frame
constexpr double kRoughTolerance = 0.01;  // of chords, to measure a text before its size is known

double highestCapital(int modules) { return kCapitalFraction * modules; }

/// Returns the distance from the symbol to the frame's inner edge, or to the end of quiet zone and text if there is no
/// frame: above and at the sides, or below.
double aboveModules(const LabelOptions& label) {
  return kQuietZoneModules + (label.frame == LabelFrame::None ? 0 : kFrameGapModules);
}
double belowModules(const LabelOptions& label, int modules) {
  const double text = label.text.empty() ? 0 : kTextGapModules + (1 + kDescender) * highestCapital(modules);
  return aboveModules(label) + text;
}

/// Returns an anticlockwise rectangle. @param radius  of its corners, 0: square
Ring rectangle(const Rectangle& box, double radius) {
  Ring ring;
  const double turn = std::numbers::pi / 2;
  const int steps =
      radius > 0 ? static_cast<int>(std::ceil(turn / (2 * std::acos(1 - kToleranceModules / radius)))) : 0;
  const std::array<Vec2, 4> corners = {box.low, Vec2(box.high.x, box.low.y), box.high, Vec2(box.low.x, box.high.y)};
  for (int k = 0; k < 4; ++k) {
    const Vec2 corner = corners[k];
    const Vec2 inward(k == 0 || k == 3 ? radius : -radius, k < 2 ? radius : -radius);
    for (int step = 0; step <= steps; ++step) {
      const double angle = turn * (k + 2 + (steps > 0 ? static_cast<double>(step) / steps : 0));
      ring.push_back(corner + inward + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return ring;
}

/// @param width   of the frame's line
/// @param radius  of its outer corners, 0: square
void addFrame(LabelLayout& layout, const Rectangle& inner, double width, double radius) {
  const Rectangle outer{inner.low - width, inner.high + width};
  layout.rings.push_back(rectangle(outer, radius));
  layout.rings.push_back(rectangle(inner, std::max(0.0, radius - width)));
  std::reverse(layout.rings.back().begin(), layout.rings.back().end());
  // The bars include the corners, whose inner radius is less than their outer one.
  const double bar = std::max(width, radius);
  layout.covered.push_back({outer.low, {outer.high.x, outer.low.y + bar}});
  layout.covered.push_back({{outer.low.x, outer.high.y - bar}, outer.high});
  layout.covered.push_back({outer.low, {outer.low.x + bar, outer.high.y}});
  layout.covered.push_back({{outer.high.x - bar, outer.low.y}, outer.high});
  layout.thinnestStrokeModules = width;
}

void addFrameOfCode(LabelLayout& layout, const LabelOptions& label, int modules) {
  const double half = modules / 2.0, side = half + aboveModules(label), below = half + belowModules(label, modules);
  addFrame(layout, {{-side, -below}, {side, side}}, kFrameModules,
           label.frame == LabelFrame::Rounded ? kCornerModules : 0);
}

/// Adds letters. @param capital  their capital height, modules
void addLetters(LabelLayout& layout, TextOutline text, Vec2 origin, double capital) {
  for (Ring& ring : text.rings) {
    Rectangle box{Vec2(INFINITY), Vec2(-INFINITY)};
    for (Vec2& corner : ring) {
      corner = origin + capital * corner;
      box = {glm::min(box.low, corner), glm::max(box.high, corner)};
    }
    layout.covered.push_back(box);
    layout.rings.push_back(std::move(ring));
  }
  layout.capitalModules = capital;
  const double stroke = thinnestStroke() * capital;
  layout.thinnestStrokeModules =
      layout.thinnestStrokeModules > 0 ? std::min(layout.thinnestStrokeModules, stroke) : stroke;
}

Status addText(LabelLayout& layout, const LabelOptions& label, int modules) {
  if (label.text.find('\n') != label.text.npos) return badInput(message<"label-has-lines">());
  const double highest = highestCapital(modules);
  auto text = outlineText(label.text, kToleranceModules / highest);
  QRELIEF_TRY(text);
  if (text->rings.empty()) return badInput(message<"label-empty">());
  const double width = text->high.x - text->low.x;
  // Accents may rise above the capitals, and some characters sink below their room.
  const double rise = std::max(1.0, text->high.y), drop = std::max(kDescender, -text->low.y);
  const double room = (1 + kDescender) * highest;
  const double capital = std::min({highest, modules / width, room / (rise + drop)});
  const double middle = (text->low.x + text->high.x) / 2;
  addLetters(layout, std::move(*text),
             {-capital * middle, -(modules / 2.0 + kQuietZoneModules + kTextGapModules) - rise * capital}, capital);
  return {};
}

/// Splits a text at its line ends.
std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  for (;;) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    if (end == text.npos) return lines;
    text.remove_prefix(end + 1);
  }
}

/// Outlines lines of text below each other, centred. The origin is the middle of their box.
Result<TextOutline> outlineLines(std::string_view text, double tolerance) {
  TextOutline block{{}, Vec2(INFINITY), Vec2(-INFINITY)};
  double baseline = 0, lowest = INFINITY;  // of the letters so far
  for (const std::string_view line : linesOf(text)) {
    auto outline = outlineText(line, tolerance);
    if (!outline) return outline;
    const double middle = (outline->low.x + outline->high.x) / 2;
    if (!outline->rings.empty()) baseline = std::min(baseline, lowest - kLineGap - outline->high.y);
    for (Ring& ring : outline->rings) {
      for (Vec2& corner : ring) {
        corner += Vec2(-middle, baseline);
        block.low = glm::min(block.low, corner);
        block.high = glm::max(block.high, corner);
      }
      block.rings.push_back(std::move(ring));
    }
    lowest = block.low.y;
    baseline -= kLinePitch;
  }
  if (block.rings.empty()) return badInput(message<"text-alone-empty">());
  const Vec2 centre = (block.low + block.high) / 2.0;
  for (Ring& ring : block.rings)
    for (Vec2& corner : ring) corner -= centre;
  block.low -= centre;
  block.high -= centre;
  return block;
}

/// Lays out a text alone within the symbol's square.
Result<LabelLayout> layOutTextAlone(const LabelOptions& label, int modules) {
  const bool isFramed = label.frame != LabelFrame::None;
  const double frameWidth = thinnestStroke();
  const auto capitalFor = [&](const TextOutline& block) {
    const Vec2 size = block.high - block.low + (isFramed ? 2 * (kTextFrameGap + frameWidth) : 0);
    return modules / std::max(size.x, size.y);
  };
  const auto rough = outlineLines(label.text, kRoughTolerance);
  QRELIEF_TRY(rough);
  auto block = outlineLines(label.text, kToleranceModules / capitalFor(*rough));
  QRELIEF_TRY(block);
  const double capital = capitalFor(*block);
  LabelLayout layout;
  if (isFramed)
    addFrame(layout, {capital * (block->low - kTextFrameGap), capital * (block->high + kTextFrameGap)},
             frameWidth * capital, label.frame == LabelFrame::Rounded ? kTextFrameRadius * capital : 0);
  addLetters(layout, std::move(*block), Vec2(0), capital);
  return layout;
}

}  // namespace

const char* labelFrameName(LabelFrame frame) {
  constexpr std::array kNames = {"none", "rounded", "square"};
  return kNames[static_cast<std::size_t>(frame)];
}

double labelMarginModules(const LabelOptions& label, int modules) {
  if (label.empty() || label.isAlone) return 0;
  const double frame = label.frame == LabelFrame::None ? 0 : kFrameModules;
  return belowModules(label, modules) + frame + kBorderModules;
}

Result<LabelLayout> layOutLabel(const LabelOptions& label, int modules) {
  if (label.isAlone) return layOutTextAlone(label, modules);
  LabelLayout layout;
  if (label.frame != LabelFrame::None) addFrameOfCode(layout, label, modules);
  if (!label.text.empty()) QRELIEF_TRY(addText(layout, label, modules));
  return layout;
}

double leastCapitalMm(double lineMm) { return lineMm / thinnestStroke(); }

}  // namespace qrelief
