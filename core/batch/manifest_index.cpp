// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/manifest_index.h"

namespace qrelief {

void ManifestIndex::read(std::string_view bytes, const std::function<void(const ManifestEntry&)>& visit) {
  for (std::size_t end = bytes.find('\n'); end != bytes.npos; end = bytes.find('\n')) {
    if (rest_.empty()) {
      add(bytes.substr(0, end), visit);
    } else {
      add(rest_.append(bytes.substr(0, end)), visit);
      rest_.clear();
    }
    bytes.remove_prefix(end + 1);
  }
  rest_.append(bytes);
}

void ManifestIndex::add(std::string_view line, const std::function<void(const ManifestEntry&)>& visit) {
  ++count_;
  if (const auto entry = readManifestLine(line)) {
    lines_[entry->number] = {begin_, static_cast<std::uint32_t>(line.size()), entry->status};
    if (visit) visit(*entry);
  } else if (firstBad_ == 0) {
    firstBad_ = count_;
  }
  begin_ += line.size() + 1;
}

}  // namespace qrelief
