#pragma once
// This is a contract whose values are larger than the stack of many a thread.

#include <suture/annotate.h>

#include <cstdint>
#include <vector>

namespace large_values {

struct SUTURE_TYPE() Picture {
  SUTURE_FIELD(capacity(1048576)) std::vector<std::uint8_t> pixels;
};

class SUTURE_INTERFACE() Gallery {
 public:
  virtual ~Gallery() = default;

  SUTURE_COMMAND() virtual const Picture& newest() const = 0;
  SUTURE_COMMAND() virtual const Picture& oldest() const = 0;
  SUTURE_COMMAND() virtual Picture dimmed(const Picture& picture) const = 0;
  SUTURE_COMMAND(queue(2)) virtual void hang(const Picture& picture) = 0;

  SUTURE_EVENT(latest()) suture::EventOf<Picture> hung;
};

}  // namespace large_values
