#include "cli/contract/contract.h"
#include <suture/base/errors.h>
#include <suture/base/nearest.h>
#include <suture/codec/json/annotations.h>
#include <suture/codec/json/to_json.h>
#include <suture/names/records.h>
#include "cli/contract/schema_guard.h"

#include <algorithm>
#include <limits>

namespace suture::cli {
namespace {

constexpr const char* kDistrust = "It was built with another Suture, or is not what it seems";

const Member* findIn(const std::vector<Member>& members, const std::string& name) {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const Member& one) { return one.name == name; });
  return found == members.end() ? nullptr : &*found;
}

/// Throws kj::Exception if any part of it cannot be read. Cap'n Proto 0.9.2, loading a node with
/// such a part, reads it again to name it in its error, and never ends.
void readOnce(wire::Explanation::Reader explanation) {
  codec::toJson(explanation, codec::Labels::Names);
}

}  // namespace

Contract::Contract(std::string title, wire::Explanation::Reader explanation)
    : title_(std::move(title)) {
  try {
    readOnce(explanation);
    takeTexts(explanation);
    loadSchema(explanation);
  } catch (const kj::Exception& failure) {
    refuseSchema(failure.getDescription().cStr());
  }
}

void Contract::takeTexts(wire::Explanation::Reader explanation) {
  descriptionText_ = codec::stringOf(explanation.getDescription());
  description_ = parsePeers(descriptionText_);
  if (!description_.is_object()) {
    throw SetupError("understand " + title_, "its description is not one", kDistrust);
  }
  for (const auto base : explanation.getBases()) baseTexts_.push_back(codec::stringOf(base));
}

void Contract::refuseSchema(const std::string& fault) const {
  throw SetupError("understand " + title_, "its schema is not one (" + fault + ")", kDistrust);
}

void Contract::loadSchema(wire::Explanation::Reader explanation) {
  if (const auto fault = faultIn(explanation.getNodes())) refuseSchema(*fault);
  for (const auto node : explanation.getNodes()) loader_.load(node);
  interface_ = loader_.get(explanation.getContract()).asInterface();
  eventsInterface_ = codec::eventsOf(interface_);
  commands_ = membersOf("commands", interface_);
  events_ = membersOf("events", eventsInterface_);
}

std::vector<Member> Contract::membersOf(const char* list, capnp::InterfaceSchema schema) const {
  std::vector<Member> members;
  for (const Json& one : listAt(description_, list)) {
    const std::string name = textAt(one, "name"), wire = textAt(one, "wire");
    members.push_back(
        {.name = name,
         .kind = textAt(one, "kind"),
         .description = one,
         .method = schema.getMethodByName(codec::textOf(wire.empty() ? name : wire))});
  }
  return members;
}

const Member* Contract::findEvent(const std::string& name) const { return findIn(events_, name); }

// The bit is the place in the list, unless the event says another. A peer may say any number, and
// have any number of events.
std::uint64_t Contract::bitOf(const Member& event) const {
  constexpr std::uint64_t kEnd = std::numeric_limits<std::uint64_t>::digits;
  const auto said = event.description.find("number");
  const bool says = said != event.description.end() && said->is_number_unsigned() &&
                    said->get<std::uint64_t>() < kEnd;
  const auto place = static_cast<std::uint64_t>(&event - events_.data());
  const std::uint64_t number = says ? said->get<std::uint64_t>() : place;
  return number < kEnd ? std::uint64_t{1} << number : 0;
}

const Member& Contract::command(const std::string& name) const {
  if (const Member* const found = findIn(commands_, name)) return *found;
  refuse("command", name, commands_);
}

const Member& Contract::event(const std::string& name) const {
  if (const Member* const found = findEvent(name)) return *found;
  refuse("event", name, events_);
}

void Contract::refuse(const char* word, const std::string& name,
                      const std::vector<Member>& existing) const {
  std::vector<std::string> names;
  for (const Member& one : existing) names.push_back(one.name);
  throw SetupError("find " + std::string(word) + " '" + name + "' of " + title_,
                   this->name() + " has " + listNamed(std::string(word) + "s", names),
                   remedyForName(name, names));
}

}  // namespace suture::cli
