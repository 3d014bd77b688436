#pragma once
/// Runs gnuplot on a script, without a shell.
#include <filesystem>
#include <string>
#include <string_view>

namespace analysis {

/// Text as a gnuplot string: quoted, on one line, nothing in it is evaluated; a question mark for characters
/// that no font has (fonts.hpp).
std::string gnuplot_text(std::string_view text);

/// A folder beside the figure for its script and data; removed with everything in it at the end. The same
/// file system as the figure's, so that a finished one can be renamed into place.
class FigureFolder {
 public:
  /// Throws std::runtime_error naming the folder where it can't be made.
  explicit FigureFolder(const std::filesystem::path& stem);
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;
  ~FigureFolder();

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, std::string_view content) const;

 private:
  std::filesystem::path path_;
};

/// Size in points of 1/72 inch at reading size; a PNG has twice as many pixels.
struct FigureSize {
  int width = 900, height = 600;
};
/// Of figures with one pair of axes.
inline constexpr FigureSize figure_size{900, 600};

/// Draws `body` (everything but terminal and output) to stem.png and stem.svg. Both are made in the folder
/// and then renamed: an older figure stays until the newer one is whole. Data files are named relative to the
/// folder. Throws std::runtime_error with what gnuplot said where it is missing or fails.
void run_gnuplot(const FigureFolder&, const std::string& body, FigureSize, const std::filesystem::path& stem);

}  // namespace analysis
