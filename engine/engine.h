// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/carvings.h"
#include "engine/job_map.h"
#include "engine/placed_code.h"
#include "engine/plate.h"
#include "engine/scene.h"
#include "engine/spot_offers.h"
#include "engine/wanted_code.h"

namespace qrelief {

/// What the page asks of the core, as verbs; the state is one model, one place on it, one engraving. Each is kept by a
/// class of its own; this one knows how they hang together, and words their answers.
///
/// Answers are JSON: {"ok": true, …} or {"ok": false, "error": {"code", "message", "hint"}} with the codes BadUsage,
/// BadInput, NoSolution, Internal. Screen positions are CSS pixels from the canvas's upper left, lengths mm. Needs a
/// current GL context from its making to its end; knows nothing of browsers.
class Engine {
 public:
  /// @param renderer  name of the graphics processor, where the caller knows it better than GL_RENDERER (browsers mask
  /// it)
  explicit Engine(const std::string& renderer = {});

  /// {renderer, version, problems: [text]}; with a problem nothing can be drawn or engraved.
  std::string capabilities() const;

  /// {model: {format, scaleToMm, triangles, vertices, sizeMm, shells, engravable, findings, centre}}; `centre` is the
  /// surface point in the middle of the view, chosen until another is. After an error the old model stays.
  /// @param bytes      the file; freed as soon as it is read
  /// @param scaleToMm  file units → mm; 0: as the file says (3MF), else 1
  std::string loadModel(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm);

  /// See readSettings. What is engraved follows from the last call.
  std::string configure(const std::string& settings);
  /// See describeSymbol; changes nothing.
  std::string symbol(const std::string& settings) const;

  /// {hit: false} or {hit: true, centre}; the centre of the code. Shows the model as it was before carving.
  std::string pick(double x, double y);
  /// The same with the surface point nearest to a point in mm.
  std::string setCentre(double x, double y, double z);

  /// {placement: {centre, direction, normal, up, symbolMm, moduleMm, guaranteedMm, rotationDeg, version, modules}}, and
  /// shows the symbol there; `direction` is the one that the centre came with (chooseSpot), else null. Where none fits,
  /// what of it does is shown.
  std::string placement();

  /// {hit: false}, {hit: true, onCode: true} over the code that has its place, else {hit: true, onCode: false, code};
  /// shows the code where it would about lie. `code`: {symbolMm, moduleMm, guaranteedMm, missingShare, exact}.
  std::string hover(double x, double y);
  void endHover();
  /// Starts finding the true place of the code hovered over; ends with the next hover.
  std::string startSettling();
  /// {done} or {done: true, code}; one bounded piece of work. An error where no code fits.
  std::string advanceSettling();
  /// {hit, code}; shows the placed code about there instead, until pick or placement. Beside the model it stays.
  std::string moveCode(double x, double y);
  /// {code}; shows the code turned and of another size, until placement. BadUsage without one.
  std::string adjustCode(double rotateDeg, double symbolMm);

  /// Starts looking for the best spots for the settings; ends an earlier search.
  std::string startSpotSearch();
  /// {stage, fraction, done}; one bounded piece of work. When done the sizes are shown on the model.
  std::string advanceSpotSearch();
  void cancelSpotSearch();
  /// {spots: [{centre, sizeMm, concerns: [message]}], topMm}: best first, with the largest size there and the reasons
  /// why a code may not print or decode there. `topMm` is the size with the last colour of the map. Empty before a
  /// search is done.
  std::string spots() const;
  /// {centre}; the spot becomes the code's centre, with the direction that was found for it.
  std::string chooseSpot(std::size_t index);
  /// The colours of the largest sizes on the model, if they are known.
  void showSizes(bool shown);

