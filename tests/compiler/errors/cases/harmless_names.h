#pragma once
#include <suture/annotate.h>
#include <cstdint>
#include <string>
namespace demo {
struct SUTURE_TYPE() Sample {
  SUTURE_FIELD(capacity(8), name("label")) std::string name;
  SUTURE_FIELD(unit("m"), range(0, 2)) double range = 1;
  SUTURE_FIELD(unit("s")) double deadline = 0;
  std::int32_t queue = 0, latest = 0, unit = 0, capacity = 0, version = 0;
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_COMMAND(queue(4), ttl(20ms)) virtual void queue(std::int32_t name) = 0;
  SUTURE_COMMAND(latest()) virtual void latest(double range) = 0;
  SUTURE_COMMAND(deadline(1s)) virtual std::int32_t name(std::int32_t queue) = 0;
  SUTURE_COMMAND(optional()) virtual double range() const { return 0; }
  SUTURE_COMMAND() virtual void info(std::int32_t version, std::int32_t slot) = 0;
  SUTURE_EVENT(latched(), queue(2)) suture::EventOf<std::int32_t> latched;
};
}  // namespace demo
