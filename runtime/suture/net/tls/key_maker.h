#pragma once
// Makes the CA and the certificates of a system: what `suture keys` does.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace suture::tls {

/// From when on, and for how long, a certificate holds.
struct Validity {
  std::chrono::seconds from = -std::chrono::hours(1);  ///< from now; clocks differ
  std::chrono::days lasts{730};
};

/// Adds to `folder` (made for its owner only) a certificate and a key for each of `processes`, and
/// before the first a CA that lasts ten years. Keys are Ed25519, in files of mode 0600. Throws
/// SetupError, having written nothing: a name that cannot be a file's, one that has a certificate
/// or a key already (nothing is overwritten), a CA without its key, a folder that others can enter.
/// Returns the files it has made.
std::vector<std::filesystem::path> makeKeys(const std::filesystem::path& folder,
                                            const std::vector<std::string>& processes,
                                            const Validity& validity = {});

}  // namespace suture::tls
