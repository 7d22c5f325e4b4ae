// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/carvings.h"
#include "engine/code_input.h"
#include "engine/job_map.h"
#include "engine/lamp_hemisphere.h"
#include "engine/placement_preview.h"
#include "engine/plate.h"
#include "engine/scene.h"
#include "engine/spot_offers.h"

namespace qrelief {

/// The core's interface for the page: a set of verbs. Its state is one model, one placement and one engraving. Three
/// classes keep this state; Engine coordinates them and serialises their answers.
///
/// Answers are JSON: {"ok": true, …} or {"ok": false, "error": {"kind", "code", "values"}} with the kinds BadUsage,
/// BadInput, NoSolution, Internal. Answers with a name of their own, such as Placement, are described in
/// web/engine/types.js. Screen positions are CSS pixels from the upper left of the canvas, lengths are mm.
/// With a GL context, needs it to be current for its whole life; without one, engraves all the same but draws nothing.
/// Knows nothing of browsers.
class Engine {
 public:
  /// @param renderer  name of the graphics processor, if the caller knows it better than GL_RENDERER (browsers mask it)
  /// @param hasGl     a GL context is current
  explicit Engine(const std::string& renderer = {}, bool hasGl = true);

  /// Returns Capabilities. With a problem, nothing can be drawn or engraved. Without a GL context the renderer is
  /// "processor".
  std::string capabilities() const;

  /// Loads a model. Returns {model: ModelInfo}. Its centre is the surface point in the middle of the view, and stays
  /// the centre until another one is chosen. After an error the old model stays.
  /// @param bytes      the file; freed as soon as it is parsed
  /// @param scaleToMm  file units → mm; 0: as the file says (3MF), else 1
  std::string loadModel(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm);

  /// Sets the settings for the next engraving, see requestFromJson(). Without "up", the symbol's top points up in the
  /// scene. The last call counts.
  std::string configure(const std::string& settings);

  /// Makes a surface point the centre of the code, and shows the model as it was before carving. Returns {hit: true,
  /// centre, movedMm} if the model is there, else {hit: false}; BadUsage if the spot does not exist. `movedMm`: from
  /// the point at the screen position.
  /// @param where  {"at": [x, y], "exact": false}: the point at a screen position, moved to where the code lies flat
  ///               (engine/nearby_centre.h) unless `exact`; {"mm": [x, y, z]}: the point nearest to this one;
  ///               {"spot": index}: a spot of the last search, with the direction found for it
  std::string setCentre(const std::string& where);

  /// Finds how to print the model with the face at a screen position on the plate: the flat surface around the point.
  /// Returns {hit: true, buildUp}, a value of that setting, or {hit: false} beside the model.
  /// @param at  [x, y]
  std::string layFace(const std::string& at) const;

  /// Finds the place and shows the symbol there. Returns {placement: Placement}. Where no code fits, shows the part
  /// that does; on a model that is too small for any code, none.
  std::string placement();

  /// Returns {construction: Construction}, how the placed code was placed; null if none is placed.
  std::string construction() const;

  /// Shows the code about where it would lie. Returns HoverResult.
  /// @param at  [x, y]: screen position; null: nowhere, so that the code is hidden
  std::string hover(const std::string& at);
  /// Returns {concerns: [message]}, why the hovered code may not print or decode there; none before it has settled.
  std::string hoverConcerns();
  /// Previews a change of the placed code until placement(). Returns {hit, code}; BadUsage if no code is placed.
  /// @param change  {"at": [x, y]}: about another position, until setCentre, too; off the model, the code stays where
  ///                it is. {"rotateDeg", "symbolMm"}: turned and resized
  std::string adjustCode(const std::string& change);

