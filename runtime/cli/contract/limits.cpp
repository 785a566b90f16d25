#include "cli/contract/limits.h"
#include "cli/contract/type_text.h"

#include <algorithm>
#include <optional>

namespace suture::cli {
namespace {

/// Looks for the first value beyond a limit.
class Search {
 public:
  Search(const Json& contract, Errc error) : contract_(contract), error_(error) {}

  /// Looks at what the list `described` of parameters or fields says of the members of `values`.
  void members(const Json& described, const Json& values, const std::string& path) {
    for (const Json& one : described) {
      const std::string name = textAt(one, "name");
      const Json& value = valueAt(values, name.c_str());
      declared_ = &one;
      look(valueAt(one, "type"), value, path.empty() ? name : path + "." + name);
      if (!found_.empty()) return;
    }
  }

  const std::string& found() const { return found_; }

 private:
  // A peer may describe a type that holds itself, but what was typed has an end.
  void look(const Json& type, const Json& value, const std::string& path) {
    if (value.is_null()) return;
    const std::string kind = textAt(type, "kind");
    if (kind == "struct") return members(fieldsOf(textAt(type, "name")), value, path);
    if (value.is_string()) return measure(type, value.get<std::string>().size(), "bytes", path);
    if (value.is_number()) return compare(value, path);
    if (value.is_array()) measure(type, value.size(), "elements", path);
    if (!value.is_structured()) return;
    const Json& element = valueAt(type, "element");
    const Json* const declared = declared_;
    for (const auto& [key, part] : value.items()) {
      if (!found_.empty()) return;
      declared_ = declared;
      look(element, part, value.is_array() ? path + "[" + key + "]" : path + "." + key);
    }
  }

  void measure(const Json& type, std::size_t size, const char* what, const std::string& path) {
    const Json& capacity = valueAt(type, "capacity");
    if (error_ != Errc::TooLarge || !capacity.is_number_unsigned() ||
        size <= capacity.get<std::size_t>()) {
      return;
    }
    tell(path, "has " + std::to_string(size) + " " + what);
  }

  void compare(const Json& value, const std::string& path) {
    const Json& range = valueAt(*declared_, "range");
    if (error_ != Errc::Invalid || !range.is_array() || range.size() != 2) return;
    const double number = value.get<double>();
    const bool below = range[0].is_number() && number < range[0].get<double>();
    const bool above = range[1].is_number() && number > range[1].get<double>();
    if (below || above) tell(path, "is " + value.dump());
  }

  void tell(const std::string& path, const std::string& found) {
    if (!found_.empty()) return;
    found_ = "'" + path + "' " + found + ", and declared as " + valueTypeText(*declared_);
  }

  const Json& fieldsOf(const std::string& name) const {
    const Json& all = listAt(contract_, "structs");
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Json& one) { return textAt(one, "name") == name; });
    static const Json kNone = Json::array();
    return found == all.end() ? kNone : listAt(*found, "fields");
  }

  const Json& contract_;
  const Errc error_;
  const Json* declared_ = nullptr;  // has the range and the unit of what is looked at
  std::string found_;
};

}  // namespace

std::string beyondLimit(const Contract& contract, const Member& command, const Json& arguments,
                        Errc error) {
  Search search(contract.description(), error);
  search.members(listAt(command.description, "parameters"), arguments, "");
  return search.found();
}

}  // namespace suture::cli
