// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/engrave.h"

#include <future>
#include <map>

#include "base/clock.h"
#include "native/read_carving.h"
#include "pipeline/verify.h"

namespace qrelief {
namespace {

struct Print {
  PrintedEvidence evidence;
  double ms = 0;
};

/// Simulates and decodes the print of a carving. Needs no GL context, so it can run in parallel.
Result<Print> printed(const VerifyRequest& request, const Mesh& carved) {
  const auto start = Clock::now();
  auto evidence = readPrinted(request, carved, [](const Progress&) {});
  QRELIEF_TRY(evidence);
  return Print{std::move(**evidence), millisecondsSince(start)};  // prints are simulated only if there is a process
}

}  // namespace

Result<Engraved> engrave(Engraver& engraver, const EngraveRequest& request, const EngravePlan::Options& options,
                         const std::function<void(const Progress&)>& tell,
                         const std::function<void(const Engraved&)>& whilePrinting) {
  Engraving engraving(engraver, request, options);
  std::map<int, std::future<Result<Print>>> prints;  // by attempt: of the best one and the current one
  for (;;) {
    tell(engraving.progress());
    const auto step = engraving.advance();
    QRELIEF_TRY(step);
    const EngravePlan& plan = engraving.plan();
    const EngraveResult* const written = engraving.printable();
    if (written && plan.expectsPrint() && !prints.contains(plan.attempt()))
      prints[plan.attempt()] =
          std::async(std::launch::async, printed, verifyRequestOf(plan.request(), *written), written->mesh);
    if (*step == Engraving::Step::Done) return std::move(*engraving.best());
    if (*step == Engraving::Step::Decode) {
      const auto start = Clock::now();
      const ReadingEvidence reading = readCarving(engraving.current()->request, engraving.current()->result);
      engraving.decoded(reading, millisecondsSince(start));
    } else if (*step == Engraving::Step::Print) {
      const Engraved& carving = *engraving.current();
      const auto early = prints.find(carving.attempt);
      if (early != prints.end()) whilePrinting(carving);
      const auto print = early != prints.end()
                             ? early->second.get()
                             : printed(verifyRequestOf(carving.request, carving.result), carving.result.mesh);
      QRELIEF_TRY(print);
      engraving.printed(print->evidence, print->ms);
    }
    std::erase_if(prints, [&](const auto& one) {
      return one.first != engraving.plan().kept() && one.first != engraving.plan().attempt();
    });
  }
}

}  // namespace qrelief
