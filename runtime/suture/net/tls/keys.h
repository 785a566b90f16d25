#pragma once
// What a process proves its name with, and by what it judges others.

#include <suture/net/tls/certificate.h>
#include <suture/net/tls/openssl.h>

#include <filesystem>
#include <string>

namespace suture::tls {

/// The certificate and key of one process and the CA of its system; nothing of the machine's own
/// trust store counts. Constant once made; any thread.
class Keys {
 public:
  /// Reads them from the folder that `suture keys` made. Throws SetupError: a file is missing or no
  /// such thing, the key can be read by others, or the certificate is not of this process, not of
  /// this CA, or not valid now.
  Keys(const std::filesystem::path& folder, std::string process);
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  const std::string& process() const { return process_; }

 private:
  friend class Session;

  static ContextPtr makeContext();
  void requireSound(X509* ca, X509* certificate) const;

  const KeyFiles files_;
  const std::string process_;
  BioMethodPtr socket_;
  ContextPtr context_;
};

}  // namespace suture::tls
