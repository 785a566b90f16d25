#pragma once
// A policy as data: schemas/policy.schema.json.

#include <suture/deploy/document/json_document.h>
#include <suture/names/policy.h>

#include <filesystem>

namespace suture {

/// What a policy file says. Throws DocumentError with every problem of the file. Set-up code only.
Policy readPolicy(const std::filesystem::path& file);
Policy readPolicy(const JsonDocument& document);

}  // namespace suture
