#include "cli/text/screen.h"
#include "cli/verbs.h"

#include <string>
#include <utility>

namespace suture::cli {

int makeKeys(loop::EventPort&, const Options& options) {
  const auto files = suture::makeKeys(options.newKeys);
  const std::string shortened = suture::shortLife(options.newKeys);
  if (options.json) {
    Json made = Json::array();
    for (const auto& file : files) made.push_back(file.string());
    Json told{{"made", std::move(made)}};
    if (!shortened.empty()) told["warning"] = shortened;
    printJson(told);
  } else {
    for (const auto& file : files) print("made " + file.string() + "\n");
    if (!shortened.empty()) print(shortened + "\n");
  }
  return 0;
}

}  // namespace suture::cli
