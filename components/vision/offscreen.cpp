#include "vision/offscreen.h"

// Mesa declares what is newer than OpenGL 1.1 only if this is defined.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// This header needs what the one above declares.
#include <GL/glext.h>
#include <suture/base/errors.h>

#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace robots {
namespace {

constexpr int kSamples = 4;  // of each pixel, which is what Mesa's renderer has
constexpr int kFiner = 2;    // squares are drawn with so many times the pixels in each direction
constexpr int kChannels = 3;

void attach(GLenum where, GLenum format, int width, int height) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
}

[[noreturn]] void refuse(const char* found) {
  throw suture::SetupError("drawing an image without a screen", found,
                           "Install libosmesa6 22.3, as Debian 12 has it");
}

}  // namespace

void Offscreen::Closer::operator()(osmesa_context* context) const { OSMesaDestroyContext(context); }

Offscreen::Offscreen(int width, int height)
    : width_(width),
      height_(height),
      context_(OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr)),
      pixels_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  if (!context_) refuse("Mesa makes no context");
  makeCurrent();
  smooth_ = makeFramebuffer(width, height);
  exact_ = makeFramebuffer(kFiner * kLargestSquare, kFiner * kLargestSquare);
}

void Offscreen::makeCurrent() {
  if (OSMesaMakeCurrent(context_.get(), pixels_.data(), GL_UNSIGNED_BYTE, width_, height_) == 0) {
    refuse("Mesa does not draw in this thread");
  }
  OSMesaPixelStore(OSMESA_Y_UP, 0);  // the upper row comes first
}

/// Returns a framebuffer that belongs to the context, which frees it.
unsigned Offscreen::makeFramebuffer(int width, int height) {
  unsigned framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height);
  attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT16, width, height);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    refuse("Mesa has no framebuffer of four samples a pixel");
  }
  return framebuffer;
}

bool Offscreen::isPossible(const Square& square) const {
  return square.size > 0 && square.size <= kLargestSquare && square.left >= 0 && square.top >= 0 &&
         square.left + square.size <= width_ && square.top + square.size <= height_;
}

void Offscreen::draw(const Parts& parts, ImageFrame& image) {
  makeCurrent();
  // The squares pass through a corner of the image's memory, so they are drawn before the image.
  std::vector<std::pair<Square, std::vector<std::uint8_t>>> exact;
  for (const Square& square : parts.squares) {
    if (isPossible(square)) exact.emplace_back(square, drawExact(parts.all, square));
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width_, height_);
  parts.background();
  if (parts.rows.first < parts.rows.last) drawSmooth(parts.all, parts.rows);
  glFinish();
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  copyTo(image);
  const cv::Mat whole(height_, width_, CV_8UC3, image.data.data());
  for (auto& [square, pixels] : exact) {
    const cv::Rect place(square.left, square.top, square.size, square.size);
    cv::Mat(square.size, square.size, CV_8UC3, pixels.data()).copyTo(whole(place));
  }
}

/// Draws the square kFiner times as large, and makes each pixel the mean of those that lie in it.
/// OpenGL counts rows from below.
std::vector<std::uint8_t> Offscreen::drawExact(const std::function<void()>& all,
                                               const Square& square) {
  const int bottom = height_ - square.top - square.size, size = kFiner * square.size;
  glBindFramebuffer(GL_FRAMEBUFFER, exact_);
  glViewport(-kFiner * square.left, -kFiner * bottom, kFiner * width_, kFiner * height_);
  glScissor(0, 0, size, size);
  glEnable(GL_SCISSOR_TEST);
  all();
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, size, size, 0, 0, size, size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glFinish();
  const cv::Mat drawn(height_, width_, CV_8UC4, pixels_.data());
  cv::Mat colours;
  cv::cvtColor(drawn(cv::Rect(0, height_ - size, size, size)), colours, cv::COLOR_RGBA2RGB);
  std::vector<std::uint8_t> pixels(std::size_t{kChannels} * square.size * square.size);
  cv::resize(colours, cv::Mat(square.size, square.size, CV_8UC3, pixels.data()),
             {square.size, square.size}, 0, 0, cv::INTER_AREA);
  return pixels;
}

/// Draws the rows with smooth edges. OpenGL counts rows from below.
void Offscreen::drawSmooth(const std::function<void()>& all, Rows rows) {
  const int bottom = height_ - rows.last, top = height_ - rows.first;
  glBindFramebuffer(GL_FRAMEBUFFER, smooth_);
  glScissor(0, bottom, width_, top - bottom);
  glEnable(GL_SCISSOR_TEST);
  all();
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, bottom, width_, top, 0, bottom, width_, top, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
}

void Offscreen::copyTo(ImageFrame& image) const {
  image.width = static_cast<std::uint32_t>(width_);
  image.height = static_cast<std::uint32_t>(height_);
  image.channels = kChannels;
  image.data.resize(std::size_t{kChannels} * image.width * image.height);
  const cv::Mat drawn(height_, width_, CV_8UC4, const_cast<std::uint8_t*>(pixels_.data()));
  cv::cvtColor(drawn, cv::Mat(height_, width_, CV_8UC3, image.data.data()), cv::COLOR_RGBA2RGB);
  image.valid = true;
}

}  // namespace robots
