#pragma once
// A deployment declares these coordinate frames for interfaces of its components.

#include <suture/component/component.h>
#include <suture/deploy/document/deployment.h>

#include <memory>
#include <span>

namespace suture {

/// Before anything is connected: gives each interface of `components`, which are in the order of
/// `process`, its frames. Throws DocumentError if no interface has that name, or its component has
/// declared other frames.
void declareFrames(const JsonDocument& document, const ProcessEntry& process,
                   std::span<const std::unique_ptr<Component>> components);

}  // namespace suture
