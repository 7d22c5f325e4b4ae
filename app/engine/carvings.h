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
#include "pipeline/printed_view.h"
#include "report/report.h"
#include "verdict/engraving.h"
#include "verification/view_trials.h"

namespace qrelief {

/// Engraves, and keeps the last carving and the previous one of the same model, and the best one of an engraving that
/// has not ended.
class Carvings {
 public:
  /// The model to engrave, and the geometry pass that renders it for display; null without a GL context.
  struct Ground {
    const LoadedModel& model;
    const std::shared_ptr<const GeometryPass>& pass;
  };

  /// Does one bounded piece of the work that the request's engraving begins with, so that the engraving has less to do.
  /// @param placed      the request's place; null: not known yet, so nothing is prepared
  /// @param withSearch  also the whole first search for depths
  /// @returns true if nothing is left to do
  bool prepare(const Ground& ground, EngraveRequest request, const FoundPlacement* placed, bool withSearch);
  /// Returns the job of that work; null: there is none.
  const CarveJob* prepared(EngraveRequest request) const;
  /// Starts another engraving. Keeps the current carving, if there is one.
  /// @param placed  the request's place, if known
  void start(const Ground& ground, EngraveRequest request, const EngravePlan::Options& options,
             const FoundPlacement* placed);
  /// Returns true while an attempt is under way.
  bool isRunning() const { return engraving_ && engraving_->isUnderWay(); }
  /// Does one bounded piece of work of the engraving. A finished attempt becomes the current carving, which
  /// setReadings() or setPrintedReadings() must answer. An error ends the engraving.
  Result<Engraving::Step> advance();
  /// Returns the engraving; null: there is none, or another carving than its own is current.
  const Engraving* engraving() const { return engraving_ ? &*engraving_ : nullptr; }
  /// Returns the number of the engraving's best carving so far; 0: none yet.
  int best() const;
  /// Ends the engraving. Its best carving so far becomes the current one.
  void cancel();
  /// Forgets every carving, because the model has changed.
  void forgetAll();

  /// Returns the number of the current carving; 0: there is none.
  int number() const { return current_; }
  /// Makes a carving the current one. @returns true if it still exists
  bool use(int number);
  const EngraveResult* result() const { return current() ? &current()->engraved->result : nullptr; }
  /// Returns the carving to print: the running attempt once its file is written, else result().
  const EngraveResult* printable() const { return isRunning() ? engraving_->printable() : result(); }
  /// Returns the display mesh of the carved model; null without a carving or a GL context. Makes it at the first call.
  std::shared_ptr<const GpuMesh> display(const Ground& ground);
  /// Returns the display mesh, null before it is made.
  std::shared_ptr<const GpuMesh> madeDisplay() const { return current() ? current()->display : nullptr; }

  /// Returns the report (core/report/report.h). Requires a carving.
  std::string report(const LoadedModel& model, const gl::Capabilities& gl) const;
  /// Draws the carving as a phone sees it from the side, see tilted(). Empty if it cannot be drawn. Requires a carving.
  GreyImage readerImageFrom(const Ground& ground, double tiltDeg, double azimuthDeg);
  /// Stores the text that each try on frontalPictures() decoded. Requires a carving.
  /// @returns the verdict on the carving, with these texts
  const Verdict& setReadings(const std::vector<std::string>& texts, const std::string& reader);
  /// Returns the parameters for printing printable(), which must not be null; none if the request names no print
  /// process.
  /// @param changed  printing settings that differ from the carved request, see requestFromJson()
  Result<std::optional<PrintedViewRequest>> printedView(const std::string& changed) const;
  /// Stores the text that each try on the print's frontalPictures() decoded. Requires a carving with a printedView().
  /// @returns the verdict on the carving, with these texts
  const Verdict& setPrintedReadings(const std::vector<std::string>& texts, double facingDeg);
  /// Returns null before setPrintedReadings().
  const PrintedEvidence* printed() const;
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
  ViewTrials* viewTrials();
  /// Draws the next trial in every reading variant. Empty if it cannot be drawn.
  std::vector<GreyImage> viewTrialPictures(const Ground& ground);
  /// See Engine::exportModel. @param number  of a carving that is kept
  std::vector<std::uint8_t> exported(const LoadedModel& model, const std::string& format, Slicer slicer, int number);
  /// See Engine::exportFiles. @param number  of a carving that is kept
  std::vector<NamedFile> exportedFiles(const LoadedModel& model, const std::string& name, int number) const;

  /// See Engine::exportMaps. @param number  of a carving that is kept
  std::vector<std::uint8_t> exportedMaps(const LoadedModel& model, int number) const;

  // For the inspector; all of it about the last attempt that was started.
  /// Measures the passes of every attempt that starts from now on, which shaders then make.
  /// @param withTimerQueries  none: measures nothing
  void timePasses(std::optional<bool> withTimerQueries) { timerQueries_ = withTimerQueries; }
  gl::PassTimings* passTimings() const { return passTimings_.get(); }
  int started() const { return started_; }  ///< number of attempts so far
  const EngraveRequest& request() const;    ///< requires an engraving or a carving
  const CarveJob* job() const { return engraving_ ? engraving_->job() : nullptr; }
  /// Returns the record of the depth search, or its symbol; null before the search has recorded anything.
  const SearchRecord* search() const;
  const Symbol* symbol() const;
  double codeEdgeMm() const;  ///< of symbol and quiet zone

 private:
  struct Carving {
    int number = 0;
    std::shared_ptr<Engraved> engraved;
    std::shared_ptr<const GpuMesh> display = nullptr;  // once it has been shown
    std::string reader = {};
    std::optional<ViewTrials> viewTrials = {};
  };
  Engraver& engraver(const Ground& ground);
  const Carving* carving(int number) const;
  Carving* carving(int number) { return const_cast<Carving*>(std::as_const(*this).carving(number)); }
  const Carving* current() const { return carving(current_); }
  Carving* current() { return carving(current_); }
  void makeCurrent(const std::shared_ptr<Engraved>& engraved);
  static bool fillPockets(const LoadedModel& model, Engraved& engraved);
  Result<EngraveRequest> printedAs(const std::string& changed) const;

  std::optional<bool> timerQueries_;  // none: passes are not timed
  std::unique_ptr<gl::PassTimings> passTimings_;
  int started_ = 0, made_ = 0;          // attempts and carvings so far
  std::unique_ptr<Engraver> engraver_;  // of the model
  std::optional<Engraving> engraving_;  // after its end, too: the inspector shows its maps
  int current_ = 0;                     // its number; 0: none
  std::vector<Carving> carvings_;       // in their order; few, since each costs memory
};

}  // namespace qrelief
