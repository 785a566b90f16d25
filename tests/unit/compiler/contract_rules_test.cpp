// Rules on contracts: bounds, queues, reads.

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

}  // namespace
}  // namespace suture::compiler::check::samples
