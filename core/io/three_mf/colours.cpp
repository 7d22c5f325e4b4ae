// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/colours.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "base/parse_json.h"
#include "io/parse_number.h"

namespace qrelief {
namespace {

constexpr std::string_view kBambuProject = "Metadata/project_settings.config";
constexpr std::string_view kPrusaProject = "Metadata/Slic3r_PE.config";
// PrusaSlicer's own colour of an extruder counts before the colour of the filament in it.
constexpr std::array<std::string_view, 2> kPrusaKeys = {"; extruder_colour = ", "; filament_colour = "};

// Distinct with every kind of colour vision [Okabe, Ito 2008]; the first is a plain grey.
constexpr std::array<Colour, 8> kStandIns = {{{200, 200, 196},
                                              {230, 159, 0},
                                              {86, 180, 233},
                                              {0, 158, 115},
                                              {204, 121, 167},
                                              {240, 228, 66},
                                              {0, 114, 178},
                                              {213, 94, 0}}};

std::optional<std::string> contentOf(const ZipArchive& archive, std::string_view name, std::uint64_t maxBytes) {
  const ZipEntry* const entry = archive.find(name);
  if (!entry) return {};
  const auto bytes = unpacked(*entry, maxBytes);
  return bytes ? std::optional(std::string(bytes->begin(), bytes->end())) : std::nullopt;
}

std::vector<std::optional<Colour>> bambuColours(const std::string& text) {
  std::vector<std::optional<Colour>> colours;
  const auto settings = parseJson(text);
  if (!settings || !settings->is_object()) return colours;
  const auto list = settings->find("filament_colour");
  if (list == settings->end() || !list->is_array()) return colours;
  for (const auto& entry : *list)
    colours.push_back(entry.is_string() ? colourFrom(entry.get<std::string>()) : std::nullopt);
  return colours;
}

std::vector<std::optional<Colour>> prusaColours(std::string_view text) {
  std::vector<std::optional<Colour>> colours;
  for (const std::string_view key : kPrusaKeys) {
    const std::size_t at = text.find(key);
    if (at == std::string_view::npos) continue;
    std::string_view list = text.substr(at + key.size());
    list = list.substr(0, list.find_first_of("\r\n"));
    for (std::size_t i = 0; !list.empty(); ++i) {
      const std::size_t end = std::min(list.find(';'), list.size());
      std::string_view word = withoutBlanks(list.substr(0, end));
      if (word.size() > 2 && word.front() == '"' && word.back() == '"') word = word.substr(1, word.size() - 2);
      if (i == colours.size()) colours.emplace_back();
      if (!colours[i]) colours[i] = colourFrom(word);
      list.remove_prefix(std::min(end + 1, list.size()));
    }
  }
  return colours;
}

}  // namespace

std::optional<Colour> colourFrom(std::string_view text) {
  text = withoutBlanks(text);
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return {};
  Colour colour{};
  for (std::size_t i = 1; i + 1 < text.size(); i += 2) {
    unsigned value = 0;
    const char* const end = text.data() + i + 2;
    if (const auto read = std::from_chars(text.data() + i, end, value, 16); read.ec != std::errc() || read.ptr != end)
      return {};
    if (i / 2 < colour.size()) colour[i / 2] = static_cast<std::uint8_t>(value);
  }
  return colour;
}

FilamentColours::FilamentColours(const ZipArchive& archive, std::uint64_t maxBytes) {
  if (const auto text = contentOf(archive, kBambuProject, maxBytes)) colours_ = bambuColours(*text);
  if (!colours_.empty()) return;
  if (const auto text = contentOf(archive, kPrusaProject, maxBytes)) colours_ = prusaColours(*text);
}

std::optional<Colour> FilamentColours::of(std::uint32_t number) const {
  return number - 1 < colours_.size() ? colours_[number - 1] : std::nullopt;
}

Colour FilamentColours::standIn(std::uint32_t number) { return kStandIns[(number - 1) % kStandIns.size()]; }

}  // namespace qrelief
