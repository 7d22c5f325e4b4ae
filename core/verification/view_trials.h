// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace qrelief {

/// Tilts and azimuths to try, to find the largest tilt at which a code decodes.
inline constexpr std::array kTiltsDeg = {5.0, 10.0, 15.0, 30.0, 45.0};
inline constexpr std::array kAzimuthsDeg = {0.0, 90.0, 180.0, 270.0};
/// Resolutions to try, in pixels per module, from the nearest to the farthest.
inline constexpr std::array kDistancesPx = {10.0, 8.0, 6.5, 5.0, 4.0, 3.3, 2.6, 2.0};

/// Returns the distance at which a module is this many pixels wide in a phone's video: 1920 pixels across 65°.
double videoDistanceMm(double moduleMm, double pixelsPerModule);

/// One picture for the decoder: tilted, or from the front and far away.
struct ViewTrial {
  double tiltDeg = 0, azimuthDeg = 0;
  std::optional<double> pixelsPerModule = {};
};

/// Result of the trials.
struct ViewTrialSummary {
  struct Tilt {
    double tiltDeg = 0;
    int reads = 0, all = 0;  ///< azimuths that decode, and azimuths tried
  };
  std::vector<Tilt> tilts;                ///< up to the first tilt at which nothing decodes
  double safeTiltDeg = 0;                 ///< largest tilt up to which every azimuth decodes; 0: only straight ahead
  std::optional<double> pixelsPerModule;  ///< lowest that decodes, with no failure nearer by; none: no distance decodes
};

/// Runs through the trials and skips those that can no longer succeed.
class ViewTrials {
 public:
  /// @param pixelsPerModule  resolution of the picture from the front: only coarser ones are tried
  explicit ViewTrials(double pixelsPerModule);

  bool done() const { return next_ == trials_.size(); }
  /// Returns the trial that is due; call it only before done().
  const ViewTrial& due() const { return trials_[next_]; }
  /// Records the result of the trial that is due.
  void note(bool read);

  std::size_t tried() const { return next_; }
  std::size_t all() const { return trials_.size(); }
  ViewTrialSummary summary() const;

 private:
  std::vector<ViewTrial> trials_;
  std::vector<bool> read_;  // results so far; false for skipped trials
  std::vector<bool> leftOut_;
  std::size_t next_ = 0;
};

}  // namespace qrelief
