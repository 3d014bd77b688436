#include <stdexcept>

#include "libmpm/core/enumerators.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {

#define MPM_DECLARE(name) extern const Kind name;
MPM_SCENE_KINDS(MPM_DECLARE)
#undef MPM_DECLARE

namespace {
#define MPM_ADDRESS(name) &name,
constexpr const Kind* list[] = {MPM_SCENE_KINDS(MPM_ADDRESS)};
#undef MPM_ADDRESS
static_assert(std::size(list) == enumerators<SceneKind>());
}  // namespace

std::span<const Kind* const> kinds() { return list; }

const Kind& kind_of(SceneKind kind) {
  for (const Kind* k : list)
    if (k->kind == kind) return *k;
  throw std::logic_error("a kind of scene that is not in the list");
}

}  // namespace mpm
