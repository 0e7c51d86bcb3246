#include "server/http_guard.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace armlet::lab;

namespace {

const Door kDoor{"127.0.0.1", 4711, "0123456789abcdef"};

Asking page() {
  return {.method = "GET",
          .path = "/",
          .query = "token=0123456789abcdef",
          .host = "127.0.0.1:4711",
          .origin = "",
          .is_socket = false};
}
Asking live() {
  Asking asking = page();
  asking.path = "/live";
  asking.origin = "http://127.0.0.1:4711";
  asking.is_socket = true;
  return asking;
}
int status(const Asking& asking, const Door& door = kDoor) {
  const auto refused = refusal(door, asking);
  return refused ? refused->status : 200;
}

}  // namespace

TEST_CASE("the page and its socket are let in with the token") {
  CHECK(status(page()) == 200);
  CHECK(status(live()) == 200);
  Asking asking = live();
  asking.query = "x=1&token=0123456789abcdef&y=2";
  CHECK(status(asking) == 200);
  asking.host = "localhost:4711";
  asking.origin = "http://localhost:4711";
  CHECK(status(asking) == 200);
  asking.origin = "";  // no browser
  CHECK(status(asking) == 200);
}

TEST_CASE("everything else is not") {
  for (const char* query :
       {"", "token=", "token=0123456789abcde", "token=0123456789abcdef0", "token=0123456789abcdeg",
        "tokens=0123456789abcdef", "0123456789abcdef"}) {
    Asking asking = page();
    asking.query = query;
    CHECK(status(asking) == 403);
  }
  for (const char* host : {"", "evil.example:4711", "127.0.0.1", "127.0.0.1:4712",
                           "127.0.0.1:47110", "127.0.0.1.evil.example:4711", "10.0.0.1:4711"}) {
    Asking asking = page();
    asking.host = host;
    CHECK(status(asking) == 403);
  }
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:4711",
                             "http://127.0.0.1", "http://127.0.0.1:4711.evil.example"}) {
    Asking asking = live();
    asking.origin = origin;
    CHECK(status(asking) == 403);
  }
  Asking asking = page();
  asking.method = "POST";
  CHECK(status(asking) == 405);
  asking = page();
  asking.path = "/../etc/passwd";
  CHECK(status(asking) == 404);
  asking = page();
  asking.path = "/live";
  CHECK(status(asking) == 400);
}

TEST_CASE("a laboratory for everybody is reached by addresses, not by names of others") {
  const Door everywhere{"0.0.0.0", 4711, kDoor.token};
  Asking asking = page();
  asking.host = "192.168.0.7:4711";
  CHECK(status(asking, everywhere) == 200);
  CHECK(status(asking) == 403);
  asking.host = "[fe80::1]:4711";
  CHECK(status(asking, everywhere) == 200);
  asking.host = "rebound.example:4711";
  CHECK(status(asking, everywhere) == 403);
}

TEST_CASE("tokens are long, of plain letters, and never the same") {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    tokens.insert(new_token());
    CHECK(fault_of_token(*tokens.begin()).empty());
  }
  CHECK(tokens.size() == 100);
  CHECK(fault_of_token("short") == "a token has 22 to 200 characters, and this one 5");
  CHECK(!fault_of_token(std::string(21, 'a')).empty());
  CHECK(fault_of_token(std::string(22, 'a')).empty());
  CHECK(fault_of_token(std::string(200, 'a')).empty());
  CHECK(!fault_of_token(std::string(201, 'a')).empty());
  CHECK(!fault_of_token("with a space, and long enough").empty());
  CHECK(!fault_of_token("a&b=c;d#e%00-and-long-enough").empty());
}

TEST_CASE("an address is of this machine alone, or others reach it") {
  for (const char* host : {"127.0.0.1", "127.8.9.1", "localhost", "::1", "[::1]"})
    CHECK(is_loopback(host));
  for (const char* host : {"0.0.0.0", "::", "[::]", "192.168.0.7", "10.0.0.1", "fe80::1",
                           "127.example.org", "localhost.example.org", ""})
    CHECK_FALSE(is_loopback(host));
}

TEST_CASE("a page runs the scripts that it names itself, and no others") {
  const auto with = [](const std::string& policy) {
    return std::string(
        scripts_of("<meta http-equiv=\"Content-Security-Policy\" content=\"" + policy + "\" />"));
  };
  CHECK(with("default-src 'none'; script-src 'sha256-AB+/=' 'wasm-unsafe-eval'; img-src data:") ==
        "script-src 'sha256-AB+/=' 'wasm-unsafe-eval'");
  CHECK(with("script-src 'self'") == "script-src 'self'");
  CHECK(with("default-src 'none'") == "script-src 'none'");
  CHECK(with("script-src 'self'\r\nSet-Cookie: a") == "script-src 'none'");
  CHECK(scripts_of("<p>no policy; script-src 'unsafe-inline'</p>") == "script-src 'none'");
}
