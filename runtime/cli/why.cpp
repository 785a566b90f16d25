#include <suture/base/nearest.h>
#include <suture/wiring/connect.h>
#include <suture/wiring/frames.h>
#include "cli/peer/lookup.h"
#include "cli/text/error_pages.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <algorithm>
#include <optional>

namespace suture::cli {
namespace {

using Side = wire::Peer::Side;

/// An End is one of the two interfaces that are compared.
struct End {
  Target target;
  Found found;
};

/// Holds what a comparison needs of a description.
struct Compared {
  explicit Compared(const std::string& description) : text(description) {
    const Json json = parsePeers(text);
    name = textAt(json, "name");
    hash = textAt(json, "hash");
  }

  InterfaceInfo info() const { return describedInfo(name, hash, text); }

  std::string text, name, hash;
};

struct Verdict {
  bool connects = false;
  bool sameContract = false;
  std::vector<std::uint16_t>
      lacking;  ///< the numbers of the required commands that the provider lacks
  std::vector<std::string> differences;
};

/// The provider's contract may be the required one, or derive from it.
Verdict judgeContracts(const End& required, const End& provided) {
  const Compared needed(required.found.contract->descriptionText());
  std::vector<std::string> offers{provided.found.contract->descriptionText()};
  for (const std::string& base : provided.found.contract->baseTexts()) offers.push_back(base);
  const bool sameProcess = required.target.process == provided.target.process;
  for (const std::string& offer : offers) {
    try {
      const Compared offered(offer);
      return {true,
              true,
              (sameProcess ? requireSameContract(needed.info(), offered.info(), "")
                           : requireCompatibleContract(needed.info(), offered.info(), ""))
                  .lacking,
              {}};
    } catch (const SetupError&) {
      // A base of it may still be the required one.
    }
  }
  return {false, false, {}, contractDifferences(needed.info(), Compared(offers.front()).info())};
}

/// Judges as the provider itself does.
Verdict judge(const End& required, const End& provided) {
  Verdict verdict = judgeContracts(required, provided);
  const std::string frames = frameDifference(required.found.frames, provided.found.frames);
  if (frames.empty()) return verdict;
  verdict.connects = false;
  verdict.differences.push_back("it " + frames);
  return verdict;
}

End endOf(loop::EventPort& loop, const Options& options, const std::string& name) {
  const Target target = Target::parseInterface(name);
  Peer peer = meet(loop, options, target.process);
  return {target, findInterface(peer, target)};
}

const char* wordOf(Side side) { return side == Side::REQUIRED ? "requires" : "provides"; }

void requireTwoSides(const End& one, const End& other) {
  if (one.found.side != other.found.side) return;
  throw SetupError("connect " + one.target.toString() + " and " + other.target.toString(),
                   std::string("each of them ") + wordOf(one.found.side) + " its contract",
                   "Name a required and a provided interface; `suture ps` tells which is which");
}

std::vector<std::string> missingCommands(const End& required, const Verdict& verdict) {
  std::vector<std::string> names;
  const auto& commands = required.found.contract->commands();
  for (const std::uint16_t number : verdict.lacking) {
    if (number < commands.size()) names.push_back(commands[number].name);
  }
  return names;
}

bool haveOneName(const End& required, const End& provided) {
  return required.found.contract->name() == provided.found.contract->name();
}

std::string remedyFor(const End& required, const End& provided, const Verdict& verdict) {
  if (verdict.sameContract) {
    return "Connect interfaces of the same frames, or correct what is declared of them.";
  }
  return haveOneName(required, provided) ? "Build both sides from the same header."
                                         : "Connect interfaces of the same contract.";
}

std::string text(const End& required, const End& provided, const Verdict& verdict) {
  const std::string both = required.target.toString() + " -> " + provided.target.toString();
  const std::string needs = required.found.contract->name(),
                    offers = provided.found.contract->name();
  const bool differ = !verdict.sameContract && !verdict.connects && haveOneName(required, provided);
  std::string text = both + (verdict.connects ? ": they connect\n" : ": they do not connect\n") +
                     (differ ? "  both are called " + needs + ", and differ\n"
                             : "  requires " + needs + ", is offered " + offers + "\n");
  for (const std::string& line : verdict.differences) text += "    " + line + "\n";
  if (!verdict.connects) return text + remedyFor(required, provided, verdict) + "\n";
  for (const std::string& name : missingCommands(required, verdict)) {
    text += "    the provider does not have '" + name + "': calls of it are refused\n";
  }
  return text;
}

Json json(const End& required, const End& provided, const Verdict& verdict) {
  Json json{{"required", required.target.toString()},
            {"provided", provided.target.toString()},
            {"connects", verdict.connects},
            {"requires", required.found.contract->name()},
            {"offers", provided.found.contract->name()}};
  if (verdict.connects) {
    json["missing_commands"] = missingCommands(required, verdict);
  } else {
    json["differences"] = verdict.differences;
    json["remedy"] = remedyFor(required, provided, verdict);
  }
  return json;
}

int explain(const Options& options) {
  const std::string explained = explainError(options.target);
  if (explained.empty()) {
    std::vector<std::string> names;
    for (const auto& [name, text] : errorPages()) names.emplace_back(name);
    throw UsageError("explain '" + options.target + "'", "no error has that name or text",
                     "There are " + listNames(names) + "; or name two interfaces");
  }
  if (options.json) {
    printJson({{"explained", explained}});
  } else {
    print(explained);
  }
  return 0;
}

}  // namespace

int why(loop::EventPort& loop, const Options& options) {
  if (options.other.empty()) return explain(options);
  End required = endOf(loop, options, options.target);
  End provided = endOf(loop, options, options.other);
  requireTwoSides(required, provided);
  if (required.found.side == Side::PROVIDED) std::swap(required, provided);
  const Verdict verdict = judge(required, provided);
  if (options.json) {
    printJson(json(required, provided, verdict));
  } else {
    print(plain(text(required, provided, verdict)));
  }
  return verdict.connects ? 0 : 1;
}

}  // namespace suture::cli
