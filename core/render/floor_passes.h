// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "gl/objects.h"
#include "render/luminance_pass.h"

namespace qrelief {

/// Goal of one floor in a depth search.
struct FloorTarget {
  float around = 1;            ///< light of its surroundings, > 0, 1 = an unoccluded surface in the QR plane
  float greatestFraction = 1;  ///< of that light, 0 … 1
  float limitMm = 0;           ///< greatest depth, a multiple of the quantum, ≥ 0
};

/// Parameters of a pass that moves the floors: see depth/fast_search.h.
struct FloorMove {
  int sweeps = 1;  ///< over all floors, towards the solution on a plane
  float aim = 0, aimForTooBright = 0;
  float changeFraction = 0, maxChange = 0;
  float leastGrowthMm = 0;  ///< of a floor that is too bright
  bool isFree = true;       ///< depths may rise and fall
};

/// The update of a depth search on the GPU: luminances in, depths out, both as textures, so that nothing waits for a
/// read-back. depth/shader_search.h describes the search. The floors of pockets are cells of a LuminancePass's map.
class FloorPasses {
 public:
  struct Setup {
    int cellsAlongEdge = 0;            ///< of the map
    std::vector<std::uint32_t> cells;  ///< of the floors, row-major from the map's lower left; not empty
    /// Paths along which a floor looks for its horizon: a row of 16 directions per step; column and row of the cell
    /// from the floor's own, rows counted upwards, and 1 / distance, which is 0 beyond the end.
    std::vector<glm::vec4> steps;
    float quantumMm = 0.01f;  ///< step of the depths
    int records = 1;          ///< measurements that can be recorded between two read-backs
  };

  /// Depth and luminance of a floor in a recorded measurement.
  struct Recorded {
    float depthMm = 0, luminance = 0;
  };

  /// @param programs  of the LuminancePass
  static Result<FloorPasses> create(const Setup& setup, std::shared_ptr<const LuminancePrograms> programs);

  /// Sets the targets of the floors, in the order of Setup::cells.
  void setTargets(std::span<const FloorTarget> targets);

  /// Starts at a flat surface.
  /// @param depthMm     where the solver starts
  /// @param difference  of every floor: log((1 − v)/v) of the measured v minus the same on a plane, as first estimate
  void start(float depthMm, float difference);

  /// Compares the luminances of floors with the plane's.
  /// @param luminance  R32F, one texel per cell
  /// @param all        all floors were measured; else those that are due (LuminancePass::runOnFloors)
  /// @param isFirst    there was no measurement since start() or setTargets()
  void compare(const gl::Texture& luminance, bool all, bool isFirst);

  /// Moves the floors.
  void move(const gl::Texture& luminance, const FloorMove& how);

  /// Records the floors' depths and luminances.
  /// @param record  < Setup::records
  void record(const gl::Texture& luminance, int record);

  /// Reads all records back: waits for the GPU.
  /// @returns record by record, in the order of Setup::cells
  std::vector<Recorded> readRecords(int count) const;

  /// Returns the floors, RGBA32F, one texel per cell; the first component is the depth, mm.
  const gl::Texture& floors() const { return floors_.now(); }

 private:
  /// Two textures; each pass reads one and writes the other.
  struct PingPong {
    std::array<gl::Texture, 2> textures;
    std::array<gl::Framebuffer, 2> targets;
    std::size_t current = 0;

    static Result<PingPong> create(int edge, gl::Format format);
    const gl::Texture& now() const { return textures[current]; }
    void bindNext() const { targets[1 - current].bind(); }
    void flip() { current = 1 - current; }
  };

  int listRows() const { return (static_cast<int>(setup_.cells.size()) + edge() - 1) / edge(); }
  int edge() const { return setup_.cellsAlongEdge; }
  const gl::Program& use(const gl::Program& program, const gl::Texture& luminance) const;

  Setup setup_;
  std::shared_ptr<const LuminancePrograms> programs_;
  PingPong floors_, solved_;
  gl::Texture targets_, steps_, list_, records_;
  gl::Framebuffer recordsTarget_;
};

}  // namespace qrelief
