#include "compiler/emit/wire/later_parameters.h"

#include <algorithm>

#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::emit {
namespace {

const lock::Member* lockedCommand(const Context& context, const model::Interface& interface,
                                  const model::Command& command) {
  const std::string path = lock::lockPath(context.lookup.headerOf(interface.name)->path);
  for (const lock::Node& node : context.schemas.at(path).nodes) {
    if (node.kind != lock::Node::Kind::Interface || node.name != interface.wireName) continue;
    for (const lock::Member& member : node.members) {
      if (member.name == command.wireName) return &member;
    }
  }
  return nullptr;
}

}  // namespace

std::set<std::string> laterParameters(const Context& context, const model::Interface& interface,
                                      const model::Command& command) {
  const lock::Member* const locked = lockedCommand(context, interface, command);
  std::set<std::string> later;
  if (locked == nullptr) return later;
  // The parameter `sent` ends those that the command was locked with; later ones follow it.
  const auto sent = std::find_if(locked->parameters.begin(), locked->parameters.end(),
                                 [](const lock::Member& one) { return one.type == lock::kSent; });
  for (auto one = sent; one != locked->parameters.end(); ++one) later.insert(one->name);
  return later;
}

}  // namespace suture::compiler::emit
