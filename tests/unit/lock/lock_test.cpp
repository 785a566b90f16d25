// These see the lock from the outside: what a build accepts, what it refuses, what an update
// writes.

#include "compiler/lock/contract_hash.h"
#include "compiler/lock/schema/parse.h"
#include "compiler/lock/schema/writer.h"
#include "compiler/lock/wire_contract.h"
#include "tests/unit/lock/lock_fixture.h"

namespace suture::compiler::lock {
namespace {

TEST_F(LockTest, HeaderWithoutLockNamesTheCommand) {
  const Diagnostics found = check(model_, {}, {.command = "make update-lock"});
  ASSERT_EQ(slugs(found), Slugs(3, "lock-missing"));
  EXPECT_EQ(found[0].message, "robots/arm.h has no lock: schemas/robots/arm.capnp does not exist");
  EXPECT_NE(found[0].help.find("make update-lock"), std::string::npos);
}

TEST_F(LockTest, ForeignHeadersAreNotLockedHere) {
  const std::vector<model::Artefact> written = update(model_, {}).files;
  const auto has = [&](const char* path) {
    return std::any_of(written.begin(), written.end(),
                       [&](const model::Artefact& file) { return file.path == path; });
  };
  EXPECT_TRUE(has("robots/arm.capnp"));
  EXPECT_FALSE(has("robots/geometry.capnp"));
}

// The places of a base contract would else follow the order of its declarations.
TEST_F(LockTest, AnotherTargetsHeaderNeedsItsLock) {
  Locks without = before_;
  ASSERT_EQ(without.files.erase("robots/geometry.capnp"), 1u);
  const Diagnostics found = check(model_, without);
  ASSERT_EQ(slugs(found), Slugs{"lock-missing"});
  EXPECT_NE(found[0].message.find("robots/geometry.h of another target"), std::string::npos);
  EXPECT_NE(found[0].help.find("LOCK_PATH"), std::string::npos);
  EXPECT_EQ(slugs(update(model_, without).diagnostics), Slugs{});
}

TEST_F(LockTest, AnotherTargetsHeaderNeedsItsTypesLocks) {
  model::Header user;
  user.path = "lab/user.h";
  user.cxxNamespace = "lab";
  model::Interface contract;
  contract.name = "lab::User";
  contract.wireName = "User";
  contract.base = "robots::Arm";
  user.interfaces = {contract};
  model_.headers.push_back(user);
  for (model::Header& header : model_.headers) header.own = header.path == user.path;
  Locks locks = lockOf(model_);
  EXPECT_EQ(slugs(check(model_, locks)), Slugs{});
  ASSERT_EQ(locks.files.erase("robots/geometry.capnp"), 1u);
  EXPECT_EQ(slugs(check(model_, locks)), Slugs{"lock-missing"});
  ASSERT_EQ(locks.files.erase("robots/arm.capnp"), 1u);
  EXPECT_EQ(slugs(check(model_, locks)), Slugs{"lock-missing"});
}

TEST_F(LockTest, FreshLockIsAcceptedAndStable) {
  EXPECT_TRUE(check(model_, before_).empty());
  EXPECT_TRUE(update(model_, before_).files.empty());
}

TEST_F(LockTest, ParsingWhatWasWrittenLosesNothing) {
  const Lock& lock = armLock(before_);
  Lock again = parse(lock.path, write(lock));
  EXPECT_EQ(write(again), write(lock));
  EXPECT_EQ(again.id, lock.id);
  EXPECT_EQ(again.nodes.size(), lock.nodes.size());
}

TEST_F(LockTest, IdsDependOnProjectAndNameOnly) {
  const Update other = update(model_, {}, {.project = "another"});
  Diagnostics none;
  const Locks locks = read(other.files, none);
  EXPECT_NE(armLock(locks).id, armLock(before_).id);
  EXPECT_NE(nodeOf(armLock(locks), "Arm").id, nodeOf(armLock(before_), "Arm").id);
  EXPECT_EQ(write(armLock(lockOf(sample::robots()))), write(armLock(before_)));
}

TEST_F(LockTest, ReorderedFieldsChangeNothing) {
  std::reverse(everything().fields.begin(), everything().fields.end());
  std::reverse(arm().commands.begin(), arm().commands.end());
  EXPECT_TRUE(check(model_, before_).empty());
}

TEST_F(LockTest, ANewFieldGoesLast) {
  auto& fields = everything().fields;
  fields.insert(fields.begin(), sample::field("extra", sample::number()));
  const Diagnostics found = check(model_, before_);
  ASSERT_EQ(slugs(found), Slugs{"lock-new"});
  EXPECT_NE(found[0].message.find("field 'robots::Everything::extra'"), std::string::npos);
  EXPECT_NE(found[0].message.find("schemas/robots/arm.capnp:"), std::string::npos);

  const Locks after = lockOf(model_, before_);
  const Member& last = nodeOf(armLock(after), "Everything").members.back();
  EXPECT_EQ(last.name, "extra");
  EXPECT_EQ(last.ordinal, fields.size() - 1);
  EXPECT_TRUE(check(model_, after).empty());
}

TEST_F(LockTest, RemovedFieldLeavesAPlaceholderForEver) {
  everything().fields.erase(everything().fields.begin() + 3);  // speed
  const Diagnostics found = check(model_, before_);
  ASSERT_EQ(slugs(found), Slugs{"lock-removed"});
  EXPECT_NE(found[0].help.find("was(\"speed\")"), std::string::npos);

  Locks after = lockOf(model_, before_);
  const Member& placeholder = nodeOf(armLock(after), "Everything").members[3];
  EXPECT_EQ(placeholder.name, "removed3");
  EXPECT_EQ(placeholder.type, "Float64");
  EXPECT_TRUE(placeholder.removed());

  everything().fields.push_back(sample::field("speed", sample::text(4)));
  after = lockOf(model_, after);
  const Node& node = nodeOf(armLock(after), "Everything");
  EXPECT_EQ(node.members[3].name, "removed3");
  EXPECT_EQ(node.members.back().name, "speed");
  EXPECT_TRUE(check(model_, after).empty());
}

TEST_F(LockTest, APlaceholderGivesWayToItsField) {
  everything().fields.push_back(sample::field("removed3", sample::scalar(Scalar::Bool)));
  const Locks old = lockOf(model_, before_);
  everything().fields.erase(everything().fields.begin() + 3);  // speed
  Locks after = lockOf(model_, old);
  const Node* node = &nodeOf(armLock(after), "Everything");
  EXPECT_TRUE(node->members[3].removed());
  EXPECT_EQ(node->members[3].name, "removed3Place");
  EXPECT_EQ(node->members.back().name, "removed3");
  EXPECT_TRUE(check(model_, after).empty());

  everything().fields.push_back(sample::field("removed3_place", sample::scalar(Scalar::Bool)));
  EXPECT_EQ(slugs(check(model_, after)), Slugs{"lock-new"});
  after = lockOf(model_, after);
  node = &nodeOf(armLock(after), "Everything");
  EXPECT_TRUE(node->members[3].removed());
  EXPECT_EQ(node->members[3].name, "removed3PlacePlace");
  EXPECT_TRUE(check(model_, after).empty());
}

TEST_F(LockTest, RenameWithWasKeepsTheOrdinal) {
  field("speed").was = "speed";
  field("speed").wireName = "pathSpeed";
  everything().fields[3].name = "path_speed";
  EXPECT_EQ(slugs(check(model_, before_)), Slugs{"lock-renamed"});
  const Locks after = lockOf(model_, before_);
  EXPECT_EQ(nodeOf(armLock(after), "Everything").members[3].name, "pathSpeed");
  EXPECT_TRUE(check(model_, after).empty()) << "a done rename may keep its was()";
}

TEST_F(LockTest, ATypeChangeNamesTheLine) {
  field("tiny").type = sample::scalar(Scalar::Int16);
  const Diagnostics found = check(model_, before_);
  ASSERT_EQ(slugs(found), Slugs{"lock-break"});
  EXPECT_EQ(found[0].message, "field 'robots::Everything::tiny': type Int16 instead of Int8");
  ASSERT_EQ(found[0].notes.size(), 1u);
  EXPECT_EQ(found[0].notes[0].source.file, "schemas/robots/arm.capnp");
  EXPECT_EQ(found[0].notes[0].text, "the lock has: tiny @1 :Int8");
  const std::string& text = armLock(before_).text;
  unsigned line = 1;
  for (std::size_t i = 0; i < text.find("tiny @1"); ++i) line += text[i] == '\n';
  EXPECT_EQ(found[0].notes[0].source.line, line);
  EXPECT_EQ(slugs(update(model_, before_).diagnostics), Slugs{"lock-break"});
}

TEST_F(LockTest, MeaningsBeyondCapnpAreGuardedToo) {
  field("speed").unit = "mm/s";
  field("period").type.periodDenominator = 1'000'000;
  field("when").type.clock = model::Clock::System;
  field("jacobian").type = sample::matrix(7, 6);
  field("pairs").type = sample::listOf(sample::arrayOf(sample::number(), 3), 5);
  arm().commands[0].kind = model::CommandKind::Write;
  EXPECT_EQ(slugs(check(model_, before_)), Slugs(6, "lock-break"));
}

TEST_F(LockTest, SignaturesOnlyGrow) {
  model::Command& solve = arm().commands[6];
  solve.parameters.push_back(solve.parameters[0]);
  solve.parameters.back().wireName = solve.parameters.back().name = "seed";
  EXPECT_EQ(slugs(check(model_, before_)), Slugs{"lock-new"});
  const Locks after = lockOf(model_, before_);
  const Member& method = nodeOf(armLock(after), "Arm").members[7];
  ASSERT_EQ(method.parameters.size(), 4u);
  EXPECT_EQ(method.parameters[2].name, "sent");
  EXPECT_EQ(method.parameters[3].name, "seed");

  solve.parameters.erase(solve.parameters.begin());
  EXPECT_EQ(slugs(check(model_, after)), Slugs{"lock-break"});
}

TEST_F(LockTest, APolicyChangeMakesTheLockStale) {
  arm().commands[0].queue = 99;
  const Diagnostics found = check(model_, before_);
  ASSERT_EQ(slugs(found), Slugs{"lock-stale"});
  EXPECT_EQ(found[0].severity, Diagnostic::Severity::Warning);
  EXPECT_TRUE(check(model_, lockOf(model_, before_)).empty());
}

TEST_F(LockTest, ARangeIsWrittenWithoutABreak) {
  sample::armHeader(model_).structs[0].fields[3].range = {{-0.5, 3}};
  const Diagnostics found = check(model_, before_);
  ASSERT_EQ(slugs(found), Slugs{"lock-range"});
  EXPECT_EQ(found[0].severity, Diagnostic::Severity::Error);
  EXPECT_TRUE(update(model_, before_).diagnostics.empty());
  EXPECT_TRUE(check(model_, lockOf(model_, before_)).empty());
}

model::Interface& gripper(model::Model& model) {
  for (model::Header& header : model.headers) {
    if (header.path == "robots/gripper.h") return header.interfaces[0];
  }
  throw std::logic_error("the sample has a gripper");
}

TEST_F(LockTest, ACapacityIsWrittenWithoutABreak) {
  field("label").type = sample::text(3);
  EXPECT_EQ(slugs(check(model_, before_)), Slugs{"lock-range"});
  EXPECT_TRUE(update(model_, before_).diagnostics.empty());
}

// Where the hashes are equal, slots are loaded as they are, and a set drops what is there twice.
TEST_F(LockTest, ListsMayBecomeSetsWithoutABreak) {
  const auto hash = [&] {
    return contractHashes(model_, upToDate(model_, before_)).at("robots::Arm");
  };
  const std::string ofList = hash();
  model::Field& list = field("names");
  ASSERT_EQ(list.type.shape, model::Type::Shape::List);
  list.type.distinct = true;
  EXPECT_EQ(slugs(check(model_, before_)), Slugs{"lock-range"});
  EXPECT_NE(hash(), ofList);
  const Locks after = lockOf(model_, before_);
  EXPECT_TRUE(check(model_, after).empty());
  list.type.distinct = false;
  EXPECT_EQ(slugs(check(model_, after)), Slugs{"lock-range"});
}

TEST_F(LockTest, ARemovedCommandIsABreak) {
  arm().commands.erase(arm().commands.begin());
  EXPECT_EQ(slugs(check(model_, before_)), Slugs{"lock-break"});
  EXPECT_EQ(slugs(update(model_, before_).diagnostics), Slugs{"lock-break"});
}

TEST_F(LockTest, AnotherVersionIsABreak) {
  gripper(model_).version = 3;
  EXPECT_EQ(slugs(update(model_, before_).diagnostics), Slugs{"lock-break"});
}

TEST_F(LockTest, ARenamedTypeKeepsItsId) {
  auto& enums = sample::armHeader(model_).enums;
  enums.push_back(sample::enumerated("robots::Pace", {{"Slow", 0}, {"Fast", 1}}));
  const Locks before = lockOf(model_, before_);
  enums.back() = sample::enumerated("robots::Speed", {{"Quick", 1}, {"Slow", 0}});
  enums.back().was = "Pace";
  enums.back().enumerators[0].was = "Fast";
  const Locks after = lockOf(model_, before);
  const Node& now = nodeOf(armLock(after), "Speed");
  EXPECT_EQ(now.id, nodeOf(armLock(before), "Pace").id);
  ASSERT_EQ(now.members.size(), 2u);
  EXPECT_EQ(now.members[0].name, "slow");
  EXPECT_EQ(now.members[1].name, "quick");
}

TEST_F(LockTest, ABuildIgnoresComments) {
  arm().doc.text = "Another comment.";
  EXPECT_TRUE(check(model_, before_).empty());
  EXPECT_EQ(update(model_, before_).files.size(), 1u);
}

TEST_F(LockTest, RemovedContractKeepsItsPlace) {
  sample::armHeader(model_).interfaces.clear();
  std::erase_if(model_.headers, [](const auto& one) { return one.path == "robots/gripper.h"; });
  EXPECT_EQ(slugs(check(model_, before_)), (Slugs{"lock-break", "lock-break", "lock-removed"}));
  const Locks after = lockOf(model_, before_);
  EXPECT_TRUE(nodeOf(armLock(after), "Arm").removed());
  EXPECT_EQ(nodeOf(armLock(after), "Arm").id, nodeOf(armLock(before_), "Arm").id);
  EXPECT_TRUE(check(model_, after).empty());
}

TEST_F(LockTest, ABaseIsPartOfTheContract) {
  const Node& node = nodeOf(before_.files.at("robots/gripper.capnp"), "Gripper");
  EXPECT_EQ(node.extends, std::vector<std::string>{"/robots/arm.capnp:Arm"});
  EXPECT_EQ(node.annotations.at("version"), "2");
  gripper(model_).base.clear();
  EXPECT_EQ(slugs(check(model_, before_)), Slugs{"lock-break"});
  const Locks without = lockOf(model_, {});
  gripper(model_).base = "robots::Arm";
  EXPECT_EQ(slugs(check(model_, without)), Slugs{"lock-break"}) << "its commands come first";
}

TEST_F(LockTest, AContractIsRenamedWithWas) {
  const Lock& old = before_.files.at("robots/gripper.capnp");
  model::Interface& renamed = gripper(model_);
  renamed.name = "robots::Hand";
  renamed.wireName = "Hand";
  renamed.was = "Gripper";
  EXPECT_EQ(slugs(check(model_, before_)), Slugs(3, "lock-renamed"));
  const Locks after = lockOf(model_, before_);
  const Lock& lock = after.files.at("robots/gripper.capnp");
  EXPECT_EQ(nodeOf(lock, "Hand").id, nodeOf(old, "Gripper").id);
  EXPECT_EQ(nodeOf(lock, "HandEvents").id, nodeOf(old, "GripperEvents").id);
  EXPECT_EQ(nodeOf(lock, "HandStateRow").id, nodeOf(old, "GripperStateRow").id);
  EXPECT_TRUE(check(model_, after).empty());
}

TEST_F(LockTest, OptionalCommandsAreNotOfTheCore) {
  const auto core = coreHashes(model_, upToDate(model_, before_)),
             whole = contractHashes(model_, upToDate(model_, before_));
  EXPECT_NE(core.at("robots::Arm"), whole.at("robots::Arm"));
  EXPECT_EQ(core.at("robots::Names"), whole.at("robots::Names"));
  std::erase_if(arm().commands, [](const model::Command& one) { return one.optional; });
  const Locks without = lockOf(model_, {});
  EXPECT_EQ(contractHashes(model_, upToDate(model_, without)).at("robots::Arm"),
            core.at("robots::Arm"));
  EXPECT_EQ(coreHashes(model_, upToDate(model_, without)).at("robots::Arm"),
            core.at("robots::Arm"));
}

TEST_F(LockTest, TheVersionIsPartOfTheHash) {
  const auto before = contractHashes(model_, upToDate(model_, before_));
  gripper(model_).version = 3;
  EXPECT_NE(contractHashes(model_, upToDate(model_, before_)).at("robots::Gripper"),
            before.at("robots::Gripper"));
}

TEST_F(LockTest, DerivedNamesMayNotMeetDeclaredOnes) {
  sample::armHeader(model_).structs.push_back(
      sample::structure("robots::ArmEvents", {sample::field("x", sample::number())}));
  const Diagnostics found = check(model_, before_);
  ASSERT_EQ(slugs(found), (Slugs{"wire-name-clash", "lock-new"}));
  EXPECT_NE(found[0].help.find("name("), std::string::npos);
}

TEST_F(LockTest, NamesThatSuturecNeedsItself) {
  arm().commands[0].wireName = "subscribe";
  arm().commands[1].parameters[0].wireName = "sent";
  arm().events[0].wireName = "state";
  arm().commands[3].wireName = "stamp";
  const Slugs found = slugs(update(model_, {}).diagnostics);
  EXPECT_EQ(found, Slugs(4, "wire-name-clash"));
}

TEST_F(LockTest, OtherHeadersNamesCountToo) {
  model_.headers.back().enums.push_back(
      sample::enumerated("robots::other::Everything", {{"One", 1}}));
  const Slugs found = slugs(check(model_, before_));
  EXPECT_EQ(std::count(found.begin(), found.end(), "wire-name-clash"), 1);
}

TEST_F(LockTest, ACopiedLockIsFound) {
  Diagnostics none;
  const Locks two = read(
      {{"robots/arm.capnp", armLock(before_).text}, {"robots/copy.capnp", armLock(before_).text}},
      none);
  const Diagnostics found = check(model_, two);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].slug, "lock-duplicate-id");
}

}  // namespace
}  // namespace suture::compiler::lock
