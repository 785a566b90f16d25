#pragma once
// This finds what would have one name twice in the schema.

#include <map>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/wanted.h"
#include "compiler/model/model.h"

namespace suture::compiler::lock {

/// Holds the wire names of all headers, by the C++ namespace in which capnp will declare them.
class WireNames {
 public:
  WireNames(const model::Model& model, const model::Lookup& lookup);

  /// Reports the nodes of `header` that have the name of another node.
  model::Diagnostics clashes(const model::Header& header,
                             const std::vector<WantedNode>& nodes) const;
  /// Reports nodes that have the name of one that `merged`, the next lock of `header`, keeps as
  /// removed: it keeps its name in the schema, so no header of the namespace may give it again.
  model::Diagnostics clashesWithRemoved(const model::Header& header, const Lock& old,
                                        const Lock& merged) const;

 private:
  struct Owner {
    std::string path;
    WantedNode node;
  };

  void add(const model::Header& header, const model::Lookup& lookup);

  std::map<std::string, Owner> owners_;
};

/// Reports composites of a header that have one name.
model::Diagnostics clashesOfComposites(const model::Header& header, const model::Lookup& lookup);

/// Reports members that have the name of what suturec adds to every contract (subscribe, state,
/// stamp, evaluated, sent).
model::Diagnostics clashesWithOwn(const std::vector<WantedNode>& wanted);

}  // namespace suture::compiler::lock
