#pragma once
// These are the reference pages of docs/diagnostics, which the build puts into suturec.

#include <map>
#include <string>
#include <string_view>

namespace suture::compiler::driver {

/// Returns the text of each page, by slug. The build writes this function.
const std::map<std::string_view, std::string_view>& diagnosticPages();

/// Prints the page of a slug, with or without "suture-" before it. Returns the exit status; if
/// there is no such page, that is 1, and standard error says so, with the slug that is likely
/// meant.
int explain(std::string_view slug);

}  // namespace suture::compiler::driver
