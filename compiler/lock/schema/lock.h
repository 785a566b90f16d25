#pragma once
// This is the lock: one committed Cap'n Proto schema for each annotated header. It is the wire
// contract itself, so ordinals and ids live in it and a header is judged against it. A build reads
// and checks; only `suturec --update-lock` writes.
//
// The driver uses it so:
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

#include "compiler/lock/schema/type_place.h"
#include "compiler/model/artefact.h"
#include "compiler/model/diagnostic.h"
#include "compiler/model/model.h"

namespace suture::compiler::lock {

/// Maps what stands behind "Meta." to its argument as written: {"unit", "\"m\""}; the argument of a
/// Void one is "".
using Annotations = std::map<std::string, std::string>;
/// Returns the argument of the annotation, or "none" if it is not there.
inline std::string valueOf(const Annotations& annotations, const std::string& name) {
  const auto found = annotations.find(name);
  return found == annotations.end() ? "none" : found->second;
}

/// A Member is something that has a name and a type: a field, a method, an enumerator, a parameter.
struct Member {
  std::string name;  ///< on the wire
  unsigned ordinal = 0;
  /// A field or a parameter has this type; one of another file reads "/arm/arm.capnp:PoseStamped".
  std::string type;
  std::string defaultValue;  ///< a field's, as capnp spells it; "" is zero
  bool isMethod = false;
  std::vector<Member> parameters;  ///< a method's; else empty
  std::vector<Member> results;     ///< a method's; else empty
  Annotations annotations;
  std::string doc;    ///< it is written as a comment and never read back
  unsigned line = 0;  ///< in the lock file

  bool removed() const { return annotations.contains("removed"); }
};

/// A Node is a struct, an enum or an interface.
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
  /// The node stands here in the files as they are, if relocated() has moved it.
  std::optional<TypePlace> cameFrom;

  bool removed() const { return annotations.contains("removed"); }
};

/// Says what a node that a lock had is called now, and where.
struct Departure {
  /// The lock that the node has left calls it so, or the one in which it has another name now. If
  /// it came from a lock that is not there any more, it is "/arm/arm.capnp:Pose".
  std::string name;
  std::uint64_t id = 0;  ///< the node's, as capnp has it
  TypePlace to;          ///< when it left; it may have moved on since then

  bool operator==(const Departure&) const = default;
};

/// This is one lock file.
struct Lock {
  std::string path;  ///< relative to the lock folder: "arm/arm.capnp"
  std::string text;
  std::uint64_t id = 0;
  std::string cxxNamespace;
  std::string header;
  std::vector<Node> nodes;
  std::vector<Departure> departures;
  /// Maps what the file as it is names by an import to the name that relocated() gave it.
  std::map<std::string, std::string> followed;
};

/// Holds the locks of all headers of a run, by path.
struct Locks {
  std::map<std::string, Lock> files;
  /// Holds locks of headers that the run does not see, where was() may find what they had. They are
  /// never written.
  std::map<std::string, Lock> others{};
};

struct Options {
  /// Says who owns the wire names. It goes into the ids of new types; a change of it changes no
  /// existing id.
  std::string project = "suture";
  /// Says how messages name the lock folder, as the user sees it: "schemas".
  std::string folder = "schemas";
  /// Says what the user has to run to write the lock: "cmake --build build --target update-lock".
  std::string command = "suturec --update-lock";
  /// Says what the user has to run if the update shall take breaks as well.
  std::string breakCommand = "suturec --update-lock --accept-break";
  /// Lets an update take breaks and raise the major of every contract that they reach.
  bool acceptBreaks = false;
  /// Names what an update gives a new id: by its name on the wire, its name in C++, or the path of
  /// a header.
  std::vector<std::string> newIds{};
};

struct Update {
  std::vector<model::Artefact> files;     ///< whole new texts, only those that differ from the old
  model::Diagnostics diagnostics;         ///< breaking edits, which an update refuses as well
  std::vector<std::string> unknownIds{};  ///< those of options.newIds that no lock has
  /// Holds what `suturec diff` says of the old and the new text, line by line, by path. Of a new
  /// file it says what came from others.
  std::map<std::string, std::vector<std::string>> changes{};
};

/// Turns "arm/arm.h" into "arm/arm.capnp".
std::string lockPath(std::string_view headerPath);

/// Tells if the header declares anything that goes over a wire (a type or an interface), because
/// only then it has a lock.
bool needsLock(const model::Header& header);

/// Parses lock files (path and text each). A file that does not parse is reported at its own line
/// and left out, so that check and update must not be called after an error.
Locks read(const std::vector<model::Artefact>& texts, model::Diagnostics& diagnostics,
           const Options& options = {});

/// Returns the C++ names, also the former ones, of what own headers declare and no lock has. Locks
/// that have them too are to be read by readOthers().
std::vector<std::string> unknownNames(const model::Model& model, const Locks& locks);

/// Adds the locks of other headers that parse. An unreadable one is the concern of its own header.
void readOthers(const std::vector<model::Artefact>& texts, Locks& locks);

/// Judges own headers against their locks. A break is an error that names the field and the lock's
/// line; a new thing that the lock does not know is an error that names the command; what the wire
/// does not care for (a queue's depth, a default) is a warning at its line.
model::Diagnostics check(const model::Model& model, const Locks& locks,
                         const Options& options = {});

/// Returns the lock files as they should be: new things are appended, removed ones are kept as
/// placeholders.
Update update(const model::Model& model, const Locks& locks, const Options& options = {});

}  // namespace suture::compiler::lock
