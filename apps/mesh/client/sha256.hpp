#pragma once
// The hash SHA-256, by which stored results are found and checked.

#include <memory>
#include <string>
#include <string_view>

struct SHA256state_st;  // from OpenSSL

namespace armlet::mesh {

// source  NIST, FIPS 180-4, Secure Hash Standard, 2015, section 6.2.
class Sha256 {
 public:
  Sha256();
  ~Sha256();

  void add(std::string_view bytes);
  // Adds the bytes and their number, so that they cannot be confused with the text that follows.
  void add_text(std::string_view text);
  // The hash as 64 hexadecimal digits. Nothing can be added after this call.
  [[nodiscard]] std::string digits();

 private:
  std::unique_ptr<SHA256state_st> state_;
};

std::string sha256(std::string_view bytes);

}  // namespace armlet::mesh