  /// {done}; one bounded piece of what the next engraving begins with, so that it has less to do. Nothing is left to do
  /// (done) while something else is at work, and where no code is placed.
  std::string prepareEngrave();
  /// {stage, fraction, done} of the first piece of work.
  /// @param overridden  the settings as they are this time; empty: as configured
  std::string startEngrave(const std::function<EngraveRequest(EngraveRequest)>& overridden = {});
  /// {stage, fraction, done, printable}; one bounded piece of work. When done there is a carved model to be shown
  /// (showCarved). `printable`: its file is written, so that printOrder() and stlToPrint() work.
  std::string advance();
  void cancel();

  /// Number of the finished engraving that can be reported and exported; 0: none.
  int carving() const { return carvings_.number(); }
  /// Brings a finished engraving back and shows it: the last one, or the one before it, of the same model.
  /// @returns whether it is still there
  bool useCarving(int number);

  /// The report of the contract; an error before an engraving is done.
  std::string report() const;
  /// What a phone at the reader's eye sees; empty before an engraving is done.
  const GreyImage& readerImage() const;
  /// The same from aside, see tilted(); empty before an engraving is done, and where it cannot be drawn.
  GreyImage readerImageFrom(double tiltDeg, double azimuthDeg);
  /// What the engraving job worked on, see jobMap in job_map.h.
  std::optional<JobMap> jobMap(const std::string& name) const;
  /// What decoders are to try, each with each of its binarisers: see frontalPictures(). Empty before an engraving.
  std::vector<GreyImage> readingPictures() const;
  /// {passed, next}: whether the code reads by the tries on readingPictures(), and the change to carve with next, or
  /// null; see changeToTryNext().
  /// @param texts   a JSON list, in the pictures' order, binariser by binariser; "" where nothing was read
  /// @param reader  which decoder
  std::string setReadings(const std::string& texts, const std::string& reader);

  /// {order}: parameters of a print for PrintedCode::start(), beside stlToPrint(); null if no print process is chosen.
  /// An error before an engraving is printable, see advance().
  /// @param changed  settings of the printing that are other than those carved with, as JSON: "{}" for none
  std::string printOrder(const std::string& changed) const;
  /// The carved model as binary STL; empty before an engraving is printable.
  std::vector<std::uint8_t> stlToPrint() const;
  /// Puts the tries on the print's pictures into the report. {passed, next}: whether the code reads as carved and as
  /// printed, and the change to carve with next, or null.
  /// @param texts      as of setReadings()
  /// @param facingDeg  see PrintedCode::advance()
  std::string setPrintedReadings(const std::string& texts, double facingDeg);
  /// {prints}: what a print with changed settings comes to; the report does not change.
  /// Other ways of printing the carving that are worth a try (verdict/other_prints.h): {ok, others: [{setting:
  /// value}]}.
  std::string otherPrints() const;
  std::string judgePrint(const std::string& changed, const std::string& texts, double facingDeg) const;
  /// {passed, failed: [message], details}: what the manifest of a batch says of the carving, see describeRow() in
  /// batch/manifest.h, and the checks that did not pass. @param totalMs  that it took altogether
  std::string describeRow(double totalMs) const;

  /// {tried, all}: starts looking from where else the code reads (verification/view_trials.h).
  std::string startViewTrials();
  /// Of the trial that is due; a decoder that reads one of them reads it. Empty where it cannot be drawn.
  std::vector<GreyImage> viewTrialPictures();
  /// {done, tried, all, views: {tilts: [{tiltDeg, reads, all}], safeTiltDeg, forgiving, pixelsPerModule, distanceMm}}
  std::string noteViewTrial(bool read);
  /// The carved model as "stl" (binary), "obj", "ply", "3mf" or "3mf-inlay" (with the body that fills the pockets),
  /// read back and compared; empty before an engraving is done, for another format, if the file would say anything
  /// else, and if the pockets cannot be filled by a solid body.
  std::vector<std::uint8_t> exportModel(const std::string& format);

  /// Begins a plate of copies of the model, each carved with a code of its own; an earlier one is forgotten.
  std::string startPlate(int copies);
  /// Puts the carving that is there on it. @param place  from 0 @param id  the copy's name
  std::string addToPlate(int place, const std::string& id);
  /// The plate as 3MF, read back and compared; it is empty then. Empty bytes if nothing is on it.
  std::vector<std::uint8_t> exportPlate(const std::string& title) { return plate_.taken(title); }

