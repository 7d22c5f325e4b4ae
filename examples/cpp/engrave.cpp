// SPDX-License-Identifier: GPL-3.0-or-later
// Engraves a link into a model: engrave IN.stl OUT.stl X,Y,Z-of-the-centre-in-mm
#include <cstdio>
#include <qrelief/io/read_model.h>
#include <qrelief/native/engraver.h>
#include <qrelief/native/files.h>
#include <qrelief/native/graphics.h>

using namespace qrelief;

int main(int argc, char** argv) {
  EngraveRequest request;
  request.code.text = "https://example.org";
  if (argc != 4 || std::sscanf(argv[3], "%lf,%lf,%lf", &request.placement.centreMm.x, &request.placement.centreMm.y,
                               &request.placement.centreMm.z) != 3)
    return 2;
  const Graphics graphics = Graphics::open();
  const auto model = prepareModel(readModel(readFile(argv[1]).value(), argv[1]).value(), {}).value();
  const auto engraver = Engraver::create(EngravableModel::create(model, graphics.pass)).value();
  const auto engraved = engraver.engrave(request, [](const Progress&) {}).value();
  std::printf("%d of %d tries decode it\n", engraved.reading.count.reads, engraved.reading.count.tries);
  return writeFileAtomically(argv[2], engraved.result.stl) ? 0 : 1;
}
