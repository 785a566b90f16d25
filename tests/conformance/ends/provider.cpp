#include "conformance/ends/provider.h"

#include <gtest/gtest.h>
#include <suture/net/tls/keys.h>

namespace conformance {
namespace {

std::unique_ptr<ArmComponent> makeArm(ProviderKind kind, Gate& gate) {
  using namespace std::chrono_literals;
  switch (kind) {
    case ProviderKind::Periodic:
      return std::make_unique<ArmTask<suture::PeriodicTask>>(
          gate, suture::PeriodicOptions{.period = 1ms});
    case ProviderKind::EventDriven:
      return std::make_unique<ArmTask<suture::EventTask>>(gate, suture::EventOptions{});
    case ProviderKind::Device: return std::make_unique<ArmDevice>(gate);
  }
  return nullptr;
}

// These are rows enough for what a scenario asks of the past: on the stepped clock it takes some
// milliseconds, and in real time it takes as long as it takes.
constexpr unsigned kRowsSteppedThrough = 256, kRowsInRealTime = 4096;

Hosted makeHosted(ProviderKind kind, Gate& gate, unsigned rows) {
  auto arm = makeArm(kind, gate);
  for (suture::ProvidedBase* one : arm->component().provided()) one->keepState({.rows = rows});
  return {.arm = std::move(arm), .manager = nullptr};
}

}  // namespace

suture::Security securityOf(const std::string& process, const std::string& keys) {
  if (keys.empty()) return {};
  return {.keys = std::make_shared<const suture::tls::Keys>(keys, process), .policy = {}};
}

Provider::Provider(ProviderKind kind, Where where) {
  if (where == Where::OneProcess) {
    hosted_ = std::make_unique<Hosted>(makeHosted(kind, gate(), kRowsSteppedThrough));
    return;
  }
  if (where == Where::TwoNamespaces) cable_.emplace();
  fork_ = std::make_unique<Fork>([&] {
    if (cable_) suture::Cable::leave();
    return std::make_shared<Hosted>(makeHosted(kind, gate(), kRowsInRealTime));
  });
  if (!cable_) return;
  run([](Hosted&) {});  // it has left
  cable_->stretchTo(fork_->pid());
  run([](Hosted&) { suture::Cable::plugIn(); });
}

void Provider::start(const std::string& address, const std::string& keys) {
  run([address = Text(address), keys = Text(keys)](Hosted& hosted) {
    const std::string where = address.text;
    hosted.manager = where.empty() ? std::make_unique<suture::Manager>("alone")
                                   : std::make_unique<suture::Manager>(
                                         "provider", where, securityOf("provider", keys.text));
    if (addedLane().name != nullptr) hosted.manager->addLane(addedLane().make());
    hosted.manager->add("PSM", hosted.arm->component());
    if (!where.empty()) hosted.manager->start();
  });
}

void Provider::stop() {
  run([](Hosted& hosted) {
    if (hosted.manager != nullptr) hosted.manager->stop();
  });
}

}  // namespace conformance