  /// Starts a job. An earlier one of that name ends.
  /// @param job  "engrave": an engraving (verdict/engraving.h). Returns what advanceJob() does
  ///             "spots": the search for the best spots for the settings
  ///             "settling": the search for the exact place of the hovered code; the next hover ends it
  ///             "view-trials": the test of the other angles from which the code decodes (verification/view_trials.h),
  ///                 each step with the pictures of pictures(). Returns {tried, all}
  /// @param options     of "engrave": {"print": look at prints, "fixed": [keys of settings that must not change],
  ///                    "offers": try other marks as remedies}; all may be missing: true, none, false
  /// @param overridden  makes the settings of this one engraving from the configured ones, and the plan changes none;
  ///                    empty: as configured
  std::string startJob(const std::string& job, const std::string& options = "{}",
                       const std::function<EngraveRequest(EngraveRequest)>& overridden = {});
  /// Does one bounded piece of work of a job.
  /// @param job  "engrave": returns {stage, fraction, done, needs, printable, carving, best, changes}. `done`: the host
  ///                 must answer what it `needs` before the next step: "texts" of pictures("reading") by setReadings(),
  ///                 or the "print" of the carving by setPrintedReadings(); null: the carving is the result.
  ///                 `printable`: the file of the attempt is written, so that printOrder() and exportModel("stl") work.
  ///                 `carving`, `best`: numbers of the current carving and of the best one so far; 0: none. `changes`:
  ///                 [{setting, value}] of the attempt from the code as requested. If nothing can be carved, an error
  ///             "spots": returns {stage, fraction, done}; when done, also {spots: [{centre, sizeMm, aimToleranceDeg,
  ///                 concerns: [message]}], topMm, fixedMm}. Best first, with the largest size
  ///                 there and the reasons why a code may not print or decode there; `topMm` is the size that has the
  ///                 last colour of the map, `fixedMm` the fixed size, whose map has two colours, or null
  ///             "settling": returns {done} or {done: true, code}; an error where no code fits
  ///             "preparation": the work that the next engraving begins with, so that the engraving has less to do. It
  ///                 is never started. Returns {done, depths}. There is nothing to do (done) while other work is
  ///                 running or no code is placed. With the search, also shows the code as it will be carved, after
  ///                 the first pass and at the end; then `depths` are {meanMm, maxMm}, else null. Of the hovered
  ///                 code: the same for an engraving where it has settled, as a click would place it
  ///             "view-trials": notes whether one of the trial's pictures decoded. Returns {done, tried, all, views:
  ///                 {tilts: [{tiltDeg, reads, all}], safeTiltDeg, forgiving, pixelsPerModule, distanceMm}}
  /// @param answers  of "view-trials": {"read"}; of "preparation": {"search": the first search for depths, too,
  /// "hovered":
  ///                 of the hovered code}; all other jobs ignore it
  std::string advanceJob(const std::string& job, const std::string& answers = "{}");
  /// Ends "engrave" or "spots". The best carving of an engraving so far becomes the current one.
  void cancelJob(const std::string& job);
  /// Returns the number of the finished engraving that can be reported and exported; 0: none.
  int carving() const { return carvings_.number(); }
  /// Restores and shows a carving of this model that is kept, see Carvings.
  /// @returns true if it still exists
  bool useCarving(int number);

  /// Returns the report (core/report/report.h); an error before an engraving is done.
  std::string report() const;
  /// Returns pictures of the carving; none before an engraving is done.
  /// @param of  "reader": the one picture that a phone at the eye takes; "reading": the pictures for the decoders, each
  ///            to be tried with every binariser, see frontalPictures(); "view-trial": the pictures of the next trial,
  ///            which passes if one of them decodes; none if it cannot be drawn
  std::vector<GreyImage> pictures(const std::string& of);
  /// Returns the picture that a phone takes from the side, see tilted(). Empty before an engraving is done, and where
  /// it cannot be drawn.
  GreyImage readerImageFrom(double tiltDeg, double azimuthDeg);
  /// Returns one of the maps that the engraving job worked on, see jobMap in job_map.h.
  std::optional<JobMap> jobMap(const std::string& name) const;
  /// Stores the texts decoded from pictures("reading"). Returns {passed}: the code decodes.
  /// @param texts   a JSON list, in the order of the pictures, binariser by binariser; "" where nothing was decoded
  /// @param reader  name of the decoder
  std::string setReadings(const std::string& texts, const std::string& reader);

  /// Returns {order}: print parameters for PrintedCode::start(), to pass along with exportModel("stl"). Null if no
  /// print process is chosen. An error before an engraving is printable, see advanceJob().
  /// @param changed  printing settings that differ from the carved request, as JSON: "{}" for none
  std::string printOrder(const std::string& changed) const;
  /// Adds the texts decoded from the print's pictures to the report. Returns {passed, more}: the code decodes as carved
  /// and as printed; the engraving has another attempt to make.
  /// @param texts      as for setReadings()
  /// @param facingDeg  see PrintedCode::advance()
  std::string setPrintedReadings(const std::string& texts, double facingDeg);
  /// Suggests other ways to print the carving that are worth trying (verdict/other_prints.h). Returns {ok, others:
  /// [{setting: value}]}.
  std::string otherPrints() const;
  /// Judges a print with changed settings. Returns {prints}; the report does not change.
  std::string judgePrint(const std::string& changed, const std::string& texts, double facingDeg) const;
  /// Returns {passed, failed: [message], details}: the carving's details for the manifest of a batch, see describeRow()
  /// in batch/manifest.h, and the failed checks. @param totalMs  of all its work
  std::string describeRow(double totalMs) const;

