#pragma once
// Messages of the language reference.

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace armlet {

// The block as it stands in the reference, without the line that says where it comes from.
inline std::string reference_message(const std::string& code) {
  std::ifstream file(std::string(ARMLET_REFERENCE_DIR) + "/messages/" + code + ".txt");
  REQUIRE_MESSAGE(file, "no sample for " << code);
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  std::ostringstream block;
  block << file.rdbuf();
  return block.str();
}

}  // namespace armlet
