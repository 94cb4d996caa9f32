// What the terminal shows while a stage runs: a line an accepted step, and one now and then inside a step that takes
// long.
#include "output.hpp"
#include "toile/base/progress.hpp"

namespace toile::run {

namespace {

class Progress : public Observer {
 public:
  explicit Progress(const OutputContext& context)
      : timer_(context.timer),
        log_(context.log),
        heartbeat_(context.heartbeat, [&timer = context.timer] { return timer.elapsed(); }),
        stages_(static_cast<int>(context.scene.stages().size())),
        tolerance_(context.scene.solver().newton.tolerance) {}

  void start_stage(const Record& record, const solve::StageOptions& stage) override {
    stage_number_ = static_cast<int>(&stage - record.scene().stages().data()) + 1;
    path_.start(timer_.elapsed());
  }

  void step(const Record& record) override {
    const solve::StepReport& report = record.last();
    base::ProgressPoint point;
    point.stage = report.stage;
    point.stage_number = stage_number_;
    point.stages = stages_;
    point.step = report.step;
    point.parameter = report.parameter;
    point.load = report.load;
    point.iterations = report.iterations;
    point.seconds = timer_.elapsed();
    point.final_state = report.undamped;
    path_.advance(report.parameter, point.seconds);
    if (!report.undamped) point.left = path_.left();
    log_.info(base::progress_line(point));
    heartbeat_.line_printed();
  }

  void iteration(const Record&, const solve::IterationReport& report) override {
    if (!log_.prints() || !heartbeat_.due()) return;
    base::IterationPoint point;
    point.stage = report.stage;
    point.stage_number = stage_number_;
    point.stages = stages_;
    point.parameter = report.parameter;
    point.relaxing = report.relaxing;
    point.iteration = report.iteration;
    point.cut_backs = report.cut_backs;
    point.residual = report.residual;
    point.tolerance = tolerance_;
    point.seconds = timer_.elapsed();
    log_.info(base::iteration_line(point));
  }

 private:
  base::Timer& timer_;
  base::Log& log_;
  base::Heartbeat heartbeat_;
  base::PathClock path_;
  int stage_number_ = 0, stages_;
  double tolerance_;
};

}  // namespace

Output progress_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<Progress>(context);
          }};
}

}  // namespace toile::run
