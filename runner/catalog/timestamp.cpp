#include "runner/catalog/timestamp.hpp"

#include <cstdio>
#include <ctime>

namespace mpmstudy {
namespace {

bool parse(const std::string& text, double& seconds) {
  std::tm tm{};
  int millis = 0;
  if (std::sscanf(text.c_str(), "%d-%d-%dT%d:%d:%d.%dZ", &tm.tm_year, &tm.tm_mon, &tm.tm_mday, &tm.tm_hour,
                  &tm.tm_min, &tm.tm_sec, &millis) != 7)
    return false;
  tm.tm_year -= 1900;
  tm.tm_mon -= 1;
  seconds = static_cast<double>(timegm(&tm)) + millis / 1000.0;
  return true;
}

}  // namespace

std::string utc_timestamp(std::chrono::system_clock::time_point at) {
  using namespace std::chrono;
  const auto millis = duration_cast<milliseconds>(at.time_since_epoch()).count();
  const std::time_t seconds = static_cast<std::time_t>(millis / 1000);
  std::tm tm{};
  gmtime_r(&seconds, &tm);
  char text[48];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ", tm.tm_year + 1900, tm.tm_mon + 1,
                tm.tm_mday, tm.tm_hour, tm.tm_min, tm.tm_sec, static_cast<int>(millis % 1000));
  return text;
}

std::string utc_now() { return utc_timestamp(std::chrono::system_clock::now()); }

double seconds_between(const std::string& earlier, const std::string& later) {
  double from = 0, to = 0;
  return parse(earlier, from) && parse(later, to) ? to - from : 0;
}

}  // namespace mpmstudy
