#include "compiler/lock/prefixes.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/lock/schema/composites.h"
#include "compiler/lock/schema/wanted.h"

namespace suture::compiler::lock {
namespace {

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Returns the prefix of the lock's composites, which is `prefix`, perhaps with a number behind it;
/// "" if the lock has none with it.
std::string lockedPrefix(const Lock& lock, const std::string& prefix) {
  for (const Node& node : lock.nodes) {
    const bool isComposite = identity(node) == node.name;
    if (!isComposite || node.removed() || !node.name.starts_with(prefix)) continue;
    const auto begin = node.name.begin() + static_cast<std::ptrdiff_t>(prefix.size());
    return {node.name.begin(), std::find_if_not(begin, node.name.end(), isDigit)};
  }
  return "";
}

/// Holds the headers of one namespace, foreign ones first: theirs are the names that others use.
class Namespace {
 public:
  void add(model::Header& header) {
    taken_.insert(prefixOf(header));
    headers_.push_back(&header);
  }

  void settle(const Locks& locks) {
    std::stable_partition(headers_.begin(), headers_.end(),
                          [](const model::Header* header) { return !header->own; });
    std::map<std::string, std::vector<model::Header*>> sharing;
    for (model::Header* const header : headers_) sharing[prefixOf(*header)].push_back(header);
    for (auto& [prefix, headers] : sharing) {
      if (headers.size() > 1) tellApart(prefix, std::move(headers), locks);
    }
  }

 private:
  void tellApart(const std::string& prefix, std::vector<model::Header*> headers,
                 const Locks& locks) {
    bool isFree = true;
    for (model::Header* const header : headers) {
      const auto lock = locks.files.find(lockPath(header->path));
      if (lock != locks.files.end()) header->wirePrefix = lockedPrefix(lock->second, prefix);
      taken_.insert(header->wirePrefix);
      if (header->wirePrefix == prefix) isFree = false;
    }
    for (model::Header* const header : headers) {
      if (!header->wirePrefix.empty()) continue;
      header->wirePrefix = std::exchange(isFree, false) ? prefix : numbered(prefix);
    }
  }

  std::string numbered(const std::string& prefix) {
    for (unsigned number = 2;; ++number) {
      std::string name = prefix + std::to_string(number);
      if (taken_.insert(name).second) return name;
    }
  }

  std::vector<model::Header*> headers_;
  std::set<std::string> taken_;
};

}  // namespace

void settlePrefixes(model::Model& model, const Locks& locks) {
  std::map<std::string, Namespace> namespaces;
  for (model::Header& header : model.headers) namespaces[header.cxxNamespace].add(header);
  for (auto& [name, headers] : namespaces) headers.settle(locks);
}

}  // namespace suture::compiler::lock
