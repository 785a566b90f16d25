#pragma once
// This is a contract whose lists are filled on loan.

#include <suture/annotate.h>

#include <cstdint>
#include <vector>

namespace large_values {

struct SUTURE_TYPE() Frame {
  std::uint32_t number = 0;
  SUTURE_FIELD(capacity(65536), range(0, 200)) std::vector<std::uint8_t> pixels;

  bool operator==(const Frame&) const = default;
};

struct SUTURE_TYPE() FramePair {
  Frame left;
  Frame right;
};

class SUTURE_INTERFACE() Screen {
 public:
  virtual ~Screen() = default;

  SUTURE_COMMAND(queue(3)) virtual void show(const Frame& frame) = 0;
  SUTURE_COMMAND(latest()) virtual void replace(const Frame& frame) = 0;
  SUTURE_COMMAND(queue(3)) virtual void show_both(const FramePair& frames) = 0;

  SUTURE_EVENT(queue(3)) suture::EventOf<Frame> shown;
  SUTURE_EVENT(latest()) suture::EventOf<Frame> newest;
  SUTURE_EVENT(queue(3)) suture::EventOf<FramePair> both;
};

}  // namespace large_values
