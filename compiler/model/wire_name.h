#pragma once
// From C++ names to the names that Cap'n Proto accepts: no underscores, a letter first, its case fixed
// by what is named.

#include <cctype>
#include <string>
#include <string_view>

namespace suture::compiler::model {

/// Joins the words of a name that underscores separate; a word of capitals only loses them, so that
/// POWER_ON and power_on agree: "servo_cp" -> "ServoCp".
inline std::string wireTypeName(std::string_view name) {
  const auto upper = [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); };
  const auto lower = [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); };
  std::string joined;
  while (!name.empty()) {
    const std::string_view word = name.substr(0, name.find('_'));
    const bool shouting =
        word.size() > 1 && word.find_first_of("abcdefghijklmnopqrstuvwxyz") == word.npos;
    for (std::size_t i = 0; i < word.size(); ++i) {
      joined += i == 0 ? upper(word[i]) : shouting ? lower(word[i]) : word[i];
    }
    name.remove_prefix(word.size() == name.size() ? word.size() : word.size() + 1);
  }
  return joined;
}

/// The same with a small first letter: "servo_cp" -> "servoCp", "DISABLED" -> "disabled".
inline std::string wireMemberName(std::string_view name) {
  std::string joined = wireTypeName(name);
  if (!joined.empty()) {
    joined[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(joined[0])));
  }
  return joined;
}

}  // namespace suture::compiler::model
