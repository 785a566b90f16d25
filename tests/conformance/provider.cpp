#include "conformance/provider.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace conformance {
namespace {

/// In memory that forks share.
std::shared_ptr<Gate> makeGate() {
  void* const memory =
      mmap(nullptr, sizeof(Gate), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) std::abort();
  return {new (memory) Gate, [](Gate* gate) { munmap(gate, sizeof *gate); }};
}

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

Hosted makeHosted(ProviderKind kind, Gate& gate) {
  auto arm = makeArm(kind, gate);
  // Seconds of the past, however long a scenario takes.
  for (suture::ProvidedBase* one : arm->component().provided()) one->keepState({.rows = 4096});
  return {.arm = std::move(arm), .manager = nullptr};
}

/// An address or a name, in what may cross to another process.
struct Text {
  explicit Text(const std::string& from) {
    EXPECT_LT(from.size(), sizeof text);
    from.copy(text, sizeof text - 1);
  }
  char text[200]{};
};

}  // namespace

Provider::Provider(ProviderKind kind, Where where) : gate_(makeGate()) {
  if (where == Where::OneProcess) {
    hosted_ = std::make_unique<Hosted>(makeHosted(kind, gate()));
    return;
  }
  if (where == Where::TwoNamespaces) cable_.emplace();
  fork_ = std::make_unique<Fork>([&] {
    if (cable_) suture::Cable::leave();
    return std::make_shared<Hosted>(makeHosted(kind, gate()));
  });
  if (!cable_) return;
  run([](Hosted&) {});  // it has left
  cable_->stretchTo(fork_->pid());
  run([](Hosted&) { suture::Cable::plugIn(); });
}

void Provider::start(const std::string& address) {
  run([address = Text(address)](Hosted& hosted) {
    const bool shared = *address.text == '\0';
    hosted.manager = shared ? std::make_unique<suture::Manager>("alone")
                            : std::make_unique<suture::Manager>("provider", address.text);
    hosted.manager->add("PSM", hosted.arm->component());
    if (!shared) hosted.manager->start();
  });
}

void Provider::stop() {
  run([](Hosted& hosted) {
    if (hosted.manager != nullptr) hosted.manager->stop();
  });
}

}  // namespace conformance
