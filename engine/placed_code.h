// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/code_on_surface.h"

namespace qrelief {

/// What a place is looked for on, and for which code.
struct PlacementTask {
  const LoadedModel& model;
  const GeometryPass& pass;
  const WantedCode& wanted;  ///< its symbol must exist
  Vec3 upHint{0, 0, 1};
};

/// Where the code is: its place, found exactly or moved about there; and the one that follows the pointer.
class PlacedCode {
 public:
  /// Finds the place of the wanted code, unless it is the one that was found last. Where none fits, the code is what
  /// would about lie there.
  Status place(const PlacementTask& task);
  /// The place of an engraving, and its code.
  void take(const Placement& placement, Result<CodeOnSurface> code);
  /// @returns null if that is not what was found last
  const PlacementSearch* found(const EngraveRequest& request, const Result<Symbol>& symbol) const;

  const Placement* placement() const { return placement_ ? &*placement_ : nullptr; }
  const CodeOnSurface* code() const { return code_ ? &*code_ : nullptr; }
  /// Shows the code about there; it has no place any more.
  Status move(const PlacementTask& task, const SurfacePoint& to);
  /// See CodeOnSurface::adjust; there must be a code.
  void adjust(double rotateDeg, double symbolMm, double outer);

  /// The code that would about lie under the pointer.
  Status hover(const PlacementTask& task, const SurfacePoint& at);
  const CodeOnSurface* hovered() const { return hovered_ ? &*hovered_ : nullptr; }
  void endHover();
  /// Starts finding the hovered code's true place. @returns whether there is one
  bool startSettling(const PlacementTask& task);
  bool isSettling() const { return settling_.has_value(); }
  void stopSettling() { settling_.reset(); }
  /// One bounded piece of work. @returns whether the hovered code is at its true place now
  Result<bool> settle(const PlacementTask& task);

  /// No place, no code, no hovered one; what was found is still known.
  void forget();
  /// The model is another.
  void forgetFound();

 private:
  struct Found {
    PlacementRequest request;
    int modules;
    PlacementSearch search;
  };
  Status find(const PlacementTask& task, const EngraveRequest& request);

  std::optional<Found> found_;  // last
  std::optional<Placement> placement_;
  std::optional<CodeOnSurface> code_, hovered_;
  std::optional<SurfacePoint> hoveredAt_;
  std::optional<PlacementSearch> settling_;
};

}  // namespace qrelief
