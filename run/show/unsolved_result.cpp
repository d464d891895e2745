// Candidates have a normal and no tangents, which an answer alone needs.
#include "run/show/unsolved_result.hpp"

#include <vector>

#include "run/output/values.hpp"
#include "run/pictures/structure_json.hpp"

namespace kusabi::run {

ResultReader unsolved_result(const problems::Structure& structure, const std::string& file) {
  auto contact = ResultJson::array();
  const std::vector<double> none(static_cast<std::size_t>(structure.dimension));
  for (std::size_t i = 0; i < structure.contact.size(); ++i) {
    const auto& each = structure.contact[i];
    ResultJson json{{"node", problems::candidate_name(structure, i)},
                    {"n", numbers(each.normal)},
                    {"t1", none},
                    {"friction", each.friction}};
    if (structure.dimension == 3) json["t2"] = none;
    contact.push_back(std::move(json));
  }
  ResultJson problem{
      {"file", file},
      {"name", structure.name},
      {"d", structure.dimension},
      {"units", {{"length", structure.units.length}, {"force", structure.units.force}}}};
  if (!contact.empty()) problem["contact"] = std::move(contact);
  problem["structure"] = structure_json(structure);
  return {
      ResultJson{
          {"command", "show"}, {"problem", std::move(problem)}, {"result", ResultJson::object()}},
      file};
}

}  // namespace kusabi::run
