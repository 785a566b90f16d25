#include "cli/peer/names.h"
#include "cli/text/process_text.h"
#include "cli/text/screen.h"
#include "cli/verbs.h"

namespace suture::cli {
namespace {

std::string text(const ProcessRecord& process) {
  std::string line = plain(process.name) + "   pid " + std::to_string(process.pid) + "   host " +
                     plain(process.host);
  for (const std::string& address : process.addresses) line += "   " + plain(address);
  if (process.silent) line += "   silent";
  return line + "\n" + componentsText(process.components);
}

}  // namespace

int ps(rpc::EventPort& loop, const Options& options) {
  const auto processes = Names(loop, options).processes();
  if (options.json) {
    Json all = Json::array();
    for (const ProcessRecord& process : processes) all.push_back(toJson(process));
    printJson(all);
    return 0;
  }
  for (const ProcessRecord& process : processes) print(text(process));
  if (processes.empty()) print("No process is known to " + options.manager + ".\n");
  return 0;
}

}  // namespace suture::cli
