#pragma once
/// The kinds of scene, one line each. The enum SceneKind and the list of all Kinds (list.cpp) are made of it:
/// a kind is added by its file of this folder, which defines `extern constinit const Kind NAME`, and its line
/// here.
#define MPM_SCENE_KINDS(KIND)                                                                       \
  /* A block with a cavity; y along the impact, the wall is y = 0, v_y = -impact_speed. */          \
  KIND(cavity_impact)                                                                               \
  /* The same block without the cavity. */                                                          \
  KIND(planar_impact)                                                                               \
  /* The block with the cavity at -impact_speed onto a block of the same size without one, which */ \
  /* comes at +impact_speed; they meet at y = 0, and hold together there once they have met. */     \
  KIND(two_body_impact)                                                                             \
  /* A ring that nothing touches, with v(r) = -inner_speed inner_radius / r. */                     \
  KIND(imploding_shell)                                                                             \
  /* Bodies of any shape and material in a box. */                                                  \
  KIND(bodies)
