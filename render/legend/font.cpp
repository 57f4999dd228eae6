#include "render/legend/font.h"

#include <stdexcept>

#include <ft2build.h>
#include FT_FREETYPE_H

extern "C" const unsigned char isoluxFontBegin[], isoluxFontEnd[];  // embedded_font.S

namespace isolux::render {

namespace {

void check(FT_Error error) {
  if (error) throw std::logic_error("FreeType error " + std::to_string(error) + " on the embedded font");
}

// The code point that starts at `at`, which moves past it. `text` is our own valid UTF-8.
char32_t nextCodePoint(const std::string& text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  char32_t code = more == 0 ? first : first & (0x3Fu >> more);
  for (int i = 0; i < more && at < text.size(); ++i)
    code = (code << 6) | (static_cast<unsigned char>(text[at++]) & 0x3Fu);
  return code;
}

}  // namespace

struct Font::Parts {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  explicit Parts(int pixels) {
    check(FT_Init_FreeType(&library));
    try {
      check(FT_New_Memory_Face(library, isoluxFontBegin, isoluxFontEnd - isoluxFontBegin, 0, &face));
      check(FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(pixels)));
    } catch (...) {
      FT_Done_FreeType(library);  // and its faces
      throw;
    }
  }
  ~Parts() { FT_Done_FreeType(library); }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  // Calls visit(pen position in 1/64 pixel) with each glyph loaded into the face; returns the end of the pen.
  template <class Visit>
  FT_Pos walk(const std::string& text, FT_Int32 flags, Visit visit) const {
    FT_Pos pen = 0;
    FT_UInt before = 0;
    for (std::size_t at = 0; at < text.size();) {
      const FT_UInt glyph = FT_Get_Char_Index(face, nextCodePoint(text, at));
      FT_Vector kerning{0, 0};
      if (before) check(FT_Get_Kerning(face, before, glyph, FT_KERNING_DEFAULT, &kerning));
      pen += kerning.x;
      check(FT_Load_Glyph(face, glyph, flags));
      visit(pen);
      pen += face->glyph->advance.x;
      before = glyph;
    }
    return pen;
  }
};

Font::Font(int pixels) : parts_(std::make_unique<Parts>(pixels)) {}
Font::~Font() = default;

int Font::width(const std::string& text) const {
  return static_cast<int>((parts_->walk(text, FT_LOAD_TARGET_LIGHT, [](FT_Pos) {}) + 63) / 64);
}

int Font::ascent() const {
  check(FT_Load_Char(parts_->face, 'H', FT_LOAD_TARGET_LIGHT));
  return static_cast<int>((parts_->face->glyph->metrics.horiBearingY + 32) / 64);
}

int Font::lineHeight() const {
  return static_cast<int>((parts_->face->size->metrics.height + 63) / 64);
}

void Font::draw(const std::string& text, glm::ivec2 origin, const Plot& plot) const {
  parts_->walk(text, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT, [&](FT_Pos pen) {
    const FT_GlyphSlot glyph = parts_->face->glyph;
    const FT_Bitmap& bitmap = glyph->bitmap;
    const glm::ivec2 corner(origin.x + static_cast<int>((pen + 32) / 64) + glyph->bitmap_left,
                            origin.y - glyph->bitmap_top);
    for (int y = 0; y < static_cast<int>(bitmap.rows); ++y)
      for (int x = 0; x < static_cast<int>(bitmap.width); ++x)
        plot(corner + glm::ivec2(x, y), bitmap.buffer[y * bitmap.pitch + x]);
  });
}

}  // namespace isolux::render
