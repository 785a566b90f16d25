#pragma once
// This is what a process proves its name with, and checks the certificates of others with.

#include <suture/net/tls/certificate.h>
#include <suture/net/tls/openssl.h>

#include <filesystem>
#include <string>

namespace suture::tls {

/// Any thread; constant once made. Holds the certificate and key of one process and the CA of its
/// system. The machine's own trust store is not used.
class Keys {
 public:
  /// Reads them from the folder that `suture keys` made. Throws SetupError if a file is missing or
  /// is not what it should be, if others can read the key, or if the certificate is not of this
  /// process, not of this CA, or not valid now.
  Keys(const std::filesystem::path& folder, std::string process);
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  const std::string& process() const { return process_; }
  /// Returns what ends within 30 days, and what to do before that; "": nothing does.
  const std::string& warning() const { return warning_; }

 private:
  friend class Session;

  static ContextPtr makeContext();
  void requireSound(X509* ca, X509* certificate) const;

  const KeyFiles files_;
  const std::string process_;
  std::string warning_;
  BioMethodPtr socket_;
  ContextPtr context_;
};

}  // namespace suture::tls
