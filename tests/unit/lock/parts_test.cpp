// The schema of a big header is compiled in parts, which together declare what the lock does.

#include "compiler/lock/parts.h"

#include <gtest/gtest.h>

#include "compiler/lock/schema/parse.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/writer.h"
#include "tests/unit/emit/sample_model.h"

namespace suture::compiler::lock {
namespace {

Node structOf(const std::string& name, const std::vector<std::string>& types) {
  Node node;
  node.name = name;
  node.id = freshId("test", name);
  for (const std::string& type : types) {
    Member member;
    member.ordinal = static_cast<unsigned>(node.members.size());
    member.name = "field" + std::to_string(member.ordinal);
    member.type = type;
    node.members.push_back(member);
  }
  return node;
}

Lock lockOf(std::vector<Node> nodes) {
  Lock lock;
  lock.path = "robots/arm.capnp";
  lock.id = freshId("test", lock.path);
  lock.nodes = std::move(nodes);
  return lock;
}

const std::vector<std::string> kPaths = {"robots/arm.wire.capnp", "robots/arm.wire.2.capnp"};

TEST(Parts, ANodeImportsWhatItNames) {
  const Lock lock = lockOf(
      {structOf("Pose", {"Float64"}), structOf("Path", {"List(Pose)", "/other.capnp:Time"})});
  const Parts parts(lock, kPaths, {{"Pose", 0}, {"Path", 1}});
  EXPECT_EQ(parts.fileOf("Pose"), kPaths[0]);
  EXPECT_EQ(parts.fileOf("Path"), kPaths[1]);
  EXPECT_EQ(parts.fileOf("Nothing"), "");
  const auto files = parts.files();
  EXPECT_EQ(files[0].text.find("Path"), std::string::npos);
  EXPECT_NE(files[1].text.find("import \"/robots/arm.wire.capnp\""), std::string::npos)
      << files[1].text;
  EXPECT_NE(files[1].text.find("import \"/other.capnp\""), std::string::npos) << files[1].text;
  EXPECT_NE(files[1].text.find("struct Path " + idText(lock.nodes[1].id)), std::string::npos);
}

TEST(Parts, PartsIncludeNoCircle) {
  const Lock lock = lockOf({structOf("Tree", {"List(Branch)"}), structOf("Branch", {"List(Tree)"}),
                            structOf("Garden", {"Tree"})});
  const Parts parts(lock, kPaths, {{"Tree", 0}, {"Branch", 1}, {"Garden", 0}});
  for (const char* const name : {"Tree", "Branch", "Garden"}) {
    EXPECT_EQ(parts.fileOf(name), kPaths[1]) << name;
  }
}

TEST(Parts, EachNodeStandsInOnePart) {
  const model::Model model = sample::allOwn(sample::robots());
  model::Diagnostics none;
  const Locks locks = read(update(model, {}).files, none);
  for (const auto& [path, lock] : locks.files) {
    std::size_t nodes = 0;
    Parts::Wishes wishes;
    for (const Node& node : lock.nodes) wishes.emplace(identity(node), nodes++ % 2);
    const Locks parts = read(Parts(lock, kPaths, wishes).files(), none);
    std::size_t found = 0;
    for (const auto& [part, one] : parts.files) found += one.nodes.size();
    EXPECT_EQ(found, nodes) << path;
  }
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace suture::compiler::lock
