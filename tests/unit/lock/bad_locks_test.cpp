// These locks cannot be read: the tests say what is reported, and at which line.

#include <gtest/gtest.h>

#include <string>

#include "compiler/lock/schema/lock.h"

namespace suture::compiler::lock {
namespace {

using model::Diagnostics;

struct BadLock {
  const char* text;
  unsigned line;
  const char* message;
  const char* slug = "lock-syntax";
};

class BadLocks : public testing::TestWithParam<BadLock> {};

TEST_P(BadLocks, AreReportedAtTheirLine) {
  Diagnostics found;
  const Locks locks = read({{"a.capnp", GetParam().text}}, found);
  EXPECT_TRUE(locks.files.empty());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].slug, GetParam().slug);
  EXPECT_EQ(found[0].source.file, "schemas/a.capnp");
  EXPECT_EQ(found[0].source.line, GetParam().line);
  EXPECT_NE(found[0].message.find(GetParam().message), std::string::npos) << found[0].message;
}

std::string nestedTooDeeply() {
  std::string type;
  for (int i = 0; i < 100'000; ++i) type += "List(";
  return "@0x8000000000000001;\nstruct A @0x8000000000000002 {\n  x @0 :" + type;
}

TEST(DeepLock, IsRefusedBeforeTheStackEnds) {
  Diagnostics found;
  read({{"a.capnp", nestedTooDeeply()}}, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].message.find("nested too deeply"), std::string::npos);
}

TEST(DeepLock, ADeepValueIsRefused) {
  Diagnostics found;
  const std::string deep(400'000, '[');
  read({{"a.capnp",
         "@0x8000000000000001;\nstruct A @0x8000000000000002 {\n  x @0 :Text "
         "$Meta.capacity(" +
             deep}},
       found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].source.line, 3u);
  EXPECT_NE(found[0].message.find("a value is nested too deeply"), std::string::npos)
      << found[0].message;
}

#define HEAD "@0x8000000000000001;\n"
INSTANTIATE_TEST_SUITE_P(
    Lock, BadLocks,
    testing::Values(
        BadLock{"", 1, "expected '@', found the end of the file"}, BadLock{"@0x1;", 1, "top bit"},
        BadLock{HEAD "struct A @0x8000000000000002 {\n  x @0 :Int8", 3, "expected ';'"},
        BadLock{HEAD "struct A @0x8000000000000002 {\n  x @0 :Int8Meta.unit(\"m\");\n}", 3,
                "is of a file that is not imported"},
        BadLock{HEAD "struct A @0x8000000000000002 {\n  x @0 :List(\"m\");\n}", 3,
                "expected a type, found '\"m\"'"},
        BadLock{HEAD "<<<<<<< HEAD\n", 2, "merge conflict", "lock-conflict"},
        BadLock{HEAD "struct A @0x8000000000000002 {\n=======\n}", 3, "merge conflict",
                "lock-conflict"},
        BadLock{HEAD "enum A @0x8000000000000002 $Meta.future {}", 2, "Meta.future", "lock-newer"},
        BadLock{HEAD "class A @0x8000000000000002 {}", 2, "expected struct, enum or interface"},
        BadLock{HEAD "struct A @0x8000000000000002 {\n  x @0 :Int8;\n  y @2 :Int8;\n}", 4,
                "expected 1"},
        BadLock{HEAD "struct A @0x8000000000000002 {\n  x @0 :Int8;\n  x @1 :Int8;\n}", 4, "twice"},
        BadLock{HEAD "struct A @0x8000000000000002 {\n\n  x @0 :Other.Pose;\n}", 4, "not imported"},
        BadLock{HEAD "struct A @0x8000000000000002 {}\nstruct A @0x8000000000000003 {}", 3,
                "twice"},
        BadLock{HEAD "struct A @0x8000000000000002 {\n  x @4294967296 :Int8;\n}", 3, "no ordinal"},
        BadLock{HEAD "\nstruct A @zero {}", 3, "expected a number"},
        BadLock{HEAD "using B = import \"/b(c).capnp\";", 2, "no path of a schema"},
        BadLock{HEAD "using B = import \"b.capnp\";", 2, "no path of a schema"},
        BadLock{HEAD "$Meta.formerly(\"A @0x1 /b.capnp:A\");", 2, "expected \"Name @0xid"},
        BadLock{HEAD "$Meta.formerly(\"A @0x8000000000000002x /b.capnp:A\");", 2, "/path:Name"},
        BadLock{HEAD "$Meta.formerly(\"A @0x8000000000000002 A\");", 2, "/path:Name"},
        BadLock{HEAD "$Meta.formerly(\"A B @0x8000000000000002 /b.capnp:A\");", 2, "/path:Name"},
        BadLock{HEAD "struct A @0x8000000000000002 $Meta.unit((\"m\") {}", 2, "expected a value"},
        BadLock{HEAD "struct A @0x8000000000000002 $Meta.unit(", 2, "ends too early"},
        BadLock{HEAD "struct A @0x8000000000000002 $Meta.cxx(\"a {\n}", 2, "string has no end"}));

}  // namespace
}  // namespace suture::compiler::lock
