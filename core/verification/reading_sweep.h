// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verification/baked_light.h"
#include "verification/frontal_reading.h"
#include "verification/symbol_reader.h"

namespace qrelief {

/// What one picture is there to find out.
enum class ReadingTest : std::uint8_t { Frontal, Lamp, Tilt, Distance, Blur, Noise, Exposure };
std::string_view readingTestName(ReadingTest test);

/// One simulated picture and what the reader made of it, in all reading variants (verification/reading_variants.h).
struct ReadingView {
  ReadingTest test = ReadingTest::Frontal;
  bool lamp = false;                   ///< under sky and lamp; else under the sky alone
  double tiltDeg = 0, azimuthDeg = 0;  ///< see tilted()
  double pixelsPerModule = 8;
  Vec2 phase{0};              ///< of the pixel grid, in pixels
  double blurModules = 0.07;  ///< standard deviation, in modules
  double noise = 0.02;        ///< standard deviation at white, linear
  double exposure = 0.85;     ///< see CameraOptions
  // What came of it:
  int tries = 0, reads = 0;    ///< with each variant and reader; reads: gave the wanted text, and not mirrored
  bool mirrored = false;       ///< one gave it mirrored
  std::string otherText = {};  ///< one gave this instead

  bool read() const { return reads > 0; }
};

/// What a sweep comes to.
struct ReadingSummary {
  ReadingCount frontal;  ///< all tries in the frontal pictures
  bool mirrored = false;
  std::string otherText;              ///< that was read instead of the wanted one; empty: none
  std::optional<double> tiltDeg;      ///< up to which every azimuth reads under the sky; none: not even from the front,
                                      ///< or SweepOptions::underLamp
  std::optional<double> tiltDegLamp;  ///< the same under sky and lamp
  std::optional<double> pixelsPerModule;     ///< least with which it reads, without a gap from the nearest
  std::optional<double> blurModules;         ///< greatest standard deviation with which it reads, without a gap
  std::optional<double> cornerErrorModules;  ///< between where it was found and where it should be, the worst corner
};

struct SweepOptions {
  bool ranges = true;      ///< find out how far it can be tilted, blurred and so on, too; else only whether it reads
  bool underLamp = false;  ///< every picture is taken under sky and lamp: the code is meant for nothing else
};

/// Pictures of a baked surface, a few at a time, and what readers make of them.
class ReadingSweep {
 public:
  /// @param light    baked and smoothed, at kBakedPixels a module; kept by reference
  /// @param modules  along the symbol's edge
  /// @param readers  tried one after the other on each picture, each counts; not empty
  ReadingSweep(const BakedLight& light, const ProjectionFrame& frame, int modules, double symbolMm, std::string text,
               std::vector<SymbolReader> readers, const SweepOptions& options);

  /// Takes the next picture and reads it. @returns whether that was the last
  bool step();
  double doneFraction() const { return static_cast<double>(next_) / static_cast<double>(views_.size()); }

  const std::vector<ReadingView>& views() const { return views_; }
  /// After the last step.
  ReadingSummary summary() const;

 private:
  std::vector<float> luminanceOf(const ReadingView& view);
  void read(ReadingView& view, const GreyImage& picture);

  const BakedLight* light_;
  ProjectionFrame frame_;
  int modules_;
  double symbolMm_;
  std::string text_;
  std::vector<SymbolReader> readers_;
  SweepOptions options_;
  std::vector<ReadingView> views_;
  std::size_t next_ = 0;
  LinearPicture seen_;  // by the camera of the view before
  double seenTilt_ = -1, seenAzimuth_ = 0;
  std::optional<double> cornerError_;
};

/// Texels of the bake, and pixels of the pictures before they are resampled, along a module's edge.
inline constexpr int kBakedPixels = 10;

/// Means over the submodules of symbol and quiet zone, row-major from the quiet zone's top left, 1 = unoccluded.
/// @param picture  luminance at kBakedPixels a module, with the margin of a picture, 1 = unoccluded; row 0 at the
/// bottom
/// @param modules  along the symbol's edge
std::vector<double> submoduleMeans(std::span<const float> picture, int modules);

/// The same of baked light. What lies beside the model counts as open.
/// @param light      baked at kBakedPixels a module, with the margin of a picture
/// @param underLamp  of sky and lamp; else of the sky alone
std::vector<double> submoduleLight(const BakedLight& light, int modules, bool underLamp);

/// Modules that the pictures show beyond the symbol on each side: quiet zone and something else.
inline constexpr int kPictureMarginModules = 6;

}  // namespace qrelief
