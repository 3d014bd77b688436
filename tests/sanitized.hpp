#pragma once
/// Is this test built with the address or the thread sanitizer? Both reserve terabytes of addresses, need
/// several times the memory, and end the process where memory cannot be had: what is about bounds on memory
/// cannot be tested with them.
namespace mpmstudy {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace mpmstudy
