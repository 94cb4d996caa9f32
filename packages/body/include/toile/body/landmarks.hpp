#pragma once

#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// A place of the human body that has a name.
struct Landmark {
  std::string name;
  Vec3 point = Vec3::Zero();   ///< mm; of a girth the centre of its section
  Vec3 normal = Vec3::Zero();  ///< of the section in which its girth lies, unit; zero: it has none
  double girth = 0.0;          ///< tape girth of that section, mm
};

/// A landmark that a body does not have, or does not show.
struct MissingLandmark {
  std::string name;
  std::string reason;
};

/// Every landmark is either found or missing with the reason.
struct Landmarks {
  std::vector<Landmark> found;
  std::vector<MissingLandmark> missing;
  std::vector<std::string> warnings = {};  ///< what the search had to take for granted

  /// Null if it was not found. "line" behind the name of a level is left out: "waist line".
  const Landmark* find(const std::string& name) const;
  /// Throws InputError: the name is none (with the nearest one), or this body does not have it (with the reason).
  const Landmark& at(const std::string& name) const;
  /// A landmark, or so many mm above or below one: "waist", "waist + 30", "left knee - 20". Its girth stays that of the
  /// landmark. Throws as at(), and for a text that is no place.
  Landmark place(const std::string& text) const;
};

/// All names, in the order from the crown down.
const base::Texts& landmark_names();

/// Landmarks of a standing body, z up, front towards -y, its left at greater x, in mm; from its sections alone. Arms
/// may hang, stand off or be held level, as long as they and the legs are apart from the trunk below the armpits and
/// the crotch. Parts may be missing: what cannot be found is told. A body that looks up to 45 degrees aside is turned
/// for the search by the long axis of its trunk; one whose trunk is round is taken as it is, with a warning. Throws
/// InputError if it looks elsewhere, lies or stands on its head.
///
/// Levels (waist, hip, ...) have a tape girth in a horizontal section; of upper arm, elbow and wrist it lies across the
/// arm. Heights are found within half a per cent of the body's height.
Landmarks find_landmarks(const TriangleMesh& mesh);
/// The same; messages name the file from which the body comes.
Landmarks find_landmarks(const TriangleMesh& mesh, const std::string& file);

/// Those of the body that a validated list "Body" describes; all of it, whatever its list "Reach" says. Throws
/// InputError if it is none from a file, or cannot be read.
Landmarks landmarks_of(const base::List& list);

}  // namespace toile::body
