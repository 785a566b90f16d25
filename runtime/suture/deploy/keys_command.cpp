#include <suture/base/errors.h>
#include <suture/deploy/document/deployment.h>
#include <suture/deploy/keys_command.h>
#include <suture/net/tls/certificate.h>
#include <suture/net/tls/key_maker.h>
#include <suture/net/tls/keys.h>

#include <CLI/CLI.hpp>

namespace suture {

void addKeysOptions(CLI::App& keys, KeysRequest& request) {
  keys.add_option("--deployment", request.deployment,
                  "The deployment file (JSON): each of its processes gets keys");
  keys.add_option("--process", request.processes, "A process that gets keys, by name");
  keys.add_option("--out", request.out,
                  "Their folder; the CA in it is used again, and no file is overwritten")
      ->required();
  keys.final_callback([&request] {
    if (!request.deployment.empty() || !request.processes.empty()) return;
    throw CLI::RequiredError("--deployment FILE or --process NAME");
  });
}

std::vector<std::filesystem::path> makeKeys(const KeysRequest& request) {
  std::vector<std::string> names = request.processes;
  if (!request.deployment.empty()) {
    const Deployment deployment(JsonDocument::read(request.deployment));
    for (const ProcessEntry& process : deployment.processes()) names.push_back(process.name);
  }
  std::error_code unknown;  // makeKeys() says what is wrong with a folder that cannot be looked at
  const bool first = !std::filesystem::exists(tls::KeyFiles{request.out}.caCertificate(), unknown);
  if (first) names.push_back(tls::kManagerName);
  return tls::makeKeys(request.out, names);
}

std::string shortLife(const KeysRequest& request) {
  const std::string end = tls::shortenedTo(request.out);
  if (end.empty()) return "";
  return "These certificates end at " + end +
         ", which is sooner than usual, because their CA does. " + "Before that, " +
         tls::kReplaceCa;
}

}  // namespace suture
