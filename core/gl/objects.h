// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GLES3/gl3.h>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

// Owners of OpenGL ES 3 objects. Each needs its own context to be current; none makes a context.

namespace qrelief::gl {

/// Texel format of a texture; all are colour-renderable in ES 3 with EXT_color_buffer_float.
enum class Format { R32F, RGBA32F, RGBA16F, RGBA8 };

/// 2D texture without mipmaps, nearest filtering, clamped at its edges.
class Texture {
 public:
  Texture() = default;
  Texture(int width, int height, Format format, const void* texels = nullptr);
  ~Texture();
  Texture(Texture&& other) noexcept { swap(other); }
  Texture& operator=(Texture&& other) noexcept {
    Texture(std::move(other)).swap(*this);
    return *this;
  }

  /// Replaces the whole content. `texels` has the layout of `format` (floats for the 32-bit formats).
  void upload(const void* texels);
  void useLinearFilter();
  GLuint id() const { return id_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void swap(Texture& other) noexcept;
  GLuint id_ = 0;
  int width_ = 0;
  int height_ = 0;
  Format format_ = Format::RGBA8;
};

/// Framebuffer over colour textures that it does not own, with an optional depth buffer that it owns.
class Framebuffer {
 public:
  Framebuffer() = default;
  /// Makes a framebuffer over textures of one size. Fails with Internal if the implementation cannot render to this
  /// combination.
  static Result<Framebuffer> create(std::span<const Texture* const> colours, bool withDepth);
  ~Framebuffer();
  Framebuffer(Framebuffer&& other) noexcept { swap(other); }
  Framebuffer& operator=(Framebuffer&& other) noexcept {
    Framebuffer(std::move(other)).swap(*this);
    return *this;
  }

  /// Makes this the draw target and sets the viewport to its size.
  void bind() const;
  /// Reads a float attachment back as RGBA floats, row 0 at the bottom. RGBA and float are the one pair of format and
  /// type that every implementation supports.
  std::vector<float> readRgba(int attachment = 0) const;
  /// Reads back the first component only, as readRgba() does.
  std::vector<float> readRed(int attachment = 0) const;

 private:
  void swap(Framebuffer& other) noexcept;
  GLuint id_ = 0;
  GLuint depth_ = 0;
  int width_ = 0;
  int height_ = 0;
};

/// Vertex or index data.
class Buffer {
 public:
  Buffer() = default;
  Buffer(GLenum target, std::span<const std::byte> bytes);
  ~Buffer();
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept {
    Buffer(std::move(other)).swap(*this);
    return *this;
  }
  GLuint id() const { return id_; }

 private:
  void swap(Buffer& other) noexcept { std::swap(id_, other.id_); }
  GLuint id_ = 0;
};

class VertexArray {
 public:
  VertexArray() = default;
  static VertexArray create();
  ~VertexArray();
  VertexArray(VertexArray&& other) noexcept { swap(other); }
  VertexArray& operator=(VertexArray&& other) noexcept {
    VertexArray(std::move(other)).swap(*this);
    return *this;
  }
  void bind() const;

 private:
  void swap(VertexArray& other) noexcept { std::swap(id_, other.id_); }
  GLuint id_ = 0;
};

/// Linked vertex and fragment shader. Uniforms are set by name on the program in use. A uniform that the compiler
/// dropped because nothing depends on it is ignored. Precondition: one of the sources declares the name.
class Program {
 public:
  Program() = default;
  /// @param name  for error messages: the driver refuses a source, or a uniform is not declared
  static Result<Program> create(const char* name, const char* vertexSource, const char* fragmentSource);
  ~Program();
  Program(Program&& other) noexcept { swap(other); }
  Program& operator=(Program&& other) noexcept {
    Program(std::move(other)).swap(*this);
    return *this;
  }

  void use() const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, glm::vec2 value) const;
  void set(const char* uniform, glm::vec3 value) const;
  void set(const char* uniform, glm::vec4 value) const;
  void setMatrix(const char* uniform, const float* columnMajor4x4) const;
  /// Binds a texture to a unit and the sampler to that unit.
  void setTexture(const char* sampler, int unit, const Texture& texture) const;

 private:
  void swap(Program& other) noexcept;
  GLint locationOf(const char* uniform) const;
  GLuint id_ = 0;
  std::string name_;
  std::vector<std::string> uniforms_;  // declared by the sources; empty in builds without asserts
};

/// Draws one triangle that covers the viewport, for programs with the vertex shader fullscreen.vert.
void drawFullscreen();

/// The renderer's name where no GL implementation is used.
inline constexpr const char* kProcessorName = "processor";

/// Capabilities of the current context.
struct Capabilities {
  std::string renderer;
  std::string version;
  int maxTextureSize = 0;
};

/// Returns the renderer's name; in a browser the unmasked name, if the browser reveals it.
std::string rendererName();
/// Returns true for a renderer that runs on the CPU (llvmpipe, SwiftShader, WARP); plain code is faster than its
/// shaders.
bool isSoftware(std::string_view rendererName);

/// @returns Internal, with advice to the user, if float render targets are missing
Result<Capabilities> queryCapabilities();

}  // namespace qrelief::gl
