// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "gl/objects.h"
#include "pipeline/engrave.h"
#include "report/json_parts.h"
#include "verdict/verdict.h"

namespace qrelief {

/// What the report says beside the result itself.
struct ReportContext {
  std::string fileName;
  std::string format;
  double scaleToMm = 1;
  ReadingEvidence reading;                 ///< what decoders made of the pictures
  std::optional<PrintedEvidence> printed;  ///< none: it was not found out
  Verdict verdict;                         ///< of all that is known
  std::string reader;                      ///< which decoder, "ZXing-C++ 1.4.0"
  std::optional<Preset> askedPreset;       ///< where a deeper one was carved than was asked for
  Wording wording;                         ///< of the messages
  gl::Capabilities gl;
  double loadMs = 0, prepareMs = 0, writeMs = 0, totalMs = 0;
  double spotMs = 0;  ///< to choose the centre, if none was given
};

/// The report as JSON with the stable keys of the contract (CHANGELOG says when one changes).
std::string makeReport(const EngraveRequest& request, const EngravableModel& model, const EngraveResult& result,
                       const ReportContext& context);

}  // namespace qrelief
