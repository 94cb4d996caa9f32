#include "table_output.hpp"

namespace toile::run {

void TableOutput::end(const Record& record) {
  const auto phase = timer_.phase("curves");
  write(record);
}

std::string TableOutput::failure(const Record& record) {
  if (!record.reports().empty()) write(record);
  return {};
}

void TableOutput::write(const std::string& name, const result::Table& table) {
  constexpr int exact = 17;  // digits
  result::write_csv(folder_->file(name + ".csv"), table, exact);
  folder_->add(name + ".csv");
}

void TableOutput::draw(const std::string& name, const result::Plot& plot) {
  run::draw(*folder_, name, plot, log_);
}

std::vector<std::string> plot_files(const std::string& name) {
  std::vector<std::string> files;
  for (const char* ending : {".csv", ".dat", ".gp", ".svg", ".png"}) files.push_back(name + ending);
  return files;
}

void draw(Folder& folder, const std::string& name, const result::Plot& plot, base::Log& log) {
  if (!folder.pictures()) return;
  const auto warning = result::write_plot(folder.path(), name, plot);
  if (warning) log.warn(*warning);
  folder.add(warning ? name + ".dat" : name + ".png");
}

}  // namespace toile::run
