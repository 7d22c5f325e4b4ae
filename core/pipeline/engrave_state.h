// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "carving/embed.h"
#include "pipeline/cell_layout.h"
#include "pipeline/engrave.h"
#include "pipeline/printed_view.h"

namespace qrelief {

/// The job's state. Stages are listed in order; each advance() does one step of the current stage.
struct EngraveJob::State {
  enum class Stage { Placing, Mapping, Searching, Embedding, Printing, Writing, Checking, Viewing, Done };

  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;
  EngraveRequest asked;  // before open patterns are filled in
  std::shared_ptr<const LuminancePrograms> programs;
  Stage stage = Stage::Placing;
  double fraction = 0;

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
  bool isPrinted = false;  // true once the print has been taken into account
  EngraveResult result;

  Status place();
  void take(const PlacementSearch& found);
  void decidePatterns(bool areWallsThin);
  std::vector<double> limitsOfMask() const;
  Status measurePlace(bool withLight);
  Status map();
  Status mapMark();
  Status chooseInlay();
  Status searchOnce();
  Status embed();
  Status print();
  Status write();
  Status check();
  void view();
  void startRecord(std::span<const double> limitMm);
  Progress progress();
};

}  // namespace qrelief
