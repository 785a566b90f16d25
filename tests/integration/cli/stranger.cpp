// A process that is not what others expect: cli_stranger <manager address> <process name> <how>
// [<folder of keys>]. Says "ready" when it is known; ends on SIGTERM. `how`:
//   version      speaks another version of the protocol
//   silent       does not answer a greeting
//   homeless     is known, and says not where it is
//   outside      listens without TLS, whatever its manager's network
//   deaf         says "asked" when it hears a read or a subscription, and never answers
//   older        cannot explain itself yet
//   escapes      has names that steer a terminal
//   description  explains itself with what is no JSON
//   depth        ... with JSON that is nested a million times
//   incomplete   ... with a schema that lacks the interface itself
//   broken       ... with a field that lies outside its struct, where 32 bits do not see it
//   groups       ... with a struct that is a group of itself
//   wordless     ... as a component's life, whose resume_connection answers a number
//   changed      ... with a contract whose field has another type

#include <capnp/message.h>
#include <suture/base/errors.h>
#include <suture/framing/link_server.h>
#include <suture/loop/control_thread.h>
#include <suture/names/manager_link.h>
#include <suture/names/records.h>
#include <suture/names/security.h>
#include <suture/net/tls/keys.h>
#include <suture/peer.capnp.h>
#include <suture/session/provider/explain.h>
#include <suture/standard/lifecycle.suture.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "robots/arm.capnp.h"
#include "robots/arm.suture.h"
#include "robots/geometry.capnp.h"
#include "support/hosted_process.h"

