// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace qrelief {

/// Facts about a model's file and about a symbol. Needs no GL context, so programs without graphics have it, too.
/// Answers have the form that Engine describes.
class Facts {
 public:
  /// Reads, checks and repairs a model and keeps nothing of it. Returns {model}: as Engine::loadModel(), without the
  /// centre, which is a place in a view.
  std::string model(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm) const;
  /// Describes the symbol for some settings, see describeSymbol.
  std::string symbol(const std::string& settings) const;
  /// Advises on a text that is, or was meant to be, a link (qr/link_advice.h). Returns {advice: [{severity: "warning"
  /// or "note", message, fixed}], shorter: [{form, text}]}.
  std::string textAdvice(const std::string& text) const;
};

}  // namespace qrelief
