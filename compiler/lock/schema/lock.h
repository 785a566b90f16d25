#pragma once
// The lock: one committed Cap'n Proto schema for each annotated header. It is the wire contract
// itself, so ordinals and ids live in it and a header is judged against it. A build reads and
// checks; only `suturec --update-lock` writes.
//
// The driver's use:
//   Locks locks = read(texts of lockPath(h) for every header h, own and foreign, those that exist,
//   ...); build:          append check(model, locks); write nothing on errors; emit(model, locks).
//   --update-lock:  Update u = update(model, locks, options); on no errors write u.files, then
//   check.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/model/artefact.h"
#include "compiler/model/diagnostic.h"
#include "compiler/model/model.h"

namespace suture::compiler::lock {

/// What stands behind "Meta." to its argument as written: {"unit", "\"m\""}; "" for a Void one.
using Annotations = std::map<std::string, std::string>;
/// "none" if it is not there.
inline std::string valueOf(const Annotations& annotations, const std::string& name) {
  const auto found = annotations.find(name);
  return found == annotations.end() ? "none" : found->second;
}

/// Something that has a name and a type: a field, a method, an enumerator, a parameter.
struct Member {
  std::string name;  ///< on the wire
  unsigned ordinal = 0;
  /// A field's or parameter's, types of other files as "/arm/arm.capnp:PoseStamped".
  std::string type;
  std::string defaultValue;  ///< a field's, as capnp spells it; "" = zero
  bool isMethod = false;
  std::vector<Member> parameters;  ///< a method's
  std::vector<Member> results;     ///< a method's
  Annotations annotations;
  std::string doc;    ///< written as a comment, never read back
  unsigned line = 0;  ///< in the lock file

  bool removed() const { return annotations.contains("removed"); }
};

/// A struct, an enum or an interface.
struct Node {
  enum class Kind { Struct, Enum, Interface };

  Kind kind = Kind::Struct;
  std::string name;  ///< on the wire
  std::uint64_t id = 0;
  std::vector<std::string> extends;  ///< an interface's bases, spelled as Member::type
  Annotations annotations;
  bool isUnion = false;         ///< a struct of which one member counts
  std::vector<Member> members;  ///< in the order of the ordinals, without a gap
  std::string doc;
  unsigned line = 0;

  bool removed() const { return annotations.contains("removed"); }
};

/// One lock file.
struct Lock {
  std::string path;  ///< relative to the lock folder: "arm/arm.capnp"
  std::string text;
  std::uint64_t id = 0;
  std::string cxxNamespace;
  std::string header;
  std::vector<Node> nodes;
};

/// Every lock that exists, by path.
struct Locks {
  std::map<std::string, Lock> files;
};

struct Options {
  /// The owner of the wire names; goes into the ids of new types. A change changes no existing id.
  std::string project = "suture";
  /// Where the lock folder is seen from the user, as it shall stand in messages: "schemas".
  std::string folder = "schemas";
  /// What the user has to run to write the lock: "cmake --build build --target update-lock".
  std::string command = "suturec --update-lock";
  /// The same, where the update shall take breaks as well.
  std::string breakCommand = "suturec --update-lock --accept-break";
  /// An update takes breaks and raises the major of every contract that they reach.
  bool acceptBreaks = false;
  /// Names on the wire, in C++ or of headers that an update gives an id anew.
  std::vector<std::string> newIds{};
};

struct Update {
  std::vector<model::Artefact> files;     ///< whole new texts, only those that differ from the old
  model::Diagnostics diagnostics;         ///< breaking edits, which an update refuses as well
  std::vector<std::string> unknownIds{};  ///< of options.newIds, what no lock has
  /// By the path of a file that was there before: what `suturec diff` says of the two, line by
  /// line.
  std::map<std::string, std::vector<std::string>> changes{};
};

/// "arm/arm.h" -> "arm/arm.capnp".
std::string lockPath(std::string_view headerPath);

/// Does the header declare anything that goes over a wire (a type or an interface)? Only then it
/// has a lock.
bool needsLock(const model::Header& header);

/// Parses lock files (path and text each). What does not parse is reported with the lock's own line
/// and left out, so that check and update must not be called after an error.
Locks read(const std::vector<model::Artefact>& texts, model::Diagnostics& diagnostics,
           const Options& options = {});

/// Judges own headers against their locks: a break is an error naming field and lock line; a new
/// thing that the lock does not know is an error naming the command; what the wire does not care
/// for (a queue's depth, a default) is a warning at its line.
model::Diagnostics check(const model::Model& model, const Locks& locks,
                         const Options& options = {});

/// The lock files as they should be: new things appended, removed ones kept as placeholders.
Update update(const model::Model& model, const Locks& locks, const Options& options = {});

}  // namespace suture::compiler::lock
