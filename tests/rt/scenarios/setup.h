#pragma once
// These are two ends, each connected to the other.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <tuple>

#include "rt/scenarios/end.h"
#include "support/temporary_directory.h"

namespace scenarios {

enum class LaneUnderTest { Local, Shm, Frame, Rpc };

using Combination = std::tuple<LaneUnderTest, Kind, Kind>;

/// `client` uses what `server` serves, and the other way round.
class Scenario : public testing::TestWithParam<Combination> {
 protected:
  Scenario();
  ~Scenario() override;
  void SetUp() override;
  void TearDown() override;

  std::unique_ptr<End> server, client;

 private:
  struct Processes;
  suture::TemporaryDirectory directory_;
  std::unique_ptr<Processes> processes_;
};

inline auto allCombinations() {
  const auto kinds = testing::Values(Kind::Device, Kind::Periodic, Kind::Continuous,
                                     Kind::FromSignal, Kind::FromCallback, Kind::Guest);
  return testing::Combine(testing::Values(LaneUnderTest::Local, LaneUnderTest::Shm,
                                          LaneUnderTest::Frame, LaneUnderTest::Rpc),
                          kinds, kinds);
}

std::string nameOf(const testing::TestParamInfo<Combination>& info);

/// This is one prototype of an argument: the command of each kind that takes or gives it, and a
/// value.
template <class Set, class Read, class Twice, class Take, class Swap, class Value>
struct Prototype {
  Set& set;
  Read& read;
  Twice& twice;
  Take& take;
  Swap& swap;
  Value value;
};
template <class Set, class Read, class Twice, class Take, class Swap, class Value>
Prototype(Set&, Read&, Twice&, Take&, Swap&, Value)
    -> Prototype<Set, Read, Twice, Take, Swap, Value>;

/// Shows each prototype to `visit`.
template <class Visit>
void forEachPrototype(Used& used, const Visit& visit) {
  visit(Prototype{used.set_scalar, used.scalar, used.twice_scalar, used.take_scalar,
                  used.swap_scalar, 2.5});
  visit(Prototype{used.set_vector, used.vector, used.twice_vector, used.take_vector,
                  used.swap_vector, Vector(1, -2, 3)});
  visit(Prototype{used.set_record, used.record, used.twice_record, used.take_record,
                  used.swap_record, recordOf(4, "tip")});
  visit(Prototype{used.set_text, used.text, used.twice_text, used.take_text, used.swap_text,
                  std::string("needle driver")});
}

}  // namespace scenarios
