#!/usr/bin/env bash
# Takes tables and figures of a full reproduction into this folder, and Fig. 8 of a quick one:
#   ./reproduce.sh --full && ./reproduce.sh --results QUICK && results/reference/take.sh results QUICK
set -e
cd "$(dirname "$0")/../.."
results=${1:-results} quick=$2
into=results/reference
ask() { build/release/runner/mpmstudy query --results "$results" --format csv "$2" > "$into/$1.csv"; }
collapsibility="SELECT a.study, j.position, j.cell_size_m, j.cavity_radius_m, j.yield_stress_Pa, a.value, a.error,
  a.extrapolated_value, a.extrapolated_error, a.measuring_error, a.observed_order, a.method FROM accuracy a JOIN jobs j ON j.key = a.key AND
  j.study = a.study WHERE a.quantity = 'collapsibility' ORDER BY a.study, j.position"

ask provenance "SELECT './reproduce.sh --full' AS command, git_revision, physics_version, count(*) AS jobs,
  sum(cpu_s) AS cpu_s FROM (SELECT DISTINCT key, cpu_s, git_revision, physics_version FROM jobs WHERE status = 'done')
  GROUP BY git_revision, physics_version"
ask claims "SELECT name, study, verdict, measured FROM claims"
ask collapsibility "$collapsibility"
ask one-cell "SELECT study, position, cell_size_m, block_height_m, cavity_center_height_m, collapsibility, collapsibility_error
  FROM jobs WHERE study IN ('symmetry', 'block-height') AND status = 'done' ORDER BY study, position"
ask critical-speed "SELECT c.study, j.spall_strength_Pa, c.wall_thickness_m, c.cell_size_m, c.lower_m_s, c.upper_m_s,
  c.extrapolated_m_s, c.interval_m_s, c.runs, c.flags FROM critical_speed c JOIN jobs j ON j.key = c.upper_key AND
  j.study = c.study ORDER BY c.study, c.position"
ask fits "SELECT study, quantity, model, coefficient, value, standard_error, unit, r2, covariance FROM fits
  ORDER BY study, quantity, model, coefficient"
ask audit "SELECT e.study, a.spall_strength_Pa, a.wall_thickness_m, a.cell_size_m, a.impact_speed_m_s,
  e.outcome AS stopped_early, a.outcome AS run_to_end FROM jobs a JOIN jobs e ON a.study = e.study || '-audit' AND
  a.wall_thickness_m = e.wall_thickness_m AND a.cell_size_m = e.cell_size_m AND a.impact_speed_m_s = e.impact_speed_m_s
  AND a.spall_strength_Pa IS e.spall_strength_Pa ORDER BY 1, 2, 3, 4, 5"
ask areas "SELECT j.study, j.position, j.cell_size_m, j.initial_area_m2, d.value AS area_difference_m2,
  t.value AS topology_changed_time_s FROM jobs j JOIN metrics d ON d.key = j.key AND d.name = 'area_difference_m2'
  LEFT JOIN metrics t ON t.key = j.key AND t.name = 'topology_changed_time_s' WHERE j.status = 'done' AND
  j.study NOT LIKE 'critical-speed%' ORDER BY j.study, j.position"
for figure in fig1-grey fig2 fig2-grey fig3-grey fig4 fig4-spall fig5 fig5-grey fig6-grey fig7-1-grey fig7-6-grey \
  fig7-aspect fig8a fig8b fig8c fig8d block-height; do
  cp "$results"/figures/*/"$figure.png" "$into/"  # a name is that of one study here
done
if [ -z "$quick" ]; then
  echo "collapsibility-quick.csv stays as it was: the folder of a quick run was not given" >&2
else
  results=$quick
  ask collapsibility-quick "$collapsibility"
fi
