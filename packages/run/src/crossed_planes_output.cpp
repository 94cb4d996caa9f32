// Warns of fabric that has passed through a plane of symmetry.
#include "crossed_planes.hpp"
#include "output.hpp"

namespace toile::run {

namespace {

class CrossedPlanes : public Observer {
 public:
  explicit CrossedPlanes(base::Log& log) : log_(log) {}

  void end(const Record& record) override {
    const scene::Scene& scene = record.scene();
    for (const solve::Support& support : scene.problem().supports) {
      const std::string text = crossed_plane(support, scene.garment().mesh, record.fields().position);
      if (!text.empty()) log_.warn(text);
    }
  }

 private:
  base::Log& log_;
};

}  // namespace

Output crossed_planes_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<CrossedPlanes>(context.log);
          }};
}

}  // namespace toile::run
