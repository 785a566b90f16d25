#pragma once
// This checks a document against a JSON schema (draft 7), and says what is wrong in the schema's
// own words.

#include <suture/component/factory/json_reader.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace suture {

/// Return the text of schemas/deployment.schema.json, and of schemas/policy.schema.json.
const char* deploymentSchema();
const char* policySchema();

/// Set-up code only. Returns every place where `value` breaks `schema`, as a pointer and a text.
/// The schema may use type, required, properties, items, enum, pattern and bounds of numbers and
/// lengths, and describes each property.
std::vector<JsonProblem> checkSchema(const nlohmann::json& value, const nlohmann::json& schema);

}  // namespace suture
