#include "compiler/lock/settle.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "compiler/lock/moves/moves.h"
#include "compiler/lock/prefixes.h"
#include "compiler/lock/schema/node_index.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/lock/schema/wire_type.h"
#include "compiler/model/lookup.h"
#include "compiler/model/naming.h"

namespace suture::compiler::lock {
namespace {

constexpr char kMore[] = "Value";

std::string cxxNameOf(const Member& member) {
  const auto found = member.annotations.find("cxx");
  return found == member.annotations.end() ? member.name : unquoted(found->second);
}

/// Tells if `name` is `wireName`, or that with a word more.
bool isFrom(const std::string& wireName, const std::string& name) {
  return name == wireName || name.starts_with(wireName + kMore);
}

/// Holds the members of one struct, or the enumerators of one enum, and what the lock says of them.
template <class Declared>
class Scope {
 public:
  Scope(std::vector<Declared>& members, const Node* node) : members_(members) {
    if (node != nullptr) locked_ = node->members;
    std::erase_if(locked_, [](const Member& one) { return one.removed(); });
    open_.assign(members.size(), true);
  }

  /// Lets member `i` keep the name of the first of the lock's for which `isIt` is true.
  template <class IsIt>
  void keep(std::size_t i, const IsIt& isIt) {
    if (!open_[i] || members_[i].isNamed) return;
    for (const Member& one : locked_) {
      if (!isIt(one) || !isFrom(members_[i].wireName, one.name)) continue;
      if (!taken_.insert(one.name).second) continue;
      members_[i].wireName = one.name;
      open_[i] = false;
      return;
    }
  }

  /// Returns the first of the lock's members for which `isIt` is true, or null.
  template <class IsIt>
  const Member* find(const IsIt& isIt) const {
    const auto found = std::find_if(locked_.begin(), locked_.end(), isIt);
    return found == locked_.end() ? nullptr : &*found;
  }

  /// Leaves member `i` the name that it has, even if that clashes.
  void leave(std::size_t i) {
    taken_.insert(members_[i].wireName);
    open_[i] = false;
  }

  void nameOthers() {
    for (const Declared& member : members_) {
      if (member.isNamed) taken_.insert(member.wireName);
    }
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (!open_[i] || members_[i].isNamed) continue;
      if (!taken_.insert(members_[i].wireName).second) members_[i].wireName = freeName(i);
    }
  }

 private:
  /// Returns a name that neither the header nor the lock has.
  std::string freeName(std::size_t i) {
    const std::string first = members_[i].wireName + kMore;
    std::string name = first;
    for (unsigned number = 2; isInUse(name); ++number) name = first + std::to_string(number);
    taken_.insert(name);
    return name;
  }

  bool isInUse(const std::string& name) const {
    const auto has = [&](const auto& list, auto member) {
      return std::any_of(list.begin(), list.end(),
                         [&](const auto& one) { return one.*member == name; });
    };
    return taken_.contains(name) || has(members_, &Declared::wireName) ||
           has(locked_, &Member::name);
  }

  std::vector<Declared>& members_;
  std::vector<Member> locked_;  // those that were removed are left out
  std::set<std::string> taken_;
  std::vector<bool> open_;  // true for each of members_ that has no name of its own yet
};

/// Returns the node of a type, which may have had another name; null if the lock has none.
template <class Type>
const Node* nodeOf(const Type& type, const NodeIndex* lock) {
  if (lock == nullptr) return nullptr;
  const auto find = [&](const std::string& name) { return lock->living("cxx " + quoted(name)); };
  const Node* node = find(type.name);
  const std::optional<std::string> was = model::formerName(type.name, type.was);
  return node == nullptr && was ? find(*was) : node;
}

/// Finds the bases of a struct in the lock. The C++ name of a base changes as soon as a member has
/// the same name, so its type tells as well which of the lock's it is. If that member has the same
/// type too, only name() can tell them apart: the clash stays, and is reported.
class Bases {
 public:
  Bases(model::Struct& type, const model::Lookup& lookup, const model::Header& header)
      : type_(type), lookup_(lookup), header_(header) {}

