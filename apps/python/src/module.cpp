// The Python module toile: a scene from a file or a dictionary, its run, and what is known of it as NumPy arrays.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>

#include "py_session.hpp"
#include "toile/base/error.hpp"
#include "toile/base/units.hpp"

namespace py = pybind11;

namespace toile::python {

namespace {

template <class F>
auto column(const std::vector<result::LevelRow>& rows, const F& value) {
  std::vector<std::decay_t<decltype(value(rows.front()))>> values;
  for (const result::LevelRow& row : rows) values.push_back(value(row));
  return values;
}

py::dict table(const std::vector<result::LevelRow>& rows) {
  using Row = result::LevelRow;
  const auto numbers = [&rows](double Row::*member, double factor) {
    return copied(column(rows, [=](const Row& row) { return factor * row.*member; }));
  };
  const auto flags = [&rows](bool Row::*member) {
    py::array_t<bool> values(static_cast<py::ssize_t>(rows.size()));
    for (size_t i = 0; i < rows.size(); ++i) values.mutable_at(i) = rows[i].*member;
    return values;
  };
  py::dict columns;
  columns["title"] = column(rows, [](const Row& row) { return row.title(); });
  columns["panels"] = column(rows, [](const Row& row) { return row.panels; });
  columns["height"] = numbers(&Row::height, 1.0);
  columns["girth"] = numbers(&Row::girth, 1.0);
  columns["pressure"] = numbers(&Row::pressure_mean, base::kpa_per_mpa);
  columns["pressure_error"] = numbers(&Row::pressure_error, base::kpa_per_mpa);
  columns["pressure_min"] = numbers(&Row::pressure_min, base::kpa_per_mpa);
  columns["pressure_max"] = numbers(&Row::pressure_max, base::kpa_per_mpa);
  columns["laplace"] = numbers(&Row::laplace, base::kpa_per_mpa);
  columns["hoop_tension"] = numbers(&Row::hoop_tension, 1.0);
  columns["closed"] = flags(&Row::closed);
  columns["at_support"] = flags(&Row::at_support);
  return columns;
}

py::array rows_of(const std::vector<solve::Vec3>& values) {
  py::array_t<double> array({static_cast<py::ssize_t>(values.size()), py::ssize_t{3}});
  for (size_t i = 0; i < values.size(); ++i)
    for (int d = 0; d < 3; ++d) array.mutable_at(i, d) = values[i][d];
  return std::move(array);
}

py::dict points(const PySession& session) {
  py::dict found;
  const std::vector<scene::Point>& points = session.scene().output().points;
  for (size_t i = 0; i < points.size(); ++i) found[py::str(points[i].title)] = rows_of(session.record().points()[i]);
  return found;
}

py::dict distances(const PySession& session) {
  py::dict found;
  const std::vector<scene::Distance>& wanted = session.scene().output().distances;
  for (size_t i = 0; i < wanted.size(); ++i) found[py::str(wanted[i].title)] = copied(session.record().distances()[i]);
  return found;
}

py::dict reactions(const PySession& session) {
  py::dict found;
  const std::vector<solve::Support>& supports = session.scene().problem().supports;
  for (size_t s = 0; s < supports.size(); ++s) {
    std::vector<solve::Vec3> forces;
    for (const solve::StepReport& r : session.record().reports()) forces.push_back(r.balance.support[s]);
    found[py::str(supports[s].name)] = rows_of(forces);
  }
  return found;
}

py::dict edges(const PySession& session) {
  py::dict found;
  for (const auto& [name, nodes] : session.scene().garment().mesh.edges) found[py::str(name)] = copied(nodes);
  return found;
}

/// Elements of one panel and fabric, as the session has them.
struct Block {
  py::object session;
  const mesh::Block* block;
};

py::list blocks(const py::object& self) {
  py::list found;
  for (const mesh::Block& block : self.cast<const PySession&>().scene().garment().mesh.blocks)
    found.append(Block{self, &block});
  return found;
}

const mesh::Mesh& mesh_of(const py::object& self) {
  return self.cast<const PySession&>().scene().garment().mesh;
}

// ---- What is declared. toile.pyi says the same to editors and type checkers.

void add_errors(py::module_& m) {
  static py::exception<base::Error> error(m, "Error");
  static py::exception<base::InputError> input(m, "InputError", error);
  static py::exception<base::SolveError> solve(m, "SolveError", error);
  static py::exception<void> check(m, "CheckError", error);
  error.doc() = "What Toile cannot do; the base of its other errors.";
  input.doc() =
      "The scene, or a file that it names, cannot be used; the message names list, parameter and what is allowed.";
  solve.doc() = "A stage could not reach its end. The session holds the last converged state.";
  check.doc() = "All was computed, but a check of the scene does not hold.";
  // NOLINTNEXTLINE(performance-unnecessary-value-param): a translator is given it by value
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const base::Error& e) {
      switch (e.code()) {
        case base::ExitCode::bad_input:
          input(e.what());
          break;
        case base::ExitCode::solve_failed:
          solve(e.what());
          break;
        case base::ExitCode::check_failed:
          check(e.what());
          break;
        default:
          error(e.what());
      }
    }
  });
}

