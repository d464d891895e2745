// Paths of files.
#include "problems/files/meshes/mesh_texts.hpp"

#include <filesystem>

namespace kusabi::problems {

namespace fs = std::filesystem;

std::string MeshTexts::place(const std::string& from, std::string_view name) {
  return (fs::path(from).parent_path() / fs::path(name)).lexically_normal().string();
}

const std::string* MeshTexts::text(const std::string& place) const {
  if (texts_ == nullptr) return nullptr;
  const auto found = texts_->find(place);
  return found == texts_->end() ? nullptr : &found->second;
}

std::string MeshTexts::name(const std::string& place) const {
  return (fs::path(problem_file_).parent_path() / fs::path(place)).string();
}

}  // namespace kusabi::problems
