// SPDX-License-Identifier: GPL-3.0-or-later
// The module's only interface to JavaScript: the verbs of web/engine/verbs.js, by name. The build makes wasm/verbs.h
// from that table.
#include <GLES3/gl3.h>
#include <emscripten/bind.h>
#include <emscripten/html5_webgl.h>
#include <emscripten/val.h>
#include <malloc.h>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "engine/answers.h"
#include "engine/facts.h"
#include "engine/planned_batch.h"
#include "engine/printed_code.h"
#include "engine/tracked_batch.h"
#include "inspector/inspected_engine.h"
#include "wasm/verbs.h"

namespace qrelief {
namespace {

using emscripten::val;

/// Copies values into a typed array of its own. A view of the heap would break when the heap moves.
template <class T>
val copied(const char* type, std::span<const T> values) {
  return val::global(type).new_(val(emscripten::typed_memory_view(values.size(), values.data())));
}

val picture(int width, int height, std::span<const std::uint8_t> pixels) {
  val object = val::object();
  object.set("width", width);
  object.set("height", height);
  object.set("pixels", copied("Uint8Array", pixels));
  return object;
}

/// Converts values at the interface: unchanged, unless JavaScript has a form of its own for the type.
template <class T>
struct Crossing {
  using Outside = T;
  static T in(T value) { return value; }
  static T out(T value) { return value; }
};

template <>
struct Crossing<std::vector<std::uint8_t>> {
  using Outside = val;
  static std::vector<std::uint8_t> in(const val& array) {
    std::vector<std::uint8_t> bytes(array["length"].as<std::size_t>());
    if (!bytes.empty()) val(emscripten::typed_memory_view(bytes.size(), bytes.data())).call<void>("set", array);
    return bytes;
  }
  static val out(const std::vector<std::uint8_t>& bytes) { return copied<std::uint8_t>("Uint8Array", bytes); }
};

template <>
struct Crossing<std::vector<float>> {
  using Outside = val;
  static std::vector<float> in(const val& array) { return emscripten::convertJSArrayToNumberVector<float>(array); }
};

template <>
struct Crossing<GreyImage> {
  static val out(const GreyImage& image) { return picture(image.width, image.height, image.pixels); }
};

template <>
struct Crossing<std::vector<GreyImage>> {
  static val out(const std::vector<GreyImage>& images) {
    val list = val::array();
    for (const GreyImage& image : images) list.call<void>("push", Crossing<GreyImage>::out(image));
    return list;
  }
};

template <>
struct Crossing<std::vector<NamedFile>> {
  static val out(const std::vector<NamedFile>& files) {
    val list = val::array();
    for (const NamedFile& file : files) {
      val object = val::object();
      object.set("name", file.name);
      object.set("bytes", copied<std::uint8_t>("Uint8Array", file.bytes));
      list.call<void>("push", object);
    }
    return list;
  }
};

template <>
struct Crossing<ColourImage> {
  static val out(const ColourImage& image) { return picture(image.width, image.height, image.rgba); }
};

/// Returns null if there is no such map.
template <>
struct Crossing<std::optional<JobMap>> {
  static val out(const std::optional<JobMap>& map) {
    if (!map) return val::null();
    val object = val::object();
    object.set("width", map->width);
    object.set("height", map->height);
    object.set("components", map->components);
    object.set("values", copied<float>("Float32Array", map->values));
    return object;
  }
};

template <class Owner>
Owner& partOf(InspectedEngine& engine) {
  if constexpr (std::is_same_v<Owner, Engine>)
    return engine.engine();
  else
    return engine;
}

/// True for classes with an object of their own in JavaScript. All other verbs belong to the engine's object.
template <class Owner>
constexpr bool kStandsAlone = std::is_same_v<Owner, PrintedCode> || std::is_same_v<Owner, PlannedBatch> ||
                              std::is_same_v<Owner, TrackedBatch> || std::is_same_v<Owner, Facts>;

template <class Owner>
requires kStandsAlone<Owner> Owner& partOf(Owner& object) { return object; }

template <class Owner>
using BoundObject = std::conditional_t<kStandsAlone<Owner>, Owner, InspectedEngine>;

template <auto verb, class Owner, class Answer, class... Given>
struct BoundVerb {
  static auto call(BoundObject<Owner>& object, typename Crossing<std::remove_cvref_t<Given>>::Outside... given) {
    const auto run = [&]() -> Answer {
      return (partOf<Owner>(object).*verb)(Crossing<std::remove_cvref_t<Given>>::in(std::move(given))...);
    };
    if constexpr (std::is_same_v<Answer, std::string>)
      return guarded(run);
    else if constexpr (std::is_void_v<Answer>)
      run();
    else
      return Crossing<std::remove_cvref_t<Answer>>::out(run());
  }
};

template <auto verb, class = decltype(verb)>
struct Verb;
template <auto verb, class Owner, class Answer, class... Given>
struct Verb<verb, Answer (Owner::*)(Given...)> : BoundVerb<verb, Owner, Answer, Given...> {};
template <auto verb, class Owner, class Answer, class... Given>
struct Verb<verb, Answer (Owner::*)(Given...) const> : BoundVerb<verb, Owner, Answer, Given...> {};

bool hasGl() { return emscripten_webgl_get_current_context() != 0; }

bool enableExtension(const char* name) {
  return hasGl() && emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), name);
}

