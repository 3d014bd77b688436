#pragma once
/// The paper's claims, one function each, by the subject that their file is named after. Without the numbers
/// that a claim needs its verdict is not_run, and `measured` is empty.
#include <optional>
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"
#include "runner/finish/evidence.hpp"

namespace mpmstudy {

// jet.cpp: Fig. 1, the jet between two bodies at 1500 m/s each, and the planar shock at that speed.
Claim initial_pressure(const Evidence&);
Claim shock_outruns_wall(const Evidence&);
Claim jet_overtakes(const Evidence&);
Claim jet_hot_spot(const Evidence&);
Claim vortex_hot_spots(const Evidence&);

// strong_collapse.cpp: Figs. 2 and 3, at 1120 m/s.
Claim wall_broken(const Evidence&);
Claim new_cavities(const Evidence&);
Claim coalescence(const Evidence&);

// critical_speed.cpp: Fig. 4, the critical speed of ejection against the thickness of the wall.
Claim parabola(const Evidence&);
Claim critical_values(const Evidence&);
/// "1375 ± 80 m/s": the critical speed of the wall that is 3 um thick, for cells of size 0; "not run".
/// Of jobs with that spall strength [Pa]; without one, of all.
std::string critical_speed_at_3_um(const Evidence&, const std::string& study,
                                   std::optional<double> spall_strength);

// weak_collapse.cpp: Figs. 5 to 7, at 200 m/s.
Claim incomplete(const Evidence&);
Claim less_along_shock(const Evidence&);
Claim lower_part(const Evidence&);
Claim isotropic(const Evidence&);
Claim hottest_below(const Evidence&);

// collapsibility.cpp: Fig. 8, and the invariance of scale that the paper states with it.
Claim falls_with_radius(const Evidence&);
Claim falls_with_yield(const Evidence&);
Claim scale_invariance(const Evidence&);
/// Collapsibilities of done jobs whose final area has a meaning, in the order of a parameter; "": of the
/// sweep.
std::vector<ValueWithError> collapsibilities(const Evidence&, const std::string& study,
                                             const std::string& parameter);

}  // namespace mpmstudy