void add_step(py::module_& m) {
  using solve::StepReport;
  py::class_<StepReport>(m, "Step", "One accepted step of a run.")
      .def_readonly("stage", &StepReport::stage, "Name of its stage.")
      .def_readonly("step", &StepReport::step, "Its number, counted over the run from 1.")
      .def_readonly("parameter", &StepReport::parameter, "Way through the stage, 0 to 1.")
      .def_readonly("load", &StepReport::load, "Load factor.")
      .def_readonly("seam", &StepReport::seam, "How far seams are closed, 0 to 1.")
      .def_readonly("iterations", &StepReport::iterations, "Newton iterations since the step before.")
      .def_readonly("cut_backs", &StepReport::cut_backs, "Failed attempts since the step before.")
      .def_property_readonly(
          "residual", [](const StepReport& r) { return r.accuracy.residual; }, "Relative residual of the forces.")
      .def_property_readonly(
          "strain_energy", [](const StepReport& r) { return r.energy.strain; }, "N mm.")
      .def_property_readonly(
          "dissipated", [](const StepReport& r) { return r.energy.dissipated; }, "Lost to damping so far, N mm.")
      .def_readonly("negative_pivots", &StepReport::negative_pivots, "Of the tangent; 0: stable, -1: not known.")
      .def_readonly("final", &StepReport::undamped, "Whether this is the equilibrium that ends the stage.")
      .def_readonly("seconds", &StepReport::seconds, "Wall time since the start of the run.")
      .def("__repr__", [](const StepReport& r) {
        return "<toile.Step " + std::to_string(r.step) + ": " + std::to_string(std::lround(100.0 * r.parameter)) +
               " % of stage \"" + r.stage + "\">";
      });
}

void add_fields(py::module_& m) {
  using Pointer = std::shared_ptr<FieldSet>;
  py::class_<FieldSet, Pointer>(m, "Fields",
                                "The fields of one state, by the names and in the units of results.exo (`toile "
                                "describe fields`): a value a node or "
                                "an element. Arrays are read-only views, and stay what they are when the run goes on.")
      .def("__getitem__",
           [](const py::object& self, const std::string& name) {
             return scalars(self.cast<const FieldSet&>().at(name).values, self);
           })
      .def("__contains__", [](const FieldSet& f, const std::string& name) { return f.find(name) != nullptr; })
      .def("__len__", [](const FieldSet& f) { return f.names().size(); })
      .def("__iter__", [](const FieldSet& f) { return py::iter(py::cast(f.names())); })
      .def("keys", &FieldSet::names, "Names of all fields: first those of nodes, then those of elements.")
      .def(
          "unit", [](const FieldSet& f, const std::string& name) { return f.at(name).unit; }, py::arg("name"),
          "Unit of a field; empty if it has none.")
      .def_property_readonly(
          "position", [](const py::object& self) { return vectors(self.cast<const FieldSet&>().all().position, self); },
          "(nodes, 3) positions, mm.")
      .def_property_readonly(
          "normal", [](const py::object& self) { return vectors(self.cast<const FieldSet&>().all().normal, self); },
          "(nodes, 3) outward normal of the body at the closest point.");
}

void add_block(py::module_& m) {
  py::class_<Block>(m, "Block", "Elements of one panel that have the same fabric and number of nodes.")
      .def_property_readonly(
          "name", [](const Block& b) { return b.block->name; }, "Unique in the garment.")
      .def_property_readonly(
          "material", [](const Block& b) { return b.block->material; }, "Name of its fabric.")
      .def_property_readonly(
          "connectivity",
          [](const Block& b) {
            return view(b.block->connectivity.data(), {b.block->size(), b.block->nodes_per_element}, b.session);
          },
          "(elements, 3 or 4) nodes of each element, counted from 0.");
}

