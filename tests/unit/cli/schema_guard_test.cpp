#include "cli/contract/schema_guard.h"
#include <gtest/gtest.h>

#include "robots/arm.capnp.h"
#include "robots/geometry.capnp.h"
#include "unit/cli/explanation.h"

namespace suture::cli {
namespace {

using robots::wire::Everything;
using robots::wire::PoseStamped;

std::string faultOf(Explained& explained) {
  return faultIn(explained.get().asReader().getNodes()).value_or("");
}

TEST(SchemaGuard, LetsARealSchemaPass) {
  Explained explained;
  EXPECT_EQ(faultOf(explained), "");
}

TEST(SchemaGuard, RefusesANumberBehindItsStruct) {
  // These are the first offset that is outside, and one that is inside again in 32 bits.
  for (const unsigned offset : {2u, 1u << 26}) {
    Explained explained;
    explained.node<PoseStamped>().getStruct().getFields()[1].getSlot().setOffset(offset);
    EXPECT_EQ(faultOf(explained), "'stamp' lies outside of PoseStamped");
  }
}

TEST(SchemaGuard, RefusesAPointerBehindItsStruct) {
  Explained explained;
  explained.node<PoseStamped>().getStruct().getFields()[0].getSlot().setOffset(1);
  EXPECT_EQ(faultOf(explained), "'pose' lies outside of PoseStamped");
}

TEST(SchemaGuard, RefusesAUnionBehindItsStruct) {
  Explained explained;
  auto layout = explained.node<PoseStamped>().getStruct();
  layout.setDiscriminantCount(2);
  layout.setDiscriminantOffset(1u << 28);
  EXPECT_EQ(faultOf(explained), "the union of PoseStamped lies outside of it");
}

TEST(SchemaGuard, RefusesAGroupOfAnotherSize) {
  Explained explained;
  auto group = explained.node<PoseStamped>();
  group.getStruct().setIsGroup(true);
  group.setScopeId(capnp::typeId<Everything>());
  explained.node<Everything>().getStruct().getFields()[0].initGroup().setTypeId(group.getId());
  EXPECT_EQ(faultOf(explained), "'on' lies outside of Everything");
  auto whole = explained.node<Everything>().getStruct();
  group.getStruct().setDataWordCount(whole.getDataWordCount());
  group.getStruct().setPointerCount(whole.getPointerCount());
  EXPECT_EQ(faultOf(explained), "");
}

TEST(SchemaGuard, RefusesAGroupThatIsAnothers) {
  Explained explained;
  auto everything = explained.node<Everything>();
  everything.getStruct().setIsGroup(true);
  everything.getStruct().getFields()[0].initGroup().setTypeId(everything.getId());
  EXPECT_EQ(faultOf(explained), "'on' lies outside of Everything");
}

}  // namespace
}  // namespace suture::cli
