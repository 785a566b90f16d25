"""Writes two versions of a header: the second has a member of every kind of type that docs/types.md names.

  kinds.py --suturec SUTUREC --out FOLDER -- FLAGS...

FOLDER/v1 and FOLDER/v2 get the header, its lock and what suturec writes from it. The lock of the second comes from that of the
first by --update-lock, so that suturec says of every member that it may be added.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

# Name, declaration with "{}" for the name, and how kinds_peer.cpp prints it when an older peer does not know it.
ADDED = [
    ("yes", "bool {} = true", "1"),
    ("int8", "std::int8_t {} = -8", "-8"),
    ("int16", "std::int16_t {} = -16", "-16"),
    ("int32", "std::int32_t {} = -32", "-32"),
    ("int64", "std::int64_t {} = -64", "-64"),
    ("uint8", "std::uint8_t {} = 8", "8"),
    ("uint16", "std::uint16_t {} = 16", "16"),
    ("uint32", "std::uint32_t {} = 32", "32"),
    ("uint64", "std::uint64_t {} = 64", "64"),
    ("float32", "float {} = 1.5f", "1.5"),
    ("float64", "double {} = 2.5", "2.5"),
    ("zero", "double {}", "0"),
    ("noLimit", "double {} = std::numeric_limits<double>::infinity()", "inf"),
    ("noLowerLimit", "float {} = -std::numeric_limits<float>::infinity()", "-inf"),
    ("mode", "Mode {} = Mode::On", "On"),
    ("plainMode", "Mode {}", "Off"),
    ("plainGear", "Gear {}{{}}", "Off"),
    ("gears", "std::array<Gear, 2> {}{{}}", "[Off,Off]"),
    ("gearOfTwo", "std::pair<Gear, double> {}", "(Off,0)"),
    ("gearOrNumber", "std::variant<Gear, double> {}", "0:Off"),
    ("rowsOfGears", "std::array<std::tuple<double, Gear>, 2> {}", "[(0,Off),(0,Off)]"),
    ("text", 'SUTURE_FIELD(capacity(8)) std::string {} = "a"', "'a'"),
    ("plainText", "SUTURE_FIELD(capacity(8)) std::string {}", "''"),
    ("bytes", "SUTURE_FIELD(capacity(4)) std::vector<std::uint8_t> {} = {{1, 2}}", "[1,2]"),
    ("rawBytes", "SUTURE_FIELD(capacity(4)) std::vector<std::byte> {} = {{std::byte{{9}}}}", "[9]"),
    ("plainRawBytes", "SUTURE_FIELD(capacity(4)) std::vector<std::byte> {}", "[]"),
    ("list", "SUTURE_FIELD(capacity(4)) std::vector<double> {} = {{1, 2, 3}}", "[1,2,3]"),
    ("plainList", "SUTURE_FIELD(capacity(4)) std::vector<double> {}", "[]"),
    ("block", "SUTURE_FIELD(capacity(4), bulk()) std::vector<double> {} = {{4, 5}}", "[4,5]"),
    ("texts", 'SUTURE_FIELD(capacity(2, 4)) std::vector<std::string> {} = {{"a", "b"}}', "['a','b']"),
    ("queue", "SUTURE_FIELD(capacity(4)) std::deque<std::int32_t> {} = {{6}}", "[6]"),
    ("array", "std::array<double, 2> {} = {{1, 2}}", "[1,2]"),
    ("plainArray", "std::array<double, 2> {}", "[0,0]"),
    ("arrayOfTexts", 'SUTURE_FIELD(capacity(4)) std::array<std::string, 2> {}', "['','']"),
    ("arrayOfArrays", "std::array<std::array<double, 2>, 2> {}", "[[0,0],[0,0]]"),
    ("arrayOfInners", "std::array<Inner, 2> {}", "[(7,'n'),(7,'n')]"),
    ("arrayOfPoses", "std::array<Eigen::Isometry3d, 2> {}", f"[{'[1 0 0 0 1 0 0 0 1 0 0 0]'},{'[1 0 0 0 1 0 0 0 1 0 0 0]'}]"),
    ("cArray", "double {}[2] = {{3, 4}}", "[3,4]"),
    ("set", "SUTURE_FIELD(capacity(4)) std::set<std::int32_t> {} = {{2, 1}}", "[1,2]"),
    ("unorderedSet", "SUTURE_FIELD(capacity(4)) std::unordered_set<std::int32_t> {} = {{3}}", "[3]"),
    ("map", "SUTURE_FIELD(capacity(4)) std::map<std::int32_t, double> {} = {{{{1, 0.5}}}}", "[(1,0.5)]"),
    ("unorderedMap", "SUTURE_FIELD(capacity(4)) std::unordered_map<std::int32_t, double> {}", "[]"),
    ("optional", "std::optional<double> {} = 4.0", "4"),
    ("plainOptional", "std::optional<double> {}", "none"),
    ("pointer", "std::unique_ptr<double> {}", "none"),
    ("pair", "std::pair<double, std::int32_t> {} = {{1.5, 2}}", "(1.5,2)"),
    ("plainPair", "std::pair<double, std::int32_t> {}", "(0,0)"),
    ("tuple", "std::tuple<double, Inner> {}", "(0,(7,'n'))"),
    ("variant", "std::variant<double, Inner> {} = Inner{{3, \"v\"}}", "1:(3,'v')"),
    ("plainVariant", "std::variant<Inner, double> {}", "0:(7,'n')"),
    ("emptyVariant", "std::variant<std::monostate, double> {}", "0:nothing"),
    ("duration", "std::chrono::milliseconds {}{{20}}", "20"),
    ("realDuration", "std::chrono::duration<double> {}{{0.5}}", "0.5"),
    ("noEnd", "std::chrono::duration<double> {}{{std::numeric_limits<double>::infinity()}}", "inf"),
    ("noEndInFloat", "std::chrono::duration<float, std::milli> {}{{-std::numeric_limits<float>::infinity()}}", "-inf"),
    ("plainDuration", "std::chrono::seconds {}", "0"),
    ("steady", "std::chrono::steady_clock::time_point {}", "0"),
    ("system", "std::chrono::system_clock::time_point {}", "0"),
    ("vector2", "Eigen::Vector2d {}", "[0 0]"),
    ("vector3", "Eigen::Vector3d {} = Eigen::Vector3d::Ones()", "[1 1 1]"),
    ("plainVector3", "Eigen::Vector3d {}", "[0 0 0]"),
    ("vector4", "Eigen::Vector4d {}", "[0 0 0 0]"),
    ("matrix3", "Eigen::Matrix3d {} = Eigen::Matrix3d::Identity()", "[1 0 0 0 1 0 0 0 1]"),
    ("matrix4", "Eigen::Matrix4d {}", "[0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0]"),
    ("quaternion", "Eigen::Quaterniond {} = Eigen::Quaterniond(0, 1, 0, 0)", "[0 1 0 0]"),
    ("plainQuaternion", "Eigen::Quaterniond {}", "[1 0 0 0]"),
    ("isometry", "Eigen::Isometry3d {}", "[1 0 0 0 1 0 0 0 1 0 0 0]"),
    ("affine", "Eigen::Affine3d {}", "[1 0 0 0 1 0 0 0 1 0 0 0]"),
    ("fixedMatrix", "Eigen::Matrix<double, 2, 3> {}", "[0 0 0 0 0 0]"),
    ("vectorOfAny", "SUTURE_FIELD(capacity(4)) Eigen::VectorXd {} = Eigen::VectorXd::Ones(2)", "[1 1]"),
    ("columns", "SUTURE_FIELD(capacity(4)) Eigen::Matrix<double, 3, Eigen::Dynamic> {}", "[]"),
    ("anyMatrix", "SUTURE_FIELD(capacity(2, 2)) Eigen::MatrixXd {}", "[]"),
    ("listOfVectors", "SUTURE_FIELD(capacity(2)) std::vector<Eigen::Vector3d> {}", "[]"),
    ("inner", "Inner {}", "(7,'n')"),
    ("changedInner", 'Inner {}{{9, "c"}}', "(9,'c')"),
    ("instance", "BoxOfInner {}", "{(7,'n')}"),
    ("made", "Made {}", "(5,'m')"),
    ("partly", "Partly {}", "(0.5 [0 0 0] [1 0 0 0])"),
    ("ever", "std::chrono::nanoseconds {} = std::chrono::nanoseconds::max()", "9223372036854775807"),
    ("half", "SUTURE_FIELD(range(-std::numeric_limits<double>::infinity(), 1)) double {} = 0.5", "0.5"),
    ("opaque", "Opaque {}", "<3>"),
    ("external", "External {}", "<1.5 2.5>"),
    ("listed", "Listed {}", "<-1 4>"),
]

HEADER = """#pragma once
// Written by kinds.py.

