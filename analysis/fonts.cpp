#include "analysis/fonts.hpp"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>

namespace analysis {
namespace {

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};

/// Asks fontconfig once per character: pango, which gnuplot draws with, takes any font that has it.
bool has_font(FcChar32 character) {
  static std::mutex mutex;
  static std::map<FcChar32, bool> known;
  const std::scoped_lock lock(mutex);
  if (const auto found = known.find(character); found != known.end()) return found->second;
  const std::unique_ptr<FcCharSet, Destroy<FcCharSetDestroy>> wanted(FcCharSetCreate());
  FcCharSetAddChar(wanted.get(), character);
  const std::unique_ptr<FcPattern, Destroy<FcPatternDestroy>> pattern(FcPatternCreate());
  FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
  const std::unique_ptr<FcObjectSet, Destroy<FcObjectSetDestroy>> objects(
      FcObjectSetBuild(FC_FAMILY, nullptr));
  const std::unique_ptr<FcFontSet, Destroy<FcFontSetDestroy>> fonts(
      FcFontList(nullptr, pattern.get(), objects.get()));
  return known[character] = fonts && fonts->nfont > 0;
}

/// Calls visit(bytes of a character, whether it can be drawn). What is no UTF-8 cannot.
template <class Visit>
void for_each_character(std::string_view text, Visit visit) {
  while (!text.empty()) {
    FcChar32 character = 0;
    const int length = FcUtf8ToUcs4(reinterpret_cast<const FcChar8*>(text.data()), &character,
                                    static_cast<int>(text.size()));
    const std::size_t bytes = length > 0 ? static_cast<std::size_t>(length) : 1;
    visit(text.substr(0, bytes), length > 0 && (character < 0x80 || has_font(character)));
    text.remove_prefix(bytes);
  }
}

}  // namespace

std::vector<std::string> characters_without_font(std::string_view utf8) {
  std::vector<std::string> missing;
  for_each_character(utf8, [&](std::string_view character, bool drawn) {
    if (!drawn && std::ranges::find(missing, character) == missing.end()) missing.emplace_back(character);
  });
  return missing;
}

std::string drawable(std::string_view utf8) {
  std::string text;
  for_each_character(utf8, [&](std::string_view character, bool drawn) { text += drawn ? character : "?"; });
  return text;
}

}  // namespace analysis
