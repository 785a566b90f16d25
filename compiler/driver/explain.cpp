#include "compiler/driver/explain.h"

#include <iostream>
#include <vector>

#include "compiler/model/nearest.h"

namespace suture::compiler::driver {

int explain(std::string_view slug) {
  constexpr std::string_view kPrefix = "suture-";
  if (slug.starts_with(kPrefix)) slug.remove_prefix(kPrefix.size());
  const auto& pages = diagnosticPages();
  if (const auto page = pages.find(slug); page != pages.end()) {
    std::cout << page->second;
    return 0;
  }
  std::vector<std::string_view> slugs;
  for (const auto& [known, text] : pages) slugs.push_back(known);
  std::cerr << "suturec: error: there is no diagnostic '" << slug << "'; ";
  if (const auto meant = model::nearest(slug, slugs)) {
    std::cerr << "did you mean '" << *meant << "'?\n";
  } else {
    std::cerr << "a message of suturec ends with the name of its own, as in [suture-pointer]\n";
  }
  return 1;
}

}  // namespace suture::compiler::driver