#include <suture/annotate.h>

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace evolution {
%(types)s
struct SUTURE_TYPE() Record%(bases)s {
%(constructor)s  double x = 0;
%(members)s};

class SUTURE_INTERFACE() Kinds {
 public:
  virtual ~Kinds() = default;
  SUTURE_COMMAND() virtual void put(const Record& record%(parameters)s) = 0;
  SUTURE_COMMAND() virtual const Record& last() const = 0;
  SUTURE_EVENT(name("put")) suture::EventOf<Record> put_event;
};

}  // namespace evolution
"""

TYPES = """
enum class SUTURE_TYPE() Mode { Off, On };
/// A Gear has its zero behind another.
enum class SUTURE_TYPE() Gear { On = 1, Off = 0 };

struct SUTURE_TYPE() Inner {
  std::int32_t a = 7;
  SUTURE_FIELD(capacity(4)) std::string name = "n";
};

template <class T>
struct SUTURE_TYPE() Box {
  T value{};
};
using BoxOfInner = Box<Inner>;

/// Says its defaults in its constructor.
struct SUTURE_TYPE() Made {
  Made() : level(5), label("m") {}
  std::int32_t level;
  SUTURE_FIELD(capacity(4)) std::string label;
};

/// Its constructor says nothing of what Eigen leaves as it is.
struct SUTURE_TYPE() Partly {
  Partly() : speed(0.5) {}
  double speed;
  Eigen::Vector3d offset;
  Eigen::Quaterniond turn;
};

