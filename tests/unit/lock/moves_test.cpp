// A type that moves to another header, or gets another name there, stays what it is on the wire.

#include "compiler/lock/moves/moves.h"

#include <map>

#include "compiler/lock/differences.h"
#include "tests/unit/lock/lock_fixture.h"

namespace suture::compiler::lock {
namespace {

using Lines = std::vector<std::string>;

const Node* findNode(const Lock& lock, const std::string& name) {
  for (const Node& node : lock.nodes) {
    if (node.name == name) return &node;
  }
  return nullptr;
}

model::Type optional(model::Type element) {
  model::Type type;
  type.shape = model::Type::Shape::Optional;
  type.spelling = "std::optional<" + element.spelling + ">";
  type.element = {std::move(element)};
  return type;
}

/// The lock has Part, which moves from from.h to to.h, beside Rest in from.h, and Whole of user.h,
/// which has a Part.
class MovesTest : public testing::Test {
 protected:
  MovesTest() {
    header("n/from.h").structs = {
        sample::structure("n::Part", {sample::field("a", number_), sample::field("b", number_)}),
        sample::structure("n::Rest", {sample::field("c", number_)})};
    header("n/user.h").structs = {sample::structure(
        "n::Whole", {sample::field("part", sample::record("n::Part")),
                     sample::field("parts", sample::listOf(sample::record("n::Part"), 3))})};
  }

  model::Header& header(const std::string& path) {
    for (model::Header& one : model_.headers) {
      if (one.path == path) return one;
    }
    model::Header& added = model_.headers.emplace_back();
    added.path = added.file = path;
    added.cxxNamespace = "n";
    return added;
  }

  model::Struct& part(const std::string& path = "n/from.h") { return header(path).structs[0]; }

  /// Moves Part in front of what the other header has.
  void move(const std::string& from, const std::string& to) {
    model::Struct moving = part(from);
    header(from).structs.erase(header(from).structs.begin());
    auto& structs = header(to).structs;
    structs.insert(structs.begin(), std::move(moving));
  }

  Slugs errors(const Locks& locks) const { return slugs(check(model_, locks)); }

