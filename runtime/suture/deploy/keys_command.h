#pragma once
// `suture keys` makes the certificates of a deployment.

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace suture {

/// A KeysRequest is what is asked for on the command line.
struct KeysRequest {
  std::string deployment;              ///< a file; each of its processes gets keys
  std::vector<std::string> processes;  ///< further ones
  std::string out;
};

/// Adds "[--deployment FILE] [--process NAME]... --out DIR" to `keys`; the values go to `request`,
/// which outlives it.
void addKeysOptions(CLI::App& keys, KeysRequest& request);

/// Returns in a sentence until when the certificates are valid that makeKeys() has made, if their
/// CA has shortened that; else "".
std::string shortLife(const KeysRequest& request);

/// Makes keys (suture/net/tls/key_maker.h) for the processes of the request and, if the CA is new,
/// for the global manager. Returns the files that it has made. Throws DocumentError or SetupError.
std::vector<std::filesystem::path> makeKeys(const KeysRequest& request);

}  // namespace suture
