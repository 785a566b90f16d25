#include "cli/text/contract_text.h"
#include "cli/contract/type_text.h"
#include "cli/text/screen.h"

#include <algorithm>

namespace suture::cli {
namespace {

constexpr std::size_t kStep = 4;

std::string docText(const Json& described, unsigned indent) {
  std::string text = textAt(described, "doc");
  if (text.empty()) return "";
  const std::string margin(indent, ' ');
  for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    if (text[at + 1] != '\n') text.insert(at + 1, margin);
  }
  return margin + text + "\n";
}

std::string parametersText(const Json& parameters) {
  std::string text;
  for (const Json& one : parameters) {
    if (!text.empty()) text += ", ";
    const std::string name = textAt(one, "name");
    text += (name.empty() ? "" : name + ": ") + valueTypeText(one);
  }
  return text;
}

std::string commandText(const Json& command) {
  std::string text =
      textAt(command, "name") + "(" + parametersText(listAt(command, "parameters")) + ")";
  const Json& result = valueAt(command, "result");
  return result.is_object() ? text + " -> " + valueTypeText(result) : text;
}

std::string eventText(const Json& event) {
  const Json& payload = valueAt(event, "payload");
  return textAt(event, "name") + "(" +
         parametersText(payload.is_object() ? Json::array({payload}) : listAt(event, "payload")) +
         ")";
}

/// Returns "write, newest wins, ttl 20 ms".
std::string traitsText(const Json& member) {
  std::string text = textAt(member, "kind");
  const auto add = [&](const std::string& trait) { text += (text.empty() ? "" : ", ") + trait; };
  if (valueAt(member, "latest") == true) add("newest wins");
  if (valueAt(member, "latched") == true) add("latched");
  if (valueAt(member, "optional") == true) add("optional");
  for (const char* limit : {"ttl", "deadline"}) {
    const Json& seconds = valueAt(member, limit);
    if (seconds.is_number()) add(limit + (" " + milliseconds(seconds.get<double>() * 1e3)));
  }
  if (const Json& queue = valueAt(member, "queue"); queue.is_number_integer()) {
    const bool waits = textAt(member, "kind") != "read" && valueAt(member, "latest") != true;
    if (waits) add("queue " + queue.dump());
  }
  if (const std::string from = textAt(member, "from"); !from.empty()) add("from " + from);
  if (const std::string why = textAt(member, "deprecated"); !why.empty()) add("deprecated: " + why);
  return text;
}

std::string membersText(const char* title, const std::vector<Member>& members,
                        std::string (*signature)(const Json&)) {
  if (members.empty()) return "";
  std::string text = std::string(title) + "\n";
  for (const Member& member : members) {
    text += std::string(kStep, ' ') + signature(member.description) + "   " +
            traitsText(member.description) + "\n" + docText(member.description, 2 * kStep);
  }
  return text;
}

std::string fieldsText(const Json& described) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& field : listAt(described, "fields")) {
    std::string doc = textAt(field, "doc");
    std::replace(doc.begin(), doc.end(), '\n', ' ');  // a table has a line for each field
    rows.push_back({textAt(field, "name"), valueTypeText(field), doc});
  }
  return columns(rows, 2 * kStep);
}

std::string valuesText(const Json& described) {
  std::string text(2 * kStep, ' ');
  for (const Json& value : listAt(described, "enumerators")) {
    text += (text.size() > 2 * kStep ? ", " : "") + textAt(value, "name");
  }
  return text + "\n";
}

std::string typesText(const Json& description) {
  std::string text;
  for (const Json& one : listAt(description, "structs")) {
    text += std::string(kStep, ' ') + textAt(one, "name") + "\n" + docText(one, 2 * kStep) +
            fieldsText(one);
  }
  for (const Json& one : listAt(description, "enums")) {
    text += std::string(kStep, ' ') + "enum " + textAt(one, "name") + "\n" +
            docText(one, 2 * kStep) + valuesText(one);
  }
  return text.empty() ? "" : "types\n" + text;
}

}  // namespace

std::string contractText(const Contract& contract) {
  return plain(contract.name() + "\n" + docText(contract.description(), kStep) +
               membersText("commands", contract.commands(), commandText) +
               membersText("events", contract.events(), eventText) +
               typesText(contract.description()));
}

}  // namespace suture::cli