void add_session(py::module_& m) {
  py::class_<PySession>(m, "Session", "A scene, its run, and the record of the run. Lengths are mm, forces N.")
      .def(py::init<const py::object&, const py::dict&, int, bool, bool>(), py::arg("scene"), py::kw_only(),
           py::arg("settings") = py::dict(), py::arg("threads") = 1, py::arg("allow_plugins") = false,
           py::arg("verbose") = false,
           "Reads and builds a scene: the path of an XML file, or a dictionary of what such a file holds (lists are "
           "dictionaries, arrays are lists or NumPy arrays). `settings`: what is to be another in a file, by paths, "
           "{\"Panels/front/size\": 4}. Raises InputError.")
      .def("run", &PySession::run, py::kw_only(), py::arg("output") = py::none(), py::arg("progress") = py::none(),
           "Takes the garment through every stage. `output`: folder of result files; none are written without. "
           "`progress` is called with each accepted Step; what it raises ends the run and is raised here. What limits "
           "the trust in the result is a UserWarning. Raises "
           "InputError, SolveError, CheckError; the session then holds the last accepted step.")
      .def_property_readonly(
          "title", [](const PySession& s) { return s.scene().title(); }, "Title of the scene.")
      .def_property_readonly(
          "start", [](PySession& s) { return s.session().start_report().lines; },
          "What is there at the start, line by line.")
      .def_property_readonly(
          "warnings", [](PySession& s) { return s.session().log().warnings(); },
          "What limits the trust in the result. Look at them.")
      .def_property_readonly(
          "notes", [](const PySession& s) { return s.record().notes(); }, "What is good to know.")
      .def_property_readonly(
          "steps", [](const PySession& s) { return s.record().reports(); }, "Every accepted Step.")
      .def_property_readonly("fields", &PySession::fields, "Fields of the last accepted step, or of the start.")
      .def_property_readonly(
          "levels", [](const PySession& s) { return table(s.pressure().levels); },
          "Sections at the levels of the scene's Output, as columns: pressures in kPa.")
      .def_property_readonly(
          "curve", [](const PySession& s) { return table(s.pressure().curve); },
          "The same along the axis, at its stations.")
      .def_property_readonly("points", &points, "(steps, 3) displacement of each point of the scene's Output, mm.")
      .def_property_readonly("distances", &distances, "(steps) each distance of the scene's Output, mm.")
      .def_property_readonly("reactions", &reactions, "(steps, 3) force of each support on the garment, N.")
      .def_property_readonly("blocks", &blocks,
                             "Every Block of the garment; element fields have them one after another.")
      .def_property_readonly("edges", &edges, "Nodes along each named edge, \"panel.edge\".")
      .def_property_readonly(
          "pattern",
          [](const py::object& self) {
            const std::vector<mesh::Vec2>& values = mesh_of(self).pattern;
            const double* data = values.empty() ? nullptr : values.front().data();
            return view(data, {static_cast<py::ssize_t>(values.size()), 2}, self);
          },
          "(nodes, 2) coordinates in the flat pattern, mm.")
      .def_property_readonly(
          "placed", [](const py::object& self) { return vectors(mesh_of(self).placed, self); },
          "(nodes, 3) positions at the start, mm.");
}

}  // namespace

}  // namespace toile::python

PYBIND11_MODULE(toile, m) {
  m.doc() =
      "What a garment does to the body that wears it: runs scenes of Toile and gives their results as NumPy arrays.";
  m.attr("__version__") = TOILE_VERSION;
  toile::python::add_errors(m);
  toile::python::add_step(m);
  toile::python::add_fields(m);
  toile::python::add_block(m);
  toile::python::add_session(m);
  m.def(
      "run",
      [](const py::object& scene, const py::object& output, const py::object& progress, const py::dict& settings,
         int threads, bool allow_plugins, bool verbose) {
        auto session = std::make_unique<toile::python::PySession>(scene, settings, threads, allow_plugins, verbose);
        session->run(output, progress);
        return session;
      },
      py::arg("scene"), py::kw_only(), py::arg("output") = py::none(), py::arg("progress") = py::none(),
      py::arg("settings") = py::dict(), py::arg("threads") = 1, py::arg("allow_plugins") = false,
      py::arg("verbose") = false, "Makes a Session of a scene, runs it, and returns it.");
}
