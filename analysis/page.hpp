#pragma once
/// One self-contained HTML page: text, tables, images and animations, nothing loaded from anywhere.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace analysis {

struct PageTable {
  std::string caption;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  ///< plain text
};

struct PageImage {
  std::filesystem::path file;  ///< .png or .svg; its bytes go into the page
  std::string caption;
};

/// Images of equal size that play one after the other. A pixel is 0 (empty) or 1 ... 255 (least to most).
struct PageAnimation {
  std::string title;
  std::string low, high;  ///< what 1 and 255 stand for, with unit
  int columns = 0, rows = 0;
  std::vector<std::string> captions;              ///< of each frame: "t = 1.2 ns"
  std::vector<std::vector<std::uint8_t>> frames;  ///< by rows from the top
};

struct PageSection {
  std::string id;  ///< of links to it: letters, digits, '-'
  std::string heading;
  std::string text;  ///< paragraphs are set apart by empty lines
  std::vector<PageTable> tables;
  std::vector<PageImage> images;
  std::vector<PageAnimation> animations;
};

struct Page {
  std::string title, subtitle, footer;
  std::vector<PageSection> sections;
};

/// The page, as UTF-8. All text is escaped. Animations play by themselves, can be stopped and stepped, and
/// keep the number of the frame that shows in the attribute data-frame of their canvas. Throws
/// std::runtime_error where an image cannot be read.
std::string html_of(const Page&);

}  // namespace analysis
