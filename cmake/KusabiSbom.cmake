# Software bill of materials in SPDX 2.3 JSON: all libraries found by the build, with versions and
# licences.

# kusabi_material(NAME VERSION LICENSE HEADERS|LINKED URL): adds a library.
set(KUSABI_MATERIALS "")
set(KUSABI_RELATIONS "")
function(kusabi_material name version license use url)
  string(MAKE_C_IDENTIFIER "${name}" id)
  string(REPLACE "_" "-" id "${id}")
  if(NOT version)
    set(version "NOASSERTION")
  endif()
  set(relation "DYNAMIC_LINK")
  if(use STREQUAL "HEADERS")
    set(relation "CONTAINS")
  endif()
  string(APPEND KUSABI_MATERIALS ",
    {\"SPDXID\": \"SPDXRef-${id}\", \"name\": \"${name}\", \"versionInfo\": \"${version}\",
     \"licenseConcluded\": \"${license}\", \"licenseDeclared\": \"${license}\", \"copyrightText\": \"NOASSERTION\",
     \"downloadLocation\": \"${url}\", \"filesAnalyzed\": false}")
  string(APPEND KUSABI_RELATIONS ",
    {\"spdxElementId\": \"SPDXRef-Kusabi\", \"relationshipType\": \"${relation}\", \"relatedSpdxElement\": \"SPDXRef-${id}\"}")
  set(KUSABI_MATERIALS "${KUSABI_MATERIALS}" PARENT_SCOPE)
  set(KUSABI_RELATIONS "${KUSABI_RELATIONS}" PARENT_SCOPE)
endfunction()

kusabi_material("Boost" "${Boost_VERSION}" "BSL-1.0" LINKED "https://www.boost.org")
kusabi_material("Eigen" "${Eigen3_VERSION}" "MPL-2.0" HEADERS "https://eigen.tuxfamily.org")
kusabi_material("fmt" "${fmt_VERSION}" "MIT" LINKED "https://github.com/fmtlib/fmt")
kusabi_material("toml++" "${tomlplusplus_VERSION}" "MIT" LINKED "https://github.com/marzer/tomlplusplus")
kusabi_material("JSON for Modern C++" "${nlohmann_json_VERSION}" "MIT" HEADERS "https://github.com/nlohmann/json")
kusabi_material("CLI11" "${CLI11_VERSION}" "BSD-3-Clause" HEADERS "https://github.com/CLIUtils/CLI11")
kusabi_material("GLPK" "${GLPK_VERSION}" "GPL-3.0-or-later" LINKED "https://www.gnu.org/software/glpk")
kusabi_material("CHOLMOD" "${CHOLMOD_VERSION}" "LGPL-2.1-or-later AND GPL-2.0-or-later" LINKED "https://suitesparse.com")
kusabi_material("BLAS" "" "NOASSERTION" LINKED "https://www.netlib.org/blas")
kusabi_material("QD" "" "BSD-3-Clause-LBNL" LINKED "https://www.davidhbailey.com/dhbsoftware")
kusabi_material("zlib" "${ZLIB_VERSION_STRING}" "Zlib" LINKED "https://zlib.net")
kusabi_material("GMP" "" "LGPL-3.0-or-later OR GPL-2.0-or-later" LINKED "https://gmplib.org")
kusabi_material("MPFR" "" "LGPL-3.0-or-later" LINKED "https://www.mpfr.org")
kusabi_material("MPI" "${MPI_C_VERSION}" "NOASSERTION" LINKED "NOASSERTION")

# CMake uses SOURCE_DATE_EPOCH, if set, instead of the current time.
string(TIMESTAMP created "%Y-%m-%dT%H:%M:%SZ" UTC)
file(WRITE ${PROJECT_BINARY_DIR}/kusabi.spdx.json "{
  \"spdxVersion\": \"SPDX-2.3\", \"dataLicense\": \"CC0-1.0\", \"SPDXID\": \"SPDXRef-DOCUMENT\",
  \"name\": \"kusabi-${PROJECT_VERSION}\", \"documentNamespace\": \"urn:kusabi:spdx:${PROJECT_VERSION}\",
  \"creationInfo\": {\"created\": \"${created}\", \"creators\": [\"Tool: CMake-${CMAKE_VERSION}\"]},
  \"packages\": [
    {\"SPDXID\": \"SPDXRef-Kusabi\", \"name\": \"Kusabi\", \"versionInfo\": \"${PROJECT_VERSION}\",
     \"licenseConcluded\": \"GPL-3.0-or-later\", \"licenseDeclared\": \"Apache-2.0\", \"copyrightText\": \"2026 The Kusabi authors\",
     \"licenseComments\": \"Sources are under the Apache License 2.0; programs linked with GLPK and CHOLMOD are under the GPL.\",
     \"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false}${KUSABI_MATERIALS}
  ],
  \"relationships\": [
    {\"spdxElementId\": \"SPDXRef-DOCUMENT\", \"relationshipType\": \"DESCRIBES\", \"relatedSpdxElement\": \"SPDXRef-Kusabi\"}${KUSABI_RELATIONS}
  ]
}
")
install(FILES ${PROJECT_BINARY_DIR}/kusabi.spdx.json DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
