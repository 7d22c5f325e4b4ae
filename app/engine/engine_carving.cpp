// SPDX-License-Identifier: GPL-3.0-or-later
// Implements the verbs that use a carving: show, decode, print, report and export it.
#include <algorithm>
#include <cassert>

#include "base/parse_json.h"
#include "engine/answers.h"
#include "engine/engine.h"
#include "engine/printed_code.h"
#include "io/write_model.h"
#include "io/write_stl.h"
#include "report/json_parts.h"
#include "verdict/other_prints.h"

namespace qrelief {

bool Engine::useCarving(int number) {
  if (!carvings_.use(number)) return false;
  showCarved(true);
  return true;
}

bool Engine::showsCarved() const {
  return scene_.surface() == Scene::Surface::Carved && carvings_.madeDisplay() != nullptr;
}

void Engine::hideCarved() {
  scene_.show(Scene::Surface::Carved, false);
  updateView();
}

void Engine::showCarved(bool carved) {
  print_.reset();
  scene_.show(Scene::Surface::Carved, carved);
  if (carved && model_) carvings_.display(ground());
  endHover();
  updateView();
}

std::string Engine::report() const { return carvings_.result() ? carvings_.report(*model_, gl_) : answer(kNoResult); }

GreyImage Engine::readerImageFrom(double tiltDeg, double azimuthDeg) {
  return carvings_.result() ? carvings_.readerImageFrom(ground(), tiltDeg, azimuthDeg) : GreyImage{};
}

std::vector<GreyImage> Engine::pictures(const std::string& of) {
  if (!carvings_.result()) return {};
  if (of == "view-trial") return carvings_.viewTrialPictures(ground());
  const ReaderView& seen = carvings_.result()->readerView;
  if (of == "reader") return {seen.picture};
  assert(of == "reading");
  if (seen.luminance.empty()) return {};  // a text alone
  return frontalPictures(seen.luminance, seen.pixelsPerModule);
}

std::string Engine::setReadings(const std::string& texts, const std::string& reader) {
  if (!carvings_.result()) return answer(kNoResult);
  const Result<Json> read = parseJson(texts);
  if (!read) return answer(read.error());
  const Verdict& verdict = carvings_.setReadings(read->get<std::vector<std::string>>(), reader);
  return textOf({{"ok", true}, {"passed", verdict.reads.passed()}});
}

std::string Engine::printOrder(const std::string& changed) const {
  if (!carvings_.printable()) return answer(kNoResult);
  const auto view = carvings_.printedView(changed);
  if (!view) return answer(view.error());
  return textOf({{"ok", true}, {"order", *view ? jsonOf(**view) : Json()}});
}

std::string Engine::setPrintedReadings(const std::string& texts, double facingDeg) {
  if (!carvings_.result() || !carvings_.result()->request.print.process) return answer(kNoResult);
  const Result<Json> read = parseJson(texts);
  if (!read) return answer(read.error());
  const Verdict& verdict = carvings_.setPrintedReadings(read->get<std::vector<std::string>>(), facingDeg);
  return textOf({{"ok", true},
                 {"passed", verdict.reads.passed() && carvings_.printed()->reading.count.enough()},
                 {"more", carvings_.engraving() && carvings_.engraving()->isWorking()}});
}

std::string Engine::otherPrints() const {
  if (!carvings_.result()) return answer(kNoResult);
  Json others = Json::array();
  for (const SettingChange& other :
       qrelief::otherPrints(verifyRequestOf(carvings_.result()->request, *carvings_.result())))
    others.push_back({{other.setting, other.value}});
  return textOf({{"ok", true}, {"others", others}});
}

std::string Engine::judgePrint(const std::string& changed, const std::string& texts, double facingDeg) const {
  if (!carvings_.result()) return answer(kNoResult);
  const Result<Json> read = parseJson(texts);
  if (!read) return answer(read.error());
  const auto prints = carvings_.judgePrint(changed, read->get<std::vector<std::string>>(), facingDeg);
  if (!prints) return answer(prints.error());
  return textOf({{"ok", true}, {"prints", describeAspect(*prints, {})}});
}

std::string Engine::describeRow(double totalMs) const {
  if (!carvings_.result()) return answer(kNoResult);
  const auto row = carvings_.row(totalMs);
  Json failed = Json::array();
  for (const Message& check : row.verdict.failed()) failed.push_back(jsonOf(check));
  return textOf({{"ok", true},
                 {"passed", row.verdict.passed()},
                 {"failed", std::move(failed)},
                 {"details", Json::parse(row.details)}});
}

std::vector<std::uint8_t> Engine::exportModel(const std::string& format, const std::string& slicer, int carving) {
  if (format == "stl" && carving == 0)
    return carvings_.printable() ? writeStl(carvings_.printable()->mesh) : std::vector<std::uint8_t>();
  const int number = carving > 0 ? carving : carvings_.number();
  const auto program = slicerByName(slicer);
  return model_ && program ? carvings_.exported(*model_, format, *program, number) : std::vector<std::uint8_t>();
}

std::vector<NamedFile> Engine::exportFiles(const std::string& name, int carving) {
  const int number = carving > 0 ? carving : carvings_.number();
  return model_ ? carvings_.exportedFiles(*model_, name, number) : std::vector<NamedFile>();
}

std::vector<std::uint8_t> Engine::exportMaps(int carving) {
  const int number = carving > 0 ? carving : carvings_.number();
  return model_ ? carvings_.exportedMaps(*model_, number) : std::vector<std::uint8_t>();
}

std::string Engine::addToPlate(int place, const std::string& id, int copies) {
  if (!carvings_.result()) return answer(kNoResult);
  const auto size = [](int count) { return static_cast<std::size_t>(std::max(count, 0)); };
  if (plate_.isEmpty()) plate_.start(size(copies));
  plate_.add(*model_, *carvings_.result(), carvings_.result()->request, size(place), id);
  return done();
}

std::optional<JobMap> Engine::jobMap(const std::string& name) const {
  return carvings_.job() ? qrelief::jobMap(*carvings_.job(), name) : std::nullopt;
}

}  // namespace qrelief
