#pragma once
/// Scenes of bodies as text: in keys, in messages between processes, in the catalog.
#include <string>

#include "libmpm/scene/scene.hpp"

namespace mpmstudy {

/// JSON of the composition of a scene and of all its materials; "" where its kind has none. The same text for
/// the same bits.
std::string composition_text(const mpm::Scene&);
/// The same where a constant of a material that has no effect is left out, and the names of materials: for
/// keys.
std::string composition_key(const mpm::Scene&);
/// Gives the scene what composition_text() had. Throws std::invalid_argument where the text is none of those.
void set_composition(mpm::Scene&, const std::string& text);

/// Parts of the composition of `here` that `there` has not, or has in another form: "box, bar, material
/// soft"; "none". Of two scenes that have one.
std::string own_parts(const mpm::Scene& here, const mpm::Scene& there);

}  // namespace mpmstudy
