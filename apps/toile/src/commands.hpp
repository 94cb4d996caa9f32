#pragma once

#include <string>

namespace toile::app {

/// What the command line says of a run.
struct RunArguments {
  std::string scene;        ///< XML file
  std::string output = "";  ///< folder of the results; empty: results/<name of the scene>
  int threads = 1;          ///< for the element loops of each rank
  bool quiet = false;
};

/// What the command line says of a fit.
struct IdentifyArguments {
  std::string file;         ///< XML file
  std::string output = "";  ///< folder of the results; empty: that of the file, or results/<name of the file>
  bool quiet = false;
};

/// Each returns the exit status of the program (base::ExitCode); errors are thrown as base::Error.
int run(const RunArguments& arguments);
int check(const std::string& scene);
int identify(const IdentifyArguments& arguments);
/// Prints the input reference of a fit file.
int describe_fit(bool markdown);
int describe(bool markdown, const std::string& list);

}  // namespace toile::app
