#include "compiler/lock/schema/reach.h"

#include "compiler/lock/schema/type_place.h"

namespace suture::compiler::lock {
namespace {

class Walk {
 public:
  explicit Walk(const std::map<std::string, Lock>& locks) : locks_(locks) {}

  void visit(const std::string& path, const std::string& name) {
    const auto lock = locks_.find(path);
    if (lock == locks_.end()) return;
    for (const Node& node : lock->second.nodes) {
      if (node.name != name || !seen_.insert(path + ":" + name).second) continue;
      for (const std::string& base : node.extends) visitType(path, base);
      for (const Member& member : node.members) visit(path, member);
    }
  }

  std::set<std::string> seen() && { return std::move(seen_); }

 private:
  void visit(const std::string& path, const Member& member) {
    for (const Member& parameter : member.parameters) visit(path, parameter);
    for (const Member& result : member.results) visit(path, result);
    visitType(path, member.type);
  }

  void visitType(const std::string& path, const std::string& type) {
    const TypePlace place = placeOf(type, path);
    visit(place.path, place.name);
  }

  const std::map<std::string, Lock>& locks_;
  std::set<std::string> seen_;
};

}  // namespace

std::set<std::string> reach(const std::map<std::string, Lock>& locks, const std::string& path,
                            const std::string& node) {
  Walk walk(locks);
  walk.visit(path, node);
  return std::move(walk).seen();
}

}  // namespace suture::compiler::lock
