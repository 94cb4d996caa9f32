#pragma once

#include "output.hpp"
#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"

namespace toile::run {

/// Tables and plots over the accepted steps, also of a run that could not reach its end.
class TableOutput : public Observer {
 public:
  explicit TableOutput(const OutputContext& context)
      : folder_(context.folder), timer_(context.timer), log_(context.log) {}

  void end(const Record& record) override;
  std::string failure(const Record& record) override;

 protected:
  virtual void write(const Record& record) = 0;
  /// NAME.csv.
  void write(const std::string& name, const result::Table& table);
  /// NAME.png and what it is made of.
  void draw(const std::string& name, const result::Plot& plot);
  base::Timer& timer() const { return timer_; }

 private:
  std::shared_ptr<Folder> folder_;
  base::Timer& timer_;
  base::Log& log_;
};

/// Files of a plot that draw() may write, with the table of its name.
std::vector<std::string> plot_files(const std::string& name);

/// Draws a plot into the folder; a program that is missing is a warning.
void draw(Folder& folder, const std::string& name, const result::Plot& plot, base::Log& log);

}  // namespace toile::run
