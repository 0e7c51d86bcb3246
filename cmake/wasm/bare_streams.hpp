#pragma once
#pragma GCC system_header
// Streams of the WebAssembly build, without locales: those of emscripten's C++ library bring along
// every locale there is, money and calendars included, some fifth of a megabyte. CMake writes the
// standard headers that read this file (ArmletWasm.cmake).
//
// They write bytes to a buffer that someone else gives, or to a text (bare_text_streams.hpp).
// Numbers are written as in the locale "C"; a width is that of a number. Nothing is read from them
// but bytes.

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <iosfwd>
#include <iterator>
#include <string>
#include <string_view>

namespace std {
inline namespace bare {

typedef ptrdiff_t streamsize;

class ios_base {
 public:
  typedef unsigned fmtflags;
  typedef unsigned iostate;
  typedef unsigned openmode;
  enum seekdir { beg, cur, end };
  static constexpr fmtflags dec = 1, hex = 2, uppercase = 4;
  static constexpr iostate goodbit = 0, badbit = 1, eofbit = 2, failbit = 4;
  static constexpr openmode in = 1, out = 2, binary = 4, trunc = 8, app = 16, ate = 32;

  virtual ~ios_base() = default;

  fmtflags flags() const { return flags_; }
  fmtflags flags(fmtflags flags) { return exchange(flags_, flags); }
  streamsize precision() const { return precision_; }
  streamsize precision(streamsize digits) { return exchange(precision_, digits); }
  streamsize width() const { return width_; }
  streamsize width(streamsize width) { return exchange(width_, width); }

 protected:
  template <class T>
  static T exchange(T& kept, T value) {
    const T before = kept;
    kept = value;
    return before;
  }

  fmtflags flags_ = dec;
  streamsize precision_ = 6;
  streamsize width_ = 0;
};

inline ios_base& dec(ios_base& stream) {
  stream.flags(stream.flags() & ~ios_base::hex);
  return stream;
}
inline ios_base& hex(ios_base& stream) {
  stream.flags(stream.flags() | ios_base::hex);
  return stream;
}
inline ios_base& uppercase(ios_base& stream) {
  stream.flags(stream.flags() | ios_base::uppercase);
  return stream;
}

template <class C, class Traits>
class basic_streambuf {
 public:
  typedef C char_type;
  typedef Traits traits_type;
  typedef typename Traits::int_type int_type;
  typedef typename Traits::pos_type pos_type;
  typedef typename Traits::off_type off_type;

  virtual ~basic_streambuf() = default;

  streamsize sputn(const C* text, streamsize count) { return xsputn(text, count); }
  int_type sputc(C letter) { return overflow(Traits::to_int_type(letter)); }
  int_type sgetc() { return underflow(); }
  int_type sbumpc() { return uflow(); }
  pos_type pubseekpos(pos_type at, ios_base::openmode which) { return seekpos(at, which); }
  pos_type pubseekoff(off_type by, ios_base::seekdir from, ios_base::openmode which) {
    return seekoff(by, from, which);
  }
  int pubsync() { return sync(); }

 protected:
  virtual streamsize xsputn(const C* text, streamsize count) {
    for (streamsize i = 0; i < count; ++i)
      if (Traits::eq_int_type(sputc(text[i]), Traits::eof())) return i;
    return count;
  }
  virtual int_type overflow(int_type) { return Traits::eof(); }
  virtual int_type underflow() { return Traits::eof(); }
  virtual int_type uflow() { return Traits::eof(); }
  virtual pos_type seekoff(off_type, ios_base::seekdir, ios_base::openmode) {
    return pos_type(off_type(-1));
  }
  virtual pos_type seekpos(pos_type, ios_base::openmode) { return pos_type(off_type(-1)); }
  virtual int sync() { return 0; }
};

template <class C, class Traits>
class basic_ios : public ios_base {
 public:
  typedef C char_type;
  typedef Traits traits_type;
  typedef typename Traits::int_type int_type;
  typedef typename Traits::pos_type pos_type;
  typedef typename Traits::off_type off_type;

  explicit basic_ios(basic_streambuf<C, Traits>* buffer)
      : buffer_(buffer), state_(buffer != nullptr ? goodbit : badbit) {}
  basic_ios(const basic_ios&) = delete;
  basic_ios& operator=(const basic_ios&) = delete;

  basic_streambuf<C, Traits>* rdbuf() const { return buffer_; }
  basic_streambuf<C, Traits>* rdbuf(basic_streambuf<C, Traits>* buffer) {
    clear(buffer != nullptr ? goodbit : badbit);
    return exchange(buffer_, buffer);
  }
  iostate rdstate() const { return state_; }
  void clear(iostate state = goodbit) { state_ = state; }
  void setstate(iostate state) { state_ |= state; }
  bool good() const { return state_ == goodbit; }
  bool eof() const { return (state_ & eofbit) != 0; }
  bool fail() const { return (state_ & (failbit | badbit)) != 0; }
  bool bad() const { return (state_ & badbit) != 0; }
  explicit operator bool() const { return !fail(); }
  bool operator!() const { return fail(); }
  C fill() const { return fill_; }
  C fill(C letter) { return exchange(fill_, letter); }
  basic_ios& copyfmt(const basic_ios& other) {
    flags_ = other.flags_;
    precision_ = other.precision_;
    width_ = other.width_;
    fill_ = other.fill_;
    return *this;
  }

 private:
  basic_streambuf<C, Traits>* buffer_;
  iostate state_;
  C fill_ = C(' ');
};

template <class C, class Traits>
class basic_istream : public basic_ios<C, Traits> {
 public:
  using basic_ios<C, Traits>::basic_ios;
};

template <class C, class Traits>
class basic_ostream : public basic_ios<C, Traits> {
 public:
  explicit basic_ostream(basic_streambuf<C, Traits>* buffer) : basic_ios<C, Traits>(buffer) {}

  basic_ostream& write(const C* text, streamsize count) {
    if (!this->good() || this->rdbuf()->sputn(text, count) != count)
      this->setstate(ios_base::badbit);
    return *this;
  }
  basic_ostream& put(C letter) { return write(&letter, 1); }
  basic_ostream& flush() {
    if (this->rdbuf() != nullptr && this->rdbuf()->pubsync() < 0) this->setstate(ios_base::badbit);
    return *this;
  }
  typename Traits::pos_type tellp() {
    if (this->fail()) return typename Traits::pos_type(typename Traits::off_type(-1));
    return this->rdbuf()->pubseekoff(0, ios_base::cur, ios_base::out);
  }
  basic_ostream& seekp(typename Traits::pos_type at) {
    const typename Traits::pos_type nowhere(typename Traits::off_type(-1));
    if (!this->fail() && this->rdbuf()->pubseekpos(at, ios_base::out) == nowhere)
      this->setstate(ios_base::failbit);
    return *this;
  }

  basic_ostream& operator<<(basic_ostream& (*change)(basic_ostream&)) { return change(*this); }
  basic_ostream& operator<<(ios_base& (*change)(ios_base&)) {
    change(*this);
    return *this;
  }
  basic_ostream& operator<<(bool value) { return put(C(value ? '1' : '0')); }
  basic_ostream& operator<<(short value) { return integer(value); }
  basic_ostream& operator<<(unsigned short value) { return integer(value); }
  basic_ostream& operator<<(int value) { return integer(value); }
  basic_ostream& operator<<(unsigned value) { return integer(value); }
  basic_ostream& operator<<(long value) { return integer(value); }
  basic_ostream& operator<<(unsigned long value) { return integer(value); }
  basic_ostream& operator<<(long long value) { return integer(value); }
  basic_ostream& operator<<(unsigned long long value) { return integer(value); }
  basic_ostream& operator<<(double value) {
    char text[64];
    return narrow(text, snprintf(text, sizeof text, "%.*g", int(this->precision_), value));
  }
  basic_ostream& operator<<(const void* value) {
    narrow("0x", 2);
    char text[32];
    return narrow(text, to_chars(text, text + 32, uintptr_t(value), 16).ptr - text);
  }

 private:
  template <class T>
  basic_ostream& integer(T value) {
    char text[32];
    const int base = (this->flags_ & ios_base::hex) != 0 ? 16 : 10;
    char* const end = to_chars(text, text + 32, value, base).ptr;
    if ((this->flags_ & ios_base::uppercase) != 0)
      for (char* at = text; at < end; ++at) *at = char(*at >= 'a' ? *at - 'a' + 'A' : *at);
    return narrow(text, end - text);
  }
  // Digits, behind what fills the width.
  basic_ostream& narrow(const char* text, streamsize count) {
    for (streamsize i = this->width(0); i > count; --i) put(this->fill());
    for (streamsize i = 0; i < count; ++i) put(C(text[i]));
    return *this;
  }
};

struct SetWidth {
  int width;
};
inline SetWidth setw(int width) { return {width}; }
template <class C>
struct SetFill {
  C letter;
};
template <class C>
SetFill<C> setfill(C letter) {
  return {letter};
}
template <class C, class Traits>
basic_ostream<C, Traits>& operator<<(basic_ostream<C, Traits>& out, SetWidth set) {
  out.width(set.width);
  return out;
}
template <class C, class Traits>
basic_ostream<C, Traits>& operator<<(basic_ostream<C, Traits>& out, SetFill<C> set) {
  out.fill(set.letter);
  return out;
}

template <class C, class Traits>
basic_ostream<C, Traits>& operator<<(basic_ostream<C, Traits>& out, C letter) {
  return out.put(letter);
}
template <class Traits>
basic_ostream<char, Traits>& operator<<(basic_ostream<char, Traits>& out, const char* text) {
  return out.write(text, streamsize(char_traits<char>::length(text)));
}
template <class Traits>
basic_ostream<wchar_t, Traits>& operator<<(basic_ostream<wchar_t, Traits>& out, const char* text) {
  for (; *text != 0; ++text) out.put(wchar_t(*text));
  return out;
}
template <class C, class Traits>
basic_ostream<C, Traits>& endl(basic_ostream<C, Traits>& out) {
  return out.put(C('\n')).flush();
}

}  // namespace bare
}  // namespace std

#include "bare_text_streams.hpp"
