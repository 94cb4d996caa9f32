// A run of a scene, and its fields, as Python has them.
#pragma once

#include <pybind11/pybind11.h>

#include <Tpetra_Core.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "scene_list.hpp"
#include "toile/base/variant.hpp"
#include "toile/material/read_laws.hpp"
#include "toile/run/outputs.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::python {

/// The fields of one state, as results.exo has them. Made once; arrays refer to it and keep it.
class FieldSet {
 public:
  FieldSet(const solve::Problem& problem, std::shared_ptr<const solve::Fields> fields)
      : fields_(std::move(fields)),
        nodal_(solve::nodal_fields(problem, *fields_)),
        element_(solve::element_fields(*fields_)) {}

  const solve::Fields& all() const { return *fields_; }
  const solve::NamedField* find(const std::string& name) const {
    for (const auto* fields : {&nodal_, &element_})
      for (const solve::NamedField& field : *fields)
        if (field.name == name) return &field;
    return nullptr;
  }
  const solve::NamedField& at(const std::string& name) const {
    if (const solve::NamedField* field = find(name)) return *field;
    throw py::key_error("there is no field \"" + name + "\"" + base::hint(name, names()));
  }
  base::Texts names() const {
    base::Texts names;
    for (const auto* fields : {&nodal_, &element_})
      for (const solve::NamedField& field : *fields) names.push_back(field.name);
    return names;
  }

 private:
  std::shared_ptr<const solve::Fields> fields_;
  std::vector<solve::NamedField> nodal_, element_;
};
/// Arrays and fields live on when the session is gone; MPI and Kokkos live until Python ends.
inline void initialise() {
  static bool done = false;
  if (std::exchange(done, true)) return;
  char name[] = "toile";
  char* arguments[] = {name, nullptr};
  char** argv = arguments;
  int argc = 1;
  Tpetra::initialize(&argc, &argv);
  py::module_::import("atexit").attr("register")(py::cpp_function([] { Tpetra::finalize(); }));
}

/// Calls Python while a run goes on. What is raised there ends the run.
class Follower : public run::Observer {
 public:
  explicit Follower(py::object progress) : progress_(std::move(progress)) {}
  ~Follower() override {
    const py::gil_scoped_acquire python;
    progress_ = py::object();
  }

  void step(const run::Record& record) override {
    const py::gil_scoped_acquire python;
    if (!progress_.is_none()) progress_(record.last());
  }
  /// So that Ctrl-C ends a run.
  void iteration(const run::Record&, const solve::IterationReport&) override {
    const py::gil_scoped_acquire python;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

 private:
  py::object progress_;
};

class PySession {
 public:
  PySession(const py::object& scene, const py::dict& settings, int threads, bool allow_plugins, bool verbose)
      : verbose_(verbose) {
    initialise();
    run::Options options;
    options.threads = threads;
    options.allow_plugins = allow_plugins;
    if (Tpetra::getDefaultComm()->getRank() == 0) options.log = base::Log(std::cout, std::cerr, !verbose);
    if (!verbose) options.log = base::Log();
    if (py::isinstance<py::dict>(scene)) {
      if (!settings.empty()) throw py::value_error("settings are for the file of a scene; set them in the dictionary");
      Teuchos::ParameterList list("scene");
      fill(list, scene.cast<py::dict>(), "scene");
      session_ = std::make_unique<run::Session>(list, "dictionary", options);
    } else {
      const auto path = py::module_::import("os").attr("fspath")(scene).cast<std::string>();
      session_ = settings.empty()
                     ? std::make_unique<run::Session>(path, options)
                     : std::make_unique<run::Session>(variant(path, settings, allow_plugins), path, options);
    }
  }

  void run(const py::object& output, const py::object& progress) {
    if (ran_) throw py::value_error("a session runs once; make another one of the same scene");
    run::OutputOptions options;
    if (!output.is_none()) options.folder = py::module_::import("os").attr("fspath")(output).cast<std::string>();
    run::add_outputs(*session_, options);
    ran_ = true;
    session_->add(std::make_unique<Follower>(progress));  // last: what it ends is written
    {
      const py::gil_scoped_release others;
      session_->run();
    }
    if (!verbose_) warn();
  }

  const run::Record& record() const { return session_->record(); }
  const scene::Scene& scene() const { return session_->scene(); }
  run::Session& session() { return *session_; }

  std::shared_ptr<FieldSet> fields() {
    const auto now = record().shared_fields();
    if (fields_ == nullptr || &fields_->all() != now.get())
      fields_ = std::make_shared<FieldSet>(scene().problem(), now);
    return fields_;
  }

  const run::PressureReport& pressure() const {
    if (record().reports().empty()) throw py::value_error("no step of the run was accepted yet");
    return record().pressure();
  }

 private:
  static Teuchos::ParameterList variant(const std::string& file, const py::dict& settings, bool allow_plugins) {
    base::Variant variant({file}, "scene");
    const base::Spec spec = scene::scene_spec(material::read_laws(file, "scene", allow_plugins));
    for (const auto& [key, value] : settings) {
      const auto path = py::str(key).cast<std::string>();
      variant.set(spec, path, text_of(path, value));
    }
    return variant.content();
  }
  /// What nobody has printed must not pass unseen.
  void warn() {
    for (const std::string& warning : session_->log().warnings())
      if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) throw py::error_already_set();
  }

  std::unique_ptr<run::Session> session_;
  std::shared_ptr<FieldSet> fields_;
  bool verbose_, ran_ = false;
};

}  // namespace toile::python
