#pragma once
#pragma GCC system_header
// <iosfwd> of the WebAssembly build: as in libc++ 13, but for streams that lie in a namespace of
// their own (bare_streams.hpp), so that nothing takes them for those of the compiled library.

#include <wchar.h>

#include <__config>

_LIBCPP_BEGIN_NAMESPACE_STD

template <class C>
struct char_traits;
template <>
struct char_traits<char>;
#ifndef _LIBCPP_HAS_NO_CHAR8_T
template <>
struct char_traits<char8_t>;
#endif
template <>
struct char_traits<char16_t>;
template <>
struct char_traits<char32_t>;
template <>
struct char_traits<wchar_t>;
template <class T>
class allocator;
template <class C, class Traits = char_traits<C>, class Allocator = allocator<C>>
class basic_string;
typedef basic_string<char, char_traits<char>, allocator<char>> string;
typedef basic_string<wchar_t, char_traits<wchar_t>, allocator<wchar_t>> wstring;
template <class T, class Allocator = allocator<T>>
class vector;
template <class C, class Traits = char_traits<C>>
class istreambuf_iterator;
template <class C, class Traits = char_traits<C>>
class ostreambuf_iterator;

template <class State>
class fpos;
typedef fpos<mbstate_t> streampos;
typedef fpos<mbstate_t> wstreampos;
#ifndef _LIBCPP_HAS_NO_CHAR8_T
typedef fpos<mbstate_t> u8streampos;
#endif
typedef fpos<mbstate_t> u16streampos;
typedef fpos<mbstate_t> u32streampos;
typedef long long streamoff;

_LIBCPP_END_NAMESPACE_STD

namespace std {
inline namespace bare {

class ios_base;
template <class C, class Traits = char_traits<C>>
class basic_ios;
template <class C, class Traits = char_traits<C>>
class basic_streambuf;
template <class C, class Traits = char_traits<C>>
class basic_istream;
template <class C, class Traits = char_traits<C>>
class basic_ostream;
template <class C, class Traits = char_traits<C>>
class basic_iostream;
template <class C, class Traits = char_traits<C>, class Allocator = allocator<C>>
class basic_stringbuf;
template <class C, class Traits = char_traits<C>, class Allocator = allocator<C>>
class basic_ostringstream;
template <class C, class Traits = char_traits<C>, class Allocator = allocator<C>>
class basic_stringstream;

typedef basic_ios<char> ios;
typedef basic_streambuf<char> streambuf;
typedef basic_istream<char> istream;
typedef basic_ostream<char> ostream;
typedef basic_iostream<char> iostream;
typedef basic_stringbuf<char> stringbuf;
typedef basic_ostringstream<char> ostringstream;
typedef basic_stringstream<char> stringstream;
typedef basic_istream<wchar_t> wistream;
typedef basic_ostream<wchar_t> wostream;

}  // namespace bare
}  // namespace std

_LIBCPP_BEGIN_NAMESPACE_STD

// What <random> keeps of a stream.
template <class C, class Traits>
class __save_flags {
 public:
  explicit __save_flags(basic_ios<C, Traits>&) {}
};

_LIBCPP_END_NAMESPACE_STD