  /// Writes the carved model as "stl" (binary), "obj", "ply", "3mf" or "3mf-inlay" (in two colours: with the body
  /// that fills the pockets, or painted), reads it back and compares. Empty before an engraving is done ("stl": before
  /// it is printable), for any other format or slicer, if the file would differ from the model, if it cannot hold a
  /// code in colour, and if no solid body can fill the pockets.
  /// @param slicer   program that will open a 3MF file, a name of kSlicerNames
  /// @param carving  number of the last carving or the previous one, also while the next one is made; 0: the current
  /// one
  std::vector<std::uint8_t> exportModel(const std::string& format, const std::string& slicer = "any", int carving = 0);
  /// Writes the carved model as the files that `qrelief batch` writes for that name: a code in two colours as STL has a
  /// second file with the body of the second colour, and as OBJ one with its materials (io/write_files.h). None where
  /// exportModel() has no bytes.
  /// @param name     of the first file; its extension tells the format
  /// @param carving  as for exportModel()
  std::vector<NamedFile> exportFiles(const std::string& name, int carving = 0);

  /// Writes the maps of the carving (delivery/maps_file.h). Empty before an engraving is done, and for a text alone.
  /// @param carving  as for exportModel()
  std::vector<std::uint8_t> exportMaps(int carving = 0);

  /// Adds the current carving to the plate. A plate holds copies of the model, each with a different code.
  /// @param place   from 0
  /// @param id      the copy's name
  /// @param copies  that the plate has room for; counts where it is empty
  std::string addToPlate(int place, const std::string& id, int copies);
  /// Returns the plate as 3MF, read back and compared, and empties the plate. No bytes if nothing is on it.
  std::vector<std::uint8_t> exportPlate(const std::string& title) { return plate_.taken(title); }

  void resize(double width, double height, double devicePixelRatio) { scene_.resize(width, height, devicePixelRatio); }
  void setTheme(bool dark) { scene_.setTheme(dark); }
  /// Shows or hides what `what` names, and leaves the rest as it is. Returns {topMm, deepestMm}: depth of the last
  /// colour and of the deepest pocket; 0 where nothing is carved.
  /// @param what  {"carved": true: the carved model, "sizes": true: the largest sizes as colours on the model, or where
  ///              the fixed size fits, if they are known, "depths": true: carved depths as colours, "buildPlate": true:
  ///              the printer's plate under the model in the pose in which it is printed, "construction": true: how the
  ///              code was placed, "lampLight": true: the light of a uniform sky and of the lamps round a placed code,
  ///              if the settings have lamps, "section": cuts the model open across the code, from top to bottom as its
  ///              viewer sees it, at that offset from the code's middle in half edges of its square, -1 … 1; null: no
  ///              section, "upAxis": the model's axis, "y" or "z", that points up in the view and along which the
  ///              code's top points}
  std::string show(const std::string& what);
  /// Moves a lamp on the hemisphere round the code to the pointer, and shows its light until the next configure(). Does
  /// not change the settings. Returns {lamps: [{azimuthDeg, elevationDeg, strength}]} with every lamp. BadUsage if no
  /// code is placed or the index is too large.
  /// @param where  {"lamp": index from 0, "at": [x, y]}
  std::string moveLamp(const std::string& where);
  /// Shows the simulated print on the surface in place of the carved model, until the camera moves or another model is
  /// shown. BadUsage if nothing is engraved.
  /// @param picture  pixels of PrintedCode::pictures("front"); none: shows the carved model again
  /// @param size     along an edge
  std::string showPrint(std::vector<std::uint8_t> picture, int size);
  /// Moves the camera.
  /// @param action  {"kind": "orbit" or "pan", "dx", "dy"}, {"kind": "zoom", "factor", "x", "y"}, {"kind": "fit"},
  ///                {"kind": "body", "index"}: to one body of the model, from 0,
  ///                {"kind": "standard", "name": "front", "back", "left", "right", "top", "bottom" or "iso"}; and where
  ///                a code is placed: {"kind": "readerView"}: as a phone sees it, without a plate, until the next
  ///                action, {"kind": "face"}: from the viewer's side, with the surroundings in view, {"kind":
  ///                "faceSection"}: to where the section is visible, {"kind": "faceConstruction"}: to where the
  ///                construction is
  std::string look(const std::string& action);

