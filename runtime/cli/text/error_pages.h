#pragma once
// These are the pages of docs/errors, which the build puts into `suture`.

#include <map>
#include <string>
#include <string_view>

namespace suture::cli {

/// Returns the text of each page, by its name: "not-yet". The build writes this function.
const std::map<std::string_view, std::string_view>& errorPages();

/// Returns the page of an error of a call, or what the list of set-up errors says of a message; ""
/// if there is neither. `words` are the error's name ("NotYet"), that of its page ("not-yet"), its
/// text ("not produced yet"), or a message that has this text.
std::string explainError(const std::string& words);

/// Returns the command that explains a message of set-up, or "" if no row is about it.
std::string whatToAsk(const std::string& message);

}  // namespace suture::cli
