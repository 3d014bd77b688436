// Any bytes as the value of --set, as a quantity, and as a number of some unit.
#include "runner/study/quantity_text.hpp"
#include "runner/study/study.hpp"
#include "tests/fuzz/scratch.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const mpmstudy::Units units;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const mpmstudy::Value value = mpmstudy::read_value("impact_speed", text);
    for (const char* unit : {"m/s", "K", "1"})
      mpmstudy::read_quantity(value, {unit, mpm::Range::positive}, units);
  } catch (const mpmstudy::StudyError&) {
  }
  units.conversion(text, "Pa");
  return 0;
}
