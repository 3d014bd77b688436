#pragma once
/// The problems of the ladder, one function each: what it solves and how, and the numbers that are known of
/// it.
#include "libmpm/verification/problems/exact_bench.hpp"

namespace mpm::verification {

// material_point_numbers.cpp: the material alone, without particles and grid.
ExactNumbers hugoniot_numbers(const ExactOptions&);
ExactNumbers uniaxial_path_numbers(const ExactOptions&);
ExactNumbers release_numbers(const ExactOptions&);
ExactNumbers bauschinger_numbers(const ExactOptions&);

/// planar_impact.cpp: a block of aluminium on a rigid wall. 0.05 um cells.
ExactNumbers planar_impact_numbers(double impact_speed, const ExactOptions&);

/// surface_history.cpp: the same, 10 um high; the speed of its free surface over all waves.
ExactNumbers surface_history_numbers(const ExactOptions&);

/// imploding_shell.cpp: a ring of aluminium, 1.5 to 3 um, with an inner speed in verney_cylinder_al.csv
/// [m/s]. 0.05 um cells.
ExactNumbers imploding_shell_numbers(double inner_speed, bool hardening, const ExactOptions&);

/// ... a sphere of the same radii, in axisymmetry.
ExactNumbers imploding_sphere_numbers(double inner_speed, const ExactOptions&);
/// ... an octant of it, in three dimensions, against the exact stop and against axisymmetry. 16 cells across
/// the wall.
ExactNumbers imploding_octant_numbers(double inner_speed, const ExactOptions&);

/// pressed_cavity.cpp: a spherical cavity of 1 um in aluminium under a pressure, as a share of that which
/// closes it; axisymmetry, 0.1 um cells.
ExactNumbers pressed_cavity_numbers(double share, const ExactOptions&);

/// lagrange_weak.cpp: the weak collapse of the paper against the Lagrangian code. 0.1 um cells.
ExactNumbers lagrange_weak_numbers(const ExactOptions&);

// blast_waves.cpp: strong shocks of an ideal gas, in plane strain a cylinder, in axisymmetry a sphere.
ExactNumbers noh_numbers(mpm::Space, const ExactOptions&);    ///< cells of a hundredth of the radius
ExactNumbers sedov_numbers(mpm::Space, const ExactOptions&);  ///< cells of a fiftieth of the radius

// elastic_numbers.cpp: neo-Hookean bodies.
ExactNumbers axis_aligned_numbers(const ExactOptions&);
ExactNumbers vortex_numbers(const ExactOptions&);
ExactNumbers vibrating_bar_numbers(const ExactOptions&);
ExactNumbers elastic_disks_numbers(const ExactOptions&);
ExactNumbers cylinder_waves_numbers(const ExactOptions&);  ///< in axisymmetry
ExactNumbers cube_waves_numbers(const ExactOptions&);      ///< in three dimensions

// invariances.cpp: two descriptions of one thing.
ExactNumbers scale_numbers(const ExactOptions&);
ExactNumbers half_and_full_numbers(const ExactOptions&);
ExactNumbers wall_and_two_bodies_numbers(const ExactOptions&);
ExactNumbers moving_frame_numbers(const ExactOptions&);
ExactNumbers planar_spaces_numbers(const ExactOptions&);
ExactNumbers spherical_cavity_numbers(const ExactOptions&);

// contact_numbers.cpp: bodies that touch.
/// `turned`: the plane lies across the grid, and not gravity across the plane.
ExactNumbers rolling_numbers(double degrees, double friction, bool turned, const ExactOptions&);
ExactNumbers spheres_numbers(double speed, const ExactOptions&);
ExactNumbers taylor_numbers(const ExactOptions&);
ExactNumbers four_spheres_numbers(const ExactOptions&);
ExactNumbers contact_shock_numbers(const ExactOptions&);

/// free_flight.cpp: what turns freely in three dimensions keeps its angular momentum.
ExactNumbers free_flight_numbers(const ExactOptions&);

}  // namespace mpm::verification
