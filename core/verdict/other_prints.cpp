// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/other_prints.h"

#include <algorithm>
#include <cmath>

#include "math/angle.h"
#include "printing/build_direction.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

constexpr double kAlikeDeg = 15;  // a model turned by less than this keeps its orientation

bool isAlike(Vec3 a, Vec3 b) { return glm::dot(glm::normalize(a), glm::normalize(b)) > std::cos(toRadians(kAlikeDeg)); }

}  // namespace

std::vector<SettingChange> otherPrints(const VerifyRequest& printed) {
  std::vector<SettingChange> others;
  std::vector<Vec3> stood = {printed.buildUp};
  for (const BuildPose pose : {BuildPose::AsModelled, BuildPose::CodeUp, BuildPose::CodeUpright}) {
    const Vec3 up = BuildDirection{pose}.resolve(printed.frame);
    const bool isKnown = std::any_of(stood.begin(), stood.end(), [&](Vec3 other) { return isAlike(up, other); });
    if (isKnown || glm::dot(up, printed.frame.normal) < 0) continue;  // the code would face down
    stood.push_back(up);
    others.push_back({"buildUp", buildPoseName(pose)});
  }
  std::vector<NamedPrinter> finer;
  for (const NamedPrinter& named : namedPrinters())
    if (named.printer.layerMm < printed.printer.layerMm && named.printer.technique != PrintTechnique::Powder)
      finer.push_back(named);
  std::stable_sort(finer.begin(), finer.end(),
                   [](const NamedPrinter& a, const NamedPrinter& b) { return a.printer.layerMm > b.printer.layerMm; });
  for (const NamedPrinter& named : finer) others.push_back({"process", std::string(named.name)});
  return others;
}

VerifyRequest printedOtherwise(VerifyRequest request, const SettingChange& other) {
  EngraveRequest settings;
  settings.print.printer = request.printer;
  settings.print.process = request.process;
  settings.print.buildUp.up = request.buildUp;
  apply(other, settings);
  request.printer = settings.print.printer;
  request.process = settings.print.process;
  request.buildUp = settings.print.buildUp.resolve(request.frame);
  return request;
}

}  // namespace qrelief
