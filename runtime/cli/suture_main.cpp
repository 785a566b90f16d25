// suture looks at a running system, and speaks to any interface in it, without generated code for
// what it looks at.

#include <fcntl.h>
#include <suture/base/nearest.h>
#include <suture/component/factory/component_library.h>
#include <suture/deploy/number_option.h>
#include <suture/loop/standard_streams.h>
#include <suture/names/global_manager.h>
#include <suture/net/tls/keys.h>
#include <unistd.h>
#include "cli/text/error_pages.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace suture::cli;

constexpr int kFailed = 1, kMisused = 2;

/// This is a verb on the command line.
struct Verb {
  const char* name;
  const char* help;
  int (*run)(suture::loop::EventPort&, const Options&);
};

constexpr Verb kVerbs[] = {
    {"ps", "The processes, their components and interfaces", ps},
    {"describe", "What a process, a component or an interface is", describe},
    {"read", "The value of a read command", read},
    {"call", "Runs a command", call},
    {"resume", "Lets the commands of a connection through again that await their operator", resume},
    {"watch", "Events, or a read command again and again", watch},
    {"doctor", "What works on the way to a process, and what to do where it does not", doctor},
    {"why", "Why two interfaces connect, or do not; or what an error means", why},
    {"keys", "Makes a CA, and a certificate and a key for each process and the global manager",
     makeKeys},
};

/// Holds seconds as they were typed.
struct Times {
  double patience = 5, period = 0;
};

CLI::AsNumberWithUnit seconds() {
  return CLI::AsNumberWithUnit(std::map<std::string, double>{{"ms", 1e-3}, {"s", 1}, {"min", 60}},
                               CLI::AsNumberWithUnit::CASE_INSENSITIVE, "TIME");
}

/// Adds the options that say what the subject of a verb is.
void addTargets(CLI::App& app, const std::string& verb, Options& options) {
  const std::string form = "process:component/interface";
  if (verb == "doctor") {
    app.add_option("targets", options.targets, "process[:component[/interface]] ...; without, all");
  } else if (verb == "describe") {
    app.add_option("target", options.target, "process[:component[/interface]]")->required();
  } else if (verb == "why") {
    app.add_option("one", options.target,
                   "a required interface, as " + form + "; or an error, by its name or text")
        ->required();
    app.add_option("other", options.other, "a provided one, in either order");
  } else if (verb == "read" || verb == "call") {
    app.add_option("interface", options.target, form)->required();
    app.add_option("command", options.member, "its name")->required();
  } else if (verb == "resume") {
    app.add_option("interface", options.target, "a required interface, as " + form)->required();
  } else if (verb == "watch") {
    app.add_option("interface", options.target, form)->required();
    app.add_option("name", options.member, "of an event or a read command; without, all events");
  }
}

void addOptions(CLI::App& app, const std::string& verb, Options& options, Times& times) {
  app.add_flag("--json", options.json, "For programs: JSON on standard output, errors too");
  if (verb == "keys") return suture::addKeysOptions(app, options.newKeys);
  addTargets(app, verb, options);
  app.add_option(
         "--manager", options.manager,
         "Address of the global manager; of several, separated by commas, the first that answers")
      ->capture_default_str();
  app.add_option("--keys", options.keys,
                 "Folder with keys of 'suture', for tls:// (suture keys --process suture)");
  app.add_option("--timeout", times.patience, "For each step, as 5s or 300ms")
      ->transform(seconds())
      ->check(suture::whyNotTime)
      ->capture_default_str();
  if (verb == "call") {
    app.add_option("settings", options.settings, "Arguments: name=value, goal.pose.x=0.1");
    app.add_option("--args", options.arguments, "Arguments as one JSON object");
  }
  if (verb == "watch") {
    app.add_option("--rate", options.rate, "Of a read command, Hz, from 0.001 to 1000")
        ->check([](const std::string& text) { return suture::whyNotNumber(text, 0.001, 1000); })
        ->capture_default_str();
    app.add_option("--count", options.count, "Ends after as many; 0: never")->capture_default_str();
    app.add_option("--for", times.period, "Ends after this time, as 2s")
        ->transform(seconds())
        ->check(suture::whyNotTime);
    app.add_flag("--read", options.onlyReads,
                 "The name is a read command's, also if there is such an event")
        ->needs(app.get_option("name"));
  }
}

