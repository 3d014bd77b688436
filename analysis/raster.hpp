#pragma once
/// Particles as squares of colour on a grid of pixels: an image that stays small however many there are.
#include <vector>

namespace analysis {

struct Window {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;  ///< [m]
  double width() const { return x_max - x_min; }
  double height() const { return y_max - y_min; }
};

/// One snapshot: columns of one length, SI.
struct ParticleSquares {
  std::vector<double> x, y;        ///< centres [m]
  std::vector<double> size;        ///< side of the square that it fills, e.g. sqrt(mass / density) [m]
  std::vector<double> value;       ///< what is coloured
  std::vector<int> material = {};  ///< its number; empty: there is one
  std::vector<double> depth = {};  ///< distance from the plane of the picture [m]; empty: all are in it
};

/// Values by rows from the bottom, from left to right. A pixel that no particle covers is a nan.
struct Raster {
  int columns = 0, rows = 0;
  std::vector<float> values;
};

/// Every pixel takes the value of the particle with the nearest centre (depth counts) among those whose
/// square, enlarged by `overlap`, covers it (stretched material shows no gaps, open cavities stay open). With
/// `mirrored`, each particle is drawn at -x as well. Non-finite particles are left out. Independent of the
/// order of particles, ties aside.
Raster rasterise(const ParticleSquares&, bool mirrored, const Window&, int columns, int rows,
                 double overlap = 2.2);

/// Pieces of the lines between materials, along the edges of pixels: from (x0, y0) to (x1, y1) [m]. None
/// between a material and nothing.
struct Piece {
  double x0, y0, x1, y1;
};
std::vector<Piece> outlines(const ParticleSquares&, bool mirrored, const Window&, int columns, int rows);

/// Where nearly all particles of these snapshots are (all but one in a thousand at each side), with a margin.
Window window_of(const std::vector<const ParticleSquares*>&, bool mirrored);

}  // namespace analysis
