// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/objects.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>
#include <utility>

#include "gl/declared_uniforms.h"
#include "gl/pass_timings.h"
#include "message_codes/graphics.h"

namespace qrelief::gl {
namespace {

struct TexelLayout {
  GLint internalFormat;
  GLenum format;
  GLenum type;
};

TexelLayout layoutOf(Format format) {
  switch (format) {
    case Format::R32F:
      return {GL_R32F, GL_RED, GL_FLOAT};
    case Format::RGBA32F:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case Format::RGBA16F:
      return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    case Format::RGBA8:
      break;
  }
  return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
}

Result<GLuint> compile(const char* name, GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  std::array<char, 2048> log{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteShader(shader);
  return fail(ErrorKind::Internal,
              message<"shader-refused">(with::term<"shader">(name), with::term<"log">(log.data())));
}

std::string glString(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

Texture::Texture(int width, int height, Format format, const void* texels)
    : width_(width), height_(height), format_(format) {
  glGenTextures(1, &id_);
  upload(texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Texture::~Texture() {
  if (id_) glDeleteTextures(1, &id_);
}

void Texture::upload(const void* texels) {
  const TexelLayout layout = layoutOf(format_);
  glBindTexture(GL_TEXTURE_2D, id_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, layout.internalFormat, width_, height_, 0, layout.format, layout.type, texels);
}

void Texture::useLinearFilter() {
  glBindTexture(GL_TEXTURE_2D, id_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void Texture::swap(Texture& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  std::swap(format_, other.format_);
}

Result<Framebuffer> Framebuffer::create(std::span<const Texture* const> colours, bool withDepth) {
  Framebuffer framebuffer;
  framebuffer.width_ = colours[0]->width();
  framebuffer.height_ = colours[0]->height();
  glGenFramebuffers(1, &framebuffer.id_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id_);
  std::vector<GLenum> targets;
  for (const Texture* colour : colours) {
    const GLenum target = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(targets.size());
    glFramebufferTexture2D(GL_FRAMEBUFFER, target, GL_TEXTURE_2D, colour->id(), 0);
    targets.push_back(target);
  }
  glDrawBuffers(static_cast<GLsizei>(targets.size()), targets.data());
  if (withDepth) {
    glGenRenderbuffers(1, &framebuffer.depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, framebuffer.depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, framebuffer.width_, framebuffer.height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, framebuffer.depth_);
  }
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    return fail(ErrorKind::Internal,
                message<"float-texture-refused">(with::count<"width">(framebuffer.width_),
                                                 with::count<"height">(framebuffer.height_),
                                                 with::term<"status">(fmt::format("0x{:x}", status))));
  return framebuffer;
}

Framebuffer::~Framebuffer() {
  if (id_) glDeleteFramebuffers(1, &id_);
  if (depth_) glDeleteRenderbuffers(1, &depth_);
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  glViewport(0, 0, width_, height_);
}

std::vector<float> Framebuffer::readRgba(int attachment) const {
  const TimedPass timed("reading back");
  std::vector<float> texels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
  glBindFramebuffer(GL_FRAMEBUFFER, id_);
  glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachment));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, texels.data());
  return texels;
}

std::vector<float> Framebuffer::readRed(int attachment) const {
  const std::vector<float> rgba = readRgba(attachment);
  std::vector<float> red(rgba.size() / 4);
  for (std::size_t i = 0; i < red.size(); ++i) red[i] = rgba[4 * i];
  return red;
}

void Framebuffer::swap(Framebuffer& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(depth_, other.depth_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
}

Buffer::Buffer(GLenum target, std::span<const std::byte> bytes) {
  glGenBuffers(1, &id_);
  glBindBuffer(target, id_);
  glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
}

Buffer::~Buffer() {
  if (id_) glDeleteBuffers(1, &id_);
}

VertexArray VertexArray::create() {
  VertexArray array;
  glGenVertexArrays(1, &array.id_);
  return array;
}

VertexArray::~VertexArray() {
  if (id_) glDeleteVertexArrays(1, &id_);
}

void VertexArray::bind() const { glBindVertexArray(id_); }

Result<Program> Program::create(const char* name, const char* vertexSource, const char* fragmentSource) {
  const Result<GLuint> vertex = compile(name, GL_VERTEX_SHADER, vertexSource);
  QRELIEF_TRY(vertex);
  const Result<GLuint> fragment = compile(name, GL_FRAGMENT_SHADER, fragmentSource);
  if (!fragment) {
    glDeleteShader(*vertex);
    return tl::unexpected(fragment.error());
  }
  Program program;
  program.id_ = glCreateProgram();
  glAttachShader(program.id_, *vertex);
  glAttachShader(program.id_, *fragment);
  glLinkProgram(program.id_);
  glDeleteShader(*vertex);
  glDeleteShader(*fragment);
  GLint linked = GL_FALSE;
  glGetProgramiv(program.id_, GL_LINK_STATUS, &linked);
  if (linked) {
    program.name_ = name;
#ifndef NDEBUG
    program.uniforms_ = declaredUniforms(vertexSource);
    for (std::string& uniform : declaredUniforms(fragmentSource)) program.uniforms_.push_back(std::move(uniform));
#endif
    return program;
  }
  std::array<char, 2048> log{};
  glGetProgramInfoLog(program.id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  return fail(ErrorKind::Internal,
              message<"shader-not-linked">(with::term<"shader">(name), with::term<"log">(log.data())));
}

Program::~Program() {
  if (id_) glDeleteProgram(id_);
}

void Program::swap(Program& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(name_, other.name_);
  std::swap(uniforms_, other.uniforms_);
}

/// Returns -1, which OpenGL ignores, for a declared uniform that the compiler dropped.
GLint Program::locationOf(const char* uniform) const {
  const GLint location = glGetUniformLocation(id_, uniform);
#ifndef NDEBUG
  const std::string_view whole(uniform);
  const std::string_view name = whole.substr(0, whole.find('['));
  if (location < 0 && std::find(uniforms_.begin(), uniforms_.end(), name) == uniforms_.end()) {
    // An assert could not name the program and the uniform.
    std::fprintf(stderr, "The shader program \"%s\" declares no uniform %s\n", name_.c_str(), uniform);
    std::abort();
  }
#endif
  return location;
}

void Program::use() const { glUseProgram(id_); }

void Program::set(const char* uniform, int value) const { glUniform1i(locationOf(uniform), value); }
void Program::set(const char* uniform, float value) const { glUniform1f(locationOf(uniform), value); }
void Program::set(const char* uniform, glm::vec2 value) const { glUniform2f(locationOf(uniform), value.x, value.y); }
void Program::set(const char* uniform, glm::vec3 value) const {
  glUniform3f(locationOf(uniform), value.x, value.y, value.z);
}
void Program::set(const char* uniform, glm::vec4 value) const {
  glUniform4f(locationOf(uniform), value.x, value.y, value.z, value.w);
}
void Program::setMatrix(const char* uniform, const float* columnMajor4x4) const {
  glUniformMatrix4fv(locationOf(uniform), 1, GL_FALSE, columnMajor4x4);
}
void Program::setTexture(const char* sampler, int unit, const Texture& texture) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture.id());
  set(sampler, unit);
}

void drawFullscreen() {
  // The corners follow from gl_VertexID alone, but ES 3 requires a bound vertex array; the default one will do.
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::string rendererName() {
  constexpr GLenum kUnmaskedRenderer = 0x9246;  // WEBGL_debug_renderer_info
  const auto* const unmasked = reinterpret_cast<const char*>(glGetString(kUnmaskedRenderer));
  while (glGetError() != GL_NO_ERROR) {
  }
  return unmasked && *unmasked != 0 ? unmasked : glString(GL_RENDERER);
}

bool isSoftware(std::string_view rendererName) {
  constexpr std::array<std::string_view, 5> kNames = {"llvmpipe", "softpipe", "SwiftShader", "Basic Render",
                                                      "Software"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](std::string_view name) { return rendererName.find(name) != rendererName.npos; });
}

Result<Capabilities> queryCapabilities() {
  Capabilities capabilities;
  capabilities.renderer = rendererName();
  capabilities.version = glString(GL_VERSION);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &capabilities.maxTextureSize);
  const Texture probe(4, 4, Format::R32F);
  const Texture* const colours[] = {&probe};
  const Result<Framebuffer> framebuffer = Framebuffer::create(colours, false);
  QRELIEF_TRY(framebuffer);
  return capabilities;
}

}  // namespace qrelief::gl
