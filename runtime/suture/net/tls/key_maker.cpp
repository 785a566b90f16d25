#include <fcntl.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <suture/base/errors.h>
#include <suture/net/tls/certificate.h>
#include <suture/net/tls/key_maker.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <set>
#include <string_view>

namespace suture::tls {
namespace {

namespace fs = std::filesystem;
using BignumPtr = std::unique_ptr<BIGNUM, Free<BN_free>>;
using ExtensionPtr = std::unique_ptr<X509_EXTENSION, Free<X509_EXTENSION_free>>;

constexpr const char* kCaName = "Suture CA";

void require(bool done, const std::string& what) {
  if (!done) throw SetupError(what, lastComplaint(), "Check the installation of OpenSSL 3.");
}

/// An Identity is a certificate and the key that belongs to it.
struct Identity {
  CertificatePtr certificate;
  KeyPtr key;
};

KeyPtr makeKey() {
  KeyPtr key(EVP_PKEY_Q_keygen(nullptr, nullptr, "ED25519"));
  require(key != nullptr, "make a key");
  return key;
}

void extend(X509* certificate, X509* issuer, int which, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
  const ExtensionPtr extension(X509V3_EXT_conf_nid(nullptr, &context, which, value.c_str()));
  require(extension != nullptr && X509_add_ext(certificate, extension.get(), -1) == 1,
          "make a certificate");
}

void setSerial(X509* certificate) {
  const BignumPtr number(BN_new());
  require(BN_rand(number.get(), 127, BN_RAND_TOP_ANY, BN_RAND_BOTTOM_ANY) == 1 &&
              BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate)) != nullptr,
          "number a certificate");
}

void setTimes(X509* certificate, const Validity& validity) {
  const auto end = validity.from + std::chrono::seconds(validity.lasts);
  X509_gmtime_adj(X509_getm_notBefore(certificate), static_cast<long>(validity.from.count()));
  X509_gmtime_adj(X509_getm_notAfter(certificate), static_cast<long>(end.count()));
}

/// Makes a certificate that has neither extensions nor a signature yet.
CertificatePtr beginCertificate(const std::string& name, EVP_PKEY* key, const Validity& validity) {
  CertificatePtr certificate(X509_new());
  require(certificate != nullptr && X509_set_version(certificate.get(), X509_VERSION_3) == 1 &&
              X509_set_pubkey(certificate.get(), key) == 1,
          "make a certificate");
  setSerial(certificate.get());
  setTimes(certificate.get(), validity);
  // A common name has at most 64 characters (RFC 5280 A.1); the name that counts is the URI.
  const std::string shown = name.substr(0, 64);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(shown.c_str());
  require(X509_NAME_add_entry_by_txt(X509_get_subject_name(certificate.get()), "CN", MBSTRING_UTF8,
                                     bytes, -1, -1, 0) == 1,
          "name a certificate");
  return certificate;
}

void sign(X509* certificate, const X509* issuer, EVP_PKEY* key) {
  require(X509_set_issuer_name(certificate, X509_get_subject_name(issuer)) == 1 &&
              X509_sign(certificate, key, nullptr) != 0,
          "sign a certificate");
}

Identity makeCa(const Validity& validity) {
  KeyPtr key = makeKey();
  CertificatePtr ca = beginCertificate(kCaName, key.get(), validity);
  X509* const raw = ca.get();
  extend(raw, raw, NID_basic_constraints, "critical,CA:TRUE,pathlen:0");
  extend(raw, raw, NID_key_usage, "critical,keyCertSign");
  extend(raw, raw, NID_subject_key_identifier, "hash");
  sign(raw, raw, key.get());
  return {std::move(ca), std::move(key)};
}

Identity makeIdentity(const std::string& process, const Identity& ca, const Validity& validity) {
  KeyPtr key = makeKey();
  CertificatePtr certificate = beginCertificate(process, key.get(), validity);
  X509* const raw = certificate.get();
  X509* const issuer = ca.certificate.get();
  const ASN1_TIME* const last = X509_get0_notAfter(issuer);
  if (ASN1_TIME_compare(X509_get0_notAfter(raw), last) > 0) {
    require(X509_set1_notAfter(raw, last) == 1, "make a certificate");
  }
  extend(raw, issuer, NID_basic_constraints, "critical,CA:FALSE");
  extend(raw, issuer, NID_key_usage, "critical,digitalSignature");
  extend(raw, issuer, NID_ext_key_usage, "serverAuth,clientAuth");
  extend(raw, issuer, NID_authority_key_identifier, "keyid");
  extend(raw, issuer, NID_subject_alt_name, "URI:" + std::string(kNameScheme) + process);
  sign(raw, issuer, ca.key.get());
  return {std::move(certificate), std::move(key)};
}

// Returns false for a name with characters that have a meaning in a path or in OpenSSL's notation
// of names.
bool isName(const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char one) {
    return std::isalnum(one) || one == '_' || one == '-' || one == '.';
  });
  return plain && !name.empty() && name.size() <= 100 && name[0] != '.' && name != "ca";
}

