// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspector/inspector_model.h"

#include <algorithm>
#include <fmt/format.h>

#include "inspector/translation.h"

namespace qrelief {
namespace {

InspectorModel::Solver solverOf(const EngraveRequest& request) {
  if (request.isForOneLight()) return InspectorModel::Solver::OneLight;
  return request.depth.solver == ContrastSolver::Fast ? InspectorModel::Solver::Fast
                                                      : InspectorModel::Solver::PaperSteps;
}

constexpr std::array<const char*, InspectorModel::kSolvers> kSolverNames = {"fast", "paper's steps", "one light"};

}  // namespace

void InspectorModel::follow(const Engine& engine) {
  const SearchRecord* record = engine.carvings().search();
  const bool isDone = engine.carvings().result() != nullptr;
  const int known = search_ ? search_->passes() : 0;
  if (!record) {
    version_ += search_.has_value();
    search_.reset();
    done_ = false;
    return;
  }
  const int passes = static_cast<int>(record->passes.size());
  const bool isOther =
      engine.carvings().started() != engraving_ || engine.carving() != carving_;  // or useCarving() restored an earlier
                                                                                  // one
  if (!isOther && passes == known && isDone == done_) return;
  if (isOther) pass_.reset();
  ++version_;
  search_.emplace(*engine.carvings().symbol(), *record, engine.carvings().request().depth.contrastAsked());
  engraving_ = engine.carvings().started();
  carving_ = engine.carving();
  done_ = isDone;
  if (isDone) rememberRun(engine);
}

void InspectorModel::rememberRun(const Engine& engine) {
  const EngraveRequest& request = engine.carvings().request();
  const auto solver = static_cast<std::size_t>(solverOf(request));
  runs_[solver] = Run{fmt::format("{}, c = {:g}, {:.1f} mm", translated(kSolverNames[solver]),
                                  request.depth.contrastAsked(), engine.carvings().result()->placement.symbolMm),
                      search_->summaries()};
}

int InspectorModel::pass() const { return std::clamp(pass_.value_or(passes() - 1), 0, std::max(0, passes() - 1)); }

void InspectorModel::setPass(int pass) {
  if (pass >= passes() - 1)
    pass_.reset();
  else
    pass_ = std::max(0, pass);
}

std::optional<SubmoduleFacts> InspectorModel::selected() const {
  if (!search_ || !selected_) return {};
  return search_->facts(pass(), *selected_);
}

std::optional<ValueMap> InspectorModel::read(const Engine& engine, MapChannel channel) const {
  if (isOfSurface(channel)) {
    const SurfaceMaps* maps = engine.carvings().job() ? engine.carvings().job()->surfaceMaps() : nullptr;
    if (!maps || !engine.carvings().result()) return {};
    const bool needsBack = channel == MapChannel::BackDistance || channel == MapChannel::Thickness;
    if (!needsBack) return surfaceMap(*maps, nullptr, engine.carvings().codeEdgeMm(), channel);
    const auto back = engine.backDistances();
    if (!back) return {};
    return surfaceMap(*maps, &*back, engine.carvings().codeEdgeMm(), channel);
  }
  if (isOfLight(channel)) {
    if (!engine.carvings().result()) return {};
    return lightMap(engine.carvings().result()->received, channel);
  }
  if (!search_) return {};
  if (channel == MapChannel::Limit) return search_->limits();
  if (channel == MapChannel::Depth) return search_->depths(pass());
  return channel == MapChannel::Luminance ? search_->luminance(pass()) : search_->excess(pass());
}

const ValueMap* InspectorModel::channel(const Engine& engine, MapChannel channel) {
  const ChannelKey key{channel, version_, infoOf(channel).changesByPass ? pass() : 0};
  if (channelKey_ != key) {
    channel_ = read(engine, channel);
    channelKey_ = key;
    ++channelVersion_;
  }
  return channel_ ? &*channel_ : nullptr;
}

}  // namespace qrelief
