#pragma once
// The access token of a laboratory, when the user chooses it.

#include <string>

#include "lab/lab.hpp"

namespace armlet::cli {

// token    from --token-file, else from the variable ARMLET_LAB_TOKEN; empty: none is given.
// warning  a sentence; empty: there is none.
struct GivenToken {
  std::string token;
  std::string warning;
  std::string fault;  // why it cannot be used; empty: it can
  int exit = kDone;
};

// A token on the command line is refused, since every user of the computer can read that.
[[nodiscard]] GivenToken given_token(const LabOptions& options);

// A warning if other computers can reach this address; empty: they cannot.
[[nodiscard]] std::string warning_of_host(const std::string& host);

}  // namespace armlet::cli
