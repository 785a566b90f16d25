#pragma once
// This checks that the connections of a deployment fit the components of one of its processes.

#include <suture/component/component.h>
#include <suture/deploy/document/deployment.h>

#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace suture {

/// Looks at the ends that lie in `process`, whose `components` are in its order, and null where one
/// cannot be created. So each process tells of its own ends, even one that only provides, which
/// would wait for ever. Adds a problem for an interface that a connection names and its component
/// does not have, and for a required one without a connection, whose task would silently do
/// nothing; not for a connection whose place in the file is in `told`.
void checkConnections(const Deployment& deployment, const ProcessEntry& process,
                      std::span<const std::unique_ptr<Component>> components,
                      std::set<std::string> told, std::vector<std::string>& problems);

}  // namespace suture
