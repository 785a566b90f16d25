#include "compiler/frontend/inheritance.h"

#include <map>
#include <set>

namespace suture::compiler::frontend {
namespace {

using Interfaces = std::map<std::string, model::Interface*>;

template <class Member>
void prepend(const std::string& base, const std::vector<Member>& inherited,
             std::vector<Member>& own) {
  std::vector<Member> all = inherited;
  for (Member& member : all) {
    if (member.inheritedFrom.empty()) member.inheritedFrom = base;
  }
  all.insert(all.end(), own.begin(), own.end());
  own = std::move(all);
}

/// Completes bases before what derives from them, and each contract once.
void complete(model::Interface& interface, const Interfaces& interfaces,
              std::set<std::string>& done) {
  if (!done.insert(interface.name).second || interface.base.empty()) return;
  const auto base = interfaces.find(interface.base);
  if (base == interfaces.end()) return;  // an error has been reported at its declaration
  complete(*base->second, interfaces, done);
  prepend(interface.base, base->second->commands, interface.commands);
  prepend(interface.base, base->second->events, interface.events);
}

}  // namespace

void addInherited(model::Model& model) {
  Interfaces interfaces;
  for (model::Header& header : model.headers) {
    for (model::Interface& one : header.interfaces) interfaces.emplace(one.name, &one);
  }
  std::set<std::string> done;
  for (const auto& [name, interface] : interfaces) complete(*interface, interfaces, done);
}

}  // namespace suture::compiler::frontend