namespace {

using suture::wire::Explanation;

constexpr const char* kEscape = "\x1b[2J";

std::string repeated(const char* text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

template <class Struct>
capnp::schema::Node::Builder nodeOf(Explanation::Builder explanation) {
  for (auto node : explanation.getNodes()) {
    if (node.getId() == capnp::typeId<Struct>()) return node;
  }
  throw suture::SetupError("there is no such struct");
}

/// Gives the struct numbers where it has outcomes.
void answerNumbers(capnp::schema::Node::Struct::Builder node) {
  for (auto field : node.getFields()) {
    if (!field.isSlot() || !field.getSlot().getType().isEnum()) continue;
    field.getSlot().getType().setUint16();
    field.getSlot().getDefaultValue().setUint16(0);
  }
}

void spoil(Explanation::Builder explanation, const std::string& how) {
  const std::string description = explanation.getDescription().cStr();
  if (how == "description") explanation.setDescription("{\"name\": ");
  if (how == "depth") explanation.setDescription(repeated("[", 1'000'000).c_str());
  if (how == "incomplete") explanation.initNodes(0);
  if (how == "broken") {  // `stamp`, 64 bits, half a gigabyte behind its struct
    auto fields = nodeOf<robots::wire::PoseStamped>(explanation).getStruct().getFields();
    fields[1].getSlot().setOffset(1u << 26);
  }
  if (how == "groups") {
    auto everything = nodeOf<robots::wire::Everything>(explanation);
    everything.setScopeId(everything.getId());
    everything.getStruct().setIsGroup(true);
    everything.getStruct().getFields()[0].initGroup().setTypeId(everything.getId());
  }
  if (how == "wordless") {
    for (auto node : explanation.getNodes()) {
      if (node.isStruct()) answerNumbers(node.getStruct());
    }
  }
  if (how == "changed") {
    std::string other = replaced(description, "\"hash\": \"", "\"hash\": \"0");
    other = replaced(other, "\"kind\": \"Float64\"}, \"unit\"", "\"kind\": \"Float32\"}, \"unit\"");
    other = replaced(other, "\"Float64 unit", "\"Float32 unit");
    explanation.setDescription(other.c_str());
  }
}

class Arm final : public robots::wire::Arm::Server {
 public:
  explicit Arm(bool deaf) : deaf_(deaf) {}

 protected:
  kj::Promise<void> mode(ModeContext context) override {
    return deaf_ ? hear() : Server::mode(context);
  }
  kj::Promise<void> subscribe(SubscribeContext context) override {
    return deaf_ ? hear() : Server::subscribe(context);
  }
  kj::Promise<void> everything(EverythingContext context) override {
    context.getResults().initValue().setCount(7);
    return kj::READY_NOW;
  }

 private:
  static kj::Promise<void> hear() {
    std::puts("asked");
    std::fflush(stdout);
    return kj::NEVER_DONE;
  }

  const bool deaf_;
};

/// Answers each call with zeros.
class Zeros final : public capnp::Capability::Server {
 public:
  DispatchCallResult dispatchCall(
      std::uint64_t, std::uint16_t,
      capnp::CallContext<capnp::AnyPointer, capnp::AnyPointer>) override {
    return {kj::READY_NOW, /*isStreaming=*/false};
  }
};

class Stranger final : public suture::wire::Peer::Server {
 public:
  explicit Stranger(std::string how) : how_(std::move(how)) {}

 protected:
  kj::Promise<void> hello(HelloContext context) override {
    if (how_ == "silent") return kj::NEVER_DONE;
    if (how_ != "version") return kj::READY_NOW;
    auto refusal = context.getResults().initRefused();
    refusal.setKind(suture::wire::Refusal::Kind::VERSION_MISMATCH);
    refusal.setText("talk to it: it speaks version 99. Build both from the same release.");
    return kj::READY_NOW;
  }

  kj::Promise<void> describe(DescribeContext context) override {
    auto component = context.getResults().initComponents(1)[0];
    component.setName("Odd");
    auto provided = component.initProvided(1)[0];
    provided.setName("Arm");
    provided.setContract(how_ == "escapes" ? kEscape : "robots::Arm");
    return kj::READY_NOW;
  }

  kj::Promise<void> explain(ExplainContext context) override {
    if (how_ == "older") return Server::explain(context);
    auto explanation = context.getResults().initExplained();
    suture::explain(how_ == "wordless" ? suture::interfaceInfo<suture::Lifecycle>()
                                       : suture::interfaceInfo<robots::Arm>(),
                    explanation);
    spoil(explanation, how_);
    return kj::READY_NOW;
  }

  kj::Promise<void> open(OpenContext context) override {
    if (how_ == "wordless") {
      context.getResults().setContract(kj::heap<Zeros>());
    } else {
      context.getResults().setContract(kj::heap<Arm>(how_ == "deaf"));
    }
    return kj::READY_NOW;
  }

 private:
  const std::string how_;
};

/// Holds what lives on the control thread.
struct Presence {
  suture::net::Refusals refusals{"stranger"};
  std::unique_ptr<suture::framing::LinkServer> server;
  std::unique_ptr<suture::ManagerLink> link;
};

kj::Promise<void> appear(suture::loop::ControlThread& control, Presence& presence, char** argv) {
  const std::string manager = argv[1], name = argv[2], how = argv[3];
  const auto address =
      suture::net::Address::parse(how == "outside" ? "tcp://127.0.0.1:0" : manager + "." + name);
  suture::Security security;
  if (argv[4] != nullptr) {
    security.keys = std::make_shared<const suture::tls::Keys>(argv[4], name);
  }
  presence.server = std::make_unique<suture::framing::LinkServer>(
      control.port(), address,
      [how](const auto& caller) -> capnp::Capability::Client {
        caller->known = true;  // else it would be given only short answers
        return suture::wire::Peer::Client(kj::heap<Stranger>(how));
      },
      presence.refusals);
  presence.link = std::make_unique<suture::ManagerLink>(
      control, suture::net::parseAddresses(manager), name, security.trust());
  return presence.link->open(std::chrono::seconds(5)).then([&presence, name, how] {
    std::vector<std::string> addresses;
    if (how != "homeless") addresses.push_back(presence.server->address().text());
    return presence.link->enrol({.name = name,
                                 .addresses = std::move(addresses),
                                 .pid = getpid(),
                                 .host = how == "escapes" ? kEscape : "here",
                                 .components = {},
                                 .generation = 0});
  });
}

}  // namespace

int main(int, char** argv) {
  return suture::statusOf([argv] {
    const suture::HostedProcess process;
    Presence presence;
    suture::loop::ControlThread control;
    control.run(std::chrono::seconds(10), [&] { return appear(control, presence, argv); });
    process.awaitEnd();
    control.run(std::chrono::seconds(10), [&] {
      presence.link.reset();
      presence.server.reset();
    });
  });
}
