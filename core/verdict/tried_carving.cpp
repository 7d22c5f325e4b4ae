// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/tried_carving.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "message_codes/verdict.h"

namespace qrelief {
namespace {

/// Returns the value of the changed mark.
const std::string& markOf(const TriedCarving& offer) {
  const auto mark = std::find_if(offer.changes.begin(), offer.changes.end(),
                                 [](const SettingChange& change) { return change.setting == "mark"; });
  assert(mark != offer.changes.end());
  return mark->value;
}

}  // namespace

const TriedCarving* passedOffer(const std::vector<TriedCarving>& tried) {
  const auto offer =
      std::find_if(tried.begin(), tried.end(), [](const TriedCarving& one) { return one.isOffer && one.passed; });
  return offer == tried.end() ? nullptr : &*offer;
}

Verdict withRemediesLeft(Verdict verdict, const std::vector<TriedCarving>& tried) {
  const auto isInVain = [&](const Remedy& remedy) {
    const auto isAmong = [](const std::vector<SettingChange>& made) {
      return [&made](const SettingChange& change) { return std::find(made.begin(), made.end(), change) != made.end(); };
    };
    return !remedy.changes.empty() && std::any_of(tried.begin(), tried.end(), [&](const TriedCarving& one) {
      return !one.passed && std::all_of(remedy.changes.begin(), remedy.changes.end(), isAmong(one.changes));
    });
  };
  for (Aspect* aspect : {&verdict.reads, &verdict.prints, &verdict.solid}) std::erase_if(aspect->remedies, isInVain);
  const TriedCarving* const offer = passedOffer(tried);
  if (!offer) return verdict;
  Aspect& failing = verdict.reads.passed() ? verdict.prints : verdict.reads;
  const std::string& mark = markOf(*offer);
  failing.remedies.insert(failing.remedies.begin(),
                          {message<"remedy-mark">(with::choice<"mark">("mark", mark)), {{"mark", mark}}});
  return verdict;
}

Error withOffer(Error error, const std::vector<TriedCarving>& tried) {
  const TriedCarving* const offer = passedOffer(tried);
  if (!offer) return error;
  const ReadingCount count = offer->printed.value_or(*offer->reads);
  return {error.kind,
          message<"mark-instead">(with::cause<"cause">(std::move(error.message)), with::term<"mark">(markOf(*offer)),
                                  with::count<"reads">(count.reads), with::count<"tries">(count.tries),
                                  with::lengthMm<"size">(offer->symbolMm))};
}

}  // namespace qrelief
