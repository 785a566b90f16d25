#include "compiler/model/naming.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace suture::compiler::model {
namespace {

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }
bool isUpper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string camelCase(std::string_view cxxName) {
  std::string result;
  bool raise = false;
  for (const char c : cxxName) {
    if (c == '_') {
      raise = !result.empty();
    } else {
      result += raise ? upper(c) : c;
      raise = false;
    }
  }
  if (!result.empty()) result.front() = lower(result.front());
  return result;
}

std::string titleCase(std::string_view wireName) {
  std::string result(wireName);
  if (!result.empty()) result.front() = upper(result.front());
  return result;
}

std::string upperSnakeCase(std::string_view wireName) {
  std::string result;
  for (const char c : wireName) {
    if (isUpper(c) && !result.empty()) result += '_';
    result += upper(c);
  }
  if (result == "NULL") result += '_';  // capnp avoids the macro in the same way
  return result;
}

std::string unqualified(std::string_view cxxName) {
  const std::size_t colon = cxxName.rfind("::");
  return std::string(colon == std::string_view::npos ? cxxName : cxxName.substr(colon + 2));
}

std::string namespaceOf(std::string_view cxxName) {
  const std::size_t colon = cxxName.rfind("::");
  return std::string(colon == std::string_view::npos ? std::string_view{}
                                                     : cxxName.substr(0, colon));
}

std::optional<std::string> formerName(const std::string& name,
                                      const std::optional<std::string>& was) {
  if (!was || was->find("::") != std::string::npos) return was;
  const std::string space = namespaceOf(name);
  return (space.empty() ? "" : space + "::") + *was;
}

std::string wireNamespace(std::string_view cxxNamespace) {
  return cxxNamespace.empty() ? "wire" : std::string(cxxNamespace) + "::wire";
}

std::string stemOf(std::string_view headerPath) {
  const std::size_t dot = headerPath.rfind('.');
  const std::size_t slash = headerPath.rfind('/');
  const bool hasExtension =
      dot != std::string_view::npos && (slash == std::string_view::npos || dot > slash);
  return std::string(hasExtension ? headerPath.substr(0, dot) : headerPath);
}

std::string plainPath(std::string path) {
  std::replace_if(
      path.begin(), path.end(),
      [](char c) { return c != '/' && std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return path;
}

}  // namespace suture::compiler::model
