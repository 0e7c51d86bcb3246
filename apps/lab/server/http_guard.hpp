#pragma once
// Who may speak to a laboratory: whoever knows its token, from the laboratory's own page.

#include <optional>
#include <string>
#include <string_view>

namespace armlet::lab {

// host   the address that is listened to; port, as it became known.
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
  std::string_view origin;  // the same
  bool is_socket = false;
};

// Why a request is not answered.
struct Refusal {
  int status = 403;
  std::string why;
};

// Names that lead here: without this check, a foreign page could let its own name point to this
// machine and read along. Then the token, and for sockets the origin, which browsers tell.
[[nodiscard]] std::optional<Refusal> refusal(const Door& door, const Asking& asking);

// "a1" of the name "n" in "token=x&n=a1"; empty: there is none. Nothing in it is decoded.
[[nodiscard]] std::string_view parameter(std::string_view query, std::string_view name);

// A new token, 32 hexadecimal digits of chance from the system.
[[nodiscard]] std::string new_token();
// Why this is no token; empty: it is one.
[[nodiscard]] std::string fault_of_token(std::string_view token);

// Whether only this machine reaches what listens there.
[[nodiscard]] bool is_loopback(std::string_view host);

// "script-src 'sha256-...'": which scripts the page itself says that it has; none, if it says
// nothing.
[[nodiscard]] std::string_view scripts_of(std::string_view page);

}  // namespace armlet::lab
