// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/objects.h"
#include "gl/pass_timings.h"
#include "mesh/ray.h"
#include "pipeline/place.h"
#include "pipeline/report.h"
#include "viewer/code_estimate.h"
#include "viewer/orbit_camera.h"
#include "viewer/viewer.h"

namespace qrelief {

/// What the page asks of the core, as verbs; the state is one model, one place on it, one engraving.
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

  /// {hit: false} or {hit: true, centre}; the centre of the code. Shows the model as it was before carving.
  std::string pick(double x, double y);
  /// The same with the surface point nearest to a point in mm.
  std::string setCentre(double x, double y, double z);

  /// {placement: {centre, normal, up, symbolMm, moduleMm, guaranteedMm, rotationDeg, version, modules}}, and shows the
  /// symbol there. Where none fits, what of it does is shown.
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
  std::string startPlacing();
  /// {stage, fraction, done}; one bounded piece of work. When done the sizes are shown on the model.
  std::string advancePlacing();
  void cancelPlacing();
  /// {spots: [{centre, sizeMm}], topMm}: best first, with the largest size there; `topMm` is the size that has the last
  /// colour of the map. Empty before a search is done.
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
  /// {stage, fraction, done}; one bounded piece of work. When done there is a carved model to be shown (showCarved).
  std::string advance();
  void cancel();

  /// Number of the finished engraving that can be reported and exported; 0: none.
  int carving() const { return result_ ? carving_ : 0; }
  /// Brings a finished engraving back and shows it: the last one, or the one before it, of the same model.
  /// @returns whether it is still there
  bool useCarving(int number);

  /// The report of the contract; an error before an engraving is done.
  std::string report() const;
  /// What a phone at the reader's eye sees; empty before an engraving is done.
  const GreyImage& readerImage() const;
  /// The same from aside, see tilted(); empty before an engraving is done, and where it cannot be drawn.
  GreyImage readerImageFrom(double tiltDeg, double azimuthDeg);
  /// What a reader made of it; empty: nothing.
  void setReadBack(const std::string& text, const std::string& reader);
  /// The carved model as "stl" (binary), "obj", "ply", "3mf" or "3mf-inlay" (with the body that fills the pockets),
  /// read back and compared; empty before an engraving is done, for another format, if the file would say anything
  /// else, and if the pockets cannot be filled by a solid body.
  std::vector<std::uint8_t> exportModel(const std::string& format);

  void resize(double width, double height, double devicePixelRatio);
  void setTheme(bool dark);
  /// "y" or "z": the model's up axis, for the view and as the direction the code's top points to.
  void setUpAxis(const std::string& axis);
  void showCarved(bool carved);
  void orbit(double dx, double dy);
  void pan(double dx, double dy);
  void zoom(double factor, double x, double y);
  void fit();
  /// "front", "back", "left", "right", "top", "bottom" or "iso"; others are ignored.
  void standardView(const std::string& name);
  void readerView();
  /// From the reader's side, with the surroundings in view.
  void faceCode();
  /// Cuts the model open across the code, from top to bottom as its reader sees it.
  /// @param offset  of the cut from the code's middle, in half edges of its square: -1 … 1
  void showSection(bool shown, double offset);
  /// Turns to where the section is seen.
  void faceSection();
  /// Carved depths as colours, if something has been carved: {topMm}, the depth of the last colour; 0 if nothing has.
  std::string showDepths(bool shown);

