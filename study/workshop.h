// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "study/carved_code.h"
#include "study/spot.h"
#include "verification/frontal_reading.h"

namespace qrelief::study {

/// Depth of the mask's submodules alone: smooth pockets reach beyond it.
DepthSummary depthOf(const CarvedCode& code);

/// What decoders make of a carving, as designed and as printed, and how deep it is.
struct Judged {
  DepthSummary depth;    ///< over the submodules that the mask has carved
  double removedMm = 0;  ///< what is carved away, as an even depth of the whole symbol
  ReadingCount designed, printed;
};

/// The models of the study, and what experiments do with them. Needs a GL context.
class Workshop {
 public:
  /// @param samplesFolder  with the page's sample models (npm run samples)
  explicit Workshop(std::string samplesFolder) : samplesFolder_(std::move(samplesFolder)) {}

  /// The eight models: the page's samples, and a cylinder; flat, curved, edged and wavy.
  static const std::vector<std::string>& models();

  /// @param scale  of all lengths, > 0
  /// @returns BadInput if the file is not there
  Result<std::shared_ptr<const EngravableModel>> model(const std::string& name, double scale = 1);

  /// The usual request at a model's centre: kText, version 3, modules of 1 mm, printed lying by the first process,
  /// carved for the design.
  Result<EngraveRequest> usualRequest(const std::string& modelName);

  /// The place of the usual request; found once. @param direction  how
  Result<const Spot*> usualSpot(const std::string& modelName,
                                DirectionMethod direction = DirectionMethod::DepthBalanced);

  /// The same place for modules of another width, mm, on the model scaled with them, so that the code lies on the same
  /// surface whatever its size; found once. @param direction  how
  Result<const Spot*> spotOfWidth(const std::string& modelName, double moduleMm,
                                  DirectionMethod direction = DirectionMethod::DepthBalanced);

  /// Carves and reads it, under the light that it is made for: light is traced on the design and on what the spot's
  /// process leaves of it.
  Result<Judged> judge(const Spot& spot, const CarvedCode& code) const;

 private:
  Result<Vec3> centreOf(const std::string& modelName);
  Result<const Spot*> spotFor(const std::string& modelName, const EngraveRequest& request, double scale,
                              const std::string& key);

  std::string samplesFolder_;
  std::map<std::string, Vec3> centres_;  // of the samples
  std::map<std::string, std::shared_ptr<const EngravableModel>> models_;
  std::map<std::string, Spot> spots_;
};

/// Fits version 3 at level H, so that every method has the same number of modules.
inline constexpr const char* kText = "https://example.org/p/1";

}  // namespace qrelief::study
