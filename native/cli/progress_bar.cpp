// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress_bar.h"

#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

#include "messages/sentences.h"

namespace qrelief {

ProgressBar::ProgressBar(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(const Progress& progress) {
  if (quiet_) return;
  if (terminal_) {
    constexpr int width = 30;
    const int filled = static_cast<int>(std::lround(progress.fraction * width));
    fmt::print(stderr, "\r\033[K{:=<{}}{:-<{}} {:3.0f} % {}", "", filled, "", width - filled, 100 * progress.fraction,
               sentence(progress.stage));
    std::fflush(stderr);
    drawn_ = true;
  } else if (progress.stage != stage_) {
    fmt::print(stderr, "{:3.0f} % {}\n", 100 * progress.fraction, sentence(progress.stage));
  }
  stage_ = progress.stage;
}

}  // namespace qrelief
