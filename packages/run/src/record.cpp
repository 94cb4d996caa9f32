#include "toile/run/record.hpp"

#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "toile/base/error.hpp"

namespace toile::run {

namespace {

/// A garment that only rests beside the body touches it with the round-off of its equilibrium: that presses nothing.
void drop_round_off(double magnitude, solve::Fields* fields) {
  double pressed = 0.0;
  for (const double force : fields->contact_force) pressed += std::abs(force);
  if (pressed > noise * magnitude) return;
  for (std::vector<double>* field :
       {&fields->pressure, &fields->pressure_error, &fields->body_change, &fields->contact_force})
    std::fill(field->begin(), field->end(), 0.0);
  for (const solve::ErrorPart& part : solve::error_parts())
    std::fill((fields->errors.*part.values).begin(), (fields->errors.*part.values).end(), 0.0);
  fields->isolated_contacts = 0;
  fields->contacts_off_surface = 0;
}

}  // namespace

Record::Record(const scene::Scene& scene, base::Timer& timer)
    : scene_(scene),
      timer_(timer),
      state_(scene.start()),
      points_(scene.output().points.size()),
      distances_(scene.output().distances.size()) {}

const solve::StepReport& Record::last() const {
  if (reports_.empty()) throw base::Error(base::ExitCode::internal_error, "no step of the run was accepted yet");
  return reports_.back();
}

std::shared_ptr<const solve::Fields> Record::shared_fields() const {
  if (fields_ == nullptr) {
    const auto phase = timer_.phase("fields");
    auto fields = std::make_shared<solve::Fields>(
        solve::compute_fields(scene_.problem(), state_, reports_.empty() ? solve::Accuracy() : last().accuracy));
    if (!reports_.empty()) drop_round_off(last().balance.magnitude, fields.get());
    fields_ = std::move(fields);
  }
  return fields_;
}

const PressureReport& Record::pressure() const {
  if (pressure_ == nullptr) {
    const auto phase = timer_.phase("curves");
    pressure_ = std::make_unique<PressureReport>(pressure_report(scene_, fields(), last()));
  }
  return *pressure_;
}

const Pierced& Record::pierced() const {
  if (!pierced_) {
    const auto phase = timer_.phase("pierced elements");
    pierced_ = pierced_elements(scene_.problem(), fields());
  }
  return *pierced_;
}

const solve::Checkpoint& Record::checkpoint() const {
  if (!checkpoint_) last();  // throws
  return *checkpoint_;
}

void Record::resume(solve::Checkpoint checkpoint, std::vector<std::vector<solve::Vec3>> points,
                    std::vector<std::vector<double>> distances) {
  reports_ = checkpoint.reports;
  state_ = checkpoint.state;
  fields_.reset();
  pressure_.reset();
  pierced_.reset();
  points_ = std::move(points);
  distances_ = std::move(distances);
  checkpoint_ = std::move(checkpoint);
}

void Record::add(const solve::StepReport& report, const solve::State& state, solve::Checkpoint checkpoint) {
  reports_.push_back(report);
  state_ = state;
  checkpoint_ = std::move(checkpoint);
  fields_.reset();
  pressure_.reset();
  pierced_.reset();
  if (points_.empty() && distances_.empty()) return;
  const std::vector<solve::Vec3> position = solve::node_positions(scene_.problem(), state);
  for (size_t i = 0; i < points_.size(); ++i) {
    const int node = scene_.output().points[i].node;
    points_[i].push_back(position[node] - scene_.garment().mesh.placed[node]);
  }
  for (size_t i = 0; i < distances_.size(); ++i) {
    const scene::Distance& distance = scene_.output().distances[i];
    const auto at = [&](const mesh::EdgePlace& place) {
      return solve::Vec3((1.0 - place.share) * position[place.first] + place.share * position[place.second]);
    };
    distances_[i].push_back((at(distance.second) - at(distance.first)).norm());
  }
}

void Record::follow(const solve::Simulation& simulation) {
  statistics_ = simulation.statistics();
  notes_ = simulation.notes();
  warnings_ = simulation.warnings();
  stopped_ = simulation.stopped();
}

}  // namespace toile::run
