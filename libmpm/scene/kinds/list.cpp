#include <stdexcept>

#include "libmpm/core/enumerators.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {

extern const Kind cavity_impact, planar_impact, two_body_impact, imploding_shell;

namespace {
/// In the order of SceneKind.
constexpr const Kind* list[] = {&cavity_impact, &planar_impact, &two_body_impact, &imploding_shell};
static_assert(std::size(list) == enumerators<SceneKind>(), "each kind of scene has one line in the list");
}  // namespace

std::span<const Kind* const> kinds() { return list; }

const Kind& kind_of(SceneKind kind) {
  for (const Kind* k : list)
    if (k->kind == kind) return *k;
  throw std::logic_error("a kind of scene that is not in the list");
}

}  // namespace mpm
