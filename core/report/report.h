// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "gl/objects.h"
#include "report/json_parts.h"
#include "settings/preset.h"
#include "verdict/tried_carving.h"
#include "verdict/verdict.h"

namespace qrelief {

struct EngravableModel;
struct EngraveRequest;
struct EngraveResult;

/// Contents of the report in addition to the result itself.
struct ReportContext {
  std::string fileName;
  std::string format;
  double scaleToMm = 1;
  ReadingEvidence reading;                 ///< decoding results of the pictures
  std::optional<PrintedEvidence> printed;  ///< none: the print was not simulated
  Verdict verdict;                         ///< based on everything known
  std::vector<TriedCarving> tried;         ///< all attempts of the plan
  int delivered = 0;                       ///< the number of this one among them
  std::string reader;                      ///< name of the decoder, "ZXing-C++ 1.4.0"
  std::optional<Preset> askedPreset;       ///< the requested preset, if a deeper one was carved
  Wording wording;                         ///< wording of the messages
  gl::Capabilities gl;                     ///< of the GL context; reported if its shaders computed the light
  double loadMs = 0, prepareMs = 0, writeMs = 0, totalMs = 0;
  double spotMs = 0;  ///< time to choose the centre, if none was given
};

/// Makes the report as JSON with stable keys (CHANGELOG says when one changes).
std::string makeReport(const EngraveRequest& request, const EngravableModel& model, const EngraveResult& result,
                       const ReportContext& context);

}  // namespace qrelief
