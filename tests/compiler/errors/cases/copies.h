#pragma once
#include <suture/annotate.h>

#include <array>
#include <memory>
#include <string>
#include <vector>
namespace demo {
struct SUTURE_TYPE() Held {
  Held() = default;
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  int x = 0;
};
struct SUTURE_TYPE() Passed {
  Passed() = default;
  Passed(Passed&&) = default;
  Passed& operator=(Passed&&) = default;
  int x = 0;
};
struct SUTURE_TYPE() Owner {
  std::unique_ptr<double> content;
};
struct SUTURE_TYPE() Many {
  std::array<Held, 2> some;
  SUTURE_FIELD(capacity(2)) std::vector<Held> all;
  SUTURE_FIELD(capacity(2)) std::vector<Passed> others;
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_COMMAND() virtual void keep(const Held& held) = 0;
  SUTURE_COMMAND() virtual void take(Held held) = 0;
  SUTURE_COMMAND() virtual const Held& held() const = 0;
  SUTURE_COMMAND() virtual std::array<Held, 2> both() const = 0;
  SUTURE_COMMAND() virtual const Passed& passed() const = 0;
  SUTURE_COMMAND() virtual Passed pass() = 0;
  SUTURE_COMMAND() virtual Owner give() = 0;
  SUTURE_EVENT() suture::EventOf<Held> let_go;
};
}  // namespace demo
