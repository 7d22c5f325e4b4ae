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
    const Vec2 corner = corners[static_cast<std::size_t>(k)];
    const Vec2 inward(k == 0 || k == 3 ? radius : -radius, k < 2 ? radius : -radius);
    for (int step = 0; step <= steps; ++step) {
      const double angle = turn * (k + 2 + (steps > 0 ? static_cast<double>(step) / steps : 0));
      ring.push_back(corner + inward + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return ring;
}

void addFrame(LabelLayout& layout, const LabelOptions& label, int modules) {
  const double half = modules / 2.0, side = half + aboveModules(label), below = half + belowModules(label, modules);
  const Rectangle inner{{-side, -below}, {side, side}};
  const Rectangle outer{inner.low - kFrameModules, inner.high + kFrameModules};
  const double radius = label.frame == LabelFrame::Rounded ? kCornerModules : 0;
  layout.rings.push_back(rectangle(outer, radius));
  layout.rings.push_back(rectangle(inner, std::max(0.0, radius - kFrameModules)));
  std::reverse(layout.rings.back().begin(), layout.rings.back().end());
  // The bars include the corners, whose inner radius is less than their outer one.
  const double bar = std::max(kFrameModules, radius);
  layout.covered.push_back({outer.low, {outer.high.x, outer.low.y + bar}});
  layout.covered.push_back({{outer.low.x, outer.high.y - bar}, outer.high});
  layout.covered.push_back({outer.low, {outer.low.x + bar, outer.high.y}});
  layout.covered.push_back({{outer.high.x - bar, outer.low.y}, outer.high});
  layout.thinnestStrokeModules = kFrameModules;
}

Status addText(LabelLayout& layout, const LabelOptions& label, int modules) {
  const double highest = highestCapital(modules);
  auto text = outlineText(label.text, kToleranceModules / highest);
  if (!text) return tl::unexpected(text.error());
  if (text->rings.empty()) return badInput(message<"label-empty">());
  const double width = text->high.x - text->low.x;
  // Accents may rise above the capitals, and some characters sink below their room.
  const double rise = std::max(1.0, text->high.y), drop = std::max(kDescender, -text->low.y);
  const double room = (1 + kDescender) * highest;
  const double capital = std::min({highest, modules / width, room / (rise + drop)});
  const Vec2 centre((text->low.x + text->high.x) / 2, 0);
  const Vec2 baseline(0, -(modules / 2.0 + kQuietZoneModules + kTextGapModules) - rise * capital);
  for (Ring& ring : text->rings) {
    Rectangle box{Vec2(INFINITY), Vec2(-INFINITY)};
    for (Vec2& corner : ring) {
      corner = baseline + capital * (corner - centre);
      box = {glm::min(box.low, corner), glm::max(box.high, corner)};
    }
    layout.covered.push_back(box);
    layout.rings.push_back(std::move(ring));
  }
  layout.capitalModules = capital;
  const double stroke = thinnestStroke() * capital;
  layout.thinnestStrokeModules =
      layout.thinnestStrokeModules > 0 ? std::min(layout.thinnestStrokeModules, stroke) : stroke;
  return {};
}

}  // namespace

const char* labelFrameName(LabelFrame frame) {
  constexpr std::array kNames = {"none", "rounded", "square"};
  return kNames[static_cast<std::size_t>(frame)];
}

double labelMarginModules(const LabelOptions& label, int modules) {
  if (label.empty()) return 0;
  const double frame = label.frame == LabelFrame::None ? 0 : kFrameModules;
  return belowModules(label, modules) + frame + kBorderModules;
}

Result<LabelLayout> layOutLabel(const LabelOptions& label, int modules) {
  LabelLayout layout;
  if (label.frame != LabelFrame::None) addFrame(layout, label, modules);
  if (!label.text.empty())
    if (const Status added = addText(layout, label, modules); !added) return tl::unexpected(added.error());
  return layout;
}

double leastCapitalMm(double lineMm) { return lineMm / thinnestStroke(); }

}  // namespace qrelief
