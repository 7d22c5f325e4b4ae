// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/placement_preview.h"

#include <utility>

namespace qrelief {

bool PlacementPreview::isFor(const std::optional<Found>& found, const EngraveRequest& request,
                             const Result<Symbol>& symbol) {
  return found && symbol && found->modules == symbol->size &&
         found->request == searchedPlacement(request, symbol->size);
}

const FoundPlacement* PlacementPreview::found(const EngraveRequest& request, const Result<Symbol>& symbol) const {
  return isFor(found_, request, symbol) ? &found_->place : nullptr;
}

Status PlacementPreview::find(const PlacementTask& task, const EngraveRequest& request) {
  const Result<Symbol>& symbol = task.wanted.symbol();
  if (found(request, symbol)) return {};
  if (isFor(hoveredFound_, request, symbol)) {
    found_ = std::exchange(hoveredFound_, std::nullopt);
    return {};
  }
  found_.reset();
  const PlacementRequest placement = searchedPlacement(request, symbol->size);
  const EngravableModel& model = *task.model.engravable;
  PlacementSearch search(model.prepared, *model.renderer, symbol->size, placement);
  for (bool done = false; !done;) {
    const Result<bool> step = search.step();
    QRELIEF_TRY(step);
    done = *step;
  }
  found_ = {placement, symbol->size, search.found()};
  return {};
}

Status PlacementPreview::place(const PlacementTask& task) {
  const EngraveRequest request = task.wanted.request(task.sceneUp);
  const Symbol& symbol = *task.wanted.symbol();
  if (const Status status = find(task, request); !status) {
    const auto surface = closestPoint(task.model.mesh(), request.placement.centreMm);
    if (auto about =
            surface ? estimatedCode(task.model, task.wanted, task.sceneUp, *surface) : tl::unexpected(status.error()))
      code_ = std::move(*about);
    return status;
  }
  const Placement& placement = found_->place.placement;
  const bool isHovered = hoveredExact_ && hoveredRequest_ == request;
  auto code = isHovered ? Result<CodeOnSurface>(*hoveredExact_) : exactCode(task.model, symbol, request, placement);
  QRELIEF_TRY(code);
  QRELIEF_TRY(findConcerns(*code, task.model, symbol, request, placement));
  placement_ = placement;
  code_ = std::move(*code);
  return {};
}

void PlacementPreview::take(const Placement& placement, Result<CodeOnSurface> code) {
  placement_ = placement;
  if (code) code_ = std::move(*code);
}

Status PlacementPreview::move(const PlacementTask& task, const SurfacePoint& to) {
  auto code = estimatedCode(task.model, task.wanted, task.sceneUp, to);
  QRELIEF_TRY(code);
  endHover();
  placement_.reset();
  code_ = std::move(*code);
  return {};
}

void PlacementPreview::adjust(double rotateDeg, double symbolMm, double outer) {
  code_->adjust(rotateDeg, symbolMm, outer);
}

Status PlacementPreview::hover(const PlacementTask& task, const SurfacePoint& at) {
  auto code = estimatedCode(task.model, task.wanted, task.sceneUp, at,
                            hovered_ ? std::optional(hovered_->symbolMm) : std::nullopt);
  QRELIEF_TRY(code);
  hoveredAt_ = at;
  forgetSettled();
  hovered_ = std::move(*code);
  return {};
}

void PlacementPreview::endHover() {
  settling_.reset();
  hovered_.reset();
  hoveredAt_.reset();
}

bool PlacementPreview::startSettling(const PlacementTask& task) {
  if (!hoveredAt_) return false;
  const EngravableModel& model = *task.model.engravable;
  const SurfacePoint centre = centreNear(task.model, task.wanted, task.sceneUp, *hoveredAt_);
  forgetSettled();
  hoveredRequest_ = task.wanted.requestAt(centre.position, task.sceneUp);
  const int modules = task.wanted.symbol()->size;
  settling_.emplace(model.prepared, *model.renderer, modules, searchedPlacement(hoveredRequest_, modules));
  return true;
}

const EngraveRequest* PlacementPreview::hoveredRequest(const PlacementTask& task) const {
  if (!hovered_ || !hoveredFound_ || !isFor(hoveredFound_, hoveredRequest_, task.wanted.symbol())) return nullptr;
  const bool isWanted = hoveredRequest_ == task.wanted.requestAt(hoveredRequest_.placement.centreMm, task.sceneUp);
  return isWanted ? &hoveredRequest_ : nullptr;
}

Result<bool> PlacementPreview::settle(const PlacementTask& task) {
  const Result<bool> isSettled = settling_->step();
  if (isSettled && !*isSettled) return false;
  auto code = isSettled ? exactCode(task.model, *task.wanted.symbol(), hoveredRequest_, settling_->placement())
                        : tl::unexpected(isSettled.error());
  std::optional<PlacementSearch> search = std::exchange(settling_, std::nullopt);
  QRELIEF_TRY(code);
  hovered_ = hoveredExact_ = std::move(*code);
  const int modules = search->modules();
  hoveredFound_ = {searchedPlacement(hoveredRequest_, modules), modules, search->found()};
  return true;
}

Result<std::vector<Message>> PlacementPreview::hoveredConcerns(const PlacementTask& task) {
  if (!hoveredRequest(task)) return std::vector<Message>();
  QRELIEF_TRY(
      findConcerns(*hoveredExact_, task.model, *task.wanted.symbol(), hoveredRequest_, hoveredFound_->place.placement));
  return *hoveredExact_->concerns;
}

void PlacementPreview::forgetSettled() {
  hoveredFound_.reset();
  hoveredExact_.reset();
}

void PlacementPreview::forget() {
  placement_.reset();
  code_.reset();
  endHover();
}

void PlacementPreview::forgetFound() {
  forget();
  found_.reset();
  forgetSettled();
}

}  // namespace qrelief
