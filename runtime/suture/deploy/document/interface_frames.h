#pragma once
// A deployment declares these coordinate frames for interfaces of its components.

#include <suture/component/component.h>
#include <suture/deploy/document/deployment.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace suture {

/// Before anything is connected: gives each interface of `components`, which are in the order of
/// `process` and null where one cannot be created, its frames. Adds a problem if no interface has
/// that name, or its component has declared other frames.
void declareFrames(const JsonDocument& document, const ProcessEntry& process,
                   std::span<const std::unique_ptr<Component>> components,
                   std::vector<std::string>& problems);

}  // namespace suture
