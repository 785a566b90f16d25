#pragma once
// These are points in time of a steady clock, wherever a type can hold them, and how long something
// lasts.

#include <suture/annotate.h>
#include <suture/base/time.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

namespace shapes {

/// It has a time of each clock, of which only one is shifted.
struct SUTURE_TYPE() Moment {
  suture::Time steady;
  std::chrono::system_clock::time_point system;
  std::int64_t number = 0;
};

/// One in each container.
struct SUTURE_TYPE() Moments {
  std::array<suture::Time, 2> pair;
  SUTURE_FIELD(capacity(3)) std::vector<suture::Time> list;
  SUTURE_FIELD(capacity(2)) std::vector<Moment> moments;
  SUTURE_FIELD(capacity(2, 2)) std::vector<std::vector<suture::Time>> nested;
  SUTURE_FIELD(capacity(2)) std::map<std::int32_t, suture::Time> byNumber;
  std::optional<suture::Time> perhaps;
  std::optional<Moment> moment;
  std::tuple<std::int64_t, suture::Time, Moment> entry;
  std::variant<std::int64_t, suture::Time, Moment> either;
};

/// Lasts as long as the types of C++ can count.
struct SUTURE_TYPE() Spans {
  std::chrono::duration<float, std::milli> brief{0};
  std::chrono::duration<double> endless{std::numeric_limits<double>::infinity()};
  SUTURE_FIELD(capacity(2)) std::vector<std::chrono::duration<float>> list;
};

/// Right in a contract: the arguments, the results and the payloads.
class SUTURE_INTERFACE() Journal {
 public:
  virtual ~Journal() = default;
  SUTURE_COMMAND() virtual void put(const suture::Time& from, std::int64_t number) = 0;
  SUTURE_COMMAND() virtual void count(std::int64_t number) = 0;
  SUTURE_COMMAND() virtual suture::Time latest() const = 0;
  SUTURE_COMMAND() virtual const Moments& moments() const = 0;
  SUTURE_COMMAND() virtual std::optional<Moment> find(std::int64_t number) const = 0;
  SUTURE_EVENT() suture::EventOf<suture::Time> added;
  SUTURE_EVENT() suture::EventOf<Moment, std::int64_t> changed;
  SUTURE_EVENT() suture::EventOf<std::int64_t> counted;
};

}  // namespace shapes
