// The cost of a call between host and script, in Armlet and through Lua's C interface: the time of
// one pass of a loop with only the call. A call by name from the host is compared with lua_pcall.

#include <chrono>
#include <cstdlib>
#include <lua.hpp>
#include <string>

#include "armlet/interpreter/define.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/host/program_function.hpp"
#include "bench.hpp"

namespace {

using namespace armlet;

constexpr std::int64_t kCalls = 1'000'000;

double shrink(double x) { return 0.5 * x + 1.0; }
double mix(double x, double y) { return 0.5 * (x + y); }
double clamp(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

using Clock = std::chrono::steady_clock;

template <class Work>
double nanoseconds(Work work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / kCalls;
}

// ---- Armlet ---------------------------------------------------------------------------------

// The time of one pass of loop(n), ns.
Answer<double> time_of(const ScriptFunction<double(std::int64_t)>& loop) {
  double sum = 0.0;
  bool done = true;
  const double time = nanoseconds([&] { done = loop.call(sum, kCalls); });
  if (!done) return Failed{};
  return time;
}

// The time of one call of f by the host, ns.
Answer<double> time_of_calls(const ScriptFunction<double(double)>& f) {
  double x = 0.5;
  bool done = true;
  const double time = nanoseconds([&] {
    for (std::int64_t i = 0; done && i < kCalls; ++i) done = f.call(x, x);
  });
  if (!done) return Failed{};
  return time;
}

// A function that is called through its slots, not directly.
std::int64_t next_of(std::int64_t n, bool up) { return up ? n + 1 : n - 1; }

const NativeFunction kFunctions[] = {
    def<shrink>("shrink(x: double) -> double", "x / 2 + 1.", "shrink(1.0)", {.real1 = &shrink}),
    def<mix>("mix(x: double, y: double) -> double", "The mean.", "mix(1.0, 2.0)", {.real2 = &mix}),
    def<clamp>("limit(x: double, low: double, high: double) -> double",
               "x, not below low and not above high.", "limit(1.0, 0.0, 2.0)", {.real3 = &clamp}),
    def<next_of>("step(n: int, up: bool) -> int", "One more or less.", "step(1, true)"),
    def<time_of>("timeOf(loop: fn(int) -> double) -> double", "Nanoseconds of a pass.",
                 "timeOf(fn(n) => 0.0)"),
    def<time_of_calls>("timeOfCalls(f: fn(double) -> double) -> double", "Nanoseconds of a call.",
                       "timeOfCalls(fn(x) => x)"),
};

constexpr const char* kProgram = R"(
fn shrinking(n: int) -> double { var x = 0.5
 for (i in range(n)) { x = shrink(x) }
 return x }
fn mixing(n: int) -> double { var x = 0.5
 for (i in range(n)) { x = mix(x, 2.0) }
 return x }
fn limiting(n: int) -> double { var x = 0.5
 for (i in range(n)) { x = limit(x, 0.0, 2.0) }
 return x }
fn stepping(n: int) -> double { var k = 0
 for (i in range(n)) { k = step(k, true) }
 return double(k) }
fn next(x: double) -> double { return 0.5 * x + 1.0 }
print(timeOf(shrinking), timeOf(mixing), timeOf(limiting), timeOf(stepping), timeOfCalls(next))
)";

constexpr int kKinds = 6;
constexpr const char* kNames[kKinds] = {"script calls f(x)",       "script calls f(x, y)",
                                        "script calls f(x, y, z)", "script calls step(n, up)",
                                        "host calls f(x) inside",  "host calls f(x) by name"};

// The time of one call between runs, by a host that found the function by its name, ns.
double time_of_function(Vm& vm) {
  const auto next = vm.function<double(double)>("next");
  double x = 0.5;
  return nanoseconds([&] {
    for (std::int64_t i = 0; i < kCalls; ++i) {
      const Answer<double> answer = next(x);
      if (!answer) std::abort();
      x = *answer;
    }
  });
}

void time_armlet(const Engine& engine, std::vector<double> (&times)[kKinds]) {
  const Compilation compilation = engine.compile(kProgram, "calls.rbt");
  std::string printed;
  VmOptions options;
  options.output = [&](std::string_view text) { printed += text; };
  if (compilation.program == nullptr) std::abort();
  Vm vm(compilation.program, std::move(options));
  if (vm.run().status != Progress::kDone) std::abort();
  const char* at = printed.c_str();
  for (int kind = 0; kind < kKinds - 1; ++kind) {
    char* end = nullptr;
    times[kind].push_back(std::strtod(at, &end));
    at = end;
  }
  times[kKinds - 1].push_back(time_of_function(vm));
}

// ---- Lua ------------------------------------------------------------------------------------

int lua_shrink(lua_State* lua) {
  lua_pushnumber(lua, shrink(luaL_checknumber(lua, 1)));
  return 1;
}
int lua_mix(lua_State* lua) {
  lua_pushnumber(lua, mix(luaL_checknumber(lua, 1), luaL_checknumber(lua, 2)));
  return 1;
}
int lua_limit(lua_State* lua) {
  lua_pushnumber(
      lua, clamp(luaL_checknumber(lua, 1), luaL_checknumber(lua, 2), luaL_checknumber(lua, 3)));
  return 1;
}
int lua_step(lua_State* lua) {
  lua_pushinteger(lua, next_of(luaL_checkinteger(lua, 1), lua_toboolean(lua, 2) != 0));
  return 1;
}

constexpr const char* kLuaProgram = R"(
local shrink, mix, limit, step = shrink, mix, limit, step
function shrinking(n) local x = 0.5 for i = 1, n do x = shrink(x) end return x end
function mixing(n) local x = 0.5 for i = 1, n do x = mix(x, 2.0) end return x end
function limiting(n) local x = 0.5 for i = 1, n do x = limit(x, 0.0, 2.0) end return x end
function stepping(n) local k = 0 for i = 1, n do k = step(k, true) end return k end
function following(x) return 0.5 * x + 1.0 end
)";

