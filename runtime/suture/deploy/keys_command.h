#pragma once
// `suture keys`: the certificates of a deployment.

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace suture {

/// What is asked for on the command line.
struct KeysRequest {
  std::string deployment;              ///< a file, of whose processes each gets keys
  std::vector<std::string> processes;  ///< further ones
  std::string out;
};

/// Adds "[--deployment FILE] [--process NAME]... --out DIR" to `keys`; what was given lands in
/// `request`, which outlives it.
void addKeysOptions(CLI::App& keys, KeysRequest& request);

/// Makes keys (suture/net/tls/key_maker.h) for the processes of the request and, with a CA
/// that is new, for the global manager. Returns the files it has made. Throws DocumentError or
/// SetupError.
std::vector<std::filesystem::path> makeKeys(const KeysRequest& request);

}  // namespace suture
