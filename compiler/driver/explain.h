#pragma once
// The reference pages of docs/diagnostics, which the build puts into suturec.

#include <map>
#include <string>
#include <string_view>

namespace suture::compiler::driver {

/// The text of each page, by slug. Written by the build.
const std::map<std::string_view, std::string_view>& diagnosticPages();

/// Prints the page of a slug, with or without "suture-" before it. The exit status: 1, and the
/// nearest slug on standard error, if there is none.
int explain(std::string_view slug);

}  // namespace suture::compiler::driver
