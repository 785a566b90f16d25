#include "compiler/emit/text/share.h"

#include <algorithm>
#include <vector>

#include "compiler/lock/schema/wire_type.h"

namespace suture::compiler::emit {
namespace {

std::size_t weight(const model::Enum&) { return 1; }
std::size_t weight(const model::Struct&) { return 1; }
std::size_t weight(const model::Interface& interface) {
  return 1 + interface.commands.size() + interface.events.size();
}

template <class Declaration>
std::size_t weightOf(const std::vector<Declaration>& all) {
  std::size_t sum = 0;
  for (const Declaration& one : all) sum += weight(one);
  return sum;
}

}  // namespace

model::Header shareOf(const model::Header& header, unsigned index, unsigned count) {
  model::Header share = header;
  if (count <= 1) return share;
  const std::size_t whole =
      weightOf(header.enums) + weightOf(header.structs) + weightOf(header.interfaces);
  std::size_t before = 0;
  const auto keep = [&](auto& all) {
    std::erase_if(all, [&](const auto& one) {
      const std::size_t begin = before;
      before += weight(one);
      return begin * count / whole != index;
    });
  };
  keep(share.enums);
  keep(share.structs);
  keep(share.interfaces);
  if (index > 0) share.components.clear();
  return share;
}

std::vector<std::string> nodesOf(const model::Header& header) {
  std::vector<std::string> nodes;
  const auto add = [&](const char* annotation, const std::string& name) {
    nodes.push_back(annotation + (" " + lock::quoted(name)));
  };
  for (const model::Enum& one : header.enums) add("cxx", one.name);
  for (const model::Struct& one : header.structs) add("cxx", one.name);
  for (const model::Interface& one : header.interfaces) {
    for (const char* const annotation : {"cxx", "eventsOf", "stateOf"}) add(annotation, one.name);
  }
  return nodes;
}

bool declares(const model::Header& header, const std::string& type) {
  const auto has = [&](const auto& all) {
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == type; });
  };
  return has(header.structs) || has(header.enums);
}

}  // namespace suture::compiler::emit
