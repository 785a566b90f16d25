#pragma once
#include <suture/annotate.h>
namespace demo {
struct SUTURE_TYPE() Sample {
  SUTURE_FIELD(was("b")) double a = 1;
  SUTURE_FIELD(was("a")) double b = 2;
  SUTURE_FIELD(was("a")) double c = 3;
};
enum class SUTURE_TYPE() Mode {
  Off SUTURE_FIELD(was("Fast")),
  On SUTURE_FIELD(was("Off")),
  Fast SUTURE_FIELD(was("On"))
};
struct SUTURE_TYPE(was("demo::Right")) Left {
  double x = 0;
};
struct SUTURE_TYPE(was("Left")) Right {
  double x = 0;
};
class SUTURE_INTERFACE(was("demo::Second")) First {
 public:
  virtual ~First() = default;
  SUTURE_COMMAND(was("stop_it")) virtual void go() = 0;
  SUTURE_COMMAND(was("go")) virtual void stop_it() = 0;
};
class SUTURE_INTERFACE(was("demo::First")) Second {
 public:
  virtual ~Second() = default;
  SUTURE_COMMAND(was("stopIt")) virtual void go() = 0;
  SUTURE_COMMAND(was("go")) virtual void stop_it() = 0;
};
// This one moved here from another namespace, and no name leads back to it.
struct SUTURE_TYPE(was("old::Moved")) Moved {
  double x = 0;
};
}  // namespace demo