void time_lua(lua_State* lua, std::vector<double> (&times)[kKinds]) {
  int kind = 0;
  for (const char* loop : {"shrinking", "mixing", "limiting", "stepping"}) {
    times[kind++].push_back(nanoseconds([&] {
      lua_getglobal(lua, loop);
      lua_pushinteger(lua, kCalls);
      lua_call(lua, 1, 1);
      lua_pop(lua, 1);
    }));
  }
  lua_getglobal(lua, "following");
  double x = 0.5;
  times[kind].push_back(nanoseconds([&] {
    for (std::int64_t i = 0; i < kCalls; ++i) {
      lua_pushvalue(lua, -1);
      lua_pushnumber(lua, x);
      lua_call(lua, 1, 1);
      x = lua_tonumber(lua, -1);
      lua_pop(lua, 1);
    }
  }));
  times[++kind].push_back(nanoseconds([&] {
    for (std::int64_t i = 0; i < kCalls; ++i) {
      lua_pushvalue(lua, -1);
      lua_pushnumber(lua, x);
      if (lua_pcall(lua, 1, 1, 0) != LUA_OK) std::abort();
      x = lua_tonumber(lua, -1);
      lua_pop(lua, 1);
    }
  }));
  asm volatile("" : : "g"(x));
  lua_pop(lua, 1);
}

}  // namespace

int main() {
  Engine engine;
  engine.add_functions(kFunctions);
  lua_State* lua = luaL_newstate();
  lua_register(lua, "shrink", &lua_shrink);
  lua_register(lua, "mix", &lua_mix);
  lua_register(lua, "limit", &lua_limit);
  lua_register(lua, "step", &lua_step);
  if (luaL_dostring(lua, kLuaProgram) != LUA_OK) std::abort();
  std::vector<double> ours[kKinds];
  std::vector<double> theirs[kKinds];
  for (int round = 0; round < 15; ++round) {
    time_armlet(engine, ours);
    time_lua(lua, theirs);
  }
  lua_close(lua);
  std::printf("%-26s %10s %10s %9s\n", "ns per call, minimum", "armlet", "lua", "ratio");
  for (int i = 0; i < kKinds; ++i) {
    const double a = *std::min_element(ours[i].begin(), ours[i].end());
    const double b = *std::min_element(theirs[i].begin(), theirs[i].end());
    std::printf("%-26s %10.1f %10.1f %8.1fx\n", kNames[i], a, b, b / a);
  }
}
