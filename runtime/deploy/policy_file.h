#pragma once
// A policy as data: schemas/policy.schema.json.

#include <suture/deploy/json_document.h>
#include <suture/manager/policy.h>

#include <filesystem>

namespace suture {

/// What a policy file says. Throws DocumentError with every problem of the file. Set-up code only.
Policy readPolicy(const std::filesystem::path& file);
Policy readPolicy(const JsonDocument& document);

}  // namespace suture
