#pragma once
// A contract whose values are small, and whose messages are not: each dot takes a word there.

#include <suture/annotate.h>

#include <cstdint>
#include <vector>

namespace large_values {

struct SUTURE_TYPE() Dot {
  std::uint8_t shade = 0;
};

struct SUTURE_TYPE() Dots {
  SUTURE_FIELD(capacity(2500000)) std::vector<Dot> dots;
};

class SUTURE_INTERFACE() Canvas {
 public:
  virtual ~Canvas() = default;

  /// Makes a painting of so many dots.
  SUTURE_COMMAND() virtual void resize(std::uint32_t dots) = 0;
  SUTURE_COMMAND(queue(2)) virtual void paint(const Dots& dots) = 0;
  SUTURE_COMMAND() virtual const Dots& painting() const = 0;
  SUTURE_COMMAND() virtual Dots copy(std::uint32_t dots) const = 0;

  SUTURE_EVENT(queue(2)) suture::EventOf<Dots> painted;
};

}  // namespace large_values