void requireFree(const KeyFiles& files, const std::vector<std::string>& processes) {
  for (const std::string& process : processes) {
    const std::string asked = "make the keys of process '" + process + "'";
    if (!isName(process)) {
      throw SetupError(asked,
                       "its name has to have 1 to 100 letters, digits, '_', '-' and '.', not begin "
                       "with '.', and not be 'ca'",
                       "Choose another name for the process.");
    }
    for (const fs::path& file : {files.certificate(process), files.key(process)}) {
      std::error_code unknown;
      if (!fs::exists(fs::symlink_status(file, unknown))) continue;
      throw SetupError(
          asked, file.string() + " exists, and nothing is overwritten",
          "Name only processes that were added, by --process NAME; remove the files of "
          "one that is to have new keys.");
    }
  }
}

void makeFolder(const fs::path& folder) {
  const std::string asked = "keep keys in " + folder.string();
  if (mkdir(folder.c_str(), S_IRWXU) == 0) return;
  if (errno != EEXIST) {
    throw SetupError(asked, std::strerror(errno), "Give a folder in one that exists.");
  }
  struct stat status {};
  const bool folderOfOurs = stat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
                            (status.st_uid == geteuid() || status.st_uid == 0);
  if (!folderOfOurs) throw SetupError(asked, "it is no folder of yours", "Give another.");
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) == 0) return;
  throw SetupError(asked, "other users of this machine can enter it",
                   "Keep it to its owner: chmod 700 " + folder.string());
}

Identity readCa(const KeyFiles& files) {
  if (!fs::exists(files.caKey())) {
    throw SetupError("make keys in " + files.folder.string(),
                     "there is a CA (ca.crt) without its key (ca.key)",
                     "Run this where the CA was made, or give a new folder for a new one.");
  }
  Identity ca{readCertificate(files.caCertificate()), readKey(files.caKey())};
  const X509* const certificate = ca.certificate.get();
  if (X509_cmp_current_time(X509_get0_notAfter(certificate)) > 0) return ca;
  throw SetupError("make keys in " + files.folder.string(),
                   "its CA (ca.crt) expired at " + endOf(certificate),
                   std::string("Check the clock; if it is right, ") + kReplaceCa);
}

/// Writes new files, and removes them again if the last one could not be written.
class NewFiles {
 public:
  ~NewFiles() {
    if (kept_) return;
    for (const fs::path& file : files_) unlink(file.c_str());
  }

  void write(const fs::path& certificate, const fs::path& key, const Identity& identity) {
    write(key, S_IRUSR | S_IWUSR, [&](BIO* out) {
      return PEM_write_bio_PrivateKey(out, identity.key.get(), nullptr, nullptr, 0, nullptr,
                                      nullptr);
    });
    write(certificate, S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH,
          [&](BIO* out) { return PEM_write_bio_X509(out, identity.certificate.get()); });
  }

  std::vector<fs::path> keep() {
    kept_ = true;
    return files_;
  }

 private:
  template <class Fill>
  void write(const fs::path& path, mode_t mode, Fill fill) {
    const BioPtr text(BIO_new(BIO_s_mem()));
    require(text != nullptr && fill(text.get()) == 1, "write " + path.string());
    char* bytes = nullptr;
    const long size = BIO_get_mem_data(text.get(), &bytes);
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (file < 0) refuse(path, errno);
    files_.push_back(path);
    const int error = errorOf(file, {bytes, static_cast<std::size_t>(size)});
    close(file);
    if (error != 0) refuse(path, error);
  }

  /// Returns the errno of what keeps `text` from being written; 0 if all of it is.
  static int errorOf(int file, std::string_view text) {
    while (!text.empty()) {
      const ssize_t taken = ::write(file, text.data(), text.size());
      if (taken < 0 && errno != EINTR) return errno;
      if (taken > 0) text.remove_prefix(static_cast<std::size_t>(taken));
    }
    return 0;
  }

  [[noreturn]] static void refuse(const fs::path& path, int error) {
    throw SetupError("write " + path.string(), std::strerror(error), "Give another folder.");
  }

  std::vector<fs::path> files_;
  bool kept_ = false;
};

}  // namespace

std::vector<fs::path> makeKeys(const fs::path& folder, const std::vector<std::string>& processes,
                               const Validity& validity, const Validity& ofCa) {
  const KeyFiles files{folder};
  const std::set<std::string> names(processes.begin(), processes.end());
  requireFree(files, processes);
  makeFolder(folder);
  const bool hasCa = fs::exists(files.caCertificate());
  const Identity ca = hasCa ? readCa(files) : makeCa(ofCa);
  NewFiles made;
  if (!hasCa) made.write(files.caCertificate(), files.caKey(), ca);
  for (const std::string& name : names) {
    made.write(files.certificate(name), files.key(name), makeIdentity(name, ca, validity));
  }
  return made.keep();
}

std::string shortenedTo(const fs::path& folder, const Validity& validity) {
  const CertificatePtr ca = readCertificate(KeyFiles{folder}.caCertificate());
  const auto end = std::chrono::system_clock::now() + validity.from + validity.lasts;
  std::time_t limit = std::chrono::system_clock::to_time_t(end);
  return X509_cmp_time(X509_get0_notAfter(ca.get()), &limit) < 0 ? endOf(ca.get()) : "";
}

}  // namespace suture::tls
