#pragma once
// A type may move to another header, or get another name there. Its node moves to the lock of that
// header, with its id and its numbers, and other locks name it where it is now.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/type_place.h"

namespace suture::compiler::lock {

/// Tells where a node of a lock stood, and where it stands now. In its own file only the name is
/// another.
struct Move {
  TypePlace from, to;
  std::uint64_t id = 0;

  bool isRename() const { return from.path == to.path; }
};

struct Moves {
  std::vector<Move> all;
  model::Diagnostics found;  ///< these say what cannot follow, and what might
};

/// Finds what the headers of the model declare elsewhere, or under other names, than the locks
/// have it.
Moves findMoves(const model::Model& model, const Locks& locks, const Options& options);

/// Finds what two versions of the locks of one folder have at different places.
std::vector<Move> movesBetween(const Locks& old, const Locks& now);

/// Returns the locks as if each node had always stood where it is now. In its own file a node keeps
/// its name, since merge() gives it the new one.
Locks relocated(const Locks& locks, const std::vector<Move>& moves);

/// Notes in a lock that an update writes where to look for what has left it, and lets placeholders
/// name nothing of other files: it may move unseen, or to a file that imports this one. `old` is
/// what the lock was before, relocated like all `locks`.
void noteMoves(const Lock& old, Lock& merged, const Locks& locks, const std::vector<Move>& moves);

}  // namespace suture::compiler::lock
