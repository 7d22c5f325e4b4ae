// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress_bar.h"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

#include "messages/sentences.h"

namespace qrelief {

ProgressBar::ProgressBar(bool quiet, double share)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0), to_(share) {}

ProgressBar::~ProgressBar() { hide(); }

void ProgressBar::next(double share) {
  from_ = to_;
  to_ = share < 1 ? to_ + share * (1 - to_) : 1;
}

void ProgressBar::finish() {
  to_ = 1;
  if (shown_ < 1) show({stage_, 1, true});
  hide();
}

void ProgressBar::hide() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

void ProgressBar::show(const Progress& progress) {
  if (quiet_) return;
  const double fraction = progress.fraction < 1 ? from_ + progress.fraction * (to_ - from_) : to_;
  const bool isEnd = fraction == 1 && shown_ < 1;
  shown_ = fraction;
  if (terminal_) {
    constexpr int width = 30;
    const int filled = static_cast<int>(std::lround(fraction * width));
    fmt::print(stderr, "\r\033[K{:=<{}}{:-<{}} {:3.0f} % {}", "", filled, "", width - filled, 100 * fraction,
               sentence(progress.stage));
    std::fflush(stderr);
    drawn_ = true;
  } else if (progress.stage != stage_ || isEnd) {
    fmt::print(stderr, "{:3.0f} % {}\n", 100 * fraction, sentence(progress.stage));
  }
  stage_ = progress.stage;
}

}  // namespace qrelief
