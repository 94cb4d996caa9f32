#pragma once

#include <string>

namespace toile::app {

/// What the command line says of a run.
struct RunArguments {
  std::string scene;        ///< XML file
  std::string output = "";  ///< folder of the results; empty: results/<name of the scene>
  int threads = 1;          ///< for the element loops of each rank
  bool quiet = false;
  bool restart = false;        ///< go on after the last step in the folder
  bool allow_plugins = false;  ///< the scene may load programs
  double heartbeat = 5.0;      ///< s without a line after which a step that is sought is told of
};

/// What the command line says of a check of a scene.
struct CheckArguments {
  std::string scene;           ///< XML file
  std::string output = "";     ///< folder for the start; empty: it is not written
  bool allow_plugins = false;  ///< the scene may load programs
};

/// What the command line says of a check of fabrics.
struct MaterialCheckArguments {
  std::string file;            ///< a fabric's XML file, or a scene if `material` is given
  std::string material;        ///< one of the scene's
  std::string output = "";     ///< folder of maps; empty: results/<name of the file>-check
  bool all = false;            ///< every published set instead of a file
  bool allow_plugins = false;  ///< the file may load programs
};

/// What the command line says of a fit.
struct IdentifyArguments {
  std::string file;         ///< XML file
  std::string output = "";  ///< folder of the results; empty: that of the file, or results/<name of the file>
  bool quiet = false;
  bool allow_plugins = false;  ///< the file may load programs
};

/// Each returns the exit status of the program (base::ExitCode); errors are thrown as base::Error.
int run(const RunArguments& arguments);
int check(const CheckArguments& arguments);
/// `what`: a list or a parameter by its path, or a line of an error message that holds one; empty: all. `scene`: empty,
/// or a file whose plug-ins are described too.
int describe(bool markdown, const std::string& what, const std::string& scene, bool allow_plugins);
/// Prints the fields that a run writes.
int describe_fields(bool markdown);
/// Compiles a fabric; `output` empty: the source's name with .so, beside it.
int build_material(const std::string& source, const std::string& output, bool verbose);
int check_material(const MaterialCheckArguments& arguments);
int identify(const IdentifyArguments& arguments);
/// Prints the input reference of a fit file; of `arguments.file`, if it is not empty, with its plug-ins and formulas.
int describe_fit(const IdentifyArguments& arguments, bool markdown);

}  // namespace toile::app
