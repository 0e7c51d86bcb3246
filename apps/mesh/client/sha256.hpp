#pragma once
// The hash SHA-256, by which what is kept is found again and recognised.

#include <memory>
#include <string>
#include <string_view>

struct SHA256state_st;  // of OpenSSL

namespace armlet::mesh {

// source  NIST, FIPS 180-4, Secure Hash Standard, 2015, section 6.2.
class Sha256 {
 public:
  Sha256();
  ~Sha256();

  void add(std::string_view bytes);
  // The bytes and how many they are, so that what follows is kept apart from them.
  void add_text(std::string_view text);
  // 64 digits to the base 16. Nothing is added after it.
  [[nodiscard]] std::string digits();

 private:
  std::unique_ptr<SHA256state_st> state_;
};

std::string sha256(std::string_view bytes);

}  // namespace armlet::mesh
