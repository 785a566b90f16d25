"""What is generated for declarations in no namespace compiles, though the runtime has the same names.

  global_names_test.py SUTUREC COMPILERS CAPNP PLUGIN SCHEMAS FLAG...    COMPILERS are separated by semicolons
"""

import sys

import compiled

TYPES = """\
#pragma once
#include <suture/annotate.h>
#include <suture/component/component.h>
#include <optional>
#include <string>
#include <vector>

enum class SUTURE_TYPE() Errc { Fine, Bad };
struct SUTURE_TYPE() Sample {
  double x = 0;
  Errc errc = Errc::Fine;
};
struct SUTURE_TYPE() Device {
  struct SUTURE_TYPE() State {
    double x = 0;
  };
  State state;
  Sample sample;
  SUTURE_FIELD(capacity(3)) std::vector<Sample> all;
  std::optional<Errc> perhaps;
  Sample pair[2];
};
class SUTURE_TYPE() Result : public Sample {
  SUTURE_FRIEND()
  Errc hidden_ = Errc::Fine;
};
class SUTURE_INTERFACE() Component {
 public:
  virtual ~Component() = default;
  SUTURE_COMMAND() virtual void move(const Sample& goal, Errc errc) = 0;
  SUTURE_COMMAND() virtual Device carry(const Device& device, const Device::State& state) = 0;
  SUTURE_COMMAND() virtual const Sample& sample() const = 0;
  SUTURE_EVENT() suture::EventOf<Sample> moved;
  SUTURE_EVENT() suture::EventOf<Errc, Device> changed;
};
class SUTURE_INTERFACE() Task : public Component {
 public:
  SUTURE_COMMAND() virtual const Result& result() const = 0;
  SUTURE_EVENT() suture::EventOf<Result> ended;
};
"""

COMPONENT = """\
#pragma once
#include <suture/component/task/event_task.h>
#include "types.suture.h"

struct SUTURE_TYPE() Connection {
  Sample start;
};
class SUTURE_COMPONENT() Manager final : public suture::EventTask, public Task {
 public:
  explicit Manager(const Connection& parameters) : sample_(parameters.start) {}
  void move(const ::Sample& goal, ::Errc) override { sample_ = goal; }
  ::Device carry(const ::Device& device, const ::Device::State&) override { return device; }
  const ::Sample& sample() const override { return sample_; }
  const ::Result& result() const override { return result_; }

 private:
  void run() override { provided_.emit().moved(sample_); }
  ::Sample sample_;
  ::Result result_;
  suture::Provided<::Task> provided_{*this, "Task", *this};
  suture::Required<::Task> required_{*this, "Other"};
};
"""


if __name__ == "__main__":
    sys.exit(compiled.main({"types.h": TYPES, "manager.h": COMPONENT}))
