#pragma once
// Shows a laboratory to browsers: one page, and a WebSocket for each that is open.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "laboratory.hpp"

namespace armlet::lab {

// host      the address to listen at.
// port      0: any that is free.
// token     that pages have to know (http_guard.hpp).
// page      the HTML of the page.
// on_ready  with the address for a browser, when it can be opened.
// is_over   asked several times a second: whether to end.
struct ServerOptions {
  std::string host = "127.0.0.1";
  int port = 0;
  std::string token;
  std::string_view page;
  std::function<void(const std::string& address)> on_ready;
  std::function<bool()> is_over;
};

// Serves until is_over. Returns why it could not begin, as a sentence; empty: it did.
[[nodiscard]] std::string serve(Laboratory& laboratory, const ServerOptions& options);

// The page that is built into the command (page/dist/index.html).
[[nodiscard]] std::string_view built_in_page();

}  // namespace armlet::lab