void tell(const std::string& error) {
  std::fprintf(stderr, "suture: %s\n", suture::plain(error).c_str());
  const std::string why = whatToAsk(error);
  if (!why.empty()) std::fprintf(stderr, "suture: `%s` tells more\n", why.c_str());
}

int report(const std::string& error, bool json, int status) {
  if (!json) {
    tell(error);
    return status;
  }
  try {
    printLine({{"error", error}});
  } catch (const ReaderGone&) {
    // The status tells the rest.
  } catch (const suture::SetupError& lost) {
    tell(lost.what());
    return kFailed;
  }
  return status;
}

bool isVerb(const std::string& word) {
  return std::any_of(std::begin(kVerbs), std::end(kVerbs),
                     [&](const Verb& verb) { return word == verb.name; });
}

std::string unknownVerb(const std::string& word) {
  std::vector<std::string> names;
  for (const Verb& verb : kVerbs) names.emplace_back(verb.name);
  const std::string nearest = suture::nearestName(word, names);
  return "find verb '" + word + "': there are " + suture::listNames(names) + ". " +
         (nearest.empty() ? "Use one of those" : "Did you mean '" + nearest + "'?");
}

/// Returns the exit status of what `work` does, which returns one too.
template <class Work>
int attempt(bool json, const Work& work) {
  try {
    return work();
  } catch (const ReaderGone&) {
    return 0;
  } catch (const UsageError& error) {
    return report(error.what(), json, kMisused);
  } catch (const kj::Exception& error) {
    // A hostile peer can describe itself so that any step breaks.
    return report(std::string("use what the process sent: ") + error.getDescription().cStr() +
                      ". It was built with another Suture, or is not what it seems",
                  json, kFailed);
  } catch (const std::exception& error) {
    return report(error.what(), json, kFailed);
  }
}

int run(const Verb& verb, Options& options) {
  if (!options.keys.empty()) {
    const auto keys = std::make_shared<const suture::tls::Keys>(options.keys, kOwnName);
    if (!keys->warning().empty()) tell("warning: " + keys->warning());
    options.trust.keys = keys;
  }
  suture::loop::EventPort loop;
  return verb.run(loop, options);
}

/// Says so if standard output is closed. The first socket would have its number, and what is
/// printed would go to whom that leads to.
bool outputIsClosed() {
  if (fcntl(STDOUT_FILENO, F_GETFD) >= 0) return false;
  tell(suture::loop::outputLost().what());
  return true;
}

int help(const CLI::App& app, const CLI::ParseError& asked) {
  std::ostringstream text;
  const int status = app.exit(asked, text, text);
  print(text.str());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  if (outputIsClosed()) return kFailed;
  suture::loop::openStandardDescriptors();
  const std::string word = argc > 1 ? argv[1] : "";
  const bool json = std::any_of(argv, argv + argc,
                                [](const char* one) { return std::string_view(one) == "--json"; });
  if (!word.empty() && word[0] != '-' && !isVerb(word)) {
    return report(unknownVerb(word), json, kMisused);
  }
  CLI::App app{"Looks at a running Suture system, and speaks to any interface in it."};
  app.name("suture");
  app.set_version_flag("--version", std::string("suture ") + suture::kVersion,
                       "Prints the version, and ends");
  app.require_subcommand(1);
  Options options;
  options.manager = suture::GlobalManager::defaultAddress();
  Times times;
  for (const Verb& verb : kVerbs) {
    addOptions(*app.add_subcommand(verb.name, verb.help), verb.name, options, times);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return attempt(json, [&] { return help(app, error); });
    return report(error.what() + std::string(". `suture ") + (isVerb(word) ? word + " " : "") +
                      "--help` tells what there is",
                  json, kMisused);
  }
  options.patience = suture::fromSeconds(times.patience);
  options.period = suture::fromSeconds(times.period);
  const auto verb = std::find_if(std::begin(kVerbs), std::end(kVerbs),
                                 [&](const Verb& one) { return app.got_subcommand(one.name); });
  return attempt(options.json, [&] { return run(*verb, options); });
}
