#pragma once
// Certificates of processes: what is in them and in which files they lie.

#include <suture/net/tls/openssl.h>

#include <filesystem>
#include <string>

namespace suture::tls {

/// The name in the global manager's certificate. No other process is called so.
inline constexpr const char* kManagerName = "suture-manager";

/// The files of a folder of keys. To the machine of a process belong ca.crt and the two files with
/// its name; ca.key stays where `suture keys` was run.
struct KeyFiles {
  std::filesystem::path folder;

  std::filesystem::path caCertificate() const { return folder / "ca.crt"; }
  std::filesystem::path caKey() const { return folder / "ca.key"; }
  std::filesystem::path certificate(const std::string& name) const {
    return folder / (name + ".crt");
  }
  std::filesystem::path key(const std::string& name) const { return folder / (name + ".key"); }
};

/// What stands before a process's name in its certificate (a URI, RFC 5280 4.2.1.6).
inline constexpr const char* kNameScheme = "suture:";

/// The process that a certificate is for; "" if it names none, or several.
std::string processOf(const X509* certificate);

/// Why `certificate` does not prove what it says, for a verdict of OpenSSL's (X509_V_ERR_...), and
/// what to do: goes on after "the certificate of ...".
std::string whyNot(const X509* certificate, long verdict);

/// Throw SetupError: no such file, no certificate or key in it, or a key that others can read.
CertificatePtr readCertificate(const std::filesystem::path& file);
KeyPtr readKey(const std::filesystem::path& file);

/// What OpenSSL last complained about in this thread, in its words; empties its list.
std::string lastComplaint();

}  // namespace suture::tls
