#pragma once

namespace armlet {

// Whether a sanitizer watches, which makes everything many times slower.
inline constexpr bool kSanitized =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    true;
#else
    false;
#endif

}  // namespace armlet
