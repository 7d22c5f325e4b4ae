// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include "base/grid.h"
#include "base/result.h"

namespace qrelief {

enum class ErrorCorrection : std::uint8_t { L, M, Q, H };  ///< restores about 7, 15, 25, 30 % of the codewords

/// Convert a level to "L", "M", "Q" or "H", and back; empty if there is no such level.
std::string_view errorCorrectionName(ErrorCorrection level);
std::optional<ErrorCorrection> errorCorrectionByName(std::string_view name);

/// Function of a module [ISO/IEC 18004, figure 2]. Data includes error correction and remainder bits. Format includes
/// the module next to the lower left finder that is always dark.
enum class ModuleRole : std::uint8_t { Data, Finder, Separator, Timing, Alignment, Format, Version };

/// Rule that chooses the mask.
enum class MaskRule : std::uint8_t {
  Standard,  ///< by the penalties of the standard [ISO/IEC 18004, 7.8.3]
  Shadiest,  ///< the mask whose dark modules would see the least sky (qr/symbol_shaping.h)
  Fixed      ///< the requested mask
};

/// Whether a symbol names the character set of its text, as ECI 26: UTF-8 (docs/decisions/0049).
enum class EciUse : std::uint8_t {
  Auto,  ///< if the text goes beyond ASCII
  Never  ///< for scanners that print the ECI, and old decoders that refuse it
};

/// Returns "auto" or "never".
const char* eciUseName(EciUse use);

/// Returns true if a symbol of the text begins with an ECI.
bool hasEci(std::string_view text, EciUse use);

struct SymbolOptions {
  ErrorCorrection errorCorrection = ErrorCorrection::M;
  std::optional<int> version = std::nullopt;  ///< 1 … 40; empty: the smallest that holds the text
  bool raiseErrorCorrection = false;          ///< raise it to the highest level that needs no larger version
  MaskRule maskRule = MaskRule::Standard;
  int mask = 0;  ///< Fixed: 0 … 7
  EciUse eci = EciUse::Auto;

  bool operator==(const SymbolOptions&) const = default;
};

/// A QR Code symbol without quiet zone: `size × size` modules.
struct Symbol {
  int version = 1;  ///< 1 … 40; 0: blankSymbol()
  ErrorCorrection errorCorrection = ErrorCorrection::M;
  int mask = 0;             ///< 0 … 7, as in the format information
  bool hasEci = false;      ///< the text's character set is named, as ECI 26
  int size = 21;            ///< 17 + 4·version
  Grid<std::uint8_t> dark;  ///< 1 = dark
  Grid<ModuleRole> roles;
  Grid<std::uint8_t> flipped;  ///< 1 = made light on purpose, for decoders to restore; empty = none

  bool isDark(int row, int column) const { return dark.at(row, column) != 0; }
  ModuleRole role(int row, int column) const { return roles.at(row, column); }
};

/// Quiet zone that the standard requires on each side, in modules.
inline constexpr int kQuietZoneModules = 4;

/// Encodes a text as UTF-8 bytes, which an ECI announces if they are not ASCII [ISO/IEC 18004, by libqrencode]. Digits
/// and capitals get their shorter modes where that saves bits (qr/segmentation.h), so the symbol is the smallest that
/// the standard allows.
///
/// Cost: milliseconds.
/// @param text  not empty, valid UTF-8, without NUL
/// @returns BadInput if the text is empty, not UTF-8, or too long for the requested version and level (the error gives
///          its length and a symbol that holds it); BadUsage if there is no such version or mask
Result<Symbol> encodeSymbol(std::string_view text, const SymbolOptions& options = {});

/// Returns a square of light modules, for a text in place of a code.
Symbol blankSymbol();

/// Cache of the smallest version that holds a text, by the bits that the text's segments take.
/// Cost: microseconds per text, milliseconds for a new number of bits.
class VersionsByLength {
 public:
  explicit VersionsByLength(ErrorCorrection level, EciUse eci = EciUse::Auto) : level_(level), eci_(eci) {}

  /// Returns the smallest version that holds the text; 0: none does.
  /// @param text  as for encodeSymbol()
  int smallest(std::string_view text);

 private:
  ErrorCorrection level_;
  EciUse eci_;
  std::map<std::array<int, 3>, int> known_;  ///< keys: bits in each group of versions with the same length fields
};

}  // namespace qrelief
