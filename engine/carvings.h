// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/loaded_model.h"
#include "gl/pass_timings.h"
#include "pipeline/printed_view.h"
#include "report/report.h"
#include "verdict/verdict.h"
#include "verification/view_trials.h"

namespace qrelief {

/// Engraves, and keeps what came out: the last carving, and the one before it of the same model.
class Carvings {
 public:
  /// What is engraved in, and by which pass.
  struct Ground {
    const LoadedModel& model;
    const std::shared_ptr<const GeometryPass>& pass;
  };

  /// One bounded piece of what the engraving of a request begins with, so that it has less to do.
  /// @param placed  the request's place; null: not known yet, and nothing is prepared
  /// @returns whether nothing is left to do
  bool prepare(const Ground& ground, EngraveRequest request, const PlacementSearch* placed);
  /// Starts another engraving and keeps the finished one, if there is one.
  /// @param placed  the request's place, if it is known
  Result<Progress> start(const Ground& ground, EngraveRequest request, const PlacementSearch* placed);
  bool isRunning() const { return runs_; }
  /// One bounded piece of work, while an engraving is running. An error ends it.
  Result<Progress> advance();
  /// Ends the engraving that is running, or forgets the last carving but keeps it as the one before.
  void setAside();
  void cancel();
  /// The model is another.
  void forgetAll();

  /// Number of the carving that is there; 0: none.
  int number() const { return current_.result ? current_.number : 0; }
  /// Brings the last carving back, or the one before it. @returns whether it is there
  bool use(int number);
  const EngraveResult* result() const { return current_.result ? &*current_.result : nullptr; }
  /// The carving to print: the running engraving once its file is written, else result().
  const EngraveResult* printable() const { return runs_ ? job_->writtenResult() : result(); }
  /// The carved model as it is shown; made at the first call. Null: there is none.
  const std::shared_ptr<const GpuMesh>& display(const Ground& ground);
  /// The same, null before it was made.
  const std::shared_ptr<const GpuMesh>& madeDisplay() const { return current_.display; }

  /// The report of the contract. There must be a carving.
  std::string report(const LoadedModel& model, const gl::Capabilities& gl) const;
  /// What a phone sees from aside, see tilted(); empty where it cannot be drawn. There must be a carving.
  GreyImage readerImageFrom(const Ground& ground, double tiltDeg, double azimuthDeg);
  /// What decoders made of it: of frontalPictures(), try by try. There must be a carving.
  /// @returns what the carving comes to with that
  Verdict setReadings(const std::vector<std::string>& texts, const std::string& reader);
  /// Parameters of the print of printable(), which must not be null; none if no print process is chosen.
  /// @param changed  settings of the printing that are other than those carved with, see requestFromJson()
  Result<std::optional<PrintedViewRequest>> printedView(const std::string& changed) const;
  /// What decoders made of the print's frontalPictures(), try by try. There must be a carving with a printedView().
  /// @returns the verdict on the carving with that
  Verdict setPrintedReadings(const std::vector<std::string>& texts, double facingDeg);
  /// Null before setPrintedReadings().
  const PrintedEvidence* printed() const { return current_.printed ? &*current_.printed : nullptr; }
  /// What a print with changed settings would come to; nothing is kept. There must be a carving.
  Result<Aspect> judgePrint(const std::string& changed, const std::vector<std::string>& texts, double facingDeg) const;
  /// What the manifest of a batch says of it. There must be a carving.
  struct Row {
    Verdict verdict;
    std::string details;  ///< see describeRow() in batch/manifest.h
  };
  Row row(double totalMs) const;
  /// Looks from where else it reads; null before startViewTrials(). There must be a carving.
  ViewTrials& startViewTrials();
  ViewTrials* viewTrials() { return current_.viewTrials ? &*current_.viewTrials : nullptr; }
  /// Of the trial that is due, in every reading variant; empty where it cannot be drawn.
  std::vector<GreyImage> viewTrialPictures(const Ground& ground);
  /// See Engine::exportModel.
  std::vector<std::uint8_t> exported(const LoadedModel& model, const std::string& format);

  // For the inspector, of the last engraving that was started.
  /// Measures the passes of the engravings that start from now on.
  void timePasses(bool withTimerQueries) { timerQueries_ = withTimerQueries; }
  gl::PassTimings* passTimings() const { return passTimings_.get(); }
  int started() const { return started_; }  ///< so many so far
  const EngraveRequest& request() const { return current_.request; }
  const EngraveJob* job() const { return job_.get(); }
  /// What the search did, and the symbol; null before it has seen anything.
  const SearchRecord* search() const;
  const Symbol* symbol() const;
  double codeEdgeMm() const;  ///< of symbol and quiet zone

 private:
  struct Prepared {
    EngraveRequest request;
    std::unique_ptr<EngraveJob> job;
    int steps = 0;  // that it has done
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
    std::optional<PrintedEvidence> printed;  // once it was made
    std::optional<ViewTrials> viewTrials;
  };
  Result<std::unique_ptr<EngraveJob>> makeJob(const Ground& ground, const EngraveRequest& request,
                                              const PlacementSearch* placed, std::shared_ptr<MeasuredPlace> measured);
  void forgetCurrent();
  Verdict verdict() const;
  Result<EngraveRequest> printedAs(const std::string& changed) const;

  std::shared_ptr<const LuminancePrograms> programs_;  // once there was an engraving
  std::optional<bool> timerQueries_;                   // none: passes are not timed
  std::unique_ptr<gl::PassTimings> passTimings_;
  int started_ = 0, finished_ = 0;
  std::optional<Prepared> prepared_;  // of the next engraving, if that is asked for as it is now
  std::unique_ptr<EngraveJob> job_;
  std::shared_ptr<MeasuredPlace> measured_;  // by the job that was the last to end, for the next
  bool runs_ = false;
  Carving current_;
  std::optional<Carving> earlier_;  // the one before: more would cost memory without end
};

}  // namespace qrelief
