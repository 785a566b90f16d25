#include <openssl/err.h>
#include <openssl/pem.h>
#include <suture/base/errors.h>
#include <suture/net/tls/certificate.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <string_view>

namespace suture::tls {
namespace {

using NamesPtr = std::unique_ptr<GENERAL_NAMES, Free<GENERAL_NAMES_free>>;

constexpr const char* kMakeKeys = "Make keys with suture keys, and give the folder's path.";

std::string textOf(const ASN1_TIME* time) {
  tm date{};
  if (ASN1_TIME_to_tm(time, &date) != 1) return "an unknown time";
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M UTC", &date);
  return text;
}

/// Says how to make one file of a folder that has a CA.
std::string remedyForMissing(const std::filesystem::path& file) {
  const KeyFiles files{file.parent_path()};
  const std::string process = file.stem();
  std::error_code unknown;  // then the folder is told
  const auto exists = [&](const std::filesystem::path& one) {
    return std::filesystem::exists(one, unknown);
  };
  if (exists(file) || !exists(files.caCertificate()) || file == files.caKey()) return kMakeKeys;
  const std::string command =
      "`suture keys --process " + process + " --out " + files.folder.string() + "`";
  if (exists(files.certificate(process))) {
    return "Remove the certificate beside it, and make both with " + command;
  }
  return "Make it and its key with " + command;
}

BioPtr contentOf(const std::filesystem::path& file) {
  BioPtr content(BIO_new_file(file.c_str(), "r"));
  if (content == nullptr) {
    const std::string found = std::strerror(errno);
    ERR_clear_error();
    throw SetupError("read " + file.string(), found, remedyForMissing(file));
  }
  return content;
}

void requireOwn(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || (status.st_mode & (S_IRWXG | S_IRWXO)) == 0) return;
  throw SetupError("use the key " + file.string(), "other users of this machine can read it",
                   "Make new keys, and keep this file to its owner: chmod 600 " + file.string());
}

}  // namespace

std::string processOf(const X509* certificate) {
  const NamesPtr names(static_cast<GENERAL_NAMES*>(
      X509_get_ext_d2i(certificate, NID_subject_alt_name, nullptr, nullptr)));
  if (names == nullptr || sk_GENERAL_NAME_num(names.get()) != 1) return "";
  const GENERAL_NAME* const name = sk_GENERAL_NAME_value(names.get(), 0);
  if (name->type != GEN_URI) return "";
  const ASN1_IA5STRING* const uri = name->d.uniformResourceIdentifier;
  const std::string_view text(reinterpret_cast<const char*>(ASN1_STRING_get0_data(uri)),
                              static_cast<std::size_t>(ASN1_STRING_length(uri)));
  if (!text.starts_with(kNameScheme)) return "";
  return std::string(text.substr(std::strlen(kNameScheme)));
}

std::string endOf(const X509* certificate) { return textOf(X509_get0_notAfter(certificate)); }

bool endsSoon(const X509* certificate) {
  const auto soon = std::chrono::system_clock::now() + std::chrono::days(30);
  std::time_t limit = std::chrono::system_clock::to_time_t(soon);
  return X509_cmp_time(X509_get0_notAfter(certificate), &limit) < 0;
}

std::string ending(const X509* certificate) {
  const std::string ends = "ends at " + endOf(certificate);
  return endsSoon(certificate) ? ends + ". Before that, " + kReplaceCertificate : ends;
}

// The CA ends as certificates do, and then new certificates of it do not help.
std::string whyNot(X509_STORE_CTX* check) {
  const X509* const failed = X509_STORE_CTX_get_current_cert(check);
  const bool isCa = X509_STORE_CTX_get_error_depth(check) > 0;
  const std::string whose = isCa ? "is of a CA (ca.crt) that " : "";
  const int verdict = X509_STORE_CTX_get_error(check);
  switch (verdict) {
    case X509_V_ERR_CERT_HAS_EXPIRED:
      return whose + "expired at " + endOf(failed) + ". Check the clock; if it is right, " +
             (isCa ? kReplaceCa : kReplaceCertificate);
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return whose + "is valid from " + textOf(X509_get0_notBefore(failed)) +
             " on. Set the clocks of both machines.";
    case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
    case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
    case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
    case X509_V_ERR_CERT_SIGNATURE_FAILURE:
      return "is not signed by this system's CA. Make the keys of all its processes with the same "
             "ca.crt.";
    default:
      return std::string("does not hold: ") + X509_verify_cert_error_string(verdict) +
             ". Make a new one with suture keys.";
  }
}

CertificatePtr readCertificate(const std::filesystem::path& file) {
  const BioPtr content = contentOf(file);
  CertificatePtr certificate(PEM_read_bio_X509(content.get(), nullptr, nullptr, nullptr));
  if (certificate != nullptr) return certificate;
  throw SetupError("read the certificate in " + file.string(), lastComplaint(), kMakeKeys);
}

KeyPtr readKey(const std::filesystem::path& file) {
  const BioPtr content = contentOf(file);
  requireOwn(file);
  // Never asks for a passphrase, because nobody is at the keyboard when a process of a robot
  // starts.
  const auto noPassphrase = [](char*, int, int, void*) { return -1; };
  KeyPtr key(PEM_read_bio_PrivateKey(content.get(), nullptr, noPassphrase, nullptr));
  if (key != nullptr) return key;
  throw SetupError("read the key in " + file.string(), lastComplaint(), kMakeKeys);
}

std::string lastComplaint() {
  const unsigned long first = ERR_get_error();
  const char* const reason = ERR_reason_error_string(first);
  ERR_clear_error();
  return reason != nullptr ? reason : "OpenSSL does not say what is wrong";
}

}  // namespace suture::tls
