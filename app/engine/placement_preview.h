// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/code_on_surface.h"
#include "engine/symbol_decal.h"
#include "pipeline/placement.h"

namespace qrelief {

/// Parameters of a placement: the surface to search and the code to place.
struct PlacementTask {
  const LoadedModel& model;
  const CodeInput& wanted;  ///< its symbol must exist
  Vec3 sceneUp{0, 0, 1};    ///< the axis that is up in the scene
};

/// Keeps the code's place, exact or roughly moved, and the code that follows the pointer.
class PlacementPreview {
 public:
  /// Finds the place of the wanted code, unless the last search found it. Where no code fits, code() is an estimate.
  Status place(const PlacementTask& task);
  /// Takes over an engraving's place and its code.
  void take(const Placement& placement, Result<CodeOnSurface> code);
  /// Show the exact code, or the exact hovered one, as it will be carved, see showSearch().
  void show(const SearchRecord& search, const Symbol& symbol) { showIn(code_, search, symbol); }
  void showHovered(const SearchRecord& search, const Symbol& symbol) { showIn(hovered_, search, symbol); }
  /// @returns null if the last search was for another request
  const FoundPlacement* found(const EngraveRequest& request, const Result<Symbol>& symbol) const;
  /// Takes a place that is known, as if the last search had found it.
  void offer(const PlacementRequest& request, int modules, const Placement& placement) {
    found_ = {request, modules, {placement, 0, 0}};
  }

  const Placement* placement() const { return placement_ ? &*placement_ : nullptr; }
  const CodeOnSurface* code() const { return code_ ? &*code_ : nullptr; }
  /// Shows the code at about that point. It has no exact place any more.
  Status move(const PlacementTask& task, const SurfacePoint& to);
  /// Turns and resizes the code, see CodeOnSurface::adjust. There must be a code.
  void adjust(double rotateDeg, double symbolMm, double outer);

  /// Estimates the code under the pointer.
  Status hover(const PlacementTask& task, const SurfacePoint& at);
  const CodeOnSurface* hovered() const { return hovered_ ? &*hovered_ : nullptr; }
  void endHover();
  /// Starts finding the exact place of the hovered code. @returns false if there is no hovered code
  bool startSettling(const PlacementTask& task);
  bool isSettling() const { return settling_.has_value(); }
  void stopSettling() { settling_.reset(); }
  /// Does one bounded piece of work. @returns true once the hovered code is at its exact place
  Result<bool> settle(const PlacementTask& task);
  /// Returns the concerns about the hovered code (CodeOnSurface); none before it has settled.
  Result<std::vector<Message>> hoveredConcerns(const PlacementTask& task);
  /// Returns the request to engrave the hovered code where it has settled, and its place.
  /// @returns null if no code has settled, or for other settings
  const EngraveRequest* hoveredRequest(const PlacementTask& task) const;
  const FoundPlacement* hoveredPlace() const { return hoveredFound_ ? &hoveredFound_->place : nullptr; }

  /// Forgets the place, the code and the hovered code, but not the result of the last search.
  void forget();
  /// Forgets everything, because the model has changed.
  void forgetFound();

 private:
  struct Found {
    PlacementRequest request;
    int modules;
    FoundPlacement place;
  };
  static bool isFor(const std::optional<Found>& found, const EngraveRequest& request, const Result<Symbol>& symbol);
  static void showIn(std::optional<CodeOnSurface>& code, const SearchRecord& search, const Symbol& symbol) {
    if (code && code->isExact) showSearch(code->decal, symbol, code->symbolMm, search);
  }
  Status find(const PlacementTask& task, const EngraveRequest& request);
  void forgetSettled();

  std::optional<Found> found_;                 // by the last search
  std::optional<Found> hoveredFound_;          // of the code that the pointer rested on last; a click places it there
  std::optional<CodeOnSurface> hoveredExact_;  // that code, not as it will be carved
  EngraveRequest hoveredRequest_;              // to engrave it, or the one that is settling
  std::optional<Placement> placement_;
  std::optional<CodeOnSurface> code_, hovered_;
  std::optional<SurfacePoint> hoveredAt_;
  std::optional<PlacementSearch> settling_;
};

}  // namespace qrelief
