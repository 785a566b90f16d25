#include <gtest/gtest.h>
#include <suture/deploy/document/policy_file.h>

#include "support/contains.h"

namespace {

using suture::Access;
using suture::contains;
using suture::DocumentError;
using suture::JsonDocument;
using suture::Policy;
using suture::readPolicy;
using Proof = suture::net::PeerIdentity::Proof;

constexpr const char* kPolicy = R"({
  "roles": [
    {"name": "surgeon", "full": ["PSM/*"], "read": ["*/*"]},
    {"name": "viewer", "read": ["PSM/Arm"]}
  ],
  "rules": [
    {"who": "process:console", "role": "surgeon"},
    {"who": "user:same", "role": "viewer"}
  ]
})";

std::string problemsOf(const std::string& piece, const std::string& replacement) {
  std::string text = kPolicy;
  text.replace(text.find(piece), piece.size(), replacement);
  try {
    readPolicy(JsonDocument::parse(text, "p.json"));
  } catch (const DocumentError& error) {
    return error.what();
  }
  return "";
}

TEST(PolicyFile, GivesRolesToThoseOfItsRules) {
  const Policy policy = readPolicy(JsonDocument::parse(kPolicy, "p.json"));
  const suture::net::PeerIdentity console{Proof::Certificate, 0, "console"},
      root{Proof::User, 0, ""};
  EXPECT_EQ(policy.access(console, {"robot", "PSM", "Arm"}), Access::Full);
  EXPECT_EQ(policy.access(console, {"robot", "ECM", "Arm"}), Access::Read);
  EXPECT_EQ(policy.access(root, {"robot", "PSM", "Arm"}), Access::Read);
  EXPECT_EQ(policy.access(root, {"robot", "ECM", "Arm"}), Access::None);
  EXPECT_FALSE(policy.admits({Proof::Certificate, 0, "stranger"}));
}

TEST(PolicyFile, EachMistakeIsToldWithItsLine) {
  const std::string cases[][3] = {
      {"\"role\": \"viewer\"", "\"role\": \"viwer\"",
       "p.json:8: error: no role 'viwer' here; there are 'surgeon' and 'viewer'; did you mean "
       "'viewer'?"},
      {"\"name\": \"viewer\"", "\"name\": \"surgeon\"", "p.json:4: error: there is another role"},
      {"user:same", "uid:7",
       "p.json:8: error: 'who': expected \"process:console\" (by its certificate"},
      {"\"PSM/*\"", "\"PSM\"", "p.json:3: error: expected an interface, \"component/interface\""},
      {"\"rules\"", "\"rule\"", "unknown key 'rule'; did you mean 'rules'?"},
      {"\"full\"", "\"ful\"", "p.json:3: error: unknown key 'ful'; did you mean 'full'?"}};
  for (const auto& [piece, replacement, expected] : cases) {
    const std::string found = problemsOf(piece, replacement);
    EXPECT_TRUE(contains(found, expected)) << replacement << ":\n" << found;
  }
}

TEST(PolicyFile, AMissingFileIsNamed) {
  try {
    readPolicy(std::filesystem::path("/nonexistent/policy.json"));
    FAIL() << "read";
  } catch (const DocumentError& error) {
    EXPECT_TRUE(contains(error.what(), "/nonexistent/policy.json")) << error.what();
  }
}

}  // namespace