  void resize(double width, double height, double devicePixelRatio) { scene_.resize(width, height, devicePixelRatio); }
  void setTheme(bool dark) { scene_.setTheme(dark); }
  /// "y" or "z": the model's up axis, for the view and as the direction the code's top points to.
  void setUpAxis(const std::string& axis);
  void showCarved(bool carved);
  void orbit(double dx, double dy) { scene_.camera().orbit(dx, dy); }
  void pan(double dx, double dy) { scene_.camera().pan(dx, dy); }
  void zoom(double factor, double x, double y);
  void fit() { scene_.camera().fit(); }
  /// "front", "back", "left", "right", "top", "bottom" or "iso"; others are ignored.
  void standardView(const std::string& name) { scene_.standardView(name); }
  void readerView();
  /// From the reader's side, with the surroundings in view.
  void faceCode();
  /// Cuts the model open across the code, from top to bottom as its reader sees it.
  /// @param offset  of the cut from the code's middle, in half edges of its square: -1 … 1
  void showSection(bool shown, double offset);
  /// Turns to where the section is seen.
  void faceSection();
  /// Shows carved depths as colours. {topMm, deepestMm}: depth of the last colour and of the deepest pocket; 0 where
  /// nothing has been carved.
  std::string showDepths(bool shown);

  /// {code: {corners: [[x, y]], facing, symbolMm, rotationDeg} or null, lamps: [{from: [x, y] or null, to: [x, y]}],
  /// axes: [right, up, back]}. `corners`: of the code and its quiet zone on the QR plane, on the screen, upper left
  /// first, clockwise for the viewer; `facing`: cosine between the camera's direction and the code's; `lamps`: a line
  /// from each lamp to the middle of the code, `from` null for a lamp behind the camera; `axes`: the camera's, z up.
  std::string viewState() const;
  /// A picture of a spot with the code on it; empty if there is no such spot.
  ColourImage spotPicture(std::size_t index, int width, int height);

  /// @param always  present again even if nothing changed, as something is drawn over it
  /// @returns whether another call would improve the picture
  bool draw(bool always = false);

  // For the inspector.
  /// Measures the passes of the engravings that start from now on.
  void timePasses(bool withTimerQueries) { carvings_.timePasses(withTimerQueries); }
  const Carvings& carvings() const { return carvings_; }
  /// As configured.
  const EngraveRequest& settings() const { return wanted_.settings(); }
  /// Distances to the far side of the material, from the eye of the last engraving.
  Result<BackDistanceMap> backDistances() const;
  /// The place in symbol and quiet zone that is seen at a screen position, if the reader sees it, too: (0, 0) = the
  /// quiet zone's upper left, (1, 1) = its lower right. Of the last engraving.
  std::optional<Vec2> codePlaceAt(double x, double y) const;
  const Placement* placed() const { return placedCode_.placement(); }
  const Viewer* viewer() const { return scene_.viewer(); }
  const gl::Capabilities& gl() const { return gl_; }

 private:
  // What the page is told.
  std::string describeModel() const;
  std::string describePlacement() const;
  std::string describeCode(const CodeOnSurface& code) const;

  bool takesCode() const;
  bool showsCarved() const;
  PlacementTask task() const;
  Carvings::Ground ground() const { return {*model_, pass_}; }
  Status placeCode();
  std::string chooseCentre(std::optional<SurfacePoint> point);
  std::optional<SurfacePoint> surfaceAt(double x, double y) const;
  void updateView();

  gl::Capabilities gl_;
  std::vector<Message> problems_;
  std::shared_ptr<const GeometryPass> pass_;
  std::optional<LoadedModel> model_;
  WantedCode wanted_;
  PlacedCode placedCode_;
  SpotOffers offers_;
  Carvings carvings_;
  Plate plate_;
  Scene scene_;
};

}  // namespace qrelief
