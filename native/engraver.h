// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <future>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "pipeline/engrave.h"
#include "verdict/engrave_plan.h"

namespace qrelief {

/// A carving with the results of its checks. To save it, use encodeCarved() (pipeline/carved_file.h).
struct Engraved {
  EngraveRequest request;  ///< as carved, which may be deeper than requested
  EngraveResult result;
  ReadingEvidence reading;
  std::optional<PrintedEvidence> printed;  ///< none: the request names no process, or the print was not simulated
  Verdict verdict;                         ///< with the remedies that are left
  std::vector<TriedCarving> tried = {};    ///< all attempts; the first is the carving as requested
  int attempt = 0;                         ///< the one that this carving is
  double spotMs = 0;                       ///< time to find spots
};

/// Engraves one code after another into one model, with all checks. Shares work between codes: the shader programs, and
/// for codes with the same placement request also the place and its measurements. Needs the model's GL context, if it
/// has one.
class Engraver {
 public:
  using Tell = std::function<void(const Progress&)>;

  /// @param model  checked: see PreparedModel::engravable()
  static Result<Engraver> create(std::shared_ptr<const EngravableModel> model);

  /// Carves as requested or, where that does not decode well, with changed settings: see EngravePlan. An error is that
  /// of the carving as requested, with the offer that would do as its hint.
  /// @param options  simulating the print, the default, takes two fifths of the time
  Result<Engraved> engrave(const EngraveRequest& request, const Tell& tell,
                           const EngravePlan::Options& options = {}) const;

  /// Carves once as requested, without trying any change.
  Result<Engraved> engraveOnce(const EngraveRequest& request, const Tell& tell) const;

  const EngravableModel& model() const { return *model_; }

 private:
  struct Place {
    int modules;
    PlacementRequest request;
    PlacementSearch found;
    std::shared_ptr<PlacementMeasurement> measured;  ///< by the last carving there
  };

  struct Print {
    std::optional<PrintedEvidence> evidence;  ///< none: the request names no process
    double ms = 0;
  };
  struct Carving {
    Engraved engraved;
    std::future<Result<Print>> print;  ///< runs while the design is decoded; not valid: not started
  };

  Engraver() = default;
  Result<Place*> placeOf(const EngraveRequest& request, int modules) const;
  Result<PlacementRequest> spotFor(const EngraveRequest& request, const Tell& tell) const;
  Result<Carving> carve(const EngraveRequest& request, const Tell& tell, bool looksAtPrint) const;
  static Result<Print> printed(const VerifyRequest& request, const Mesh& carved);
  Status addPrint(Carving& carving, const Tell& tell) const;
  Result<Engraved> follow(EngravePlan plan, const Tell& tell) const;

  std::shared_ptr<const EngravableModel> model_;
  std::shared_ptr<const LuminancePrograms> programs_;  // null: the processor computes the light
  mutable std::list<Place> places_;                    // the latest first
};

}  // namespace qrelief
