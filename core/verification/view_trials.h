// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace qrelief {

/// Where readers are put to find out from how far aside and from how far away a code reads.
inline constexpr std::array kTiltsDeg = {5.0, 10.0, 15.0, 30.0, 45.0};
inline constexpr std::array kAzimuthsDeg = {0.0, 90.0, 180.0, 270.0};
/// Pixels a module, from the nearest to the farthest.
inline constexpr std::array kDistancesPx = {10.0, 8.0, 6.5, 5.0, 4.0, 3.3, 2.6, 2.0};

/// How far a phone may be for a module to be so many pixels wide in its video: 1920 pixels that see 65°.
double videoDistanceMm(double moduleMm, double pixelsPerModule);

/// One picture that a reader is given: from aside, or from the front and far away.
struct ViewTrial {
  double tiltDeg = 0, azimuthDeg = 0;
  std::optional<double> pixelsPerModule = {};
};

/// What the trials come to.
struct ViewTrialSummary {
  struct Tilt {
    double tiltDeg = 0;
    int reads = 0, all = 0;  ///< of the azimuths
  };
  std::vector<Tilt> tilts;  ///< up to the first at which nothing reads
  double safeTiltDeg = 0;   ///< up to which every azimuth reads; 0: only straight ahead
  std::optional<double>
      pixelsPerModule;  ///< least with which it reads, without a gap from the nearest; none: with none
};

/// Trials one after the other; those that cannot succeed any more are left out.
class ViewTrials {
 public:
  /// @param pixelsPerModule  of the picture from the front: only coarser ones are tried
  explicit ViewTrials(double pixelsPerModule);

  bool done() const { return next_ == trials_.size(); }
  /// The one that is due; not after the last.
  const ViewTrial& due() const { return trials_[next_]; }
  /// What came of it.
  void note(bool read);

  std::size_t tried() const { return next_; }
  std::size_t all() const { return trials_.size(); }
  ViewTrialSummary summary() const;

 private:
  std::vector<ViewTrial> trials_;
  std::vector<bool> read_;  // of those noted; false for those left out
  std::vector<bool> leftOut_;
  std::size_t next_ = 0;
};

}  // namespace qrelief
