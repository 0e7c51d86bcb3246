#pragma once
// Serves a laboratory to browsers: one page, and a WebSocket for each open page.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "laboratory.hpp"

namespace armlet::lab {

// host      the address of the server.
// port      0: any free port.
// token     that pages must send (http_guard.hpp).
// page      the HTML of the page.
// on_ready  called with the address for a browser, when the server has started.
// is_over   called several times a second; true: the server ends.
struct ServerOptions {
  std::string host = "127.0.0.1";
  int port = 0;
  std::string token;
  std::string_view page;
  std::function<void(const std::string& address)> on_ready;
  std::function<bool()> is_over;
};

// Serves until is_over. Returns why it could not start, as a sentence; empty: it did.
[[nodiscard]] std::string serve(Laboratory& laboratory, const ServerOptions& options);

// The page that is part of the command (page/dist/index.html).
[[nodiscard]] std::string_view built_in_page();

}  // namespace armlet::lab
