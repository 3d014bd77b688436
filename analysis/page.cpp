#include "analysis/page.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "analysis/page_style.hpp"

namespace analysis {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

template <class Bytes>
std::string base64(const Bytes& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      result += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return result;
}

std::string image(const PageImage& image) {
  std::ifstream in(image.file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in || bytes.empty()) throw std::runtime_error(image.file.string() + ": cannot be read");
  const bool svg = image.file.extension() == ".svg";
  return fmt::format(
      "<figure><img loading=\"lazy\" alt=\"{0}\" "
      "src=\"data:image/{1};base64,{2}\"><figcaption>{0}</figcaption></figure>\n",
      escaped(image.caption), svg ? "svg+xml" : "png", base64(bytes));
}

std::string table(const PageTable& table) {
  std::string text = "<div class=\"table\"><table>";
  if (!table.caption.empty()) text += "<caption>" + escaped(table.caption) + "</caption>";
  text += "<thead><tr>";
  for (const auto& cell : table.head) text += "<th>" + escaped(cell) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (const auto& cell : row) text += "<td>" + escaped(cell) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string animation(const PageAnimation& a) {
  std::string frames, captions;
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    frames += (i ? " " : "") + base64(a.frames[i]);
    captions += (i ? "|" : "") + a.captions[i];
  }
  return fmt::format(
      "<figure class=\"animation\"><figcaption>{}</figcaption><canvas width=\"{}\" height=\"{}\" "
      "data-frame=\"0\" "
      "data-captions=\"{}\" data-frames=\"{}\"></canvas><div class=\"controls\"><button "
      "type=\"button\">Pause</button>"
      "<input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" aria-label=\"frame\"><output></output></div>"
      "<div class=\"scale\"><span>{}</span><i></i><span>{}</span></div></figure>\n",
      escaped(a.title), a.columns, a.rows, escaped(captions), frames, a.frames.size() - 1, escaped(a.low),
      escaped(a.high));
}

std::string section(const PageSection& s) {
  std::string text = fmt::format("<section id=\"{}\"><h2>{}</h2>\n", escaped(s.id), escaped(s.heading));
  std::size_t start = 0;
  while (start < s.text.size()) {
    const std::size_t end = std::min(s.text.find("\n\n", start), s.text.size());
    text += "<p>" + escaped(s.text.substr(start, end - start)) + "</p>\n";
    start = end + 2;
  }
  for (const auto& a : s.animations) text += animation(a);
  for (const auto& i : s.images) text += image(i);
  for (const auto& t : s.tables) text += table(t);
  return text + "</section>\n";
}

}  // namespace

std::string html_of(const Page& page) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>{0}</title>"
      "<style>{2}</style></head>\n<body><header><h1>{0}</h1><p>{1}</p><nav>",
      escaped(page.title), escaped(page.subtitle), page_style);
  for (const auto& s : page.sections)
    text += fmt::format("<a href=\"#{}\">{}</a> ", escaped(s.id), escaped(s.heading));
  text += "</nav></header>\n<main>\n";
  for (const auto& s : page.sections) text += section(s);
  return text + fmt::format("</main>\n<footer>{}</footer>\n<script>{}</script>\n</body></html>\n",
                            escaped(page.footer), page_script);
}

}  // namespace analysis
