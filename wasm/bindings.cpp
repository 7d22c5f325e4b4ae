// SPDX-License-Identifier: GPL-3.0-or-later
// The module's only door: one class of verbs for the page. No exception crosses it.
#include <GLES3/gl3.h>
#include <emscripten/bind.h>
#include <emscripten/html5_webgl.h>
#include <emscripten/val.h>
#include <exception>
#include <malloc.h>
#include <new>
#include <nlohmann/json.hpp>

#include "engine/answers.h"
#include "engine/engine.h"
#include "engine/job_map.h"
#include "engine/settings.h"
#include "engine/symbol_facts.h"
#include "inspector/inspector_window.h"
#include "inspector/translation.h"

namespace qrelief {
namespace {

using emscripten::val;

std::string failure(const char* code, const char* what, const char* hint) {
  const nlohmann::ordered_json answer = {{"ok", false}, {"error", {{"code", code}, {"message", what}, {"hint", hint}}}};
  return answer.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// The verb's answer, or its exception as one.
template <class Verb>
std::string guarded(Verb verb) {
  try {
    return verb();
  } catch (const std::bad_alloc&) {
    return failure("OutOfMemory", "there is not enough memory for this",
                   "use a model with fewer triangles, or close other tabs");
  } catch (const std::exception& exception) {
    return failure("Internal", exception.what(),
                   "this is a fault of QRelief: please report it with the model and the settings");
  }
}

std::vector<std::uint8_t> copyIn(const val& array) {
  std::vector<std::uint8_t> bytes(array["length"].as<std::size_t>());
  if (!bytes.empty()) val(emscripten::typed_memory_view(bytes.size(), bytes.data())).call<void>("set", array);
  return bytes;
}

/// A Uint8Array of its own, not a view of the heap, which may move.
val copyOut(std::span<const std::uint8_t> bytes) {
  return val::global("Uint8Array").new_(val(emscripten::typed_memory_view(bytes.size(), bytes.data())));
}

/// What draws: browsers say "WebKit WebGL" and the like unless asked by this extension.
std::string rendererName() {
  constexpr GLenum kUnmaskedRenderer = 0x9246;
  if (!emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), "WEBGL_debug_renderer_info"))
    return {};
  const GLubyte* name = glGetString(kUnmaskedRenderer);
  return name ? reinterpret_cast<const char*>(name) : "";
}

/// The engine and the window over it.
class Facade {
 public:
  Facade() : engine_(rendererName()) {}
  std::string capabilities() {
    return guarded([&] { return engine_.capabilities(); });
  }
  std::string loadModel(const val& bytes, const std::string& fileName, double scaleToMm) {
    return guarded([&] { return engine_.loadModel(copyIn(bytes), fileName, scaleToMm); });
  }
  std::string configure(const std::string& settings) {
    return guarded([&] { return engine_.configure(settings); });
  }
  std::string symbol(const std::string& settings) {
    return guarded([&] {
      const auto request = readSettings(settings);
      return request ? describeSymbol(*request) : answer(request.error());
    });
  }
  std::string pick(double x, double y) {
    return guarded([&] { return engine_.pick(x, y); });
  }
  std::string setCentre(double x, double y, double z) {
    return guarded([&] { return engine_.setCentre(x, y, z); });
  }
  std::string placement() {
    return guarded([&] { return engine_.placement(); });
  }
  std::string hover(double x, double y) {
    return guarded([&] { return engine_.hover(x, y); });
  }
  void endHover() { engine_.endHover(); }
  std::string startSettling() {
    return guarded([&] { return engine_.startSettling(); });
  }
  std::string advanceSettling() {
    return guarded([&] { return engine_.advanceSettling(); });
  }
  std::string moveCode(double x, double y) {
    return guarded([&] { return engine_.moveCode(x, y); });
  }
  std::string adjustCode(double rotateDeg, double symbolMm) {
    return guarded([&] { return engine_.adjustCode(rotateDeg, symbolMm); });
  }
  std::string startPlacing() {
    return guarded([&] { return engine_.startPlacing(); });
  }
  std::string advancePlacing() {
    return guarded([&] { return engine_.advancePlacing(); });
  }
  void cancelPlacing() { engine_.cancelPlacing(); }
  std::string spots() {
    return guarded([&] { return engine_.spots(); });
  }
  std::string chooseSpot(std::size_t index) {
    return guarded([&] { return engine_.chooseSpot(index); });
  }
  void showSizes(bool shown) { engine_.showSizes(shown); }
  std::string prepareEngrave() {
    return guarded([&] { return engine_.prepareEngrave(); });
  }
  /// @param withOverrides  as the inspector's settings say, where they differ from the page's
  std::string startEngrave(bool withOverrides) {
    return guarded([&] {
      if (!withOverrides || !inspector_) return engine_.startEngrave();
      return engine_.startEngrave([&](EngraveRequest page) { return inspector_->overrides().appliedTo(page); });
    });
  }
  std::string advance() {
    return guarded([&] { return engine_.advance(); });
  }
  void cancel() { engine_.cancel(); }
  int carving() const { return engine_.carving(); }
  bool useCarving(int number) { return engine_.useCarving(number); }
  std::string report() {
    return guarded([&] { return engine_.report(); });
  }
  val readerImage() { return pictureOf(engine_.readerImage()); }
  val readerImageFrom(double tiltDeg, double azimuthDeg) {
    return pictureOf(engine_.readerImageFrom(tiltDeg, azimuthDeg));
  }
  static val pictureOf(const GreyImage& image) {
    val answer = val::object();
    answer.set("width", image.width);
    answer.set("height", image.height);
    answer.set("pixels", copyOut(image.pixels));
    return answer;
  }
  /// Null where there is no such map.
  val jobMap(const std::string& name) {
    const std::optional<JobMap> map =
        engine_.job() ? qrelief::jobMap(engine_.job()->inspectorMaps(), name) : std::nullopt;
    if (!map) return val::null();
    val answer = val::object();
    answer.set("width", map->width);
    answer.set("height", map->height);
    answer.set("components", map->components);
    answer.set(
        "values",
        val::global("Float32Array").new_(val(emscripten::typed_memory_view(map->values.size(), map->values.data()))));
    return answer;
  }
  void setReadBack(const std::string& text, const std::string& reader) { engine_.setReadBack(text, reader); }
  val exportModel(const std::string& format) { return copyOut(engine_.exportModel(format)); }