/// Returns the renderer's name. Without this extension browsers say "WebKit WebGL" and the like.
std::string rendererName() {
  if (!enableExtension("WEBGL_debug_renderer_info")) return {};
  return gl::rendererName();
}

InspectedEngine* makeEngine() {
  return new InspectedEngine(rendererName(), hasGl(), enableExtension("EXT_disjoint_timer_query_webgl2"),
                             &makeInspector);
}

/// Returns the bytes of the heap in use, which a leak increases.
double memoryInUse(const InspectedEngine&) { return mallinfo().uordblks; }

}  // namespace

EMSCRIPTEN_BINDINGS(qrelief) {
  const auto engine = emscripten::class_<InspectedEngine>("Engine");
  engine.constructor(&makeEngine, emscripten::allow_raw_pointers());
#define QRELIEF_BIND(Owner, verb) engine.function(#verb, &Verb<&Owner::verb>::call);
  QRELIEF_ENGINE_VERBS(QRELIEF_BIND)
#undef QRELIEF_BIND
  engine.function("memoryInUse", &memoryInUse);
  const auto print = emscripten::class_<PrintedCode>("PrintedCode");
  print.constructor<>();
#define QRELIEF_BIND(Owner, verb) print.function(#verb, &Verb<&Owner::verb>::call);
  QRELIEF_PRINT_VERBS(QRELIEF_BIND)
#undef QRELIEF_BIND
  const auto facts = emscripten::class_<Facts>("Facts");
  facts.constructor<>();
#define QRELIEF_BIND(Owner, verb) facts.function(#verb, &Verb<&Owner::verb>::call);
  QRELIEF_FACT_VERBS(QRELIEF_BIND)
#undef QRELIEF_BIND
  const auto batch = emscripten::class_<PlannedBatch>("PlannedBatch");
  batch.constructor<>();
#define QRELIEF_BIND(Owner, verb) batch.function(#verb, &Verb<&Owner::verb>::call);
  QRELIEF_BATCH_VERBS(QRELIEF_BIND)
#undef QRELIEF_BIND
  const auto track = emscripten::class_<TrackedBatch>("TrackedBatch");
  track.constructor<>();
#define QRELIEF_BIND(Owner, verb) track.function(#verb, &Verb<&Owner::verb>::call);
  QRELIEF_TRACK_VERBS(QRELIEF_BIND)
#undef QRELIEF_BIND
}

}  // namespace qrelief
