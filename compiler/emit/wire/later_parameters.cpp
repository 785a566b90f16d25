#include "compiler/emit/wire/later_parameters.h"

#include <algorithm>

#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::emit {
namespace {

/// Returns what stands behind `last`, which ends those that the method was locked with.
template <class IsLast>
std::set<std::string> behind(const Context& context, const char* annotation,
                             const model::Interface& interface, const std::string& method,
                             const IsLast& last) {
  const std::string path = lock::lockPath(context.lookup.headerOf(interface.name)->path);
  const lock::Node* const node = context.schemas.at(path).ofContract(annotation, interface.name);
  std::set<std::string> later;
  if (node == nullptr) return later;
  for (const lock::Member& member : node->members) {
    if (member.name != method) continue;
    const auto end = std::find_if(member.parameters.begin(), member.parameters.end(), last);
    for (auto one = end; one != member.parameters.end(); ++one) later.insert(one->name);
  }
  return later;
}

}  // namespace

std::set<std::string> laterParameters(const Context& context, const model::Interface& interface,
                                      const model::Command& command) {
  return behind(context, "cxx", interface, command.wireName,
                [](const lock::Member& one) { return one.type == lock::kSent; });
}

std::set<std::string> laterValues(const Context& context, const model::Interface& interface,
                                  const model::Event& event) {
  return behind(context, "eventsOf", interface, event.wireName,
                [](const lock::Member& one) { return one.name == "stamp"; });
}

}  // namespace suture::compiler::emit
