#pragma once
// What capnp writes for a big schema is too much for one run of a compiler, so a build compiles it
// in parts: schemas that import each other. The lock itself stays one file, and every id is that of
// the lock, so nothing on the wire tells the parts apart.

#include <map>
#include <string>
#include <vector>

#include "compiler/lock/schema/lock.h"
#include "compiler/model/artefact.h"

namespace suture::compiler::lock {

class Parts {
 public:
  /// Maps what identity() says of a node to the part that it should be in.
  using Wishes = std::map<std::string, unsigned>;

  /// Divides the nodes of `lock`, which must outlive this, among the files `paths`. Headers of C++
  /// cannot include each other in a circle, so a node stands in the part that is wished for, or in
  /// a later one if something that it names is there.
  Parts(const Lock& lock, std::vector<std::string> paths, const Wishes& wishes);

  /// Returns the path of the part that has the node, or "" if no node is called so.
  std::string fileOf(const std::string& identity) const;

  /// Returns the parts as capnp reads them.
  std::vector<model::Artefact> files() const;

 private:
  std::string text(unsigned part) const;

  const Lock& lock_;
  const std::vector<std::string> paths_;
  std::map<std::string, unsigned> parts_;       // by name on the wire
  std::map<std::string, std::string> names_{};  // by identity
};

}  // namespace suture::compiler::lock