struct SUTURE_TYPE() OpaqueForm {
  std::int32_t number = 3;
};
class Opaque {
 public:
  Opaque() = default;
  explicit Opaque(std::int32_t number) : number_(number) {}
  std::int32_t number() const { return number_; }

 private:
  std::int32_t number_ = 3;
};

/// Stands for a struct that cannot be edited.
struct External {
  double low = 1.5;
  double high = 2.5;
};
SUTURE_EXTERNAL_TYPE(External, low, high);

/// A Listed is another one, whose constructor says what it is by default.
struct Listed {
  Listed() : low(-1), high(4) {}
  double low, high;
};
SUTURE_EXTERNAL_TYPE(Listed);

struct SUTURE_TYPE() Base {
  Base() = default;
  explicit Base(const std::string& name) : id(name) {}
  SUTURE_FIELD(capacity(4)) std::string id = "b";
};

}  // namespace evolution

template <>
struct suture::Wire<evolution::Opaque> {
  using Type = evolution::OpaqueForm;
  static Type to(const evolution::Opaque& value) { return {value.number()}; }
  static evolution::Opaque from(const Type& form) { return evolution::Opaque(form.number); }
};

namespace evolution {
"""

VERSIONED = """#pragma once
// Written by kinds.py: what the peers of this version do otherwise than those of the other.

#include <suture/component/commands.h>

#include "evolution/kinds.suture.h"
#include "tests/compiler/evolution/kinds_text.h"

namespace evolution {

template <class Print>
void forEachAdded(const Record&%(record)s, const Print&%(print)s) {
%(calls)s}

/// Hears what arrives with a command, whatever its version has.
class Receiver : public Kinds {
 public:
  void put(%(parameters)s) final {
    received(record);
%(told)s  }

  virtual void received(const Record& record) = 0;
  virtual void received(const std::string& name, const std::string& value) = 0;
};

inline auto startPut(suture::Required<Kinds>& kinds, const Record& record) {
  return kinds.put.start(record%(arguments)s);
}

}  // namespace evolution
"""

PARAMETERS = [
    ("inner", "const Inner& inner", "Inner{}", "(7,'n')"),
    ("pose", "const Eigen::Isometry3d& pose", "Eigen::Isometry3d::Identity()", "[1 0 0 0 1 0 0 0 1 0 0 0]"),
    ("pair", "const std::array<double, 2>& pair", "std::array<double, 2>{}", "[0,0]"),
]


def write(folder, version):
    newer = version == "v2"
    added = ADDED if newer else []
    parameters = PARAMETERS if newer else []
    listed = "".join(f", {parameter}" for _, parameter, _, _ in parameters)
    calls = '  print("base", record.id);\n' if newer else ""
    (folder / "evolution").mkdir(parents=True, exist_ok=True)
    (folder / "evolution" / "kinds.h").write_text(HEADER % {
        "types": TYPES if newer else "",
        "bases": " : Base" if newer else "",
        "constructor": '  Record() : Base("d") {}\n' if newer else "",
        "members": "".join(f"  {declaration.format(name)};\n" for name, declaration, _ in added),
        "parameters": listed,
    })
    (folder / "versioned.h").write_text(VERSIONED % {
        "record": " record" if newer else "",
        "print": " print" if newer else "",
        "calls": calls + "".join(f'  print("{name}", record.{name});\n' for name, _, _ in added),
        "parameters": "const Record& record" + listed,
        "told": "".join(f'    received("{name}", text({name}));\n' for name, _, _, _ in parameters),
        "arguments": "".join(f", {value}" for _, _, value, _ in parameters),
    })


def run(arguments, folder, flags, *more):
    command = [arguments.suturec, "--target-name", "kinds", "--base-dir", str(folder), "--out", str(folder), "--lock-dir",
               str(folder / "schemas"), *more, str(folder / "evolution" / "kinds.h"), "--", *flags]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stdout + done.stderr)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--suturec", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    arguments, flags = parser.parse_known_args()
    first, second = arguments.out / "v1", arguments.out / "v2"
    for folder in (first, second):
        shutil.rmtree(folder, ignore_errors=True)
        write(folder, folder.name)
    run(arguments, first, flags[1:], "--update-lock")
    shutil.copytree(first / "schemas", second / "schemas")
    run(arguments, second, flags[1:], "--update-lock")
    for folder in (first, second):
        run(arguments, folder, flags[1:])


if __name__ == "__main__":
    main()
