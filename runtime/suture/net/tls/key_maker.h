#pragma once
// This makes the CA and the certificates of a system, as `suture keys` does.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace suture::tls {

/// Says from when on, and for how long, a certificate is valid. None is for longer than its CA.
struct Validity {
  std::chrono::seconds from = -std::chrono::hours(1);  ///< from now: earlier, as clocks differ
  std::chrono::days lasts{730};
};

/// A certificate of a CA lasts this long.
inline constexpr Validity kCaValidity{.lasts = std::chrono::days(3650)};

/// Adds to `folder` (made for its owner only) a certificate and a key for each of `processes`, and
/// before the first a CA. Keys are Ed25519, in files of mode 0600. Returns the files that it has
/// made. Throws SetupError, having written nothing, for a name that cannot be a file's, a name that
/// has a certificate or a key already (nothing is overwritten), a CA without its key or that has
/// ended, or a folder that others can enter.
std::vector<std::filesystem::path> makeKeys(const std::filesystem::path& folder,
                                            const std::vector<std::string>& processes,
                                            const Validity& validity = {},
                                            const Validity& ofCa = kCaValidity);

/// Returns when the CA in `folder` ends, as endOf() does, if certificates that are made now end
/// with it and so before they would by themselves; else "".
std::string shortenedTo(const std::filesystem::path& folder, const Validity& validity = {});

}  // namespace suture::tls
