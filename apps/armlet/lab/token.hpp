#pragma once
// The token of a laboratory that is to have the same one each time.

#include <string>

#include "commands.hpp"

namespace armlet::cli {

// token    of --token-file, else of the variable ARMLET_LAB_TOKEN; empty: none is given.
// warning  a sentence; empty: there is none.
struct GivenToken {
  std::string token;
  std::string warning;
  std::string fault;  // why it cannot be taken; empty: it can
  int exit = kDone;
};

// A token is never taken from the command line, which every user of the machine can read.
[[nodiscard]] GivenToken given_token(const LabOptions& options);

// What there is to say of an address that other machines reach; empty: they do not.
[[nodiscard]] std::string warning_of_host(const std::string& host);

}  // namespace armlet::cli
