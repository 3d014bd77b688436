// Any bytes as a study file: read, or refused with a StudyError.
#include "runner/study/study.hpp"

#include "runner/study/units.hpp"
#include "tests/fuzz/scratch.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const mpmstudy::fuzz::Scratch scratch;
  static const mpmstudy::Units units;
  const auto path = scratch.path() / "study.toml";
  mpmstudy::fuzz::write(path, data, size);
  mpmstudy::ReadOptions options;
  options.most_jobs = 50;  // more are refused: a fuzzer that finds them is no wiser
  try {
    mpmstudy::read_study(path, options, units);
  } catch (const mpmstudy::StudyError&) {
  }
  return 0;
}
