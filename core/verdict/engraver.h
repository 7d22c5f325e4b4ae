// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <memory>
#include <optional>

#include "pipeline/engrave.h"

namespace qrelief {

/// Begins the carvings of one model. Caches shader programs, places and their measurements, and prepares the next
/// carving in advance. Needs the model's GL context, if it has one.
class Engraver {
 public:
  /// @param model      checked: see PreparedModel::engravable()
  /// @param maxPlaces  number of places to remember, ≥ 1; each costs memory
  explicit Engraver(std::shared_ptr<const EngravableModel> model, std::size_t maxPlaces = 8);

  const EngravableModel& model() const { return *model_; }
  std::shared_ptr<const EngravableModel> sharedModel() const { return model_; }
  /// Sets the device for carvings that begin from now on.
  void setDevice(Device device) { device_ = device; }
  /// Returns the programs that compute light, compiled at the first call. Needs a GL context.
  Result<std::shared_ptr<const LuminancePrograms>> programs();

  /// Adds a place to the cache.
  /// @param found  for searchedPlacement() of the request and its symbol
  void remember(const EngraveRequest& request, FoundPlacement found);
  /// Does one bounded piece of the work that the engraving of a request begins with, if its place is known. Keeps the
  /// work of the last kPreparedKept requests.
  /// @param withSearch  also the whole first search for depths
  /// @returns true if nothing is left to do
  bool prepare(const EngraveRequest& request, bool withSearch);
  /// Returns the job of that work; null: there is none.
  const CarveJob* prepared(const EngraveRequest& request) const;

 private:
  friend class Engraving;

  struct Place {
    int modules;
    PlacementRequest request;
    FoundPlacement found;
    std::shared_ptr<PlacementMeasurement> measured;  // by the last carving there
  };
  /// A carving under way.
  struct Work {
    EngraveRequest request;
    int modules = 0;
    std::unique_ptr<CarveJob> job;
    int steps = 0;  // done so far
    double ms = 0;  // so far, with the search for the place
  };

  Place* placeOf(const EngraveRequest& request, int modules);
  Result<Work> create(const EngraveRequest& request, bool sharesMeasurement);
  Result<Work> begin(const EngraveRequest& request);
  static Result<Progress> advance(Work& work);
  static bool isPrepared(const Work& work, bool withSearch);
  void keepPlace(const Work& work);

  std::shared_ptr<const EngravableModel> model_;
  std::size_t maxPlaces_;
  Device device_ = Device::Faster;
  std::shared_ptr<const LuminancePrograms> programs_;
  std::list<Place> places_;  // the last one first
  static constexpr std::size_t kPreparedKept = 2;
  std::list<Work> prepared_;  // the last one first
};

}  // namespace qrelief