  void resize(double width, double height, double devicePixelRatio) {
    size_ = {width, height};
    devicePixelRatio_ = devicePixelRatio;
    engine_.resize(width, height, devicePixelRatio);
    if (inspector_) inspector_->resize(width, height, devicePixelRatio);
  }
  void setTheme(bool dark) {
    dark_ = dark;
    engine_.setTheme(dark);
    if (inspector_) inspector_->setTheme(dark);
  }
  void setUpAxis(const std::string& axis) { engine_.setUpAxis(axis); }
  void showCarved(bool carved) { engine_.showCarved(carved); }
  void orbit(double dx, double dy) { engine_.orbit(dx, dy); }
  void pan(double dx, double dy) { engine_.pan(dx, dy); }
  void zoom(double factor, double x, double y) { engine_.zoom(factor, x, y); }
  void fit() { engine_.fit(); }
  void standardView(const std::string& name) { engine_.standardView(name); }
  void readerView() { engine_.readerView(); }
  void showSection(bool shown, double offset) { engine_.showSection(shown, offset); }
  void faceSection() { engine_.faceSection(); }
  std::string showDepths(bool shown) {
    return guarded([&] { return engine_.showDepths(shown); });
  }
  std::string viewState() {
    return guarded([&] { return engine_.viewState(); });
  }
  val spotPicture(std::size_t index, int width, int height) {
    const Engine::Picture picture = engine_.spotPicture(index, width, height);
    val answer = val::object();
    answer.set("width", picture.width);
    answer.set("height", picture.height);
    answer.set("pixels", copyOut(picture.rgba));
    return answer;
  }
  void faceCode() { engine_.faceCode(); }

