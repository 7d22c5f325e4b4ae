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

/// Returns the depth of the mask's submodules only; smooth pockets reach beyond them.
DepthSummary depthOf(const CarvedCode& code);

/// Depth of a carving, and how many tries decode it, as designed and as printed.
struct Judged {
  DepthSummary depth;    ///< over the carved submodules of the mask
  double removedMm = 0;  ///< removed volume, as an even depth over the whole symbol
  ReadingCount designed, printed;
};

/// The models of the study and the common steps of experiments. Needs a GL context.
class StudyContext {
 public:
  /// @param samplesFolder  has the page's sample models (npm run samples)
  explicit StudyContext(std::string samplesFolder) : samplesFolder_(std::move(samplesFolder)) {}

  /// Returns the eight models: the page's samples, and a cylinder; flat, curved, edged and wavy.
  static const std::vector<std::string>& models();

  /// Loads a model.
  /// @param scale  of all lengths, > 0
  /// @returns BadInput if the file does not exist
  Result<std::shared_ptr<const EngravableModel>> model(const std::string& name, double scale = 1);

  /// Returns the usual request at a model's centre: kText, version 3, modules of 1 mm, printed lying with the first
  /// process, carved for the design.
  Result<EngraveRequest> usualRequest(const std::string& modelName);

  /// Returns the place of the usual request; searched only once. @param direction  method for finding the direction
  Result<const StudyPlacement*> usualSpot(const std::string& modelName,
                                          DirectionMethod direction = DirectionMethod::DepthBalanced);

  /// Returns the same place for modules of another width, mm. The model is scaled with them, so that the code lies on
  /// the same surface at every size. Searched only once. @param direction  method for finding the direction
  Result<const StudyPlacement*> spotOfWidth(const std::string& modelName, double moduleMm,
                                            DirectionMethod direction = DirectionMethod::DepthBalanced);

  /// Embeds and decodes a carved code under the light that it is carved for. Traces the light on the design and on the
  /// print by the spot's process.
  Result<Judged> judge(const StudyPlacement& spot, const CarvedCode& code) const;

 private:
  Result<Vec3> centreOf(const std::string& modelName);
  Result<const StudyPlacement*> spotFor(const std::string& modelName, const EngraveRequest& request, double scale,
                                        const std::string& key);

  std::string samplesFolder_;
  std::map<std::string, Vec3> centres_;  // for the samples
  std::map<std::string, std::shared_ptr<const EngravableModel>> models_;
  std::map<std::string, StudyPlacement> spots_;
};

/// Text that fits version 3 at level H, so that every method has the same number of modules.
inline constexpr const char* kText = "https://example.org/p/1";

}  // namespace qrelief::study
