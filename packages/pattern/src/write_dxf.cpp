#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "dxf_layers.hpp"
#include "format.hpp"
#include "runs.hpp"
#include "toile/base/error.hpp"

namespace toile::pattern {
namespace {

/// How far the polylines of curves keep from them, mm; what is read, a spline through their points, is as close.
constexpr double tolerance = 0.0025;
/// Where a curve turns by more than this, radians, it has a corner.
constexpr double corner = 1e-3;

class Writer {
 public:
  Writer(const Pattern& pattern, const std::string& path)
      : pattern_(pattern), writer_(dxf_.out(path.c_str(), DL_Codes::AC1009)) {}

  /// Whether all could be written.
  bool run() {
    if (writer_ == nullptr || writer_->openFailed()) return false;
    write_head();
    writer_->sectionBlocks();
    for (std::size_t k = 0; k < pattern_.panels.size(); ++k) write_piece(pattern_.panels[k], block_name(k));
    writer_->sectionEnd();
    writer_->sectionEntities();
    text(dxf_layer::boundary, std::string(dxf_text::units) + " METRIC", Vec2::Zero());
    for (std::size_t k = 0; k < pattern_.panels.size(); ++k)
      dxf_.writeInsert(*writer_, DL_InsertData(block_name(k), 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 1, 1, 0.0, 0.0),
                       on(dxf_layer::boundary));
    writer_->sectionEnd();
    writer_->dxfEOF();
    writer_->close();
    return true;
  }

 private:
  static std::string block_name(std::size_t k) { return "PIECE" + std::to_string(k + 1); }

  static DL_Attributes on(const char* layer) { return {layer, 256, -1, "BYLAYER", 1.0}; }

  void write_head() {
    dxf_.writeHeader(*writer_);
    writer_->dxfString(9, "$INSUNITS");
    writer_->dxfInt(70, 4);
    writer_->sectionEnd();
    writer_->sectionTables();
    const char* const layers[] = {dxf_layer::boundary, dxf_layer::turn_points, dxf_layer::curve_points,
                                  dxf_layer::notches,  dxf_layer::grain,       dxf_layer::lines,
                                  dxf_layer::cutouts,  dxf_layer::notes};
    writer_->tableLayers(static_cast<int>(std::size(layers)));
    for (const char* layer : layers)
      dxf_.writeLayer(*writer_, DL_LayerData(layer, 0), DL_Attributes("", 7, 0, "CONTINUOUS", 1.0));
    writer_->tableEnd();
    writer_->sectionEnd();
  }

  void write_piece(const Panel& panel, const std::string& block) {
    dxf_.writeBlock(*writer_, DL_BlockData(block, 0, 0.0, 0.0, 0.0));
    text(dxf_layer::boundary, std::string(dxf_text::piece) + " " + panel.name, panel.outline.front().curve.front());
    write_loop(panel.outline, dxf_layer::boundary);
    for (const Loop& hole : panel.holes) write_loop(hole, dxf_layer::cutouts);
    for (const InternalLine& line : panel.lines) {
      polyline(points_of({{line.name, line.curve}}), dxf_layer::lines, false);
      text(dxf_layer::notes, std::string(dxf_text::line) + " " + line.name, line.curve.front());
    }
    for (const Notch& notch : panel.notches) {
      const Vec2 at = panel.edge(notch.edge)->curve.at(notch.at);
      point(dxf_layer::notches, at);
      text(dxf_layer::notes, std::string(dxf_text::notch) + " " + notch.name, at);
    }
    if (panel.grain)
      dxf_.writeLine(
          *writer_,
          DL_LineData(panel.grain->from.x(), panel.grain->from.y(), 0.0, panel.grain->to.x(), panel.grain->to.y(), 0.0),
          on(dxf_layer::grain));
    dxf_.writeEndBlock(*writer_, block);
  }

  void write_loop(const Loop& loop, const char* layer) {
    polyline(points_of(loop), layer, true);
    for (const Edge& edge : loop)
      for (const Curve& run : smooth_runs(edge.curve.segments(), corner))
        text(dxf_layer::notes, std::string(dxf_text::edge) + " " + edge.name, run.at(0.5));
  }

  /// Points along edges, with a turn point at each end and corner and a curve point between them.
  std::vector<Vec2> points_of(const Loop& loop) {
    std::vector<Vec2> all;
    for (const Edge& edge : loop)
      for (const Curve& run : smooth_runs(edge.curve.segments(), corner)) {
        const std::vector<Vec2> points = run.points(tolerance);
        point(dxf_layer::turn_points, points.front());
        for (std::size_t k = 1; k + 1 < points.size(); ++k) point(dxf_layer::curve_points, points[k]);
        all.insert(all.end(), points.begin(), points.end() - 1);
      }
    const Vec2 end = loop.back().curve.back();
    if ((end - all.front()).norm() > 1e-6) {
      point(dxf_layer::turn_points, end);
      all.push_back(end);
    }
    return all;
  }

  void polyline(const std::vector<Vec2>& points, const char* layer, bool closed) {
    dxf_.writePolyline(*writer_, DL_PolylineData(static_cast<int>(points.size()), 0, 0, closed ? 1 : 0), on(layer));
    for (const Vec2& p : points) dxf_.writeVertex(*writer_, DL_VertexData(p.x(), p.y()));
    dxf_.writePolylineEnd(*writer_);
  }

  void point(const char* layer, const Vec2& p) {
    dxf_.writePoint(*writer_, DL_PointData(p.x(), p.y(), 0.0), on(layer));
  }

  void text(const char* layer, const std::string& words, const Vec2& at) {
    if (std::any_of(words.begin(), words.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }))
      throw base::InputError("\"" + words + "\": a name with a line end cannot be written to a DXF file");
    dxf_.writeText(*writer_,
                   DL_TextData(at.x(), at.y(), 0.0, at.x(), at.y(), 0.0, 3.0, 1.0, 0, 0, 0, words, "STANDARD", 0.0),
                   on(layer));
  }

  const Pattern& pattern_;
  DL_Dxf dxf_;
  std::unique_ptr<DL_WriterA> writer_;
};

void write_dxf(const Pattern& pattern, const std::string& path) {
  const std::string temporary = temporary_name(path);
  put_in_place(temporary, path, Writer(pattern, temporary).run());
}

}  // namespace

Format dxf_format() {
  return {".dxf", "pieces in the layers of AAMA/ASTM D6673, without stitches and placement", read_dxf, write_dxf};
}

}  // namespace toile::pattern
