#pragma once
// What no library above has, and a lab may: names that Cap'n Proto or suturec needs for itself,
// names that clash there or are macros, enums at the ends of their type, deprecated and empty
// things, types that hold each other, helpers that share the name of a command.

#include <suture/annotate.h>

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace device {

/// These enums have underlying types that no slot has.
enum class Grade : char { Fair = 'f', Good = 'g' };
enum Offset : long long { Below = -5'000'000'000, Above = 5'000'000'000 };
enum class Mask : unsigned long long { None, All = ~0ull };

/// A Packet has text and bytes as old drivers have them, and integers that no slot has.
struct Packet {
  Grade grade = Grade::Good;
  Offset offset = Below;
  std::map<Mask, std::array<Grade, 2>> masks;
  std::array<char, 5> id{};
  std::vector<char> payload;
  std::vector<char> block;
  std::optional<char> key;
  std::map<long long, std::vector<char>> parts;
  std::array<std::array<char, 3>, 2> grid{};
  char line[4] = {};
};

}  // namespace device

namespace odd {

SUTURE_EXTERNAL_TYPE(device::Grade);
SUTURE_EXTERNAL_TYPE(device::Offset);
SUTURE_EXTERNAL_TYPE(device::Mask);
SUTURE_EXTERNAL_TYPE(device::Packet, all(), member(payload, capacity(16)),
                     member(block, capacity(8), bulk()), member(parts, capacity(2, 4)),
                     member(masks, capacity(2)));

struct SUTURE_TYPE() Text {
  std::int32_t letters = 0;
};
struct SUTURE_TYPE() Data {
  std::int32_t bytes = 0;
};
struct SUTURE_TYPE() List {
  Text first;
};
struct SUTURE_TYPE() Int32 {
  std::int32_t value = 0;
};
struct SUTURE_TYPE() Reader {
  Data card;
};
enum class SUTURE_TYPE() Bool { no, yes, eof, overflow, null };

struct SUTURE_TYPE() Empty {};
enum class SUTURE_TYPE() Lowest : std::int64_t {
  start = std::numeric_limits<std::int64_t>::min(),
  zero = 0
};
enum class SUTURE_TYPE() Highest : std::uint64_t {
  end = std::numeric_limits<std::uint64_t>::max(),
  zero = 0
};

struct SUTURE_TYPE() Old {
  Empty nothing;
  Lowest lowest = Lowest::zero;
  Highest highest = Highest::zero;
  [[deprecated("see lowest")]] double least = 0;
};

/// Branches have a bound, but what leads back to them has none.
struct Leaf;
struct SUTURE_TYPE() Branch {
  SUTURE_FIELD(capacity(3)) std::vector<Leaf> leaves;
};
struct SUTURE_TYPE() Leaf {
  std::unique_ptr<Branch> branch;
  std::vector<Branch> more;
};

template <class T>
struct SUTURE_TYPE() Box {
  T content{};
};
template <>
struct SUTURE_TYPE() Box<bool> {
  std::uint8_t bits = 0;
};
using NumberBox = Box<double>;
using FlagBox = Box<bool>;

typedef struct SUTURE_TYPE() {
  NumberBox number;
  FlagBox flag;
} Boxes;

/// Names that differ where the wire makes no difference, beside one that has the word more already.
enum class SUTURE_TYPE() Twins { First, first, FIRST, firstValue };
struct SUTURE_TYPE() Alike : Text {
  double base = 0;
  std::int32_t foo_bar = 1;
  std::int32_t fooBar = 2;
  Twins twins = Twins::FIRST;
};

/// Its enums are those of a class of C++98, whose enumerators are its own.
class SUTURE_TYPE() Motor {
 public:
  enum SUTURE_TYPE() Mode { Off, On };
  enum SUTURE_TYPE() Brake : std::uint8_t { Open, Shut };

  Mode mode = Off;
  Brake brake = Shut;
};

struct SUTURE_TYPE() Everything {
  Motor motor;
  Alike alike;
  Text text;
  Data data;
  List list;
  Int32 number;
  Reader reader;
  Bool truth = Bool::no;
  SUTURE_FIELD(capacity(4)) std::variant<Text, std::string> either;
  Boxes boxes;
};

/// Its commands and events have names that every contract on the wire has already.
class SUTURE_INTERFACE() Client {
 public:
  virtual ~Client() = default;
  SUTURE_COMMAND() virtual void subscribe(const Everything& sent) = 0;
  SUTURE_COMMAND() virtual double stamp() const = 0;
  SUTURE_COMMAND() virtual Motor::Mode mode() const = 0;
  SUTURE_COMMAND() virtual void keep(const Old& old, Highest value, std::int32_t slot) = 0;
  SUTURE_EVENT() suture::EventOf<Bool> state;
};

#define OK 0
#define ERROR (-1)
/** Is as of a vendor's SDK, C:\sdk\status\ */
enum class SUTURE_TYPE() Status { Ok, Error, Stopped };

inline double turn(double angle) { return angle; }
constexpr double gain = 2;

/// A Stage has helpers with the names of its commands, and a parameter whose name reads like
/// another's.
class SUTURE_INTERFACE() Stage {
 public:
  virtual ~Stage() = default;
  SUTURE_COMMAND() virtual void move(const Text& goal) = 0;
  void move(std::int32_t letters) { move(Text{letters}); }
  SUTURE_COMMAND() virtual double gain() const = 0;
  double& gain() {
    static double own = 0;
    return own;
  }
  SUTURE_COMMAND() virtual const Data& find(const Text& key, double depth) const = 0;
  const Data& find(const Text& key) const { return find(key, 1); }
  SUTURE_COMMAND() virtual Status turn(double angle) = 0;
  template <class Unit>
  Status turn(Unit angle) {
    return turn(angle.value());
  }
  SUTURE_COMMAND() virtual void set_gain(double value) = 0;
  SUTURE_COMMAND() virtual void set(double gain_value) = 0;
};

}  // namespace odd