  /// Returns {code: {corners: [[x, y]], facing, edgeMm, symbolMm, rotationDeg} or null, lamps: [{from: [x, y] or null,
  /// to: [x, y]}], buildPlate: {foot: [x, y], top: [x, y], heightMm} or null, construction: {centre, closest, eye,
  /// directions: [position]} or null, axes: [right, up, back]}. `corners`: of
  /// the code with its quiet zone or label, a square of `edgeMm` on the QR plane, on the screen, upper left first,
  /// clockwise for the viewer; `facing`: cosine between the camera's direction and the code's; `lamps`: a line from
  /// each lamp to the middle of the code, `from` null for a lamp behind the camera; `buildPlate`: the shown one, with
  /// an upright edge of the model's box over it, at its left on the screen; `construction`: if it is shown,
  /// positions [x, y] of C, S, the eye and the tips of the arrows, null for what is not there or behind the camera;
  /// `axes`: the camera's, z up.
  std::string viewState() const;
  /// Draws a spot with the code on it; empty if there is no such spot.
  ColourImage spotPicture(std::size_t index, int width, int height);

  /// @param always  present again even if nothing changed, because something else is drawn on top
  /// @returns true if another call would improve the picture
  bool draw(bool always = false);

  // For the inspector.
  /// See Carvings.
  void timePasses(std::optional<bool> withTimerQueries) { carvings_.timePasses(withTimerQueries); }
  const Carvings& carvings() const { return carvings_; }
  /// Returns the settings as configured.
  const EngraveRequest& settings() const { return wanted_.settings(); }
  /// Returns the distances to the far side of the material, from the eye of the last engraving.
  Result<BackDistanceMap> backDistances() const;
  /// Returns the place in symbol and quiet zone at a screen position, if the eye of the last engraving sees it, too:
  /// (0, 0) = the quiet zone's upper left, (1, 1) = its lower right.
  std::optional<Vec2> codePlaceAt(double x, double y) const;
  const Placement* placed() const { return preview_.placement(); }
  const Viewer* viewer() const { return scene_.viewer(); }
  const gl::Capabilities& gl() const { return gl_; }

 private:
  std::string startEngrave(const std::string& options, const std::function<EngraveRequest(EngraveRequest)>& overridden);
  std::string startSpotSearch();
  std::string advanceEngrave();
  std::string advanceSpotSearch();
  std::string advanceSettling();
  std::string advancePreparation(const std::string& options);
  std::string advanceViewTrials(const std::string& outcome);

  // Parts of the answers to the page.
  std::string describeModel() const;
  std::string describePlacement() const;
  std::string describeCode(const CodeOnSurface& code) const;

  void setUpAxis(const std::string& axis);
  /// Turns the camera so that the plate is below, if the printer's vertical does not depend on the code's place.
  void standOnPlate();
  void showCarved(bool carved);
  void hideCarved();
  void hidePrint();
  void showSizes(bool isShown);
  void zoom(double factor, double x, double y);
  /// Refuses a model that is too small for any code of as many modules.
  Status hasRoom() const;
  bool takesCode() const;
  bool showsCarved() const;
  PlacementTask task() const;
  Carvings::Ground ground() const { return {*model_, pass_}; }
  Status placeCode();
  std::string chooseCentre(std::optional<SurfacePoint> point, double movedMm = 0);
  std::string chooseSpot(std::size_t index);
  std::string moveCode(double x, double y);
  std::string resizeCode(double rotateDeg, double symbolMm);
  void endHover();
  std::optional<SurfacePoint> surfaceAt(double x, double y) const;
  std::optional<BuildPlate> buildPlate() const;
  std::optional<Construction> placedConstruction() const;
  std::vector<DirectionalLight> shownLamps() const;
  void updateView();
  /// Gives the scene the light of the lamps round the code. While a code is placed anew, they stay where they were.
  void lightScene();

  bool hasGl_;
  gl::Capabilities gl_;
  std::vector<Message> problems_;
  std::shared_ptr<const GeometryPass> pass_;
  std::optional<LoadedModel> model_;
  CodeInput wanted_;
  std::vector<DirectionalLight> heldLamps_;   // while one of them is moved; empty: the lamps of the settings
  std::optional<LampHemisphere> hemisphere_;  // round the last code on the model
  PlacementPreview preview_;
  SpotOffers offers_;
  Carvings carvings_;
  std::optional<Decal> print_;  // while it is shown
  Plate plate_;
  Scene scene_;
  std::optional<Construction> construction_;  // while it is shown
};

}  // namespace qrelief