  bool draw() {
    const bool hasInspector = inspectorShown_ && inspector_;
    const bool more = engine_.draw(hasInspector || inspectorGone_);
    inspectorGone_ = false;
    return hasInspector ? inspector_->draw(engine_) || more : more;
  }
  /// Before it is shown for the first time: after its part of the module was loaded.
  void openInspector() {
    if (inspector_) return;
    inspector_ = makeInspector();
    inspector_->setTheme(dark_);
    engine_.timePasses(
        emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), "EXT_disjoint_timer_query_webgl2"));
  }
  void showInspector(bool shown) {
    if (shown && inspector_) inspector_->resize(size_.x, size_.y, devicePixelRatio_);
    inspectorGone_ = inspectorShown_ && !shown;
    inspectorShown_ = shown;
  }
  /// Bytes of the heap in use: what a leak makes grow.
  double memoryInUse() const { return mallinfo().uordblks; }
  /// @param texts  of the page's language, by the English ones, as a JSON object
  void inspectorTexts(const std::string& texts) { setTranslation(nlohmann::json::parse(texts).get<Translation>()); }
  void inspectorArea(double x, double y, double width, double height) {
    if (inspector_) inspector_->setFreeArea(x, y, width, height);
  }
  /// @param metrics  six numbers a glyph: code point, width, height, left, top, advance
  void inspectorGlyphs(float lineHeight, const val& metrics, const val& alpha) {
    if (!inspector_) return;
    DrawnGlyphs glyphs;
    glyphs.lineHeight = lineHeight;
    const auto numbers = emscripten::convertJSArrayToNumberVector<float>(metrics);
    for (std::size_t i = 0; i + 5 < numbers.size(); i += 6)
      glyphs.glyphs.push_back({static_cast<std::uint32_t>(numbers[i]), static_cast<int>(numbers[i + 1]),
                               static_cast<int>(numbers[i + 2]), numbers[i + 3], numbers[i + 4], numbers[i + 5]});
    glyphs.alpha = copyIn(alpha);
    inspector_->setGlyphs(std::move(glyphs));
  }
  bool inspectorPointer(double x, double y, int buttons, double wheel) {
    return inspectorShown_ && inspector_ && inspector_->pointer(x, y, buttons, wheel);
  }
  void inspectorKey(const std::string& key, bool control, bool shift) {
    if (inspectorShown_ && inspector_) inspector_->key(key, control, shift);
  }
  bool inspectorPick(double x, double y) {
    return inspectorShown_ && inspector_ && inspector_->pickSubmodule(engine_, x, y);
  }
  std::string inspectorState() {
    return guarded([&] { return inspector_ ? inspector_->state() : std::string("{}"); });
  }

 private:
  Engine engine_;
  std::unique_ptr<InspectorWindow> inspector_;
  bool inspectorShown_ = false, inspectorGone_ = false, dark_ = false;
  Vec2 size_{1};
  double devicePixelRatio_ = 1;
};

}  // namespace

EMSCRIPTEN_BINDINGS(qrelief) {
  emscripten::class_<Facade>("Engine")
      .constructor<>()
      .function("capabilities", &Facade::capabilities)
      .function("loadModel", &Facade::loadModel)
      .function("configure", &Facade::configure)
      .function("symbol", &Facade::symbol)
      .function("pick", &Facade::pick)
      .function("setCentre", &Facade::setCentre)
      .function("placement", &Facade::placement)
      .function("hover", &Facade::hover)
      .function("endHover", &Facade::endHover)
      .function("startSettling", &Facade::startSettling)
      .function("advanceSettling", &Facade::advanceSettling)
      .function("moveCode", &Facade::moveCode)
      .function("adjustCode", &Facade::adjustCode)
      .function("startPlacing", &Facade::startPlacing)
      .function("advancePlacing", &Facade::advancePlacing)
      .function("cancelPlacing", &Facade::cancelPlacing)
      .function("spots", &Facade::spots)
      .function("chooseSpot", &Facade::chooseSpot)
      .function("showSizes", &Facade::showSizes)
      .function("prepareEngrave", &Facade::prepareEngrave)
      .function("startEngrave", &Facade::startEngrave)
      .function("advance", &Facade::advance)
      .function("cancel", &Facade::cancel)
      .function("carving", &Facade::carving)
      .function("useCarving", &Facade::useCarving)
      .function("report", &Facade::report)
      .function("readerImage", &Facade::readerImage)
      .function("jobMap", &Facade::jobMap)
      .function("readerImageFrom", &Facade::readerImageFrom)
      .function("setReadBack", &Facade::setReadBack)
      .function("exportModel", &Facade::exportModel)
      .function("resize", &Facade::resize)
      .function("setTheme", &Facade::setTheme)
      .function("setUpAxis", &Facade::setUpAxis)
      .function("showCarved", &Facade::showCarved)
      .function("orbit", &Facade::orbit)
      .function("pan", &Facade::pan)
      .function("zoom", &Facade::zoom)
      .function("fit", &Facade::fit)
      .function("standardView", &Facade::standardView)
      .function("readerView", &Facade::readerView)
      .function("showSection", &Facade::showSection)
      .function("faceSection", &Facade::faceSection)
      .function("showDepths", &Facade::showDepths)
      .function("viewState", &Facade::viewState)
      .function("spotPicture", &Facade::spotPicture)
      .function("faceCode", &Facade::faceCode)
      .function("draw", &Facade::draw)
      .function("memoryInUse", &Facade::memoryInUse)
      .function("openInspector", &Facade::openInspector)
      .function("showInspector", &Facade::showInspector)
      .function("inspectorTexts", &Facade::inspectorTexts)
      .function("inspectorArea", &Facade::inspectorArea)
      .function("inspectorGlyphs", &Facade::inspectorGlyphs)
      .function("inspectorPointer", &Facade::inspectorPointer)
      .function("inspectorKey", &Facade::inspectorKey)
      .function("inspectorPick", &Facade::inspectorPick)
      .function("inspectorState", &Facade::inspectorState);
}

}  // namespace qrelief
