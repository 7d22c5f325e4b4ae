// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/engraver.h"

#include "base/clock.h"
#include "io/sniff_format.h"
#include "io/write_checked.h"
#include "native/read_carving.h"
#include "pipeline/carved_objects.h"

namespace qrelief {
namespace {

constexpr std::size_t kPlaces = 8;  // rows of a batch may differ in what their place depends on

}  // namespace

Result<Engraver> Engraver::create(std::shared_ptr<const EngravableModel> model) {
  Engraver engraver;
  auto pass = GeometryPass::create();
  if (!pass) return tl::unexpected(pass.error());
  auto programs = LuminancePrograms::create();
  if (!programs) return tl::unexpected(programs.error());
  engraver.model_ = std::move(model);
  engraver.pass_ = std::make_shared<const GeometryPass>(std::move(*pass));
  engraver.programs_ = std::move(*programs);
  return engraver;
}

Result<Engraver::Place*> Engraver::placeOf(const EngraveRequest& request, int modules) const {
  const PlacementRequest wanted = searchedPlacement(request, modules);
  for (Place& place : places_)
    if (place.modules == modules && place.request == wanted) return &place;
  PlacementSearch search(model_->prepared, model_->gpu, *pass_, modules, wanted);
  for (;;) {
    const Result<bool> done = search.step();
    if (!done) return tl::unexpected(done.error());
    if (*done) break;
  }
  places_.push_front({modules, wanted, std::move(search), nullptr});
  if (places_.size() > kPlaces) places_.pop_back();
  return &places_.front();
}

Result<Engraved> Engraver::carve(const EngraveRequest& request, const Tell& tell) const {
  const auto symbol = encodeSymbol(request.text, request.symbol);
  if (!symbol) return tl::unexpected(symbol.error());
  tell({message("finding-direction-and-size"), 0});
  if (const Status good = checkEngraving(*model_, request, *symbol); !good) return tl::unexpected(good.error());
  const auto place = placeOf(request, symbol->size);
  if (!place) return tl::unexpected(place.error());
  Place& known = **place;
  auto job = EngraveJob::create(
      model_, request,
      {.placed = &known.found, .pass = pass_, .programs = programs_, .symbol = &*symbol, .measured = known.measured});
  if (!job) return tl::unexpected(job.error());
  for (;;) {
    const auto progress = (*job)->advance();
    if (!progress) return tl::unexpected(progress.error());
    tell(*progress);
    if (progress->done) break;
  }
  EngraveResult result = (*job)->takeResult();
  known.measured = (*job)->measuredPlace();
  const auto start = Clock::now();
  const auto evidence = readCarving(request, result, tell);
  if (!evidence) return tl::unexpected(evidence.error());
  result.timingsMs.verify += millisecondsSince(start);
  Verdict verdict = judge(request, result, *evidence);
  return Engraved{request, std::move(result), *evidence, {}, std::move(verdict)};
}

/// Finds out how the carving that was decided for comes off the printer.
Status Engraver::print(Engraved& engraved, const Tell& tell) const {
  const auto start = Clock::now();
  auto printed = readPrinted(verifyRequestOf(engraved.request, engraved.result), engraved.result.mesh, tell);
  if (!printed) return tl::unexpected(printed.error());
  if (!*printed) return {};
  engraved.printed = std::move(*printed);
  engraved.result.timingsMs.print = millisecondsSince(start);
  engraved.verdict = judge(engraved.request, engraved.result, engraved.reading, &*engraved.printed);
  return {};
}

Result<Engraved> Engraver::engraveOnce(const EngraveRequest& request, const Tell& tell) const {
  auto carved = carve(request, tell);
  if (!carved) return carved;
  if (const Status printed = print(*carved, tell); !printed) return tl::unexpected(printed.error());
  return carved;
}

Result<Engraved> Engraver::engrave(const EngraveRequest& request, const Tell& tell, bool looksAtPrint) const {
  auto asked = carve(request, tell);
  if (!asked) return asked;
  EngraveRequest deeper = request;
  for (auto next = changeToTryNext(deeper, asked->verdict); next;) {
    apply(*next, deeper);
    auto carved = carve(deeper, tell);
    if (!carved) break;  // what is asked for can be carved: better than nothing
    next = changeToTryNext(deeper, carved->verdict);
    if (!carved->verdict.reads.passed()) continue;
    asked = std::move(carved);
    break;
  }
  if (!looksAtPrint) return asked;
  if (const Status printed = print(*asked, tell); !printed) return tl::unexpected(printed.error());
  return asked;
}

Result<std::vector<std::uint8_t>> encodeCarved(const EngraveResult& result, std::span<const std::string> partNames,
                                               const std::string& fileName, bool withInlay, const std::string& title,
                                               bool ascii) {
  const ModelFormat format = formatOfName(fileName);
  if (format == ModelFormat::Stl && !ascii) return result.stl;
  return writeChecked(carvedObjects(result, partNames, withInlay), format, {.title = title, .ascii = ascii});
}

}  // namespace qrelief
