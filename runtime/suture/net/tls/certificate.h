#pragma once
// This says what is in the certificates of processes, and in which files they lie.

#include <suture/net/tls/openssl.h>

#include <filesystem>
#include <string>

namespace suture::tls {

/// The global manager's certificate has this name. No other process has it.
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

/// Returns until when `certificate` is valid, as "2028-11-29 10:00 UTC".
std::string endOf(const X509* certificate);

/// Returns true if that is within the next 30 days, or has been.
bool endsSoon(const X509* certificate);
/// Returns "ends at ...", with what to do if it ends soon. The text continues "the certificate of
/// ...".
std::string ending(const X509* certificate);

/// Say how to replace the certificate of one process, and the CA with all that it has signed.
inline constexpr const char* kReplaceCertificate =
    "remove the certificate and its key and make new ones with suture keys.";
inline constexpr const char* kReplaceCa =
    "make the keys of all processes anew with suture keys, in a new folder.";

/// Returns why the certificate that `check` has looked at does not prove what it says, and what to
/// do. The text continues "the certificate of ...".
std::string whyNot(X509_STORE_CTX* check);

/// Throw SetupError if there is no such file, if it holds no certificate or key, or if others can
/// read the key.
CertificatePtr readCertificate(const std::filesystem::path& file);
KeyPtr readKey(const std::filesystem::path& file);

/// Returns what OpenSSL last complained about in this thread, in its words, and empties its list.
std::string lastComplaint();

}  // namespace suture::tls
