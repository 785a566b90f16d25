// These make keys of deployments, and run processes that use them.

#include <gtest/gtest.h>
#include <suture/component/device.h>
#include <suture/deploy/host.h>
#include <suture/deploy/keys_command.h>
#include <suture/loop/control_thread.h>
#include <suture/names/global_manager.h>
#include <suture/net/tls/key_maker.h>
#include <suture/net/tls/keys.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>

#include "support/contains.h"
#include "support/refusal.h"
#include "support/temporary_directory.h"

namespace {

using suture::contains;
using suture::Deployment;
using suture::JsonDocument;
using suture::KeysRequest;
using suture::refusal;

struct Rack final : suture::Device {};

class DeploymentKeys : public testing::Test {
 protected:
  std::string deploymentAt(const std::string& manager) const {
    return R"({"manager": ")" + manager + R"(", "keys": "keys", "processes": [
      {"name": "left", "components": [{"name": "Shelf", "class": "Shelf"}]},
      {"name": "right", "components": []}]})";
  }
  std::string write(const std::string& text) const {
    const std::string file = directory_.file("system.json");
    std::ofstream(file) << text;
    return file;
  }
  std::string keys() const { return directory_.file("keys"); }

  const suture::TemporaryDirectory directory_;
};

TEST_F(DeploymentKeys, EachProcessAndManagerGetSome) {
  const auto made = suture::makeKeys({.deployment = write(deploymentAt("tls://127.0.0.1:1")),
                                      .processes = {"gui"},
                                      .out = keys()});
  EXPECT_EQ(made.size(), 10u);
  for (const char* name : {"left", "right", "gui", "suture-manager", "ca"}) {
    EXPECT_TRUE(std::filesystem::exists(keys() + "/" + name + ".key")) << name;
  }
  EXPECT_EQ(suture::makeKeys({.deployment = "", .processes = {"late"}, .out = keys()}).size(), 2u);
}

TEST_F(DeploymentKeys, AnImpossibleFolderIsAnError) {
  const std::string out(300, 'x');
  const std::string error =
      refusal([&] { suture::makeKeys({.deployment = "", .processes = {"left"}, .out = out}); });
  EXPECT_EQ(error,
            "keep keys in " + out + ": File name too long. Give a folder in one that exists.");
}

TEST_F(DeploymentKeys, TheCommandLineSaysWhatIsWanted) {
  CLI::App program;
  KeysRequest request;
  suture::addKeysOptions(program, request);
  program.parse("--process left --process right --out k");
  EXPECT_EQ(request.processes, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(request.out, "k");
  EXPECT_THROW(program.parse("--process left"), CLI::RequiredError);
}

TEST_F(DeploymentKeys, ACommandLineNeedsProcesses) {
  CLI::App program;
  KeysRequest request;
  suture::addKeysOptions(program, request);
  EXPECT_EQ(refusal([&] { program.parse("--out k"); }),
            "--deployment FILE or --process NAME is required");
}

TEST_F(DeploymentKeys, AHostUsesThoseOfItsProcess) {
  suture::makeKeys({.deployment = "", .processes = {"left"}, .out = keys()});
  suture::loop::ControlThread control;
  const suture::GlobalManager global(
      control, "tls://127.0.0.1:0",
      {.keys = std::make_shared<const suture::tls::Keys>(keys(), suture::tls::kManagerName)});
  const suture::ComponentClass classes[] = {
      {"Shelf", [](const suture::JsonReader&) -> std::unique_ptr<suture::Component> {
         return std::make_unique<Rack>();
       }}};
  const Deployment deployment(JsonDocument::read(write(deploymentAt(global.address()))));
  const suture::Host host(deployment, "left", classes);
  EXPECT_EQ(host.manager().missingGlobalManager(), "");
  const std::string error = refusal([&] { suture::Host(deployment, "right", {}); });
  EXPECT_TRUE(contains(error, "system.json:1: error: ") && contains(error, "right.crt")) << error;
}

TEST_F(DeploymentKeys, AHostWarnsBeforeTheyEnd) {
  suture::tls::makeKeys(keys(), {"left"}, {.lasts = std::chrono::days(29)});
  const suture::ComponentClass classes[] = {
      {"Shelf", [](const suture::JsonReader&) -> std::unique_ptr<suture::Component> {
         return std::make_unique<Rack>();
       }}};
  const Deployment deployment(JsonDocument::read(write(R"({"keys": "keys", "processes": [
      {"name": "left", "components": [{"name": "Shelf", "class": "Shelf"}]}]})")));
  suture::Host host(deployment, "left", classes);
  const auto news = host.news();
  ASSERT_EQ(news.size(), 1u);
  EXPECT_TRUE(contains(news[0], "system.json:1: warning: the certificate ") &&
              contains(news[0], "left.crt ends at 2"))
      << news[0];
  EXPECT_TRUE(host.news().empty());
}

TEST_F(DeploymentKeys, TlsWithoutThemIsAnError) {
  const std::string error = refusal([&] {
    Deployment(JsonDocument::parse(
        R"({"manager": "tls://10.0.0.1:7700", "processes": [{"name": "a", "components": []}]})",
        "d.json"));
  });
  EXPECT_TRUE(contains(error, "d.json:1: error: 'tls://10.0.0.1:7700' needs keys")) << error;
}

TEST_F(DeploymentKeys, AWrongPolicyStopsTheHost) {
  std::ofstream(directory_.file("policy.json")) << R"({"roles": [], "rules": []})";
  const Deployment deployment(JsonDocument::read(
      write(R"({"policy": "policy.json", "processes": [{"name": "a", "components": []}]})")));
  const std::string error = refusal([&] { suture::Host(deployment, "a", {}); });
  EXPECT_TRUE(contains(error, "policy.json:1: error: 'roles': expected the list of roles"))
      << error;
}

}  // namespace
