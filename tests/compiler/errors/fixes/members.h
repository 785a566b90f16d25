#pragma once
#include <suture/annotate.h>

#include <cstdint>
namespace demo {
enum class Mode { Off, eof };
struct Inner {
  double x = 0;
};
struct SUTURE_TYPE() Fields {
  const int fixed = 1;
  SUTURE_FIELD(unit("m")) double const width = 2;
  volatile int port = 0;
  long long big = 0;
  unsigned long long bigger = 0;
  Inner first;
  Inner second;
  Mode mode = Mode::Off;
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  virtual void forgotten() = 0;
  suture::EventOf<Inner> moved;
};
}  // namespace demo
