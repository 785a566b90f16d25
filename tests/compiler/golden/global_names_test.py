"""What is generated for declarations in no namespace compiles, though the runtime has the same names.

  global_names_test.py SUTUREC COMPILERS CAPNP PLUGIN SCHEMAS FLAG...    COMPILERS are separated by semicolons
"""

import pathlib
import subprocess
import sys
import tempfile

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
  SUTURE_FRIEND();
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


def run(folder, *command):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    return [] if done.returncode == 0 else [f"{' '.join(command)}\n{done.stdout}{done.stderr}"]


def main():
    suturec, compilers, capnp, plugin, schemas, *flags = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("types", TYPES), ("manager", COMPONENT)):
            pathlib.Path(folder, f"{name}.h").write_text(text, encoding="utf-8")
        problems = []
        for action in (["--update-lock"], ["--out", ".", "--components-file", "components.cpp"]):
            problems = problems or run(folder, suturec, *action, "--lock-dir", ".", "types.h", "manager.h", "--", "-I.", *flags)
        problems = problems or run(folder, capnp, "compile", f"-I{schemas}", "-I.", f"-o{plugin}", "types.capnp", "manager.capnp")
        sources = sorted(path.name for path in pathlib.Path(folder).glob("*.cpp"))
        pathlib.Path(folder, "all.cc").write_text("".join(f'#include "{source}"\n' for source in sources), encoding="utf-8")
        for compiler in compilers.split(";") if not problems else []:
            problems += run(folder, compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-isystem.", *flags, "all.cc")
    print("\n".join(problems) or f"{len(sources)} files compile")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
