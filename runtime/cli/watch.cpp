#include <suture/base/errors.h>
#include <suture/base/nearest.h>
#include <sys/stat.h>
#include <unistd.h>
#include "cli/peer/wait.h"
#include "cli/text/answer_text.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace suture::cli {
namespace {

constexpr Duration kForever = std::chrono::hours(24 * 365);

/// Prints what it is shown, one line each, until it has shown enough.
class Lines {
 public:
  explicit Lines(const Options& options) : options_(options) {}

  codec::Labels labels() const {
    return options_.json ? codec::Labels::Names : codec::Labels::Units;
  }
  bool enough() const { return options_.count != 0 && shown_ >= options_.count; }

  /// `kind` is "event" or "command".
  void show(const char* kind, const Member& member, const Json& value) {
    if (enough()) return;
    ++shown_;
    const double elapsed = std::chrono::duration<double>(now() - started_).count();
    if (options_.json)
      return printLine({{"elapsed", elapsed}, {kind, member.name}, {"value", value}});
    std::array<char, 40> time{};
    std::snprintf(time.data(), time.size(), "%9.3f s  ", elapsed);
    print(time.data() + plain(member.name) + (value.is_null() ? "" : "  " + valueLine(value)) +
          unitOf(member, value) + "\n");
  }

 private:
  const Options& options_;
  const Time started_ = now();
  unsigned shown_ = 0;
};

bool isPipeOrSocket(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

/// Resolves when nobody reads standard output any more, which a write would tell only with the next
/// line.
kj::Promise<void> whenReaderGone(loop::EventPort& loop) {
  if (!isPipeOrSocket(STDOUT_FILENO)) return kj::NEVER_DONE;
  using Observer = loop::EventPort::FdObserver;
  auto observer = kj::heap<Observer>(loop, STDOUT_FILENO, Observer::OBSERVE_WRITE);
  auto gone = observer->whenWriteDisconnected();
  return gone.attach(kj::mv(observer));
}

/// Resolves when it is told to stop, nobody reads or the time is over. Rejects when the provider is
/// gone.
kj::Promise<void> ending(loop::EventPort& loop, Provider& provider, const Options& options) {
  const Duration period = options.period == Duration{0} ? kForever : options.period;
  return loop.onSignal(SIGINT)
      .ignoreResult()
      .exclusiveJoin(loop.onSignal(SIGTERM).ignoreResult())
      .exclusiveJoin(whenReaderGone(loop))
      .exclusiveJoin(loop.getTimer().afterDelay(loop::toKj(period)))
      .exclusiveJoin(provider.whenGone());
}

void watchReads(loop::EventPort& loop, Provider& provider, const Options& options) {
  const Member& command = readCommand(provider.contract(), options.member);
  const auto tick = loop::toKj(
      std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / options.rate)));
  auto ended = ending(loop, provider, options).then([] { return true; }).fork();
  const auto endsBefore = [&](kj::Promise<void> what) {
    return wait(loop, ended.addBranch().exclusiveJoin(what.then([] { return false; })));
  };
  Lines lines(options);
  Json value;
  for (auto next = loop.getTimer().now();;) {
    auto answered = provider.start(command, Json::object(), lines.labels());
    if (endsBefore(answered.then([&](Answer&& answer) { value = std::move(answer.value); })))
      return;
    lines.show("command", command, value);
    if (lines.enough()) return;
    next = kj::max(next + tick, loop.getTimer().now());
    if (endsBefore(loop.getTimer().atTime(next))) return;
  }
}

void watchEvents(loop::EventPort& loop, Provider& provider, const Options& options,
                 std::uint64_t events) {
  auto enough = kj::newPromiseAndFulfiller<void>();
  auto ended = ending(loop, provider, options)
                   .exclusiveJoin(provider.whenSilent())
                   .exclusiveJoin(kj::mv(enough.promise));
  Lines lines(options);
  std::exception_ptr lost;  // is no failure of the provider, so that must not hear of it
  auto subscribed =
      provider.subscribe(events, lines.labels(), [&](const Member& event, const Json& value) {
        if (lost) return;
        try {
          lines.show("event", event, value);
        } catch (...) {
          lost = std::current_exception();
        }
        if (lost || lines.enough()) enough.fulfiller->fulfill();
      });
  auto refused = subscribed.then([]() -> kj::Promise<void> { return kj::NEVER_DONE; });
  wait(loop, ended.exclusiveJoin(kj::mv(refused)));
  if (lost) std::rethrow_exception(lost);
}

/// Says what there is to watch, unless `name` is a command, which readCommand() judges.
void requireKnown(const Contract& contract, const std::string& name) {
  std::vector<std::string> names;
  for (const auto* const members : {&contract.events(), &contract.commands()}) {
    for (const Member& one : *members) {
      if (members == &contract.commands() && one.name == name) return;
      names.push_back(one.name);
    }
  }
  throw SetupError("watch '" + name + "' of " + contract.title(),
                   contract.name() + " has " + listNamed("events and commands", names),
                   remedyForName(name, names));
}

}  // namespace

int watch(loop::EventPort& loop, const Options& options) {
  Provider provider(loop, options, Target::parseInterface(options.target));
  // Until here a signal ends the program by itself.
  for (const int signal : {SIGINT, SIGTERM}) kj::UnixEventPort::captureSignal(signal);
  const Contract& contract = provider.contract();
  if (options.member.empty()) {
    watchEvents(loop, provider, options, ~std::uint64_t{0});
    return 0;
  }
  const Member* const event = options.onlyReads ? nullptr : contract.findEvent(options.member);
  if (event != nullptr) {
    watchEvents(loop, provider, options, contract.bitOf(*event));
  } else {
    if (!options.onlyReads) requireKnown(contract, options.member);
    watchReads(loop, provider, options);
  }
  return 0;
}

}  // namespace suture::cli
