// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/volumes.h"

#include <algorithm>
#include <array>
#include <optional>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::array<std::string_view, 4> kBambuKinds = {"modifier_part", "negative_part", "support_blocker",
                                                         "support_enforcer"};
constexpr std::array<std::string_view, 4> kPrusaKinds = {"ParameterModifier", "NegativeVolume", "SupportBlocker",
                                                         "SupportEnforcer"};
constexpr std::size_t kMaxVolumes = 100'000;
constexpr std::uint32_t kMaxFilaments = 64;  // more are no slicer's

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& kinds, std::string_view kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Returns a number from an attribute; none if it is missing, negative or too large.
std::optional<std::uint32_t> numberOf(const XmlElement& element, std::string_view name) {
  const auto text = element.attribute(name);
  const auto number = text ? parseInteger(withoutBlanks(*text)) : std::nullopt;
  if (!number || *number < 0 || *number > 0x7fffffff) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

/// Returns an object's id; 0, which no object has, if there is none.
std::uint32_t idOf(const XmlElement& element) { return numberOf(element, "id").value_or(0); }

/// Reads both programs' files, whose elements and keys have different names.
class VolumeHandler : public XmlHandler {
 public:
  explicit VolumeHandler(ThreeMfVolumes& volumes) : volumes_(volumes) {}

  Status startElement(const XmlElement& element) override {
    if (element.name == "object")
      takeObject(element);
    else if (element.name == "part")
      takePart(element);
    else if (element.name == "volume")
      takeRange(element);
    else if (element.name == "metadata")
      takeMetadata(element);
    else if (element.name == "plate")
      ++volumes_.plates;
    return count_ <= kMaxVolumes ? Status()
                                 : badInput(message<"3mf-too-many-entries">(with::count<"limit">(kMaxVolumes)));
  }

 private:
  void takeObject(const XmlElement& element) {
    object_ = idOf(element);
    filament_ = 0;
    range_ = nullptr;
    traits_ = nullptr;
  }

  void takePart(const XmlElement& element) {
    range_ = nullptr;
    ++count_;
    traits_ = &volumes_.parts[{object_, idOf(element)}];
    traits_->filament = filament_;
    if (contains(kBambuKinds, element.attribute("subtype").value_or("")))
      volumes_.notModels.insert({object_, idOf(element)});
  }

  void takeRange(const XmlElement& element) {
    ++count_;
    auto& ranges = volumes_.ranges[object_];
    const auto first = numberOf(element, "firstid"), last = numberOf(element, "lastid");
    ranges.push_back(first && last ? VolumeRange{*first, *last} : VolumeRange{1, 0});
    range_ = &ranges.back();
    traits_ = &range_->traits;
    traits_->filament = filament_;
  }

  void takeMetadata(const XmlElement& element) {
    const std::string_view key = element.attribute("key").value_or(""), value = element.attribute("value").value_or("");
    if (key == "extruder") {
      const std::uint32_t number = numberOf(element, "value").value_or(0);
      if (number > 0 && number <= kMaxFilaments) (traits_ ? traits_->filament : filament_) = number;
    } else if (key == "name" && traits_) {
      traits_->name = value;
    }
    if (range_ && ((key == "volume_type" && contains(kPrusaKinds, value)) || (key == "modifier" && value == "1")))
      range_->isModel = false;
  }

  ThreeMfVolumes& volumes_;
  VolumeRange* range_ = nullptr;    // the latest
  VolumeTraits* traits_ = nullptr;  // of the latest volume or part of the object
  std::uint32_t object_ = 0, filament_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

bool divideMesh(std::span<const VolumeRange> ranges, std::size_t triangles) {
  std::vector<VolumeRange> sorted(ranges.begin(), ranges.end());
  std::sort(sorted.begin(), sorted.end(), [](const VolumeRange& a, const VolumeRange& b) { return a.first < b.first; });
  std::size_t end = 0;  // of the ranges so far
  for (const VolumeRange& range : sorted) {
    if (range.first < end || range.first > range.last || range.last >= triangles) return false;
    end = range.last + 1;
  }
  return true;
}

ThreeMfVolumes readThreeMfVolumes(const ZipArchive& archive, std::uint64_t maxBytes, std::vector<Message>& warnings) {
  ThreeMfVolumes volumes;
  for (const std::string_view name : {kBambuSettings, kPrusaSettings}) {
    const ZipEntry* entry = archive.find(name);
    if (!entry) continue;
    ThreeMfVolumes read = volumes;
    VolumeHandler handler(read);
    Result<ZipStream> stream = ZipStream::open(*entry, maxBytes);
    const Status done = stream ? readXml(*stream, std::string(name), handler) : tl::unexpected(stream.error());
    if (done)
      volumes = std::move(read);
    else
      warnings.push_back(message<"3mf-settings-unread">(with::cause<"cause">(done.error().message)));
  }
  return volumes;
}

}  // namespace qrelief
