#include "cli/text/screen.h"
#include "cli/verbs.h"

namespace suture::cli {

int makeKeys(rpc::EventPort&, const Options& options) {
  const auto files = suture::makeKeys(options.newKeys);
  if (options.json) {
    Json made = Json::array();
    for (const auto& file : files) made.push_back(file.string());
    printJson({{"made", std::move(made)}});
  } else {
    for (const auto& file : files) print("made " + file.string() + "\n");
  }
  return 0;
}

}  // namespace suture::cli