  const model::Type number_ = sample::number();
  model::Model model_;
};

const Lock& from(const Locks& locks) { return locks.files.at("n/from.capnp"); }
const Lock& to(const Locks& locks) { return locks.files.at("n/to.capnp"); }
const Lock& user(const Locks& locks) { return locks.files.at("n/user.capnp"); }

TEST_F(MovesTest, AMovedTypeKeepsItsNumbers) {
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  std::swap(part("n/to.h").fields[0], part("n/to.h").fields[1]);
  const Locks after = lockOf(model_, before);
  const Node& moved = nodeOf(to(after), "Part");
  EXPECT_EQ(moved.id, nodeOf(from(before), "Part").id);
  ASSERT_EQ(moved.members.size(), 2u);
  EXPECT_EQ(moved.members[0].name, "a");
  EXPECT_EQ(findNode(from(after), "Part"), nullptr);
  EXPECT_EQ(nodeOf(user(after), "Whole").members[1].type, "List(/n/to.capnp:Part)");
  EXPECT_EQ(errors(after), Slugs{});
  EXPECT_TRUE(update(model_, after).files.empty());
}

TEST_F(MovesTest, ABuildAsksToUpdateEachLock) {
  header("n/to.h").structs = {sample::structure("n::Other", {sample::field("d", number_)})};
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  EXPECT_EQ(errors(before), Slugs(3, "lock-moved"));
}

TEST_F(MovesTest, AnUpdateTellsWhatMoved) {
  header("n/to.h").structs = {sample::structure("n::Other", {sample::field("d", number_)})};
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  const std::map<std::string, Lines> expected = {
      {"n/from.capnp", {"fine:    Part moved to /n/to.capnp"}},
      {"n/to.capnp", {"fine:    struct Part was /n/from.capnp:Part before"}},
      {"n/user.capnp",
       {"fine:    the schema names /n/to.capnp:Part instead of /n/from.capnp:Part"}}};
  EXPECT_EQ(update(model_, before).changes, expected);
}

TEST_F(MovesTest, AMovedTypeMayBeRenamed) {
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  part("n/to.h").name = "n::Piece";
  part("n/to.h").wireName = "Piece";
  part("n/to.h").was = "Part";
  for (model::Field& field : part("n/user.h").fields) {
    (field.type.element.empty() ? field.type : field.type.element[0]).name = "n::Piece";
  }
  const Locks after = lockOf(model_, before);
  EXPECT_EQ(nodeOf(to(after), "Piece").id, nodeOf(from(before), "Part").id);
  EXPECT_EQ(nodeOf(user(after), "Whole").members[0].type, "/n/to.capnp:Piece");
  EXPECT_EQ(errors(after), Slugs{});
}

TEST_F(MovesTest, ATypeMayMoveThereAndBack) {
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  const Locks between = lockOf(model_, before);
  move("n/to.h", "n/from.h");
  const Locks after = lockOf(model_, between);
  EXPECT_EQ(nodeOf(from(after), "Part").id, nodeOf(from(before), "Part").id);
  EXPECT_EQ(nodeOf(user(after), "Whole").members[0].type, "/n/from.capnp:Part");
  EXPECT_EQ(from(after).departures.size(), 0u);
  EXPECT_EQ(to(after).departures.size(), 1u);
}

TEST_F(MovesTest, AMovedTypesNamesAreSpelledAnew) {
  part().fields.push_back(sample::field("rest", sample::record("n::Rest")));
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  EXPECT_EQ(update(model_, before).diagnostics.size(), 0u);
  const Locks after = lockOf(model_, before);
  EXPECT_EQ(nodeOf(to(after), "Part").members[2].type, "/n/from.capnp:Rest");
}

TEST_F(MovesTest, AnUnsharedCompositeMovesToo) {
  part().fields.push_back(sample::field("maybe", optional(optional(number_))));
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  EXPECT_EQ(update(model_, before).diagnostics.size(), 0u);
  const Locks after = lockOf(model_, before);
  for (const std::string name : {"OptionalFloat64", "OptionalOptionalFloat64"}) {
    EXPECT_EQ(nodeOf(to(after), "NTo" + name).id, nodeOf(from(before), "NFrom" + name).id);
    EXPECT_EQ(findNode(from(after), "NFrom" + name), nullptr);
  }
  EXPECT_EQ(errors(after), Slugs{});
}

TEST_F(MovesTest, ACompositeThatStaysIsABreak) {
  part().fields.push_back(sample::field("maybe", optional(number_)));
  header("n/from.h").structs[1].fields.push_back(sample::field("maybe", optional(number_)));
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  const Diagnostics found = update(model_, before).diagnostics;
  ASSERT_EQ(slugs(found), Slugs{"lock-break"});
  EXPECT_NE(found[0].help.find("leave Part in its header"), std::string::npos) << found[0].help;
}

TEST_F(MovesTest, AnExistingCompositeIsABreak) {
  part().fields.push_back(sample::field("maybe", optional(number_)));
  header("n/to.h").structs = {
      sample::structure("n::Other", {sample::field("maybe", optional(number_))})};
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  const Diagnostics found = update(model_, before).diagnostics;
  ASSERT_EQ(slugs(found), Slugs{"lock-break"});
  EXPECT_NE(found[0].help.find("leave Part in its header"), std::string::npos) << found[0].help;
}

// A placeholder keeps its place on the wire, and no import of what may import it.
TEST_F(MovesTest, WhatWasRemovedForgetsAMovedType) {
  part().fields.push_back(sample::field("rest", sample::record("n::Rest")));
  const Locks before = lockOf(model_);
  part().fields.pop_back();
  const Locks between = lockOf(model_, before);
  move("n/from.h", "n/to.h");
  part("n/user.h").fields.pop_back();
  EXPECT_EQ(update(model_, between).diagnostics.size(), 0u);
  const Locks after = lockOf(model_, between);
  EXPECT_EQ(nodeOf(to(after), "Part").members[2].type, "AnyPointer");
  EXPECT_EQ(nodeOf(user(after), "Whole").members[1].type, "AnyPointer");
  EXPECT_EQ(errors(after), Slugs{});
}

// The header that had it may not include the other one any more, whose type then moves unseen.
TEST_F(MovesTest, RemovingForgetsAnotherHeadersType) {
  const Locks before = lockOf(model_);
  auto& fields = part("n/user.h").fields;
  fields.clear();
  const Locks after = lockOf(model_, before);
  EXPECT_EQ(nodeOf(user(after), "Whole").members[0].type, "AnyPointer");
  EXPECT_EQ(nodeOf(user(after), "Whole").members[1].type, "AnyPointer");
  EXPECT_EQ(errors(after), Slugs{});
}

TEST_F(MovesTest, AMovedTypesCompositeMayReturn) {
  auto& fields = part("n/user.h").fields;
  fields.push_back(sample::field("maybe", optional(sample::record("n::Part"))));
  const Locks before = lockOf(model_);
  fields.pop_back();
  const Locks without = lockOf(model_, before);
  EXPECT_TRUE(nodeOf(user(without), "NUserOptionalPart").removed());
  move("n/from.h", "n/to.h");
  const Locks between = lockOf(model_, without);
  EXPECT_EQ(nodeOf(user(between), "NUserOptionalPart").members[1].type, "AnyPointer");
  part("n/user.h").fields.push_back(sample::field("again", optional(sample::record("n::Part"))));
  EXPECT_EQ(update(model_, between).diagnostics.size(), 0u);
  const Locks after = lockOf(model_, between);
  EXPECT_EQ(nodeOf(user(after), "NUserOptionalPart").members[1].type, "/n/to.capnp:Part");
  EXPECT_EQ(errors(after), Slugs{});
}

TEST_F(MovesTest, ANewTypesTakenNameIsRemarked) {
  Locks before = lockOf(model_);
  before.others.insert(before.files.extract("n/from.capnp"));
  before.files.erase("n/user.capnp");
  move("n/from.h", "n/to.h");
  std::erase_if(model_.headers, [](const auto& one) { return one.path != "n/to.h"; });
  EXPECT_EQ(errors(before), (Slugs{"lock-moved", "lock-missing"}));
  const Update updated = update(model_, before);
  ASSERT_EQ(slugs(updated.diagnostics), Slugs{"lock-moved"});
  EXPECT_EQ(updated.diagnostics[0].severity, Diagnostic::Severity::Warning);
  EXPECT_NE(updated.diagnostics[0].help.find("was(\"n::Part\")"), std::string::npos);
}

// The other target gave the members other numbers, since it did not know of this lock.
TEST_F(MovesTest, AnotherTargetMustKeepTheNumbers) {
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  Locks between = before;
  Lock& other = between.files["n/to.capnp"] = to(lockOf(model_, before));
  std::swap(other.nodes[0].members[0].name, other.nodes[0].members[1].name);
  header("n/to.h").own = false;
  EXPECT_EQ(slugs(update(model_, between).diagnostics), Slugs{"lock-moved"});
}

TEST_F(MovesTest, ClashingWithARemovedTypeAdvisesWas) {
  part("n/user.h").fields.clear();
  const Locks before = lockOf(model_);
  part().name = "n::inner::Part";
  const auto clashOf = [&](const Locks& locks) {
    const Diagnostics found = check(model_, locks);
    const auto clash = std::find_if(found.begin(), found.end(), [](const Diagnostic& one) {
      return one.slug == "wire-name-clash";
    });
    return clash == found.end() ? "" : clash->help;
  };
  EXPECT_NE(clashOf(before).find("say was(\"n::Part\")"), std::string::npos);
  part().was = "n::Part";
  EXPECT_EQ(clashOf(before), "");
  part().was.reset();
  header("n/from.h").structs.erase(header("n/from.h").structs.begin());
  const Locks removed = lockOf(model_, before);
  header("n/from.h").structs.push_back(sample::structure("n::inner::Part", {}));
  EXPECT_EQ(clashOf(removed), "give it another: name(\"...\")");
}

TEST_F(MovesTest, AContractMovesToo) {
  model::Interface contract;
  contract.name = "n::Arm";
  contract.wireName = "Arm";
  contract.commands = {sample::read("last", sample::record("n::Rest"))};
  header("n/from.h").interfaces = {contract};
  const Locks before = lockOf(model_);
  header("n/from.h").interfaces.clear();
  header("n/to.h").interfaces = {contract};
  EXPECT_EQ(update(model_, before).diagnostics.size(), 0u);
  const Locks after = lockOf(model_, before);
  for (const std::string name : {"Arm", "ArmEvents", "ArmStateRow"}) {
    EXPECT_EQ(nodeOf(to(after), name).id, nodeOf(from(before), name).id);
  }
  EXPECT_EQ(errors(after), Slugs{});
}

TEST_F(MovesTest, OthersFollowARenamedType) {
  const Locks before = lockOf(model_);
  part().name = "n::Piece";
  part().wireName = "Piece";
  part().was = "Part";
  for (model::Field& field : part("n/user.h").fields) {
    (field.type.element.empty() ? field.type : field.type.element[0]).name = "n::Piece";
  }
  EXPECT_EQ(update(model_, before).diagnostics.size(), 0u);
  const Locks after = lockOf(model_, before);
  EXPECT_EQ(nodeOf(user(after), "Whole").members[0].type, "/n/from.capnp:Piece");
}

TEST_F(MovesTest, AnotherTargetTakesTheTypeFirst) {
  header("n/to.h").structs = {sample::structure("n::Other", {sample::field("d", number_)})};
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  const Locks after = lockOf(model_, before);
  header("n/to.h").own = false;
  EXPECT_EQ(slugs(update(model_, before).diagnostics), Slugs{"lock-moved"});
  Locks between = before;  // the other target has been updated, and this one has not
  between.files.at("n/to.capnp") = to(after);
  EXPECT_EQ(errors(between), Slugs(2, "lock-moved"));
  EXPECT_EQ(from(lockOf(model_, between)).text, from(after).text);
}

// The lock of the new header tells it, since nothing is left that would.
TEST_F(MovesTest, AnotherTargetFollowsARemovedHeadersType) {
  const Locks before = lockOf(model_);
  Locks between = before;
  between.others.insert(between.files.extract("n/from.capnp"));
  move("n/from.h", "n/to.h");
  std::erase_if(model_.headers, [](const auto& one) { return one.path == "n/from.h"; });
  part("n/to.h").was = "n::Part";
  Locks after = lockOf(model_, between);
  const std::string expected = user(after).text;
  after.files.at("n/user.capnp") = user(before);
  header("n/to.h").own = false;
  EXPECT_EQ(errors(after), Slugs{"lock-moved"});
  EXPECT_EQ(user(lockOf(model_, after)).text, expected);
}

TEST_F(MovesTest, ALockIsRenamedWithItsHeader) {
  part().fields.push_back(sample::field("maybe", optional(number_)));
  const Locks before = lockOf(model_);
  Locks renamed = before;
  auto file = renamed.files.extract("n/from.capnp");
  file.key() = file.mapped().path = "n/to.capnp";
  renamed.files.insert(std::move(file));
  header("n/from.h").path = "n/to.h";
  EXPECT_EQ(slugs(update(model_, renamed).diagnostics), Slugs{});
  Locks after = lockOf(model_, renamed);
  EXPECT_EQ(nodeOf(to(after), "Part").id, nodeOf(from(before), "Part").id);
  EXPECT_EQ(nodeOf(user(after), "Whole").members[0].type, "/n/to.capnp:Part");
  EXPECT_EQ(errors(after), Slugs{});
  after.files.at("n/user.capnp") = user(before);  // its target is updated later
  EXPECT_EQ(errors(after), Slugs{"lock-moved"});
}

TEST_F(MovesTest, ALockAwaitsAnotherTarget) {
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  Locks between = before;
  between.files["n/to.capnp"] = to(lockOf(model_, before));
  header("n/from.h").own = header("n/to.h").own = false;
  const Diagnostics found = check(model_, between);
  ASSERT_EQ(slugs(found), Slugs(2, "lock-moved"));
  EXPECT_EQ(found[0].help, "update the lock of the target of n/from.h first");
  EXPECT_FALSE(update(model_, between).diagnostics.empty());
}

TEST_F(MovesTest, OnlyWasTakesARemovedHeadersType) {
  part().fields.push_back(sample::field("maybe", optional(number_)));
  Locks before = lockOf(model_);
  before.others.insert(before.files.extract("n/from.capnp"));
  move("n/from.h", "n/to.h");
  std::erase_if(model_.headers, [](const auto& one) { return one.path == "n/from.h"; });
  EXPECT_EQ(unknownNames(model_, before), std::vector<std::string>{"n::Part"});
  EXPECT_EQ(slugs(update(model_, before).diagnostics),
            (Slugs{"lock-moved", "lock-break", "lock-break"}));
  part("n/to.h").was = "n::Part";
  EXPECT_EQ(slugs(update(model_, before).diagnostics), Slugs{});
  const Locks after = lockOf(model_, before);
  const Lock& old = before.others.at("n/from.capnp");
  EXPECT_EQ(nodeOf(to(after), "Part").id, nodeOf(old, "Part").id);
  EXPECT_EQ(nodeOf(to(after), "NToOptionalFloat64").id, nodeOf(old, "NFromOptionalFloat64").id);
  EXPECT_EQ(nodeOf(user(after), "Whole").members[0].type, "/n/to.capnp:Part");
  EXPECT_EQ(unknownNames(model_, after), std::vector<std::string>{});
}

TEST_F(MovesTest, ADefaultEnumeratorMayMove) {
  header("n/from.h").enums = {sample::enumerated("n::Mode", {{"Off", 0}, {"On", 1}})};
  auto& fields = part("n/user.h").fields;
  for (const char* const value : {"Off", "On"}) {
    fields.push_back(sample::field(std::string("mode") + value, sample::enumeration("n::Mode")));
    fields.back().defaultJson = std::string("\"") + value + "\"";
  }
  const Locks before = lockOf(model_);
  header("n/user.h").enums.swap(header("n/from.h").enums);
  const Locks after = lockOf(model_, before);
  const auto& members = nodeOf(user(after), "Whole").members;
  EXPECT_EQ(members[2].type, "Mode");
  EXPECT_EQ(members[2].annotations, nodeOf(user(before), "Whole").members[2].annotations);
  EXPECT_EQ(members[3].annotations, nodeOf(user(before), "Whole").members[3].annotations);
  EXPECT_EQ(errors(after), Slugs{});
}

TEST_F(MovesTest, ALockFollowsATypeBetweenTargets) {
  const Locks before = lockOf(model_);
  move("n/from.h", "n/to.h");
  Locks between = lockOf(model_, before);
  const Lock expected = user(between);
  between.files.at("n/user.capnp") = user(before);
  header("n/from.h").own = header("n/to.h").own = false;
  EXPECT_EQ(errors(between), Slugs{"lock-moved"});
  EXPECT_EQ(user(lockOf(model_, between)).text, expected.text);
}

}  // namespace
}  // namespace suture::compiler::lock
