// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/symbol_flags.h"

namespace qrelief {

void addSymbolFlags(CLI::App& command, SymbolFlags& flags) {
  command.add_option("--ecc", flags.ecc, "error correction [M, or a higher one where that needs no larger version]")
      ->check(CLI::IsMember({"L", "M", "Q", "H"}));
  command.add_flag("--raise-ecc", flags.raiseEcc, "a higher one than --ecc says where that needs no larger version");
  command.add_option("--version", flags.version, "symbol version, 1 to 40 [smallest]")->check(CLI::Range(1, 40));
  command
      .add_option("--mask", flags.mask,
                  "0 to 7; auto: by the standard's penalties; shadiest: that with the smallest dark areas [auto]")
      ->check(CLI::IsMember({"0", "1", "2", "3", "4", "5", "6", "7", "auto", "shadiest"}));
  command.add_flag("--break-up", flags.breakUp,
                   "make modules of large dark areas light, as many as error correction restores and still has left "
                   "what --ecc L has");
}

SymbolOptions symbolOptionsFrom(const SymbolFlags& flags) {
  SymbolOptions options;
  if (!flags.ecc.empty()) options.errorCorrection = *errorCorrectionByName(flags.ecc);
  if (flags.version > 0) options.version = flags.version;
  options.raiseErrorCorrection = flags.raiseEcc || flags.ecc.empty();
  options.breakUpDarkAreas = flags.breakUp;
  if (flags.mask == "shadiest") {
    options.maskRule = MaskRule::Shadiest;
  } else if (flags.mask != "auto") {
    options.maskRule = MaskRule::Fixed;
    options.mask = std::stoi(flags.mask);
  }
  return options;
}

}  // namespace qrelief
