// A checkpoint as named arrays: one list of its members serves both ways.
#include <algorithm>
#include <type_traits>

#include "toile/base/error.hpp"
#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

namespace {

/// Writes members into named arrays, or reads them back.
class Archive {
 public:
  Archive(CheckpointArrays& arrays, bool reads) : arrays_(arrays), reads_(reads) {}
  bool reads() const { return reads_; }
  [[noreturn]] void fail(const std::string& name) const {
    throw base::InputError("the checkpoint is not complete: \"" + prefix_ + name +
                           "\" is missing, or not as it must be");
  }

  void operator()(const std::string& name, double& v) { one(arrays_.reals, name, v); }
  void operator()(const std::string& name, int& v) { one(arrays_.integers, name, v); }
  void operator()(const std::string& name, bool& v) {
    int value = v ? 1 : 0;
    one(arrays_.integers, name, value);
    v = value != 0;
  }
  void operator()(const std::string& name, std::string& v) { whole(arrays_.texts, name, v); }
  void operator()(const std::string& name, std::vector<double>& v) { whole(arrays_.reals, name, v); }
  void operator()(const std::string& name, std::vector<int>& v) { whole(arrays_.integers, name, v); }
  void operator()(const std::string& name, Vec3& v) {
    std::vector<Vec3> values = {v};
    (*this)(name, values);
    if (values.size() != 1) fail(name);
    v = values.front();
  }
  void operator()(const std::string& name, std::vector<Vec3>& v) { tuples<3>(name, v); }
  void operator()(const std::string& name, std::vector<Frame>& v) { tuples<9>(name, v); }
  void operator()(const std::string& name, std::vector<std::array<double, 2>>& v) { tuples<2>(name, v); }
  void operator()(const std::string& name, std::vector<std::string>& v) {
    constexpr char end = '\x1e';  // what separates records
    std::string all;
    for (const std::string& text : v) all += text + end;
    (*this)(name, all);
    v.clear();
    for (size_t from = 0, to = 0; (to = all.find(end, from)) != std::string::npos; from = to + 1)
      v.push_back(all.substr(from, to - from));
  }
  void operator()(const std::string& name, std::set<std::string>& v) {
    std::vector<std::string> all(v.begin(), v.end());
    (*this)(name, all);
    v = {all.begin(), all.end()};
  }
  template <class T, std::enable_if_t<std::is_enum_v<T>, int> = 0>
  void operator()(const std::string& name, T& v) {
    int value = static_cast<int>(v);
    (*this)(name, value);
    v = static_cast<T>(value);
  }
  template <class T>
  void maybe(const std::string& name, std::optional<T>& v) {
    bool known = v.has_value();
    (*this)(name + " is known", known);
    if (!known)
      v.reset();
    else if (!v)
      v.emplace();
    if (v) inner(name, *v);
  }
  /// A struct: its members after its name.
  template <class T>
  void inner(const std::string& name, T& v) {
    const std::string outer = prefix_;
    prefix_ += name + ": ";
    members(*this, v);
    prefix_ = outer;
  }
  template <class T>
  void list(const std::string& name, std::vector<T>& v) {
    int count = static_cast<int>(v.size());
    (*this)(name + " count", count);
    v.resize(static_cast<size_t>(count));
    for (size_t i = 0; i < v.size(); ++i) inner(name + " " + std::to_string(i), v[i]);
  }

 private:
  template <class T>
  void whole(std::map<std::string, T>& all, const std::string& name, T& v) {
    if (!reads_) {
      all[prefix_ + name] = v;
      return;
    }
    const auto found = all.find(prefix_ + name);
    if (found == all.end()) fail(name);
    v = found->second;
  }
  template <class T>
  void one(std::map<std::string, std::vector<T>>& all, const std::string& name, T& v) {
    std::vector<T> values = {v};
    whole(all, name, values);
    if (values.size() != 1) fail(name);
    v = values.front();
  }
  template <size_t n, class T>
  void tuples(const std::string& name, std::vector<T>& v) {
    std::vector<double> flat;
    for (const T& t : v) flat.insert(flat.end(), t.data(), t.data() + n);
    whole(arrays_.reals, name, flat);
    if (flat.size() % n != 0) fail(name);
    v.resize(flat.size() / n);
    for (size_t i = 0; i < v.size(); ++i) std::copy_n(&flat[n * i], n, v[i].data());
  }

