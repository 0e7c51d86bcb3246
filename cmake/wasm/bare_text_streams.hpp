#pragma once
#pragma GCC system_header
// Streams that keep a text, of the WebAssembly build; bare_streams.hpp reads this file.

#include "bare_streams.hpp"

namespace std {
inline namespace bare {

template <class C, class Traits>
class basic_iostream : public basic_ostream<C, Traits> {
 public:
  using basic_ostream<C, Traits>::basic_ostream;
};

// A text that grows at its end.
template <class C, class Traits, class Allocator>
class basic_stringbuf : public basic_streambuf<C, Traits> {
 public:
  basic_string<C, Traits, Allocator> text;

 protected:
  streamsize xsputn(const C* added, streamsize count) override {
    text.append(added, size_t(count));
    return count;
  }
  typename Traits::int_type overflow(typename Traits::int_type letter) override {
    text.push_back(Traits::to_char_type(letter));
    return letter;
  }
  typename Traits::pos_type seekoff(typename Traits::off_type by, ios_base::seekdir from,
                                    ios_base::openmode) override {
    const bool is_end = by == 0 && from != ios_base::beg;
    return is_end ? typename Traits::off_type(text.size()) : typename Traits::off_type(-1);
  }
};

template <class C, class Traits, class Allocator>
class basic_stringstream : public basic_iostream<C, Traits> {
 public:
  basic_stringstream() : basic_iostream<C, Traits>(&kept_) {}
  basic_string<C, Traits, Allocator> str() const { return kept_.text; }
  void str(const basic_string<C, Traits, Allocator>& text) { kept_.text = text; }

 private:
  basic_stringbuf<C, Traits, Allocator> kept_;
};

template <class C, class Traits, class Allocator>
class basic_ostringstream : public basic_stringstream<C, Traits, Allocator> {};

// Nothing reads what a module would print.
inline ostream cout(nullptr);
inline ostream cerr(nullptr);

}  // namespace bare
}  // namespace std

_LIBCPP_BEGIN_NAMESPACE_STD

template <class C, class Traits, class Allocator>
basic_ostream<C, Traits>& operator<<(basic_ostream<C, Traits>& out,
                                     const basic_string<C, Traits, Allocator>& text) {
  return out.write(text.data(), streamsize(text.size()));
}
template <class C, class Traits>
basic_ostream<C, Traits>& operator<<(basic_ostream<C, Traits>& out,
                                     basic_string_view<C, Traits> text) {
  return out.write(text.data(), streamsize(text.size()));
}

_LIBCPP_END_NAMESPACE_STD
