// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/removed_settings.h"

#include <utility>
#include <vector>

#include "message_codes/settings_errors.h"

namespace qrelief {
namespace {

constexpr const char* kSinceSecond = "0.2.0";

std::vector<RemovedSetting> makeRemoved() {
  const Message reading = message<"removed-reading">();
  std::vector<RemovedSetting> all = {
      {"raiseEcc", "--raise-ecc", "", "symbol", true, kSinceSecond,
       message<"removed-raise-ecc">(with::setting<"ecc">("ecc"), with::choice<"auto">("ecc", "auto"))},
      {"breakUp", "--break-up", "", "symbol", true, kSinceSecond, message<"removed-break-up">()},
      {"floor", "--floor", "", "depth", false, kSinceSecond, message<"removed-floor">()},
      {"objective", "--objective", "reading", "", false, kSinceSecond, reading}};
  for (const auto& [key, flag] :
       {std::pair("dataContrast", "--data-contrast"), std::pair("finderContrast", "--finder-contrast"),
        std::pair("blurModules", "--blur-modules"), std::pair("tolerance", "--tolerance"),
        std::pair("maxPasses", "--max-passes")})
    all.push_back({key, flag, "", "reading", false, kSinceSecond, reading});
  return all;
}

}  // namespace

std::span<const RemovedSetting> removedSettings() {
  static const std::vector<RemovedSetting> kAll = makeRemoved();
  return kAll;
}

const RemovedSetting* findRemovedSetting(std::string_view key) { return findRemovedChoice(key, ""); }

const RemovedSetting* findRemovedChoice(std::string_view key, std::string_view choice) {
  for (const RemovedSetting& removed : removedSettings())
    if (removed.key == key && removed.choice == choice) return &removed;
  return nullptr;
}

Message removedWarning(const RemovedSetting& removed, std::string_view name) {
  return message<"setting-removed">(with::term<"name">(name), with::term<"since">(removed.since),
                                    with::cause<"why">(removed.why));
}

}  // namespace qrelief
