// These test the rules on contracts: bounds, queues, reads.

#include <gtest/gtest.h>

#include "samples.h"

namespace suture::compiler::check::samples {
namespace {

using Slugs = std::vector<std::string>;

model::Header withCommand(model::Command command) {
  model::Header result = header();
  result.interfaces[0].commands.push_back(std::move(command));
  return result;
}

TEST(Bounds, StringsAndListsNeedThem) {
  EXPECT_EQ(slugs(withCommand(write("say", text(std::nullopt)))), Slugs{"unbounded-contract"});
  EXPECT_EQ(slugs(withCommand(write("say", text(8)))), Slugs{});
  EXPECT_EQ(slugs(withCommand(write("say", list(text(8), std::nullopt)))),
            Slugs{"unbounded-contract"});
  EXPECT_EQ(slugs(withCommand(write("say", list(text(std::nullopt), 8)))),
            Slugs{"unbounded-contract"});
}

TEST(Bounds, MessageNamesThePath) {
  model::Header bad = header();
  bad.structs[0].fields.push_back(field("names", list(text(std::nullopt), 8)));
  const model::Diagnostics findings = check(model::Model{{bad}});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(findings[0].message.find("Sample.names[] is a std::string"), std::string::npos)
      << findings[0].message;
}

TEST(Bounds, TypesOutsideContractsMayBeOpen) {
  model::Header fine = header();
  model::Struct parameters;
  parameters.name = "demo::Parameters";
  parameters.wireName = "Parameters";
  parameters.fields.push_back(field("file", text(std::nullopt)));
  fine.structs.push_back(parameters);
  EXPECT_EQ(slugs(fine), Slugs{});
}

TEST(Bounds, EventsAndResultsCount) {
  model::Header bad = header();
  bad.interfaces[0].events.push_back(event("said", text(std::nullopt)));
  EXPECT_EQ(slugs(bad), Slugs{"unbounded-contract"});
  model::Command name = read("name", text(std::nullopt));
  name.resultByReference = true;
  EXPECT_EQ(slugs(withCommand(name)), Slugs{"unbounded-contract"});
}

model::Type array(model::Type element, unsigned rows) {
  model::Type type;
  type.shape = model::Type::Shape::Array;
  type.rows = rows;
  type.element.push_back(std::move(element));
  return type;
}

TEST(Bounds, SizesDoNotOverflow) {
  const model::Type wraps = array(array(number(), 1u << 30), 1u << 31);  // 2^64 bytes
  EXPECT_EQ(slugs(withCommand(write("flood", wraps))), Slugs{"slot-size"});
}

TEST(Reads, HeapComesByReference) {
  EXPECT_EQ(slugs(withCommand(read("name", text(8)))), Slugs{"heap-read-by-value"});
  model::Command name = read("name", text(8));
  name.resultByReference = true;
  EXPECT_EQ(slugs(withCommand(name)), Slugs{});
  name.resultByReference = false;
  name.kind = model::CommandKind::QualifiedRead;
  name.parameters.push_back(parameter("index", number()));
  EXPECT_EQ(slugs(withCommand(name)), Slugs{});
}

TEST(Queues, LatestExcludesQueue) {
  model::Command servo = write("servo", number());
  servo.latest = true;
  EXPECT_EQ(slugs(withCommand(servo)), Slugs{});
  servo.queueGiven = true;
  EXPECT_EQ(slugs(withCommand(servo)), Slugs{"latest-with-queue"});
}

TEST(Queues, DepthIsBounded) {
  for (const unsigned depth : {0u, 4097u}) {
    model::Command command = write("servo", number());
    command.queue = depth;
    EXPECT_EQ(slugs(withCommand(command)), Slugs{"queue-depth"}) << depth;
  }
}

TEST(Queues, ReadsHaveNone) {
  model::Command command = read("speed", number());
  command.latest = true;
  EXPECT_EQ(slugs(withCommand(command)), Slugs{"queued-read"});
  command.latest = false;
  command.ttlNanoseconds = 5;
  EXPECT_EQ(slugs(withCommand(command)), Slugs{"queued-read"});
}

TEST(Queues, TtlIsPositive) {
  model::Command command = write("servo", number());
  command.ttlNanoseconds = 0;
  EXPECT_EQ(slugs(withCommand(command)), Slugs{"ttl-range"});
}

TEST(Kinds, AReplacedCallHasNoAnswer) {
  model::Command next = read("next", number());
  next.kind = model::CommandKind::VoidReturn;
  EXPECT_EQ(slugs(withCommand(next)), Slugs{});
  next.latest = true;
  EXPECT_EQ(slugs(withCommand(next)), Slugs{"latest-with-result"});
}

TEST(Kinds, DeadlinesArePositiveAndForAnswers) {
  model::Command move = write("moveTo", number());
  move.deadlineNanoseconds = 1;
  EXPECT_EQ(slugs(withCommand(move)), Slugs{});
  move.deadlineNanoseconds = 0;
  EXPECT_EQ(slugs(withCommand(move)), Slugs{"deadline-range"});
  model::Command speed = read("speed", number());
  speed.deadlineNanoseconds = 1;
  EXPECT_EQ(slugs(withCommand(speed)), Slugs{"deadline-on-read"});
}

TEST(Kinds, ConcurrentAndDirectFitSomeKinds) {
  model::Command fits = write("fits", number());
  fits.concurrent = true;
  EXPECT_EQ(slugs(withCommand(fits)), Slugs{"concurrent-kind"});
  fits.kind = model::CommandKind::QualifiedRead;
  fits.result = number();
  EXPECT_EQ(slugs(withCommand(fits)), Slugs{});
  model::Command servo = write("servo", number());
  servo.direct = true;
  EXPECT_EQ(slugs(withCommand(servo)), Slugs{});
  servo.latest = true;
  EXPECT_EQ(slugs(withCommand(servo)), Slugs{"direct-kind"});
}

TEST(Lifecycle, SinceCountsFromOne) {
  for (const unsigned since : {0u, 1u, 3u}) {
    model::Command command = write("servo", number());
    command.lifecycle.since = since;
    EXPECT_EQ(slugs(withCommand(command)), since > 0 ? Slugs{} : Slugs{"since-version"}) << since;
  }
}

TEST(Inheritance, InheritedMembersAreJudgedOnce) {
  model::Header two = withCommand(write("say", text(std::nullopt)));
  model::Interface derived = two.interfaces[0];
  for (model::Command& command : derived.commands) command.inheritedFrom = derived.name;
  for (model::Event& event : derived.events) event.inheritedFrom = derived.name;
  derived.name = "demo::Derived";
  derived.wireName = "Derived";
  two.interfaces.push_back(derived);
  EXPECT_EQ(slugs(two), Slugs{"unbounded-contract"});
}

TEST(Inheritance, NewNamesMustDifferFromInheritedOnes) {
  model::Header two = header();
  model::Interface derived = two.interfaces[0];
  for (model::Command& command : derived.commands) command.inheritedFrom = derived.name;
  derived.events.clear();
  derived.name = "demo::Derived";
  derived.wireName = "Derived";
  derived.commands.push_back(write("move", number()));
  two.interfaces.push_back(derived);
  EXPECT_EQ(slugs(two), Slugs{"wire-name-clash"});
}

/// Returns the contract of header() with this many reads and events.
model::Interface crowded(unsigned count) {
  model::Interface contract = header().interfaces[0];
  while (contract.commands.size() < count + 1) {  // one of them is a write
    contract.commands.push_back(read("r" + std::to_string(contract.commands.size()), number()));
  }
  while (contract.events.size() < count) {
    contract.events.push_back(event("e" + std::to_string(contract.events.size()), number()));
  }
  return contract;
}

TEST(Crowds, ReadsAndEventsHaveABitEach) {
  model::Header one = header();
  one.interfaces[0] = crowded(64);
  EXPECT_EQ(slugs(one), Slugs{});
  one.interfaces[0] = crowded(65);
  EXPECT_EQ(slugs(one), (Slugs{"contract-size", "contract-size"}));
}

TEST(Crowds, InheritedReadsAndEventsCount) {
  model::Header two = header();
  two.interfaces[0] = crowded(64);
  model::Interface derived = two.interfaces[0];
  for (model::Command& command : derived.commands) command.inheritedFrom = derived.name;
  for (model::Event& event : derived.events) event.inheritedFrom = derived.name;
  derived.name = "demo::Derived";
  derived.wireName = "Derived";
  two.interfaces.push_back(derived);
  EXPECT_EQ(slugs(two), Slugs{});
  two.interfaces[1].commands.push_back(read("own", number()));
  two.interfaces[1].events.push_back(event("own", number()));
  EXPECT_EQ(slugs(two), (Slugs{"contract-size", "contract-size"}));
}

TEST(Crowds, AnEmptyDerivedContractIsNotJudged) {
  model::Header two = header();
  two.interfaces[0] = crowded(65);
  model::Interface derived = two.interfaces[0];
  for (model::Command& command : derived.commands) command.inheritedFrom = derived.name;
  for (model::Event& event : derived.events) event.inheritedFrom = derived.name;
  derived.name = "demo::Derived";
  derived.wireName = "Derived";
  two.interfaces.push_back(derived);
  EXPECT_EQ(slugs(two), (Slugs{"contract-size", "contract-size"}));
}

TEST(Components, InterfacesHaveNamesOfTheirOwn) {
  model::Header one = header();
  model::Component component;
  component.name = "demo::Twice";
  component.ports.resize(2);
  component.ports[0].provided = component.ports[1].provided = true;
  component.ports[0].name = component.ports[1].name = "Arm";
  one.components = {component};
  EXPECT_EQ(slugs(one), Slugs{"interface-name-clash"});
  one.components[0].ports[1].provided = false;  // one of each kind is fine
  EXPECT_EQ(slugs(one), Slugs{});
  one.components[0].ports[1].maxAgeNanoseconds = 0;
  EXPECT_EQ(slugs(one), Slugs{"max-age-range"});
}

model::Header crtkWith(model::Command command) {
  model::Header one = withCommand(std::move(command));
  one.interfaces[0].commands.erase(one.interfaces[0].commands.begin(),
                                   one.interfaces[0].commands.begin() + 2);
  one.interfaces[0].commands[0].wireName = "wireName";
  one.interfaces[0].events.clear();
  one.interfaces[0].crtk = true;
  return one;
}

model::Type pose() {
  model::Type type = number();
  type.shape = model::Type::Shape::Isometry;
  return type;
}

TEST(Crtk, NamesAreLevelAndSpace) {
  for (const char* name : {"measured_cp", "measured2_cp", "setpoint_cp", "goal_cp",
                           "local_measured_cp", "jaw_setpoint_cp"}) {
    EXPECT_EQ(slugs(crtkWith(read(name, pose()))), Slugs{}) << name;
  }
  for (const char* name : {"measured", "measuredx_cp", "measure_cp", "measured_cx", "where_cp",
                           "measured_jp", "moved_cp"}) {
    EXPECT_EQ(slugs(crtkWith(read(name, pose()))), Slugs{"crtk-name"}) << name;
  }
}

TEST(Crtk, QueriesAreReadsAndMotionIsNot) {
  EXPECT_EQ(slugs(crtkWith(write("servo_cp", pose()))), Slugs{});
  EXPECT_EQ(slugs(crtkWith(write("measured_cp", pose()))), Slugs{"crtk-query"});
  EXPECT_EQ(slugs(crtkWith(read("move_cp", pose()))), Slugs{"crtk-motion"});
}

TEST(Crtk, PayloadsAreThoseOfTheTable) {
  EXPECT_EQ(slugs(crtkWith(read("measured_cp", number()))), Slugs{"crtk-payload"});
  EXPECT_EQ(slugs(crtkWith(write("servo_jp", list(number(), 8)))), Slugs{});
  EXPECT_EQ(slugs(crtkWith(write("servo_jp", pose()))), Slugs{"crtk-payload"});
  EXPECT_EQ(slugs(crtkWith(write("state_command", text(8)))), Slugs{});
  EXPECT_EQ(slugs(crtkWith(write("state_command", number()))), Slugs{"crtk-payload"});
}

}  // namespace
}  // namespace suture::compiler::check::samples
