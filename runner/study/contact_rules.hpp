#pragma once
/// [[contact]] of a study of scenes of bodies: what pairs of bodies do where they touch.
#include <string>
#include <vector>

#include "libmpm/scene/composition.hpp"
#include "runner/study/quantity_reader.hpp"

namespace mpmstudy {

inline constexpr std::string_view contact_table = "contact";

/// The rules of one job, in the order of the file. `bodies`: the names that there are.
std::vector<mpm::ContactRule> read_contacts(const Table& document, const std::vector<std::string>& bodies,
                                            QuantityReader&, const ValueOf&, Mistakes&);

/// The two names of a pair, ["a", "b"]. Empty after adding a mistake.
std::vector<std::string> read_pair(std::string_view key, const Value&, Mistakes&);

}  // namespace mpmstudy
