#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
#include <suture/component/required.h>

#include <cstdint>
#include <mutex>
#include <vector>
// What looks questionable and is not: none of it is refused.
namespace demo {
#define DEMO_LENGTH(name) SUTURE_FIELD(unit("m")) double name = 0
struct SUTURE_TYPE() Words {
  DEMO_LENGTH(length);
  int import = 0;
  bool annotation = true;
  double interface = 0;
  float Void = 0;
  int text = 0;
  SUTURE_FIELD(name("struct")) int kind = 0;
  SUTURE_FIELD(name("true")) bool yes = true;
  SUTURE_FIELD(name("angle")) double winkelÄ = 0;
  SUTURE_FIELD(skip()) std::mutex* guard = nullptr;
  int : 5;
};
class SUTURE_INTERFACE() Contract {
 public:
  virtual ~Contract() = default;
  SUTURE_COMMAND() virtual void emit() = 0;
  SUTURE_COMMAND() virtual void name(int range, int queue, int unit) = 0;
  SUTURE_COMMAND(queue(2)) virtual void queue() = 0;
  SUTURE_COMMAND() virtual Words range() const = 0;
  SUTURE_EVENT(name("on")) suture::EventOf<> on_event;
  SUTURE_EVENT() suture::EventOf<std::int64_t> counted;
};
// Constructors use what is still to be generated.
class Client : public suture::Device {
 public:
  Client() : started_(needed.queue()) {}
  suture::Required<Contract> needed{*this, "Needed"};

 private:
  bool started_;
};
struct Both {
  Both() {
    if (first.needed.queue()) second.needed.emit();
  }
  Client first, second;
};
}  // namespace demo
