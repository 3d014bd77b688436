#pragma once
#include <chrono>
#include <string>

namespace mpmstudy {

/// "2031-05-06T07:08:09.123Z": UTC, sorts as text.
std::string utc_timestamp(std::chrono::system_clock::time_point);
std::string utc_now();

/// Seconds between two such texts; 0 if one of them is none.
double seconds_between(const std::string& earlier, const std::string& later);

}  // namespace mpmstudy
