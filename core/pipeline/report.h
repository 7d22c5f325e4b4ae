// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "gl/objects.h"
#include "pipeline/engrave.h"

namespace qrelief {

/// What the report says beside the result itself.
struct ReportContext {
  std::string fileName;
  std::string format;
  double scaleToMm = 1;
  std::string readBack;  ///< text that a reader found in the simulated picture; empty if none
  std::string reader;    ///< which reader, "ZXing-C++ 1.4.0"
  struct Presets {
    std::string asked, used;
  };
  std::optional<Presets> presets;  ///< none where the contrast was asked for by itself
  gl::Capabilities gl;
  double loadMs = 0, prepareMs = 0, writeMs = 0, totalMs = 0;
  double spotMs = 0;  ///< to choose the centre, if none was given
};

/// The report as JSON with the stable keys of the contract (CHANGELOG says when one changes).
std::string makeReport(const EngraveRequest& request, const EngravableModel& model, const EngraveResult& result,
                       const ReportContext& context);

/// Whether everything that was checked is as it should be; else what is not, in words.
std::vector<std::string> failedChecks(const EngraveRequest& request, const EngraveResult& result,
                                      const std::string& readBack);

}  // namespace qrelief
