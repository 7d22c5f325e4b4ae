// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/loaded_model.h"
#include "gl/pass_timings.h"
#include "io/write_files.h"
#include "pipeline/engrave.h"
#include "pipeline/printed_view.h"
#include "report/report.h"
#include "verdict/engrave_plan.h"
#include "verdict/verdict.h"
#include "verification/view_trials.h"

namespace qrelief {

/// Engraves, and keeps the last carving and the previous one of the same model.
class Carvings {
 public:
  /// The model to engrave, and the geometry pass that renders it for display; null without a GL context.
  struct Ground {
    const LoadedModel& model;
    const std::shared_ptr<const GeometryPass>& pass;
  };

  /// Does one bounded piece of the work that the request's engraving begins with, so that the engraving has less to do.
  /// @param placed  the request's place; null: not known yet, so nothing is prepared
  /// @returns true if nothing is left to do
  bool prepare(const Ground& ground, EngraveRequest request, const PlacementSearch* placed);
  /// Begins a plan. Its carvings are those started from now on, as its steps say; setReadings(), setPrintedReadings()
  /// and errors of advance() end its steps.
  void follow(EngravePlan plan);
  /// Returns the plan; null: there is none, or another carving than its own is current.
  const EngravePlan* plan() const { return plan_ ? &*plan_ : nullptr; }
  /// Returns the number of the plan's best carving so far; 0: none yet.
  int kept() const { return kept_; }
  /// Starts another engraving. Keeps the finished one, if there is one.
  /// @param placed  the request's place, if known
  Result<Progress> start(const Ground& ground, EngraveRequest request, const PlacementSearch* placed);
  bool isRunning() const { return runs_; }
  /// Does one bounded piece of work of the running engraving. An error ends it.
  Result<Progress> advance();
  /// Ends the running engraving, or makes the last carving the previous one. A carving of the plan that is not its best
  /// one is forgotten instead.
  void setAside();
  void cancel();
  /// Forgets every carving, because the model has changed.
  void forgetAll();

  /// Returns the number of the current carving; 0: there is none.
  int number() const { return current_.result ? current_.number : 0; }
  /// Restores the last carving or the previous one. @returns true if it still exists
  bool use(int number);
  const EngraveResult* result() const { return current_.result ? &*current_.result : nullptr; }
  /// Returns the carving to print: the running engraving once its file is written, else result().
  const EngraveResult* printable() const { return runs_ ? job_->writtenResult() : result(); }
  /// Returns the display mesh of the carved model; null without a carving or a GL context. Makes it at the first call.
  const std::shared_ptr<const GpuMesh>& display(const Ground& ground);
  /// Returns the display mesh, null before it is made.
  const std::shared_ptr<const GpuMesh>& madeDisplay() const { return current_.display; }

  /// Returns the report (core/report/report.h). Requires a carving.
  std::string report(const LoadedModel& model, const gl::Capabilities& gl) const;
  /// Draws the carving as a phone sees it from the side, see tilted(). Empty if it cannot be drawn. Requires a carving.
  GreyImage readerImageFrom(const Ground& ground, double tiltDeg, double azimuthDeg);
  /// Stores the text that each try on frontalPictures() decoded. Requires a carving.
  /// @returns the verdict on the carving, with these texts
  Verdict setReadings(const std::vector<std::string>& texts, const std::string& reader);
  /// Returns the parameters for printing printable(), which must not be null; none if the request names no print
  /// process.
  /// @param changed  printing settings that differ from the carved request, see requestFromJson()
  Result<std::optional<PrintedViewRequest>> printedView(const std::string& changed) const;
  /// Stores the text that each try on the print's frontalPictures() decoded. Requires a carving with a printedView().
  /// @returns the verdict on the carving, with these texts
  Verdict setPrintedReadings(const std::vector<std::string>& texts, double facingDeg);
  /// Returns null before setPrintedReadings().
  const PrintedEvidence* printed() const { return current_.printed ? &*current_.printed : nullptr; }
  /// Judges a print with changed settings, and stores nothing. Requires a carving.
  Result<Aspect> judgePrint(const std::string& changed, const std::vector<std::string>& texts, double facingDeg) const;
  /// The carving's entry in the manifest of a batch. Requires a carving.
  struct Row {
    Verdict verdict;
    std::string details;  ///< see describeRow() in batch/manifest.h
  };
  Row row(double totalMs) const;
  /// Starts the test of the other angles from which the code still decodes. viewTrials() is null before. Requires a
  /// carving.
  ViewTrials& startViewTrials();
  ViewTrials* viewTrials() { return current_.viewTrials ? &*current_.viewTrials : nullptr; }
  /// Draws the next trial in every reading variant. Empty if it cannot be drawn.
  std::vector<GreyImage> viewTrialPictures(const Ground& ground);
  /// See Engine::exportModel. @param number  of the last carving or the previous one
  std::vector<std::uint8_t> exported(const LoadedModel& model, const std::string& format, Slicer slicer, int number);
  /// See Engine::exportFiles. @param number  of the last carving or the previous one
  std::vector<NamedFile> exportedFiles(const LoadedModel& model, const std::string& name, int number);

  // For the inspector; all of it about the last engraving that was started.
  /// Measures the passes of every engraving that starts from now on.
  void timePasses(bool withTimerQueries) { timerQueries_ = withTimerQueries; }
  gl::PassTimings* passTimings() const { return passTimings_.get(); }
  int started() const { return started_; }  ///< number of engravings so far
  const EngraveRequest& request() const { return current_.request; }
  const EngraveJob* job() const { return job_.get(); }
  /// Returns the record of the depth search, or its symbol; null before the search has recorded anything.
  const SearchRecord* search() const;
  const Symbol* symbol() const;
  double codeEdgeMm() const;  ///< of symbol and quiet zone

 private:
  struct Prepared {
    EngraveRequest request;
    std::unique_ptr<EngraveJob> job;
    int steps = 0;  // that the job has done
    double ms = 0;
  };
  struct Carving {
    int number = 0;
    EngraveRequest request;
    double ms = 0;
    std::optional<EngraveResult> result;     // none: not finished
    std::shared_ptr<const GpuMesh> display;  // once it has been shown
    ReadingEvidence reading;
    std::string reader;
    std::optional<PrintedEvidence> printed;  // once the print has been read
    std::optional<ViewTrials> viewTrials;
  };
  Result<std::unique_ptr<EngraveJob>> makeJob(const Ground& ground, const EngraveRequest& request,
                                              const PlacementSearch* placed,
                                              std::shared_ptr<PlacementMeasurement> measured);
  Status compilePrograms();
  Carving* carving(int number);
  static bool fillPockets(const LoadedModel& model, Carving& carving);
  void forgetCurrent();
  Verdict verdict() const;
  Result<EngraveRequest> printedAs(const std::string& changed) const;

  std::shared_ptr<const LuminancePrograms> programs_;  // once shaders have computed light
  std::optional<bool> timerQueries_;                   // none: passes are not timed
  std::unique_ptr<gl::PassTimings> passTimings_;
  int started_ = 0, finished_ = 0;
  std::optional<Prepared> prepared_;  // for the next engraving, if its request is still the same by then
  std::unique_ptr<EngraveJob> job_;
  std::shared_ptr<PlacementMeasurement> measured_;  // from the last job that ended, for the next one
  bool runs_ = false;
  std::optional<EngravePlan> plan_;
  int kept_ = 0;
  Carving current_;
  std::optional<Carving> earlier_;  // the previous one only: keeping more would cost memory without limit
};

}  // namespace qrelief
