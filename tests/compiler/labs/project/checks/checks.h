#pragma once
// The checks of all libraries need this.

#include "values/members.h"
// It calls what members.h declares.
#include "values/round_trip.h"

#include <suture/base/field_path.h>

#include <limits>
#include <string>

namespace invented {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Checks a few hundred values of one type.
template <class Value, class Slot, class Message>
void checkType(const char* name, Random& random) {
  RoundTrip<Value, Slot, Message> trip(name);
  checkAll(trip, random, Value());
}

/// The name of the part that the check of a value refuses is `part`; "" stands for none.
template <class Slot, class Value>
void checkRefused(const Value& value, const char* part) {
  const auto slot = slotFullOf<Slot>(0x5a);
  require(store(value, *slot), part, "a value within its bounds does not fit");
  suture::FieldPath path;
  require(isValid(*slot, &path) == path.empty(), part, "a refusal names a part");
  require(path.text() == part, part, "the refusal names another part");
}

void checkFranka(Random& random);
void checkRobot(Random& random);
void checkRuckig(Random& random);
void checkMavlink(Random& random);
void checkPx4(Random& random);
void checkRos2(Random& random);
void checkConsole(Random& random);
void checkOpenCv(Random& random);

}  // namespace invented
