#pragma once
#include <suture/annotate.h>

#include <optional>
namespace demo {
struct SUTURE_TYPE(since(2), deprecated("use Pose")) Place {
  double x = 0;
};
struct SUTURE_TYPE() Sample {
  Place place;
  SUTURE_FIELD(deprecated("use place")) Place old;
};
class SUTURE_INTERFACE() Contract {
 public:
  SUTURE_COMMAND() virtual void go(const std::optional<Place>& to) = 0;
  SUTURE_COMMAND() virtual Place where() const = 0;
  SUTURE_COMMAND(deprecated("use go")) virtual void went(const Place& to) = 0;
  SUTURE_EVENT() suture::EventOf<Place> moved;
};
}  // namespace demo
