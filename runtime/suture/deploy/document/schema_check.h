#pragma once
// This checks a document against a JSON schema (draft 7), and says what is wrong in the schema's
// own words.

#include <suture/deploy/document/json_document.h>

namespace suture {

/// Return the text of schemas/deployment.schema.json, and of schemas/policy.schema.json.
const char* deploymentSchema();
const char* policySchema();

/// Set-up code only. Throws DocumentError with every place where `document` breaks `schema`, which
/// may use type, required, properties, items, enum, pattern and bounds of numbers and lengths, and
/// describes each property.
void requireSchema(const JsonDocument& document, const char* schema);

}  // namespace suture
