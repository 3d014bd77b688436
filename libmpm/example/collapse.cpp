// How much of a cavity does a weak shock close? Build a scene, run it, read the area.
#include <cstdio>

#include "libmpm/mpm.hpp"

int main() {
  mpm::Scene scene;
  scene.kind = mpm::SceneKind::cavity_impact;
  scene.material = mpm::named_material("aluminium");
  scene.impact_speed = 200;   // m/s
  scene.block_width = 10e-6;  // m
  scene.block_height = 5e-6;
  scene.cavity_radius = 1.5e-6;
  scene.cavity_center_height = 1.9e-6;
  scene.end_time = 6e-9;  // s
  scene.numerics = mpm::default_numerics(scene.kind);
  scene.numerics.cell_size = 0.2e-6;
  scene.measures.area_every = 0.1e-9;

  const mpm::RunResult result = mpm::run(scene);
  if (result.status != mpm::RunStatus::done) {
    std::fprintf(stderr, "the run failed: %s\n", result.reason.c_str());
    return 1;
  }
  std::printf("area %.3f -> %.3f um2, collapsibility %.3f +- %.3f, energy error %.1e\n",
              *result.initial_area * 1e12, *result.final_area * 1e12, *result.collapsibility,
              *result.collapsibility_error, result.energy_error);
}