  CheckpointArrays& arrays_;
  bool reads_;
  std::string prefix_;
};

void members(Archive& a, State& v) {
  a("position", v.position);
  a("contact force", v.contact_force);
  a("contact history", v.contact_history);
  a("offset", v.offset);
  a("frame", v.frame);
  a("rotation", v.rotation);
  a("seam", v.seam);
  a("load", v.load);
}

void members(Archive& a, Energies& v) {
  a("largest", v.largest);
  a("last", v.last);
  a("dissipated", v.dissipated);
}

void members(Archive& a, StageProgress& v) {
  a("phase", v.phase);
  a.inner("start", v.start);
  a("earlier steps", v.earlier_steps);
  a("last move", v.last_move);
  a("stabilised", v.stabilised);
  a("stabilised at", v.stabilised_at);
  a("lost ellipticity", v.lost_ellipticity);
}

void members(Archive& a, EquilibriumMemory& v) {
  a("z", v.z);
  a("s", v.s);
  a("offset", v.offset);
  a("contact history", v.contact_history);
  a("normal", v.normal);
  a("frame", v.frame);
  a("rotation", v.rotation);
  a("frozen", v.frozen);
  a("damping", v.damping);
  a("shift", v.shift);
}

void members(Archive& a, PathMemory& v) {
  a("step", v.step);
  a("smallest", v.smallest);
  a("largest", v.largest);
  a("is smallest", v.is_smallest);
  a("aimed", v.aimed);
  a("weight", v.weight);
  a("attempts", v.attempts);
  a("change", v.change);
  a("interval", v.interval);
}

void members(Archive& a, FoundSteps& v) {
  a("count", v.count);
  a("first", v.first);
  a("end", v.end);
  a("has largest", v.has_largest);
  a("from", v.from);
  a("to", v.to);
  a("distance", v.distance);
  a("at", v.at);
  a("dissipated", v.dissipated);
  a("share", v.share);
  a("part", v.part);
  a("taken", v.taken);
}

void members(Archive& a, WatchMemory& v) {
  a("start", v.start);
  a("last", v.last);
  a("change", v.change);
  a("s", v.s);
  a("interval", v.interval);
  a("first length", v.first_length);
  a.inner("found", v.found);
}

void members(Archive& a, PivotMemory& v) {
  a("pivots", v.pivots);
  a("load", v.load);
  a("s", v.s);
  a("direction", v.direction);
  a("z", v.z);
}

void members(Archive& a, TargetMemory& v) {
  a("before", v.before);
  a("after", v.after);
  a("s before", v.s_before);
  a("s after", v.s_after);
  a("value before", v.value_before);
  a("value after", v.value_after);
}

void members(Archive& a, Pin& v) {
  a("motion", v.motion);
  a("cluster", v.cluster);
  a("component", v.component);
}

void members(Archive& a, SolveStatistics& v) {
  a("newton iterations", v.newton_iterations);
  a("linear iterations", v.linear_iterations);
  a("factorisations", v.factorisations);
  a("steps", v.steps);
  a("cut-backs", v.cut_backs);
  a("unknowns", v.unknowns);
  a("contact nodes", v.contact_nodes);
  a("contact stiffness", v.contact_stiffness);
}

/// Forces of a balance, one after the other.
template <class Use>
void each_value(ForceBalance& b, const Use& use) {
  for (Vec3* force : {&b.contact, &b.load, &b.damping, &b.pins}) std::for_each(force->data(), force->data() + 3, use);
  use(b.pin_magnitude);
  use(b.magnitude);
  for (Vec3& force : b.support) std::for_each(force.data(), force.data() + 3, use);
  std::for_each(b.torque.begin(), b.torque.end(), use);
}

template <class Use>
void each_value(StepReport& r, const Use& use) {
  for (double* value : {&r.parameter, &r.load, &r.seam, &r.accuracy.residual, &r.accuracy.undamped_residual,
                        &r.accuracy.gap, &r.accuracy.kept, &r.energy.strain, &r.energy.stabilisation,
                        &r.energy.dissipated, &r.energy.dissipation_ratio, &r.condition, &r.seconds})
    use(*value);
  each_value(r.balance, use);
}

template <class Use>
void each_whole_number(StepReport& r, const Use& use) {
  for (int* value : {&r.step, &r.iterations, &r.cut_backs, &r.negative_pivots}) use(*value);
  use(r.critical);
  use(r.extrapolated);
  use(r.undamped);
}

/// An array for all values, step by step.
void step_reports(Archive& a, std::vector<StepReport>& reports) {
  std::vector<std::string> stages;
  std::vector<int> whole;
  std::vector<double> reals;
  int supports = reports.empty() ? 0 : static_cast<int>(reports.front().balance.support.size());
  for (StepReport& r : reports) {
    stages.push_back(r.stage);
    each_whole_number(r, [&](auto value) { whole.push_back(static_cast<int>(value)); });
    each_value(r, [&](double value) { reals.push_back(value); });
  }
  a("reports: supports", supports);
  a("reports: stages", stages);
  a("reports: whole numbers", whole);
  a("reports: reals", reals);
  if (!a.reads()) return;
  const auto next = [&a](const auto& values, size_t& place) {
    if (place == values.size()) a.fail("reports");
    return values[place++];
  };
  size_t integer = 0, real = 0;
  reports.assign(stages.size(), {});
  for (size_t i = 0; i < stages.size(); ++i) {
    StepReport& r = reports[i];
    r.stage = stages[i];
    r.balance.support.resize(static_cast<size_t>(supports));
    r.balance.torque.resize(static_cast<size_t>(supports));
    each_whole_number(r,
                      [&](auto& value) { value = static_cast<std::decay_t<decltype(value)>>(next(whole, integer)); });
    each_value(r, [&](double& value) { value = next(reals, real); });
  }
}

void members(Archive& a, Checkpoint& v) {
  a("stage", v.stage.index);
  a("stage name", v.stage.name);
  a("stage iterations", v.stage.iterations);
  a.inner("progress", v.stage.progress);
  a.inner("state", v.state);
  a.list("pin", v.pins);
  a("released", v.released);
  a.inner("equilibrium", v.equilibrium);
  a.inner("path", v.path);
  a.maybe("path watch", v.watches.path);
  a.maybe("arc watch", v.watches.arc);
  a.maybe("damped watch", v.watches.damped);
  a.maybe("target", v.target);
  a.inner("pivots", v.pivots);
  a.inner("energies", v.energies);
  a("seconds", v.seconds);
  a.inner("statistics", v.statistics);
  a("notes", v.notes.all);
  a("warnings", v.warnings);
  a("first pin note", v.notes.first_pin);
  a("pin notes", v.notes.pins);
  step_reports(a, v.reports);
}

/// Arrays that belong together have the lengths that they need.
bool is_consistent(const Checkpoint& c) {
  const auto fits = [](const State& s, size_t clusters, size_t nodes) {
    return s.position.size() == clusters && s.contact_force.size() == clusters && s.offset.size() == clusters &&
           s.contact_history.size() % clusters == 0 && s.frame.size() == nodes && s.rotation.size() == nodes;
  };
  const size_t clusters = c.state.position.size(), nodes = c.state.frame.size();
  if (!fits(c.state, clusters, nodes)) return false;
  if (c.stage.progress.phase == StagePhase::finished) return true;
  const EquilibriumMemory& e = c.equilibrium;
  const size_t all = 4 * clusters + 2 * nodes;
  const auto is_vector = [all](const Unknowns& v) { return v.empty() || v.size() == all; };
  bool vectors = e.z.size() == all && c.pivots.z.size() == all && is_vector(c.path.change);
  for (const auto* watch : {&c.watches.path, &c.watches.arc})
    if (*watch)
      vectors = vectors && is_vector((*watch)->start) && is_vector((*watch)->last) && is_vector((*watch)->change);
  if (c.target) vectors = vectors && is_vector(c.target->before) && is_vector(c.target->after);
  return vectors && fits(c.stage.progress.start, clusters, nodes) && e.offset.size() == e.normal.size() &&
         (e.normal.empty() || e.normal.size() == clusters) && e.contact_history.size() % clusters == 0 &&
         e.frame.size() == nodes && e.rotation.size() == 2 * nodes;
}

}  // namespace

CheckpointArrays to_arrays(const Checkpoint& checkpoint) {
  CheckpointArrays arrays;
  Archive archive(arrays, false);
  Checkpoint copy = checkpoint;
  members(archive, copy);
  return arrays;
}

Checkpoint from_arrays(const CheckpointArrays& arrays) {
  CheckpointArrays copy = arrays;
  Archive archive(copy, true);
  Checkpoint checkpoint;
  members(archive, checkpoint);
  if (!is_consistent(checkpoint)) archive.fail("lengths of arrays");
  return checkpoint;
}

}  // namespace toile::solve
