#pragma once
// This says what is in the certificates of processes, and in which files they lie.

#include <suture/net/tls/openssl.h>

#include <filesystem>
#include <string>

namespace suture::tls {

/// Is the name in the global manager's certificate. No other process has this name.
inline constexpr const char* kManagerName = "suture-manager";

/// Names the files of a folder of keys. The machine of a process needs ca.crt and the two files
/// with the name of that process; ca.key stays where `suture keys` was run.
struct KeyFiles {
  std::filesystem::path folder;

  std::filesystem::path caCertificate() const { return folder / "ca.crt"; }
  std::filesystem::path caKey() const { return folder / "ca.key"; }
  std::filesystem::path certificate(const std::string& name) const {
    return folder / (name + ".crt");
  }
  std::filesystem::path key(const std::string& name) const { return folder / (name + ".key"); }
};

/// Stands before a process's name in its certificate (a URI, RFC 5280 4.2.1.6).
inline constexpr const char* kNameScheme = "suture:";

/// Returns the process that a certificate is for; "" if it names none, or several.
std::string processOf(const X509* certificate);

/// Returns why `certificate` does not prove what it says, for a verdict of OpenSSL
/// (X509_V_ERR_...), and what to do. The text continues "the certificate of ...".
std::string whyNot(const X509* certificate, long verdict);

/// Throw SetupError if there is no such file, if it holds no certificate or key, or if others can
/// read the key.
CertificatePtr readCertificate(const std::filesystem::path& file);
KeyPtr readKey(const std::filesystem::path& file);

/// Returns what OpenSSL last complained about in this thread, in its words, and empties its list.
std::string lastComplaint();

}  // namespace suture::tls
