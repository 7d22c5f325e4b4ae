// SPDX-License-Identifier: GPL-3.0-or-later
// Takes pictures of one sample's codes for the page's gallery, as designed and as printed: with the defaults, for one
// lamp, and with every module pattern and finder pattern (`script/gallery`). Writes FOLDER/SAMPLE.json and the PNG
// files that it names.
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "messages/sentences.h"
#include "native/egl_context.h"
#include "native/engrave.h"
#include "native/files.h"
#include "native/png_file.h"
#include "pipeline/printed_view.h"
#include "settings/settings.h"
#include "study/study_context.h"

namespace qrelief::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMaxSizeMm = 30;
constexpr DirectionalLight kLamp{.azimuthDeg = 90, .elevationDeg = 33, .strength = 1};

/// One code of the gallery.
struct Exhibit {
  std::string kind;  ///< "default", "lamp" or "pattern"
  Json settings;     ///< settings that differ from the defaults, by key
  EngraveRequest request;
};

std::vector<Exhibit> exhibits(const EngraveRequest& usual, bool withPatterns) {
  std::vector<Exhibit> all{{"default", Json::object(), usual}};
  EngraveRequest forLamp = usual;
  forLamp.depth.lights = {kLamp};
  all.push_back({"lamp",
                 {{"light", fmt::format("{:g},{:g},{:g}", kLamp.azimuthDeg, kLamp.elevationDeg, kLamp.strength)}},
                 forLamp});
  for (int modules = 0; withPatterns && modules < 5; ++modules)
    for (int finders = 0; finders < 5; ++finders) {
      EngraveRequest request = usual;
      request.code.modulePattern = static_cast<ModulePattern>(modules);
      request.code.finderPattern = static_cast<FinderPattern>(finders);
      request.depth.keepPreset = true;
      all.push_back({"pattern",
                     {{"pattern", modulePatternName(*request.code.modulePattern)},
                      {"finderPattern", finderPatternName(*request.code.finderPattern)}},
                     request});
    }
  return all;
}

/// Halves width and height.
GreyImage halved(const GreyImage& image) {
  GreyImage half{image.width / 2, image.height / 2, {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const auto at = [&](int dx, int dy) {
        return int{image.pixels[static_cast<std::size_t>((2 * y + dy) * image.width + 2 * x + dx)]};
      };
      half.pixels.push_back(static_cast<std::uint8_t>((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4));
    }
  return half;
}

Status writePicture(const std::string& path, const GreyImage& image) {
  const auto png = encodePng(halved(image));
  QRELIEF_TRY(png);
  return writeFileAtomically(path, *png);
}

Result<GreyImage> printedPicture(const Engraved& engraved) {
  const auto request = printedViewOf(verifyRequestOf(engraved.request, engraved.result));
  QRELIEF_TRY(request);
  auto job = PrintedViewJob::create(engraved.result.mesh, **request);
  QRELIEF_TRY(job);
  auto view = runToEnd(**job);
  QRELIEF_TRY(view);
  return std::move(view->seen.clean);
}

Result<Json> show(Engraver& engraver, const Exhibit& exhibit, const std::string& folder, const std::string& name) {
  const auto engraved = engrave(engraver, exhibit.request);
  QRELIEF_TRY(engraved);
  const auto printed = printedPicture(*engraved);
  QRELIEF_TRY(printed);
  const std::string designedFile = name + "-designed.png", printedFile = name + "-printed.png";
  QRELIEF_TRY(writePicture(folder + "/" + designedFile, engraved->result.readerView.clean));
  QRELIEF_TRY(writePicture(folder + "/" + printedFile, *printed));
  return Json{{"kind", exhibit.kind},
              {"settings", exhibit.settings},
              {"designed", designedFile},
              {"printed", printedFile},
              {"depthMm", summarise(engraved->result.depths).meanMm},
              {"moduleMm", engraved->result.placement.moduleMm},
              {"reads", engraved->reading.count.reads},
              {"printedReads", engraved->printed->reading.count.reads},
              {"tries", engraved->reading.count.tries}};
}

Status make(const std::string& sample, const std::string& samples, const std::string& folder, bool withPatterns) {
  const auto gl = EglContext::create();
  QRELIEF_TRY(gl);
  StudyContext context(samples);
  const auto model = context.model(sample);
  QRELIEF_TRY(model);
  auto usual = context.usualRequest(sample);
  QRELIEF_TRY(usual);
  usual->code.symbol.version.reset();
  usual->depth.keepPreset = false;
  usual->depth.carveFor = defaultRequest().depth.carveFor;
  usual->print.buildUp = {};
  usual->placement.sizeMode = SizeMode::Best;
  usual->placement.maxSizeMm = kMaxSizeMm;
  Engraver engraver(*model);
  Json pictures = Json::array();
  int number = 0;
  for (const Exhibit& exhibit : exhibits(*usual, withPatterns)) {
    const auto one = show(engraver, exhibit, folder, fmt::format("{}-{}", sample, number++));
    QRELIEF_TRY(one);
    pictures.push_back(*one);
  }
  const std::string json = Json{{"sample", sample}, {"exhibits", pictures}}.dump(1) + "\n";
  return writeFileAtomically(folder + "/" + sample + ".json", json);
}

}  // namespace
}  // namespace qrelief::study

int main(int argc, char** argv) {
  CLI::App app("Makes the gallery's pictures of one sample");
  std::string sample, samples, folder;
  bool withPatterns = false;
  app.add_option("SAMPLE", sample, "its id")->required();
  app.add_option("--samples", samples, "folder of the page's sample models")->required();
  app.add_option("--out", folder, "folder for the pictures, which is there")->required();
  app.add_flag("--patterns", withPatterns, "with every module pattern and finder pattern, too");
  CLI11_PARSE(app, argc, argv);
  if (const auto status = qrelief::study::make(sample, samples, folder, withPatterns); !status) {
    fmt::print(stderr, "{}: {}\n", sample, qrelief::sentenceAndHint(status.error().message));
    return 1;
  }
  return 0;
}
