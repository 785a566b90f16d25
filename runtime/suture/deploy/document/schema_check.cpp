#include <suture/base/nearest.h>
#include <suture/deploy/document/document_problems.h>
#include <suture/deploy/document/json_document.h>
#include <suture/deploy/document/schema_check.h>

#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace suture {
namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// Says where valijson found something wrong: the value, and the part of the schema that it breaks.
struct Place {
  const json* value;
  const json* schema;
  std::string pointer;
};

// Returns the schema of a key: its own, or that of all keys; nullptr if it may be anything.
const json* schemaOf(const std::string& key, const json& schema) {
  const auto properties = schema.find("properties");
  if (properties == schema.end()) {
    const auto all = schema.find("additionalProperties");
    return all == schema.end() || !all->is_object() ? nullptr : &*all;
  }
  const auto own = properties->find(key);
  return own == properties->end() ? nullptr : &*own;
}

// valijson's context is "<root>", then "[key]" or "[index]" for each step.
Place placeOf(const std::vector<std::string>& context, const json& value, const json& schema) {
  Place place{&value, &schema, ""};
  for (std::size_t i = 1; i < context.size(); ++i) {
    const std::string step = context[i].substr(1, context[i].size() - 2);
    place.pointer = childPointer(place.pointer, step);
    if (place.value->is_array()) {
      place.value = &place.value->at(std::stoul(step));
      place.schema = &place.schema->at("items");
    } else {
      place.value = &place.value->at(step);
      place.schema = schemaOf(step, *place.schema);
    }
  }
  return place;
}

std::string shortly(const json& value) {
  constexpr std::size_t kLongest = 60;
  const std::string text = value.dump();
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

/// Returns the keys of a place from the last list on, as in "'contract.max_age': "; "": there is
/// none.
std::string keysOf(const std::string& pointer) {
  std::string keys;
  const json::json_pointer all(pointer);
  for (json::json_pointer rest = all; !rest.empty(); rest.pop_back()) {
    const std::string& key = rest.back();
    if (key.find_first_not_of("0123456789") == std::string::npos) break;
    keys = keys.empty() ? key : key + "." + keys;
  }
  return keys.empty() ? "" : "'" + keys + "': ";
}

bool isTime(const Place& place) {
  const std::string pattern = place.schema->value("pattern", "");
  return pattern.ends_with("(ns|us|ms|s)$") && !place.value->is_object();
}

std::string expectation(const Place& place) {
  const std::string meant = isTime(place) ? "a time with its unit, such as \"10ms\""
                                          : place.schema->at("description").get<std::string>();
  return keysOf(place.pointer) + "expected " + meant + "; found " + place.value->type_name() + " " +
         shortly(*place.value);
}

void reportUnknownKeys(const Place& place, std::vector<JsonProblem>& problems) {
  std::vector<std::string> known;
  for (const auto& [key, unused] : place.schema->at("properties").items()) known.push_back(key);
  for (const auto& [key, unused] : place.value->items()) {
    if (place.schema->at("properties").contains(key)) continue;
    const std::string nearest = nearestName(key, known);
    problems.push_back({childPointer(place.pointer, key),
                        "unknown key '" + key + "'; " +
                            (nearest.empty() ? "known are " + listNames(known)
                                             : "did you mean '" + nearest + "'?")});
  }
}

void reportMissingKeys(const Place& place, std::vector<JsonProblem>& problems) {
  for (const json& key : place.schema->at("required")) {
    const auto name = key.get<std::string>();
    if (place.value->contains(name)) continue;
    problems.push_back(
        {place.pointer,
         "key '" + name + "' is missing; it is " +
             place.schema->at("properties").at(name).at("description").get<std::string>()});
  }
}

void report(const std::string& description, const Place& place,
            std::vector<JsonProblem>& problems) {
  // valijson names one key at a time, and stops at the first unknown one.
  if (description.starts_with("Object contains a property")) {
    reportUnknownKeys(place, problems);
  } else if (description.starts_with("Missing required property")) {
    reportMissingKeys(place, problems);
  } else {
    problems.push_back({place.pointer, expectation(place)});
  }
}

// std::regex calls itself for each character, and so has no stack left for a long text.
void reportLongTexts(const Place& place, std::vector<JsonProblem>& problems) {
  constexpr std::size_t kMost = 1024;
  const json& value = *place.value;
  const json& schema = *place.schema;
  if (value.is_string() && schema.contains("pattern")) {
    const std::size_t size = value.get_ref<const std::string&>().size();
    if (size <= kMost) return;
    problems.push_back({place.pointer, "a text of " + std::to_string(size) +
                                           " characters is longer than " + std::to_string(kMost) +
                                           ", which is the most here; shorten it"});
  } else if (value.is_array() && schema.contains("items")) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      reportLongTexts({&value[i], &schema.at("items"), place.pointer + "/" + std::to_string(i)},
                      problems);
    }
  } else if (value.is_object()) {
    for (const auto& [key, child] : value.items()) {
      const json* const below = schemaOf(key, schema);
      if (below == nullptr) continue;
      reportLongTexts({&child, below, childPointer(place.pointer, key)}, problems);
    }
  }
}

// Returns true for what valijson adds about each level around the place where something is wrong.
bool isConsequence(const std::string& description) {
  return description.starts_with("Failed to validate ");
}

// Returns every place where `value` breaks `schema`, as a pointer and a text.
std::vector<JsonProblem> checkSchema(const json& value, const json& schema) {
  std::vector<JsonProblem> problems;
  reportLongTexts({&value, &schema, ""}, problems);
  if (!problems.empty()) return problems;
  valijson::Schema compiled;
  valijson::SchemaParser().populateSchema(Adapter(schema), compiled);
  valijson::ValidationResults results;
  valijson::Validator().validate(compiled, Adapter(value), &results);

  std::vector<std::string> last;  // the same key of the same place is reported once
  for (const auto& error : results) {
    std::vector<std::string> key = error.context;
    key.push_back(error.description.substr(0, error.description.find('\'')));
    if (isConsequence(error.description) || key == last) continue;
    last = std::move(key);
    report(error.description, placeOf(error.context, value, schema), problems);
  }
  return problems;
}

}  // namespace

void requireSchema(const JsonDocument& document, const char* schema) {
  DocumentProblems problems(document);
  for (const JsonProblem& problem : checkSchema(document.value(), json::parse(schema))) {
    problems.report(problem.pointer, problem.text);
  }
  problems.throwIfAny();
}

}  // namespace suture
