#pragma once

#include <string>
#include <vector>

namespace toile::scene {

/// A class of compression hosiery: the pressure at the ankle (level B) that it allows, limits included.
struct CompressionClass {
  std::string standard;
  std::string name;    ///< A, I, II, III, IV
  double lower = 0.0;  ///< mmHg
  double upper = 0.0;  ///< mmHg; infinite: no upper limit
};

/// Standards whose classes are known.
std::vector<std::string> compression_standards();

/// The classes of a standard in rising order of pressure. Neighbours leave a gap, since a standard gives whole mmHg.
std::vector<CompressionClass> compression_classes(const std::string& standard);

/// "II", "between I and II" or "below I", for a pressure in mmHg; "none" for one that is not a number.
std::string class_text(const std::string& standard, double pressure);

enum class Verdict { pass, fail, undecided };

/// Whether pressure +- error (mmHg) is of the class: `pass` if all of the error bar lies in it, `fail` if none of it
/// does, else `undecided`; so is a value, or an error, that is not a number.
Verdict verdict(const CompressionClass& wanted, double pressure, double error);

/// What would decide an undecided verdict, as a sentence: the error at which it falls, and the pressures that pass.
std::string what_decides(const CompressionClass& wanted, double pressure, double error);

/// "RAL-GZ 387 class II, 23 to 32 mmHg".
std::string limits_text(const CompressionClass& wanted);

}  // namespace toile::scene
