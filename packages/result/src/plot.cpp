#include "toile/result/plot.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <limits>
#include <sstream>

#include "toile/base/process.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::result {
namespace {

/// A text in gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) {
    result += letter == '\n' ? ' ' : letter;
    if (letter == '\'') {
      result += letter;
    }
  }
  return result + "'";
}

/// A label in the data file's double quotes.
std::string label(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    result += letter == '"' || letter == '\n' ? ' ' : letter;
  }
  return result + "\"";
}

void write_text(const std::string& path, const std::string& text) {
  replace_file(path, text, "cannot write the plot '" + path + "': ");
}

/// One block (gnuplot: index) a series: x, y, error, label; blocks are separated by two empty lines.
std::string data_text(const Plot& plot) {
  std::ostringstream out;
  out << std::setprecision(10);
  for (const Series& series : plot.series) {
    out << "# " << label(series.title) << '\n';
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
        out << '\n';
        continue;
      }
      out << series.x[i] << ' ' << series.y[i];
      if (!series.errors.empty()) {
        out << ' ' << series.errors[i];
      }
      if (!series.labels.empty()) {
        out << ' ' << label(series.labels[i]);
      }
      out << '\n';
    }
    out << "\n\n";
  }
  return out.str();
}

/// The parts of gnuplot's plot command for one series.
std::vector<std::string> curves(const std::string& data, const Series& series, std::size_t index) {
  const std::string style = " linetype " + std::to_string(series.colour > 0 ? series.colour : index + 1);
  const std::string title = series.title.empty() ? " notitle" : " title " + quoted(series.title);
  const char* kind = !series.markers ? " with lines linewidth 2" : series.line ? " with linespoints" : " with points";
  const std::string source = quoted(data) + " index " + std::to_string(index);
  std::vector<std::string> result;
  if (!series.errors.empty()) {
    result.push_back(source +
                     (series.line
                          ? " using 1:($2-$3):($2+$3) with filledcurves fillstyle transparent solid 0.2 noborder"
                          : " using 1:2:3 with yerrorbars pointtype 7 linewidth 2") +
                     style + " notitle");
  }
  result.push_back(source + " using 1:2" + kind + (series.markers ? " pointtype 7 pointsize 1.3" : "") + style + title);
  if (!series.labels.empty()) {
    result.push_back(source + " using 1:2:" + (series.errors.empty() ? "3" : "4") + " with labels offset 0,1 notitle");
  }
  return result;
}

/// Round step (1, 2 or 5 times a power of ten) that divides `span` into about six parts.
double tic_step(double span) {
  const double wanted = span / 6.0;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  return power * (wanted < 1.5 * power ? 1.0 : wanted < 3.5 * power ? 2.0 : wanted < 7.5 * power ? 5.0 : 10.0);
}

/// Largest minus smallest ordinate; counted from zero if the axis is.
double ordinate_span(const Plot& plot) {
  double low = plot.y_from_zero ? 0.0 : std::numeric_limits<double>::infinity();
  double high = plot.y_from_zero ? 0.0 : -low;
  for (const Series& series : plot.series) {
    for (const double y : series.y) {
      low = std::isfinite(y) ? std::min(low, y) : low;
      high = std::isfinite(y) ? std::max(high, y) : high;
    }
  }
  return high > low ? high - low : 1.0;
}

/// gnuplot does not choose tics for a linked axis, so their step is given.
void write_second_axis(std::ostream& out, const Plot& plot) {
  const SecondAxis& axis = *plot.second_axis;
  out << "set ytics nomirror\n"
      << "set link y2 via " << axis.factor << "*y inverse y/" << axis.factor << '\n'
      << "set y2label " << quoted(axis.label) << '\n'
      << "set y2tics " << tic_step(axis.factor * ordinate_span(plot)) << '\n';
}

std::string script_text(const std::string& name, const Plot& plot) {
  std::ostringstream out;
  out << std::setprecision(10) << "set encoding utf8\n"
      << "set title " << quoted(plot.title) << " noenhanced\n"
      << "set xlabel " << quoted(plot.x_label) << " noenhanced\n"
      << "set ylabel " << quoted(plot.y_label) << " noenhanced\n"
      << "set key noenhanced " << (plot.legend_above ? "tmargin center horizontal" : "top right") << '\n'
      << "set grid\n"
      << (plot.logarithmic ? "set logscale xy\nset format \"%h\"\n" : "")
      << (plot.y_from_zero ? "set yrange [0:*]\n" : "")
      << (plot.logarithmic ? "" : "set offsets graph 0.02, graph 0.02, graph 0.08, 0\n");
  if (plot.second_axis) {
    write_second_axis(out, plot);
  }
  std::string command = "plot ";
  const char* separator = "";
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    for (const std::string& curve : curves(name + ".dat", plot.series[i], i)) {
      command += separator + curve;
      separator = ", \\\n     ";
    }
  }
  out << "set terminal svg size 900,600 noenhanced background rgb 'white'\n"
      << "set output " << quoted(name + ".svg") << '\n'
      << command << '\n'
      << "set terminal pngcairo size 1350,900 fontscale 1.4 noenhanced\n"
      << "set output " << quoted(name + ".png") << '\n'
      << "replot\n";
  return out.str();
}

/// Runs gnuplot in `folder`, its messages dropped. Returns what went wrong, empty if nothing did.
std::string run_gnuplot(const std::string& folder, const std::string& script, double limit) {
  base::ProcessOptions options;
  options.folder = folder;
  options.most_seconds = limit;
  const base::ProcessEnd end = base::run_process({"gnuplot", script}, options);
  if (!end.found) return "gnuplot was not found";
  if (end.out_of_time) {
    std::ostringstream text;
    text << "gnuplot did not end in " << limit << " s and was ended";
    return text.str();
  }
  return end.status == 0 ? "" : "gnuplot failed";
}

/// Whether a picture is there to its end: gnuplot does not notice a full disk.
bool is_complete(const std::string& path, const std::string& end) {
  std::ifstream stream(path, std::ios::binary);
  const std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::size_t at = content.rfind(end);
  return at != std::string::npos && content.find_first_not_of(" \r\n", at + end.size()) == std::string::npos;
}

/// What is wrong with the pictures that gnuplot says it drew, which are then removed; empty if nothing is.
std::string check_pictures(const std::string& stem) {
  const std::string png_end("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
  for (const auto& [path, end] : {std::pair(stem + ".svg", std::string("</svg>")), std::pair(stem + ".png", png_end)}) {
    if (!is_complete(path, end)) {
      remove_file(path, "cannot remove the picture '" + path + "': ");
      return "gnuplot left '" + path + "' incomplete; the disk may be full";
    }
  }
  return "";
}

}  // namespace

std::optional<std::string> write_plot(const std::string& folder, const std::string& name, const Plot& plot,
                                      double limit) {
  const std::string stem = folder + "/" + name;
  const std::string script = name + ".gp";
  write_text(stem + ".dat", data_text(plot));
  write_text(folder + "/" + script, script_text(name, plot));
  // gnuplot would write through a link.
  for (const char* ending : {".svg", ".png"}) {
    remove_file(stem + ending, "cannot replace the picture '" + stem + ending + "': ");
  }
  std::string problem = run_gnuplot(folder, script, limit);
  if (problem.empty()) {
    problem = check_pictures(stem);
  }
  if (problem.empty()) {
    return std::nullopt;
  }
  return "no picture of '" + stem + "': " + problem + "; run 'gnuplot " + script + "' in that folder to draw it";
}

}  // namespace toile::result
