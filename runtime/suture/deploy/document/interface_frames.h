#pragma once
// The coordinate frames that a deployment declares for interfaces of its components.

#include <suture/component/component.h>
#include <suture/deploy/document/deployment.h>

#include <memory>
#include <span>

namespace suture {

/// Tells each interface of `components`, which are in the order of `process`, what its frames are.
/// Before anything is connected. Throws DocumentError: no interface of that name, or its component
/// has declared other frames.
void declareFrames(const JsonDocument& document, const ProcessEntry& process,
                   std::span<const std::unique_ptr<Component>> components);

}  // namespace suture
