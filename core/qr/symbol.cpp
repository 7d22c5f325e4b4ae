// SPDX-License-Identifier: GPL-3.0-or-later
#include "qr/symbol.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <memory>
#include <qrencode.h>
#include <string>

#include "base/unicode.h"
#include "base/utf8.h"
#include "message_codes/text.h"
#include "qr/segmentation.h"
#include "qr/symbol_shaping.h"

namespace qrelief {
namespace {

constexpr int kLargestVersion = 40;
constexpr std::size_t kMostCharacters = 7089;  ///< digits in version 40-L, the most that any symbol holds

// Flags of a module in the output of libqrencode.
constexpr unsigned kDarkBit = 1, kFormatBit = 4, kVersionBit = 8, kTimingBit = 16, kAlignmentBit = 32,
                   kFinderOrSeparatorBit = 64, kFunctionBit = 128;

using InputHandle = std::unique_ptr<QRinput, decltype(&QRinput_free)>;
using CodeHandle = std::unique_ptr<QRcode, decltype(&QRcode_free)>;

Status checkCharacters(std::string_view text) {
  if (text.empty()) return badInput(message<"text-empty">());
  if (text.size() <= kMostCharacters && isBlank(text)) return badInput(message<"text-unseen">());
  const std::size_t nul = text.find('\0'), broken = firstNoUtf8(text);
  if (nul < broken) return badInput(message<"text-holds-nul">(with::index<"byte">(nul + 1)));
  if (broken != text.npos) return badInput(message<"text-no-utf8">(with::index<"byte">(broken + 1)));
  return {};
}

QRecLevel toLibrary(ErrorCorrection level) {
  switch (level) {
    case ErrorCorrection::L:
      return QR_ECLEVEL_L;
    case ErrorCorrection::M:
      return QR_ECLEVEL_M;
    case ErrorCorrection::Q:
      return QR_ECLEVEL_Q;
    case ErrorCorrection::H:
      return QR_ECLEVEL_H;
  }
  return QR_ECLEVEL_M;
}

constexpr std::array kLevels = {ErrorCorrection::L, ErrorCorrection::M, ErrorCorrection::Q, ErrorCorrection::H};

/// The parts of SymbolOptions that the bits of a text depend on.
struct Coding {
  ErrorCorrection level = ErrorCorrection::M;
  EciUse eci = EciUse::Auto;
};

/// Encodes the text in the segments that suit `version`. Returns the smallest symbol from `version` on that holds them;
/// null if there is none (errno is ERANGE then).
CodeHandle encodeFrom(std::string_view text, int version, Coding coding) {
  constexpr unsigned kUtf8 = 26;
  InputHandle input(QRinput_new2(version, toLibrary(coding.level)), &QRinput_free);
  if (!input) return {nullptr, &QRcode_free};
  if (hasEci(text, coding.eci) && QRinput_appendECIheader(input.get(), kUtf8) != 0) return {nullptr, &QRcode_free};
  for (const Segment& segment : segmentText(text, version)) {
    constexpr std::array<QRencodeMode, 3> kLibraryModes = {QR_MODE_NUM, QR_MODE_AN, QR_MODE_8};
    const auto* bytes = reinterpret_cast<const unsigned char*>(text.data() + segment.begin);
    const auto mode = kLibraryModes[static_cast<std::size_t>(segment.mode)];
    if (QRinput_append(input.get(), mode, static_cast<int>(segment.length), bytes) != 0) return {nullptr, &QRcode_free};
  }
  return {QRcode_encodeInput(input.get()), &QRcode_free};
}

/// Returns the last version with the same length fields. The best segments change with them, at versions 10 and 27.
int lastVersionOfGroup(int version) { return version < 10 ? 9 : version < 27 ? 26 : kLargestVersion; }

/// Encodes the text in the smallest symbol of at least version `from`; null as in encodeFrom.
CodeHandle encodeSmallest(std::string_view text, int from, Coding coding) {
  CodeHandle code = encodeFrom(text, from, coding);
  const int last = lastVersionOfGroup(from);
  const bool outgrewGroup = code ? code->version > last : errno == ERANGE;
  return outgrewGroup && last < kLargestVersion ? encodeSmallest(text, last + 1, coding) : std::move(code);
}

int smallestVersion(std::string_view text, Coding coding) {
  const CodeHandle code = encodeSmallest(text, 1, coding);
  return code ? code->version : 0;
}

/// Returns what would hold the text, for use within the refusal: a larger version, weaker error correction, or neither.
Message whatWouldHold(std::string_view text, const SymbolOptions& options) {
  if (text.size() > kMostCharacters) return message<"no-symbol-holds-it">();
  const int asked = options.version.value_or(0);
  const int needed = smallestVersion(text, {options.errorCorrection, options.eci});
  for (int weaker = static_cast<int>(options.errorCorrection) - 1; weaker >= 0; --weaker) {
    const auto level = static_cast<ErrorCorrection>(weaker);
    const int version = smallestVersion(text, {level, options.eci});
    if (version == 0 || (needed != 0 && version > asked)) continue;
    if (needed == 0)
      return message<"weaker-symbol-holds-it">(with::index<"version">(std::max(version, asked)),
                                               with::term<"level">(errorCorrectionName(level)));
    return message<"larger-or-weaker-symbol-holds-it">(with::count<"larger">(needed),
                                                       with::index<"version">(std::max(version, asked)),
                                                       with::term<"level">(errorCorrectionName(level)));
  }
  if (needed != 0) return message<"larger-symbol-holds-it">(with::index<"version">(needed));
  return message<"no-symbol-holds-it">();
}

tl::unexpected<Error> tooLong(std::string_view text, const SymbolOptions& options) {
  if (options.version)
    return badInput(message<"text-too-long-for-version">(
        with::count<"count">(text.size()), with::index<"version">(*options.version),
        with::term<"level">(errorCorrectionName(options.errorCorrection)),
        with::cause<"held">(whatWouldHold(text, options))));
  return badInput(message<"text-too-long">(with::count<"count">(text.size()),
                                           with::term<"level">(errorCorrectionName(options.errorCorrection)),
                                           with::cause<"held">(whatWouldHold(text, options))));
}

bool isInFinder(int row, int column, int size) {
  constexpr int kFinder = 7;
  const bool left = column < kFinder, top = row < kFinder;
  return (left && top) || (top && column >= size - kFinder) || (left && row >= size - kFinder);
}

ModuleRole roleOf(unsigned flags, bool inFinder) {
  if (flags & kFinderOrSeparatorBit) return inFinder ? ModuleRole::Finder : ModuleRole::Separator;
  if (flags & kAlignmentBit)
    return ModuleRole::Alignment;  // must come before timing: some alignment patterns lie
                                   // across it
  if (flags & kTimingBit) return ModuleRole::Timing;
  if (flags & kFormatBit) return ModuleRole::Format;
  if (flags & kVersionBit) return ModuleRole::Version;
  return flags & kFunctionBit ? ModuleRole::Format : ModuleRole::Data;  // the dark module is in the format area
}

/// Reads the mask from bits 12 to 10 of the format information, in row 8, under the fixed mask 101 [ISO/IEC 18004,
/// 7.9.1].
int maskOf(const Symbol& symbol) {
  const int bits = symbol.isDark(8, 2) << 2 | symbol.isDark(8, 3) << 1 | static_cast<int>(symbol.isDark(8, 4));
  return bits ^ 0b101;
}

Symbol toSymbol(const QRcode& code, ErrorCorrection level) {
  Symbol symbol;
  symbol.version = code.version;
  symbol.errorCorrection = level;
  symbol.size = code.width;
  symbol.dark = {code.width, code.width};
  symbol.roles = {code.width, code.width};
  for (int row = 0; row < code.width; ++row)
    for (int column = 0; column < code.width; ++column) {
      const unsigned flags = code.data[row * code.width + column];
      symbol.dark.at(row, column) = flags & kDarkBit;
      symbol.roles.at(row, column) = roleOf(flags, isInFinder(row, column, code.width));
    }
  symbol.mask = maskOf(symbol);
  return symbol;
}

Symbol withRaisedErrorCorrection(std::string_view text, EciUse eci, Symbol symbol) {
  for (const ErrorCorrection level : kLevels) {
    if (level <= symbol.errorCorrection) continue;
    const CodeHandle code = encodeFrom(text, symbol.version, {level, eci});
    if (!code || code->version > symbol.version) break;
    symbol = toSymbol(*code, level);
  }
  return symbol;
}

}  // namespace

std::string_view errorCorrectionName(ErrorCorrection level) {
  constexpr std::array<std::string_view, 4> kNames = {"L", "M", "Q", "H"};
  return kNames[static_cast<std::size_t>(level)];
}

std::optional<ErrorCorrection> errorCorrectionByName(std::string_view name) {
  for (const ErrorCorrection level : kLevels)
    if (errorCorrectionName(level) == name) return level;
  return std::nullopt;
}

const char* eciUseName(EciUse use) { return use == EciUse::Auto ? "auto" : "never"; }

bool hasEci(std::string_view text, EciUse use) {
  const auto isBeyondAscii = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
  return use == EciUse::Auto && std::any_of(text.begin(), text.end(), isBeyondAscii);
}

Result<Symbol> encodeSymbol(std::string_view text, const SymbolOptions& options) {
  if (options.version && (*options.version < 1 || *options.version > kLargestVersion)) {
    return fail(ErrorKind::BadUsage, message<"no-such-version">(with::index<"version">(*options.version)));
  }
  if (options.maskRule == MaskRule::Fixed && (options.mask < 0 || options.mask > 7))
    return fail(ErrorKind::BadUsage, message<"no-such-mask">(with::index<"mask">(options.mask)));
  QRELIEF_TRY(checkCharacters(text));
  if (text.size() > kMostCharacters) return tooLong(text, options);

  const Coding coding = {options.errorCorrection, options.eci};
  const CodeHandle code =
      options.version ? encodeFrom(text, *options.version, coding) : encodeSmallest(text, 1, coding);
  if (!code && errno != ERANGE) {
    return fail(ErrorKind::Internal, message<"text-not-encoded">(with::index<"errno">(errno)));
  }
  if (!code || (options.version && code->version > *options.version)) return tooLong(text, options);
  Symbol symbol = toSymbol(*code, options.errorCorrection);
  if (options.raiseErrorCorrection) symbol = withRaisedErrorCorrection(text, options.eci, std::move(symbol));
  symbol.hasEci = hasEci(text, options.eci);
  if (options.maskRule == MaskRule::Fixed) symbol = withMask(symbol, options.mask);
  if (options.maskRule == MaskRule::Shadiest) symbol = withShadiestMask(symbol);
  return symbol;
}

Symbol blankSymbol() {
  Symbol symbol;
  symbol.version = 0;
  symbol.dark = {symbol.size, symbol.size};
  symbol.roles = {symbol.size, symbol.size};
  return symbol;
}

int VersionsByLength::smallest(std::string_view text) {
  if (text.empty() || text.size() > kMostCharacters) return 0;
  std::array<int, 3> bits{};
  for (std::size_t group = 0, version = 1; group < bits.size(); ++group) {
    bits[group] = segmentBits(segmentText(text, static_cast<int>(version)), static_cast<int>(version)) +
                  (hasEci(text, eci_) ? kEciBits : 0);
    version = static_cast<std::size_t>(lastVersionOfGroup(static_cast<int>(version))) + 1;
  }
  const auto [it, isNew] = known_.try_emplace(bits, 0);
  if (isNew) it->second = smallestVersion(text, {level_, eci_});
  return it->second;
}

}  // namespace qrelief
