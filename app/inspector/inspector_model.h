// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "inspector/map_channels.h"
#include "inspector/request_overrides.h"
#include "inspector/search_view.h"

namespace qrelief {

/// Data and choices of the inspector, apart from their drawing.
class InspectorModel {
 public:
  /// The convergence of a search, kept beyond the next search so that solvers can be compared.
  struct Run {
    std::string name;  ///< "fast, c = 0.3, 28.1 mm"
    std::vector<PassSummary> passes;
  };
  enum class Solver { Fast, PaperSteps, OneLight };
  static constexpr std::size_t kSolvers = 3;

  /// Takes over the engine's changes since the last call. Call it before each frame.
  void follow(const Engine& engine);

  const SearchView* search() const { return search_ ? &*search_ : nullptr; }
  /// Returns the last search of each solver, indexed by Solver.
  const std::array<std::optional<Run>, kSolvers>& runs() const { return runs_; }
  void forgetRuns() { runs_ = {}; }

  /// Returns the pass shown: the last one, until setPass() chooses an earlier one.
  int pass() const;
  int passes() const { return search_ ? search_->passes() : 0; }
  void setPass(int pass);

  void select(std::optional<SubmodulePlace> place) { selected_ = place; }
  std::optional<SubmoduleFacts> selected() const;

  /// Returns a channel at the pass shown; null if it is not known yet. Valid until the next call.
  const ValueMap* channel(const Engine& engine, MapChannel channel);
  /// Counts how often `channel` has returned a different map.
  int channelVersion() const { return channelVersion_; }

  RequestOverrides& overrides() { return overrides_; }
  const RequestOverrides& overrides() const { return overrides_; }

 private:
  struct ChannelKey {
    MapChannel channel;
    int version, pass;
    bool operator==(const ChannelKey&) const = default;
  };
  void rememberRun(const Engine& engine);
  std::optional<ValueMap> read(const Engine& engine, MapChannel channel) const;

  int engraving_ = 0, carving_ = 0;
  int version_ = 0;  // of the data taken over
  bool done_ = false;
  std::optional<SearchView> search_;
  std::array<std::optional<Run>, kSolvers> runs_;
  std::optional<int> pass_;
  std::optional<SubmodulePlace> selected_;
  std::optional<ChannelKey> channelKey_;
  std::optional<ValueMap> channel_;
  int channelVersion_ = 0;
  RequestOverrides overrides_;
};

}  // namespace qrelief
