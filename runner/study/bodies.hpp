#pragma once
/// What a study of scenes of bodies says of them: [box], [faces], [[body]], [materials.NAME].
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "runner/study/document.hpp"
#include "runner/study/quantity_reader.hpp"

namespace mpmstudy {

/// Tables of a study file that only scenes of bodies have.
inline constexpr std::string_view box_table = "box", faces_table = "faces", body_table = "body",
                                  materials_table = "materials";

class BodiesReader {
 public:
  /// Keeps references to the document and the units.
  BodiesReader(const Table& document, const Units&, KnownParameters);

  /// Whether a body is of the study's own material, that of [parameters] and [material].
  bool uses_study_material() const;
  /// Whether there is a material of each name that a body says. If not, apply() adds the mistake.
  bool knows_all_materials() const;

  /// Gives a scene its composition and its materials. `value`: of the parameters in its job. Adds mistakes,
  /// each of them once for all jobs.
  void apply(mpm::Scene&, const ValueOf& value, Mistakes&);

  /// Where a part of the composition is written that find_problems() speaks of. Null: it speaks of another.
  const Place* place_of(std::string_view parameter) const;

  /// A line for each material of the file whose density is changed and what goes with it is not.
  std::vector<std::string> warnings() const;

 private:
  std::optional<mpm::Material> read_material(const mpm::Scene&, std::string_view name, const ValueOf&,
                                             Mistakes&);
  void read_box(mpm::Scene&, const ValueOf&, Mistakes&);
  void read_faces(mpm::Scene&, Mistakes&);
  const List& bodies() const;
  std::vector<std::string_view> known_materials() const;

  const Table& document_;
  QuantityReader quantities_;
  std::map<std::string, Place, std::less<>> places_;
};

}  // namespace mpmstudy
