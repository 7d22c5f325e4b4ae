// SPDX-License-Identifier: GPL-3.0-or-later
// Engraves a link into a model: engrave IN OUT [X,Y,Z-of-the-centre-in-mm]. Without a centre it takes the best spot.
#include <cstdio>
#include <cstdlib>
#include <qrelief/delivery/carved_file.h>
#include <qrelief/io/read_model.h>
#include <qrelief/messages/sentences.h>
#include <qrelief/native/engrave.h>
#include <qrelief/native/files.h>
#include <qrelief/native/graphics.h>
#include <qrelief/pipeline/best_spot.h>

using namespace qrelief;

/// Returns the value. Prints an error and ends the program.
template <class T>
T valueOf(Result<T> result) {
  if (!result) std::fprintf(stderr, "%s\n", sentenceAndHint(result.error().message).c_str()), std::exit(1);
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

int main(int argc, char** argv) {
  EngraveRequest request;
  request.code.text = "https://example.org";
  Vec3& centre = request.placement.centreMm;
  const bool isPlaced = argc == 4 && std::sscanf(argv[3], "%lf,%lf,%lf", &centre.x, &centre.y, &centre.z) == 3;
  if (argc != 3 && !isPlaced) return std::puts("engrave IN OUT [X,Y,Z]"), 2;
  const PolygonSoup soup = valueOf(readModel(valueOf(readFile(argv[1])), argv[1]));
  PreparedModel prepared = valueOf(prepareModel(soup, {.scaleToMm = soup.unitMm.value_or(1)}));
  const Graphics graphics = Graphics::open();
  const auto model = EngravableModel::create(std::move(prepared), graphics.pass);
  if (!isPlaced) request.placement = placedAt(valueOf(bestSpot(model, request)), request.placement);
  Engraver engraver(model);
  const Engraved engraved = valueOf(engrave(engraver, request));
  std::printf("%d of %d tries decode it\n", engraved.reading.count.reads, engraved.reading.count.tries);
  const CarvedFiles carved = valueOf(encodeCarved(model->prepared, engraved.result, argv[2]));
  for (const NamedFile& file : carved.files) valueOf(writeFileAtomically(file.name, file.bytes));
}