  /// Calls bases as the lock does if they have changed their places: the first is called `base`,
  /// and another one by its class, but the order of bases means nothing on the wire.
  void rename(const Scope<model::Field>& scope) const {
    std::set<std::string> given;
    std::vector<model::Field*> others;
    for (model::Field& base : type_.fields) {
      if (!base.isBase) continue;
      const std::string wire = typeOf(base);
      const auto isKnown = [&](const Member& one) {
        return one.type == wire && withoutMark(cxxNameOf(one)) == base.wireName;
      };
      const auto isElsewhere = [&](const Member& one) {
        const std::string name = withoutMark(cxxNameOf(one));
        return one.type == wire && name.starts_with(kBase) && !isMember(name);
      };
      const Member* const known = scope.find(isKnown) ? nullptr : scope.find(isElsewhere);
      if (known == nullptr) {
        others.push_back(&base);
      } else {
        call(base, withoutMark(cxxNameOf(*known)));
        given.insert(base.wireName);
      }
    }
    for (model::Field* const base : others) {
      const std::string byClass = kBase + model::titleCase(model::unqualified(base->type.name));
      if (given.contains(base->wireName)) call(*base, byClass);
    }
  }

  void settle(Scope<model::Field>& scope) const {
    for (std::size_t i = 0; i < type_.fields.size(); ++i) {
      if (!type_.fields[i].isBase) continue;
      const std::string plain = type_.fields[i].wireName, wire = typeOf(type_.fields[i]);
      const auto isCalled = [&](const std::string& name) {
        return
            [name, &wire](const Member& one) { return cxxNameOf(one) == name && one.type == wire; };
      };
      const std::size_t namesake = memberCalled(plain);
      const bool alike = namesake < type_.fields.size() && typeOf(type_.fields[namesake]) == wire;
      if (alike && scope.find(isCalled(plain)) && !scope.find(isCalled(plain + "_"))) {
        scope.leave(i);
        scope.leave(namesake);
      }
      scope.keep(i, isCalled(plain + "_"));
      if (!isSaid(plain)) scope.keep(i, isCalled(plain));
    }
  }

 private:
  static constexpr char kBase[] = "base";

  /// Drops what tells the slot of a base from a member of the same name.
  static std::string withoutMark(std::string name) {
    if (name.ends_with('_')) name.pop_back();
    return name;
  }

  bool isMember(const std::string& name) const {
    return std::any_of(type_.fields.begin(), type_.fields.end(),
                       [&](const model::Field& one) { return !one.isBase && one.name == name; });
  }

  void call(model::Field& base, const std::string& name) const {
    base.wireName = name;
    base.name = isMember(name) ? name + "_" : name;
  }

  std::string typeOf(const model::Field& field) const {
    return wireType(field.type, lookup_, header_);
  }

  /// Tells if a member has this name on the wire because name() says so.
  bool isSaid(const std::string& wireName) const {
    return std::any_of(type_.fields.begin(), type_.fields.end(), [&](const model::Field& one) {
      return one.isNamed && one.wireName == wireName;
    });
  }

  /// Returns the index of a member without name(), or the number of all if there is none.
  std::size_t memberCalled(const std::string& name) const {
    const auto found = std::find_if(
        type_.fields.begin(), type_.fields.end(),
        [&](const model::Field& one) { return !one.isBase && !one.isNamed && one.name == name; });
    return static_cast<std::size_t>(found - type_.fields.begin());
  }

  model::Struct& type_;
  const model::Lookup& lookup_;
  const model::Header& header_;
};

void settle(model::Struct& type, const Node* node, const model::Lookup& lookup,
            const model::Header& header) {
  Scope scope(type.fields, node);
  const Bases bases(type, lookup, header);
  bases.rename(scope);
  bases.settle(scope);
  for (std::size_t i = 0; i < type.fields.size(); ++i) {
    scope.keep(i, [&](const Member& one) { return cxxNameOf(one) == type.fields[i].name; });
  }
  scope.nameOthers();
}

void settle(model::Enum& type, const Node* node) {
  Scope scope(type.enumerators, node);
  for (std::size_t i = 0; i < type.enumerators.size(); ++i) {
    scope.keep(i, [&](const Member& one) { return cxxNameOf(one) == type.enumerators[i].name; });
  }
  scope.nameOthers();
}

}  // namespace

model::Model settled(const model::Model& model, const Locks& committed) {
  const Locks locks = relocated(committed, findMoves(model, committed, {}).all);
  const model::Lookup lookup(model);
  model::Model result = model;
  settlePrefixes(result, locks);
  const NodeIndexes indexes = indexed(locks.files);
  for (std::size_t i = 0; i < model.headers.size(); ++i) {
    const model::Header& header = model.headers[i];
    const auto lock = indexes.find(lockPath(header.path));
    const NodeIndex* const known = lock == indexes.end() ? nullptr : &lock->second;
    for (model::Enum& type : result.headers[i].enums) settle(type, nodeOf(type, known));
    for (model::Struct& type : result.headers[i].structs) {
      settle(type, nodeOf(type, known), lookup, header);
    }
  }
  return result;
}

}  // namespace suture::compiler::lock
