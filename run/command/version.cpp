// Versions of MPI and GLPK as linked, of other libraries as compiled.
#include <algorithm>
#include <array>
#include <string_view>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <fmt/format.h>
#include <glpk.h>
#include <gmp.h>
#include <kusabi_commit.hpp>  // made by cmake/commit.cmake
#include <mpi.h>

#include "run/command/help.hpp"

namespace kusabi::run {
namespace {

// "Open MPI v4.1.4, package: ..." up to the comma; for MPICH, the first of several lines.
std::string mpi_library() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);  // permitted before MPI_Init
  std::string line(std::string_view(text.data(), static_cast<std::size_t>(length)));
  line.resize(std::min(line.find_first_of(",\n"), line.size()));
  for (char& c : line) c = c == '\t' ? ' ' : c;
  return line;
}

std::string compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "unknown";
#endif
}

}  // namespace

std::string version() {
  return fmt::format(
      "kusabi {}\ncommit    {}\nMPI       {}\ncompiler  {}, {}\nEigen     {}.{}.{}\nGLPK      {}\n"
      "GMP       {}\nBoost     {}.{}.{}\n",
      KUSABI_VERSION, KUSABI_COMMIT, mpi_library(), compiler(), KUSABI_BUILD_TYPE,
      EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, glp_version(), gmp_version,
      BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
}

std::string_view release_date() {
  return KUSABI_RELEASE_DATE;
}

}  // namespace kusabi::run
