#pragma once
// This is a policy as data: schemas/policy.schema.json.

#include <suture/deploy/document/json_document.h>
#include <suture/names/policy.h>

#include <filesystem>

namespace suture {

/// Set-up code only. Reads a policy file. Throws DocumentError with every problem of the file.
Policy readPolicy(const std::filesystem::path& file);
Policy readPolicy(const JsonDocument& document);

}  // namespace suture