  /// {code: {corners: [[x, y]], facing, symbolMm, rotationDeg} or null, axes: [right, up, back]}: where on the screen
  /// the square of the code and its quiet zone lies on the QR plane (upper left first, clockwise for its reader), the
  /// cosine at which the camera looks at it; the camera's axes, z up.
  std::string viewState() const;
  /// A picture of a spot with the code on it.
  struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;  ///< row 0 at the top
  };
  /// Empty if there is no such spot.
  Picture spotPicture(std::size_t index, int width, int height);

  /// @param always  present again even if nothing changed, as something is drawn over it
  /// @returns whether another call would improve the picture
  bool draw(bool always = false);

  // For the inspector.
  /// Measures the passes of the engravings that start from now on.
  void timePasses(bool withTimerQueries) { timerQueries_ = withTimerQueries; }
  gl::PassTimings* passTimings() const { return passTimings_.get(); }
  const EngraveRequest& settings() const { return request_; }
  const EngraveRequest& engravedRequest() const { return jobRequest_; }
  int engravings() const { return engravings_; }  ///< started so far
  /// What the search of the last engraving did, and its symbol; null before it has seen anything.
  const SearchRecord* search() const;
  const Symbol* engravedSymbol() const;
  /// Distances to the far side of the material, from the eye of the last engraving.
  Result<BackDistanceMap> backDistances() const;
  /// The place in symbol and quiet zone that is seen at a screen position, if the reader sees it, too: (0, 0) = the
  /// quiet zone's upper left, (1, 1) = its lower right. Of the last engraving.
  std::optional<Vec2> codePlaceAt(double x, double y) const;
  double codeEdgeMm() const;  ///< of symbol and quiet zone of the last engraving
  const EngraveJob* job() const { return job_.get(); }
  const EngraveResult* result() const { return result_ ? &*result_ : nullptr; }
  const Placement* placed() const { return placement_ ? &*placement_ : nullptr; }
  const Viewer* viewer() const { return viewer_.get(); }
  const gl::Capabilities& gl() const { return gl_; }

 private:
  struct Model {
    std::string fileName, format;
    double scaleToMm = 1, loadMs = 0, prepareMs = 0;
    std::vector<Message> warnings;
    std::vector<std::string> partNames;
    std::shared_ptr<const EngravableModel> engravable;
    SurfaceLook look;  // by the processor: what follows the pointer does not wait for pictures
    std::shared_ptr<const GpuMesh> display;
  };
  // A code as it is shown.
  struct CodeOnSurface {
    SurfacePrint print;
    double symbolMm = 0, rotationDeg = 0, guaranteedMm = 0;
    double missingShare = 0;
    bool isExact = false;
    std::shared_ptr<const EyeReach> reach;  // as the map knows it; the print may know better
  };
  Result<CodeOnSurface> estimatedCode(const SurfacePoint& at, std::optional<double> expectedMm = {}) const;
  Result<CodeOnSurface> exactCode(const Symbol& symbol, const EngraveRequest& request,
                                  const Placement& placement) const;
  bool takesCode() const;
  std::optional<CuttingPlane> cut() const;
  Result<Model> readAndPrepare(std::vector<std::uint8_t> bytes, const std::string& fileName, double scaleToMm) const;
  void proposeCentre();
  std::string describeModel() const;
  std::string describePlacement() const;
  std::string chooseCentre(std::optional<SurfacePoint> point);
  std::string describeCode(const CodeOnSurface& code) const;
  std::optional<SurfacePoint> surfaceAt(double x, double y) const;
  Status placeSymbol();
  Status findPlacement(const EngraveRequest& request);  // unless it is the one that was found last
  const PlacementSearch* foundPlacement(const EngraveRequest& request) const;  // null: not yet
  EngraveRequest completeRequest() const;
  void finishPlacing();
  void forgetPlacement();
  void forgetSpots();
  void forgetJob();
  Result<std::unique_ptr<EngraveJob>> makeJob(const EngraveRequest& request, const PlacementSearch* placed);
  void setCarvingAside();
  void finishJob();
  void makeCarvedDisplay();
  void updateView();

  gl::Capabilities gl_;
  std::vector<std::string> problems_;
  std::shared_ptr<const GeometryPass> pass_;
  std::shared_ptr<const LuminancePrograms> luminancePrograms_;  // once there was an engraving
  std::unique_ptr<Viewer> viewer_, spotViewer_;
  OrbitCamera camera_;

  std::optional<Model> model_;
  EngraveRequest request_;
  std::optional<Vec3> centre_;
  Result<Symbol> symbol_;  // of the request
  struct FoundPlacement {
    PlacementRequest request;
    int modules;
    PlacementSearch search;
  };
  std::optional<FoundPlacement> found_;  // last
  std::optional<Placement> placement_;
  std::optional<CodeOnSurface> code_;  // that has its place, or is being moved there
  std::optional<CodeOnSurface> hovered_;
  std::optional<SurfacePoint> hoveredAt_;
  std::optional<PlacementSearch> settling_;
  bool sectionShown_ = false, dark_ = false;
  double sectionOffset_ = 0;

  PlaceRequest placingRequest_;  // of the search that runs, or whose spots are known
  std::unique_ptr<PlaceJob> placing_;
  std::vector<OfferedSpot> spots_;
  double topMm_ = 0;
  std::shared_ptr<const GpuMesh> sizesDisplay_;
  bool showSizes_ = false;
  std::optional<Vec3> spotDirection_;  // that the centre needs

  std::optional<bool> timerQueries_;  // none: passes are not timed
  std::unique_ptr<gl::PassTimings> passTimings_;
  int engravings_ = 0;
  struct Prepared {
    EngraveRequest request;
    std::unique_ptr<EngraveJob> job;
    int steps = 0;  // that it has done
    double ms = 0;
  };
  std::optional<Prepared> prepared_;  // of the next engraving, if that is asked for as it is now
  EngraveRequest jobRequest_;
  std::unique_ptr<EngraveJob> job_;
  bool jobRuns_ = false;
  double jobMs_ = 0;
  std::optional<EngraveResult> result_;
  std::shared_ptr<const GpuMesh> carvedDisplay_;  // once it has been shown
  bool showCarved_ = false;
  bool showDepths_ = false;
  std::string readBack_, reader_;

  struct Carving {
    int number = 0;
    EngraveRequest request;
    double ms = 0;
    EngraveResult result;
    std::shared_ptr<const GpuMesh> display;
    std::string readBack, reader;
  };
  int carving_ = 0;                 // the number of `result_`, or of the last there was
  int carvings_ = 0;                // so many were finished
  std::optional<Carving> earlier_;  // the one before: more would cost memory without end
};

}  // namespace qrelief
