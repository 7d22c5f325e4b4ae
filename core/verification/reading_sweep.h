// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verification/baked_light.h"
#include "verification/decoder.h"
#include "verification/frontal_reading.h"

namespace qrelief {

/// Purpose of a simulated picture.
enum class ReadingTest : std::uint8_t { Frontal, Lamp, Tilt, Distance, Blur, Noise, Exposure };
std::string_view readingTestName(ReadingTest test);

/// One simulated picture and its decoding results over all reading variants (verification/reading_variants.h).
struct ReadingView {
  ReadingTest test = ReadingTest::Frontal;
  bool lamp = false;                   ///< true: under sky and lamps; false: under the sky alone
  double tiltDeg = 0, azimuthDeg = 0;  ///< see tilted()
  double pixelsPerModule = 8;
  Vec2 phase{0};              ///< offset of the pixel grid, in pixels
  double blurModules = 0.07;  ///< standard deviation, in modules
  double noise = 0.02;        ///< standard deviation at white, linear
  double exposure = 0.85;     ///< see CameraOptions
  // Results:
  int tries = 0, reads = 0;    ///< one try per variant and decoder; reads: tries that gave the wanted text, not
                               ///< mirrored
  bool mirrored = false;       ///< a try gave the text mirrored
  std::string otherText = {};  ///< a try gave this text instead

  bool read() const { return reads > 0; }
};

/// Result of a sweep.
struct ReadingSummary {
  ReadingCount frontal;  ///< all tries in the frontal pictures
  bool mirrored = false;
  std::string otherText;              ///< text decoded instead of the wanted one; empty: none
  std::optional<double> tiltDeg;      ///< largest tilt up to which every azimuth reads under the sky; none: not even
                                      ///< the front reads, or SweepOptions::underLamps is set
  std::optional<double> tiltDegLamp;  ///< the same under sky and lamps
  std::optional<double> pixelsPerModule;     ///< lowest that reads, with no failure nearer by
  std::optional<double> blurModules;         ///< greatest standard deviation that reads, with no failure below it
  std::optional<double> cornerErrorModules;  ///< distance between decoded and expected position, for the worst corner
};

struct SweepOptions {
  bool ranges = true;       ///< true: also find the limits of tilt, blur and so on; false: only check that the code
                            ///< reads
  bool underLamps = false;  ///< take every picture under sky and lamps, because the code is meant for that light
  std::optional<InkMap> ink = {};  ///< of a code in colour
};

/// Takes pictures of a baked surface, a few at a time, and decodes them.
class ReadingSweep {
 public:
  /// @param light    baked and smoothed, at kBakedPixels per module; kept by reference
  /// @param modules  along the symbol's edge
  /// @param decoders  all try each picture, one after the other, and each try counts; not empty
  ReadingSweep(const BakedLight& light, const ProjectionFrame& frame, int modules, double symbolMm, std::string text,
               std::vector<Decoder> decoders, const SweepOptions& options);

  /// Takes the next picture and decodes it.
  /// @returns true after the last
  bool step();
  double doneFraction() const { return static_cast<double>(next_) / static_cast<double>(views_.size()); }

  const std::vector<ReadingView>& views() const { return views_; }
  /// Returns the result; call it after the last step.
  ReadingSummary summary() const;

 private:
  BottomUp<float> luminanceOf(const ReadingView& view);
  void read(ReadingView& view, const GreyImage& picture);

  const BakedLight* light_;
  ProjectionFrame frame_;
  int modules_;
  double symbolMm_;
  std::string text_;
  std::vector<Decoder> decoders_;
  SweepOptions options_;
  std::vector<ReadingView> views_;
  std::size_t next_ = 0;
  LinearPicture seen_;  // by the previous view's camera
  double seenTilt_ = -1, seenAzimuth_ = 0;
  std::optional<double> cornerError_;
};

/// Resolution of the bake and of pictures before resampling: texels or pixels along a module's edge.
inline constexpr int kBakedPixels = 10;

/// Averages over the submodules of symbol and quiet zone, 1 = unoccluded.
/// @param picture          luminance with the margin of a picture, 1 = unoccluded
/// @param modules          along the symbol's edge
/// @param pixelsPerModule  of the picture, ≥ 5; a pixel counts for the submodule that its middle lies in
Grid<double> submoduleMeans(const BottomUp<float>& picture, int modules, int pixelsPerModule = kBakedPixels);

/// Averages baked light in the same way. Texels off the model count as open.
/// @param light      baked at kBakedPixels per module, with the margin of a picture
/// @param underLamps  true: light of sky and lamps; false: of the sky alone
Grid<double> submoduleLight(const BakedLight& light, int modules, bool underLamps);

/// Width of the picture margin on each side of the symbol, in modules: the quiet zone and some of its surroundings.
inline constexpr int kPictureMarginModules = 6;

}  // namespace qrelief
