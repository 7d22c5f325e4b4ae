// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/job_stages.h"
#include "carving/embed.h"
#include "pipeline/engrave.h"
#include "pipeline/placement_light.h"
#include "pipeline/printed_view.h"

namespace qrelief {

/// The job's state.
struct CarveJob::State {
  JobStages<State> stages;
  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;
  EngraveRequest asked;  // before open patterns are filled in
  std::shared_ptr<const LuminancePrograms> programs;

  Symbol symbol;
  SubmoduleMask mask;
  CellLayout layout;
  std::optional<PlacementSearch> placing;
  std::shared_ptr<PlacementMeasurement> measured;  // before Mapping: an earlier measurement, perhaps of this place
  bool isMeasured = false;
  DepthField marked;  // for a code in colour: the field to embed
  Device device = Device::Faster;
  CarvingTarget target;
  MakeSearch makeOwnSearch;  // empty: the request decides
  std::unique_ptr<DepthSearchRun> search;
  EmbedResult embedded;
  std::unique_ptr<PrintedViewJob> printing;
  EngraveResult result;

  explicit State(JobStages<State> jobStages) : stages(std::move(jobStages)) {}

  /// Returns the stages of a request.
  /// @param isPlaced  the placement is known
  static JobStages<State> stagesOf(const EngraveRequest& request, bool isPlaced);

  Result<StageStep> place();
  void take(const FoundPlacement& placed);
  void decidePatterns(bool areWallsThin);
  std::vector<double> limitsOfMask() const;
  Status measurePlace(bool withLight);
  Result<StageStep> map();
  Result<StageStep> mapMark();
  Status chooseInlay();
  Result<StageStep> searchOnce();
  Result<StageStep> embed();
  Result<StageStep> print();
  Result<StageStep> weld();
  Result<StageStep> check();
  Result<StageStep> view();
  void startRecord(std::span<const double> limitMm);
};

}  // namespace qrelief
