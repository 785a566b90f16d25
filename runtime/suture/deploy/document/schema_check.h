#pragma once
// Checks a document against a JSON schema (draft 7), and says what is wrong in the schema's own
// words.

#include <suture/component/factory/json_reader.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace suture {

/// The text of schemas/deployment.schema.json, and of schemas/policy.schema.json.
const char* deploymentSchema();
const char* policySchema();

/// Every place where `value` breaks `schema`; a pointer and a text each. The schema may use type,
/// required, properties, items, enum, pattern and bounds of numbers and lengths, and describes each
/// property. Set-up code only.
std::vector<JsonProblem> checkSchema(const nlohmann::json& value, const nlohmann::json& schema);

}  // namespace suture
