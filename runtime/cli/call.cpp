#include "cli/command_line/arguments.h"
#include "cli/contract/from_json.h"
#include "cli/peer/wait.h"
#include "cli/text/answer_text.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace suture::cli {
namespace {

/// Hears what a component says by the standard events `warning` and `error` of the interface, from
/// now on. By these a robot refuses commands that it has executed.
class Complaints {
 public:
  Complaints(loop::EventPort& loop, Provider& provider) : loop_(loop), provider_(provider) {
    for (const char* const name : {"warning", "error"}) {
      const Member* const event = provider.contract().findEvent(name);
      if (event != nullptr) events_ |= provider.contract().bitOf(*event);
    }
    listen();
  }

  /// Returns all of the cycle in which the component answered last, as {"event", "text"}.
  const Json& heard() {
    if (events_ == 0) return heard_;
    provider_.awaitCycleEnd();
    listen();                   // has the process send what waits there,
    provider_.awaitCycleEnd();  // which arrives before the answer to this
    return heard_;
  }

 private:
  void listen() {
    if (events_ == 0) return;
    wait(loop_, provider_.subscribe(
                    events_, codec::Labels::Names,
                    [this](const Member& event, const Json& value) { hear(event.name, value); }));
  }

  // Both events are latched, so that what was said before comes again.
  void hear(const std::string& event, const Json& message) {
    const Json &text = valueAt(message, "text"), &stamp = valueAt(message, "stamp");
    if (!text.is_string() || !stamp.is_number_integer()) return;
    const Time said = provider_.here(stamp.get<std::int64_t>());
    if (said + provider_.clockError() < began_) return;
    heard_.push_back({{"event", event}, {"text", text}});
  }

  loop::EventPort& loop_;
  Provider& provider_;
  const Time began_ = now();
  std::uint64_t events_ = 0;
  Json heard_ = Json::array();
};

void tell(const std::string& title, const Json& complaints) {
  for (const Json& one : complaints) {
    const std::string text =
        title + ": it was executed, and the component said meanwhile: " + textAt(one, "event") +
        ": " + textAt(one, "text");
    std::fprintf(stderr, "suture: %s\n", plain(text).c_str());
  }
}

/// A warning is no failure of the call, because it may be about what another client streams.
bool hasError(const Json& complaints) {
  return std::any_of(complaints.begin(), complaints.end(),
                     [](const Json& one) { return textAt(one, "event") == "error"; });
}

}  // namespace

int call(loop::EventPort& loop, const Options& options) {
  Json arguments = argumentsOf(options);
  Provider provider(loop, options, Target::parseInterface(options.target));
  const Member& command = provider.contract().command(options.member);
  takeTexts(arguments, options, [&](const std::string& name, const Json& value) {
    return leadsToText(command.method.getParamType(), name, value);
  });
  Complaints complaints(loop, provider);
  const Answer answer =
      provider.call(command, arguments, options.json ? codec::Labels::Names : codec::Labels::Units);
  const Json& heard = complaints.heard();
  if (options.json) {
    Json told = answerJson(command, answer);
    if (!heard.empty()) told["complaints"] = heard;
    printJson(told);
  } else {
    print(answerText(command, answer));
    tell("call " + command.name + " of " + provider.contract().title(), heard);
  }
  return hasError(heard) ? 1 : 0;
}

}  // namespace suture::cli
