#pragma once
// Access control of a laboratory: requests need its token and must come from its own page.

#include <optional>
#include <string>
#include <string_view>

namespace armlet::lab {

// host   the address of the server; port: the one that it got.
// token  of the laboratory.
struct Door {
  std::string host;
  int port = 0;
  std::string token;
};

struct Asking {
  std::string_view method;
  std::string_view path;    // without the query
  std::string_view query;   // without the question mark
  std::string_view host;    // of the header; empty: it has none
  std::string_view origin;  // of the header; empty: it has none
  bool is_socket = false;
};

// Why a request is refused.
struct Refusal {
  int status = 403;
  std::string why;
};

// Checks the host name (otherwise a foreign page could redirect its own name to this computer and
// read the answers), the token, and for sockets the origin, which browsers send.
[[nodiscard]] std::optional<Refusal> refusal(const Door& door, const Asking& asking);

// "a1" of the name "n" in "token=x&n=a1"; empty: there is none. The value is not decoded.
[[nodiscard]] std::string_view parameter(std::string_view query, std::string_view name);

// A new token, 32 random hexadecimal digits from the system.
[[nodiscard]] std::string new_token();
// Why this is no valid token; empty: it is one.
[[nodiscard]] std::string fault_of_token(std::string_view token);

// Whether only this computer can reach a server at this address.
[[nodiscard]] bool is_loopback(std::string_view host);

// "script-src 'sha256-...'": the scripts that the page declares; empty if it declares
// none.
[[nodiscard]] std::string_view scripts_of(std::string_view page);

}  // namespace armlet::lab
