#include "dxf_pieces.hpp"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "dxf_layers.hpp"
#include "format.hpp"
#include "toile/base/error.hpp"
#include "toile/base/file.hpp"

namespace toile::pattern::dxf {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// mm of a value of $INSUNITS; 0 if it is none of a pattern's.
double unit_of(int code) {
  switch (code) {
    case 1:
      return 25.4;
    case 4:
      return 1.0;
    case 5:
      return 10.0;
    case 6:
      return 1000.0;
    default:
      return 0.0;
  }
}

/// mm of the standard's word for a unit; 0 if it is none of these.
double unit_of(const std::string& word) {
  return word == "METRIC" ? 1.0 : word == "ENGLISH" || word == "IMPERIAL" ? 25.4 : 0.0;
}

/// Collects what dxflib finds.
class Collector : public DL_CreationAdapter {
 public:
  File file;  ///< without its unit

  /// mm of the file's unit; 0 if it does not tell. The text goes before the variable, which must not say otherwise.
  double unit() const {
    const double variable = unit_of(variable_), text = unit_of(text_);
    if (text_.empty()) return variable;
    if (variable != 0.0 && text != 0.0 && variable != text)
      throw base::InputError(
          "the file contradicts itself on its unit: the variable $INSUNITS = " + std::to_string(variable_) + " says " +
          number_text(variable) + " mm, the text \"UNITS: " + text_ + "\" says " + number_text(text) +
          " mm. Measure a piece, and take the wrong one of the two out of the file");
    return text;
  }

  void addBlock(const DL_BlockData& block) override {
    file.blocks.push_back({block.name, {}, {}, {}});
    in_block_ = true;
  }
  void endBlock() override { in_block_ = false; }
  void addPoint(const DL_PointData& p) override { piece().points.push_back({layer(), at(p.x, p.y)}); }
  void addLine(const DL_LineData& l) override {
    piece().lines.push_back({layer(), {{at(l.x1, l.y1)}, {at(l.x2, l.y2)}}, false});
  }
  void addPolyline(const DL_PolylineData& p) override { piece().lines.push_back({layer(), {}, (p.flags & 1) != 0}); }
  void addVertex(const DL_VertexData& v) override {
    if (piece().lines.empty()) throw base::InputError("a vertex outside of a polyline");
    piece().lines.back().vertices.push_back({at(v.x, v.y), std::isfinite(v.bulge) ? v.bulge : 0.0});
  }
  void addText(const DL_TextData& t) override {
    const Vec2 place = at(t.ipx, t.ipy);
    piece().texts.push_back({t.text, place});
    if (const std::string unit = upper(after(t.text, dxf_text::units)); !unit.empty()) text_ = unit;
  }
  void addInsert(const DL_InsertData& insert) override {
    if (std::abs(insert.sx - 1.0) > 1e-9 || std::abs(insert.sy - 1.0) > 1e-9)
      throw base::InputError("block \"" + insert.name +
                             "\" is inserted at another size; pieces are read at size 1 only");
  }
  void setVariableInt(const std::string& name, int value, int) override {
    if (name == "$INSUNITS") variable_ = value;
  }
  void addSpline(const DL_SplineData&) override { refuse("SPLINE"); }
  void addArc(const DL_ArcData&) override { refuse("ARC"); }
  void addCircle(const DL_CircleData&) override { refuse("CIRCLE"); }
  void addEllipse(const DL_EllipseData&) override { refuse("ELLIPSE"); }

 private:
  Piece& piece() { return in_block_ ? file.blocks.back() : file.outside; }
  std::string layer() { return getAttributes().getLayer(); }

  static Vec2 at(double x, double y) {
    if (!(std::abs(x) <= largest_coordinate && std::abs(y) <= largest_coordinate))
      throw base::InputError("a coordinate is no number or too large for a garment");
    return {x, y};
  }

  /// Where they would be part of a piece.
  void refuse(const std::string& entity) {
    const std::string on = layer();
    for (const char* read : {dxf_layer::boundary, dxf_layer::lines, dxf_layer::cutouts, dxf_layer::sew_lines})
      if (in_block_ && on == read)
        throw base::InputError("block \"" + piece().name + "\" has the entity " + entity + " on layer " + on +
                               "; ASTM D6673 has polylines there; export it as such");
  }

  static std::string number_text(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
  }

  bool in_block_ = false;
  int variable_ = 0;  ///< $INSUNITS
  std::string text_;  ///< word of the text
};

/// The library reads the rest of a damaged file as it can; that the file is one of groups is checked before.
void check_groups(const std::string& text) {
  std::istringstream in(text);
  std::string code, value, last;
  for (std::size_t line = 1; std::getline(in, code); line += 2) {
    code.erase(std::remove_if(code.begin(), code.end(), [](unsigned char c) { return std::isspace(c) != 0; }),
               code.end());
    const bool is_number = !code.empty() && code.size() < 5 &&
                           std::all_of(code.begin(), code.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!is_number)
      throw base::InputError("line " + std::to_string(line) +
                             ": expected the code of a group, a whole number, found \"" + code.substr(0, 40) +
                             "\"; only DXF files in ASCII are read");
    if (!std::getline(in, value)) break;
    last = value;
    while (!last.empty() && std::isspace(static_cast<unsigned char>(last.back())) != 0) last.pop_back();
    if (code == "0" && last.find("EOF") != std::string::npos) return;
  }
  throw base::InputError("the file ends before its end mark, EOF; it is cut off");
}

}  // namespace

std::string after(const std::string& text, const std::string& keyword) {
  if (upper(text.substr(0, keyword.size())) != keyword) return "";
  const std::size_t from = text.find_first_not_of(' ', keyword.size());
  if (from == std::string::npos) return "";
  return text.substr(from, text.find_last_not_of(" \r") + 1 - from);
}

File read_pieces(const std::string& path) {
  const std::string text = base::read_file(path, "a DXF file", largest_file);
  try {
    check_groups(text);
    std::istringstream in(text);
    Collector collector;
    DL_Dxf dxf;
    if (!dxf.in(in, &collector)) throw base::InputError("this is no DXF file");
    collector.file.mm = collector.unit();
    return std::move(collector.file);
  } catch (const base::InputError& error) {
    throw base::InputError(path + ": " + error.what());
  } catch (const std::exception& error) {
    throw base::InputError(path + ": this DXF file is damaged: " + error.what());
  }
}

}  // namespace toile::pattern::dxf
