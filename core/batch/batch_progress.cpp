// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_progress.h"

#include <algorithm>
#include <array>
#include <utility>

namespace qrelief {
namespace {

constexpr std::array<std::string_view, 4> kStateNames = {"waiting", "running", "done", "failed"};
constexpr std::size_t kMostLosses = 3;  // without a carved row in between

}  // namespace

std::string_view rowStateName(RowState state) { return kStateNames[static_cast<std::size_t>(state)]; }

std::optional<RowState> readRowState(std::string_view name) {
  const auto it = std::find(kStateNames.begin(), kStateNames.end(), name);
  if (it == kStateNames.end()) return std::nullopt;
  return static_cast<RowState>(it - kStateNames.begin());
}

BatchProgress::BatchProgress(const BatchLayout& layout, const Shard& share)
    : layout_(layout), share_(share), states_(layout.rows, RowState::Waiting) {
  counts_.waiting = layout_.rowsOf(share_);
}

std::string_view BatchProgress::reason(std::size_t row) const {
  const auto it = reasons_.find(row);
  return it == reasons_.end() ? std::string_view() : it->second;
}

std::vector<std::size_t> BatchProgress::page(std::optional<RowState> state, std::size_t skipped,
                                             std::size_t count) const {
  std::vector<std::size_t> rows;
  std::size_t passed = 0;
  for (std::size_t row = state ? 0 : skipped; row < states_.size() && rows.size() < count; ++row)
    if (!state || (states_[row] == *state && passed++ >= skipped)) rows.push_back(row);
  return rows;
}

std::size_t& BatchProgress::countOf(RowState state) {
  const std::array<std::size_t*, 4> counts = {&counts_.waiting, &counts_.running, &counts_.done, &counts_.failed};
  return *counts[static_cast<std::size_t>(state)];
}

void BatchProgress::set(std::size_t row, RowState state, std::string reason) {
  --countOf(states_[row]);
  ++countOf(state);
  states_[row] = state;
  if (state == RowState::Waiting) firstWaiting_ = std::min(firstWaiting_, row);
  if (state == RowState::Failed)
    reasons_[row] = std::move(reason);
  else
    reasons_.erase(row);
}

void BatchProgress::note(const ManifestEntry& entry) {
  const std::size_t row = layout_.rowOf(entry.number);
  if (row >= layout_.rows || !share_.has(layout_.of(row))) return;
  set(row, entry.status == RowStatus::Done ? RowState::Done : RowState::Failed, entry.reason);
}

void BatchProgress::startRun(bool retriesFailed) {
  lost_.clear();
  losses_ = carved_ = 0;
  if (!retriesFailed) return;
  for (std::size_t row = 0; row < states_.size(); ++row)
    if (states_[row] == RowState::Failed) set(row, RowState::Waiting);
}

void BatchProgress::endRun() {
  for (std::size_t row = 0; counts_.running > 0; ++row)
    if (states_[row] == RowState::Running) set(row, RowState::Waiting);
}

std::optional<std::size_t> BatchProgress::take() {
  if (counts_.waiting == 0) return std::nullopt;
  while (states_[firstWaiting_] != RowState::Waiting || !share_.has(layout_.of(firstWaiting_))) ++firstWaiting_;
  const std::size_t unit = layout_.of(firstWaiting_);
  for (std::size_t row = layout_.begin(unit); row < layout_.end(unit); ++row) set(row, RowState::Running);
  return unit;
}

void BatchProgress::settle(std::span<const ManifestEntry> carved) {
  for (const ManifestEntry& entry : carved) note(entry);
  carved_ += carved.size();
  losses_ = 0;
}

BatchProgress::Loss BatchProgress::lose(std::optional<std::size_t> unit) {
  ++losses_;
  if (!unit) return losses_ < kMostLosses ? Loss::Retry : Loss::Stop;
  if (losses_ > kMostLosses) return Loss::Stop;
  if (!lost_.insert(*unit).second) return Loss::Fail;
  for (std::size_t row = layout_.begin(*unit); row < layout_.end(*unit); ++row) set(row, RowState::Waiting);
  return Loss::Retry;
}

std::optional<double> BatchProgress::remainingMs(double workedMs) const {
  if (carved_ == 0) return std::nullopt;
  return workedMs / static_cast<double>(carved_) * static_cast<double>(counts_.waiting + counts_.running);
}

}  // namespace qrelief
