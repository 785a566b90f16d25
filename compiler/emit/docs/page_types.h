#pragma once
// This writes the types of a reference page: in words where they are used, and the section of each.

#include <string>

#include "compiler/emit/text/context.h"
#include "compiler/emit/text/reachable_types.h"

namespace suture::compiler::emit {

/// Says what a page knows of the types that it shows.
class PageTypes {
 public:
  PageTypes(const Context& context, const Reached& shown) : context_(context), shown_(shown) {}

  /// Returns "list of `double`, at most 8"; a type that the page shows is a link.
  std::string words(const model::Type& type) const;
  /// Does the same for a type by its qualified name.
  std::string words(const std::string& name) const;
  /// Does the same with unit and range behind it: "`double`, m/s, from 0 to 2".
  std::string value(const model::Type& type, const model::Limits& limits) const;

  /// Returns the sections of all types that the page shows.
  std::string sections() const;

 private:
  std::string cxxWords(const model::Type& type) const;
  std::string sequence(const model::Type& type) const;
  std::string composite(const model::Type& type) const;
  std::string list(const model::Type& type, const char* separator) const;
  std::string heading(const std::string& name) const;
  std::string section(const model::Struct& declaration) const;
  std::string section(const model::Enum& declaration) const;

  const Context& context_;
  const Reached& shown_;
};

/// Returns "Since version 2. **Deprecated:** use move_jp." as far as something was said.
std::string lifecycleWords(const model::Lifecycle& lifecycle);

}  // namespace suture::compiler::emit
