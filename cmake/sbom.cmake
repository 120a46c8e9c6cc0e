# libcontact.spdx in each package: its components in SPDX 2.3, as tags and
# values.
string(TIMESTAMP now %Y-%m-%dT%H:%M:%SZ UTC)  # or SOURCE_DATE_EPOCH
string(UUID sbom NAMESPACE 6ba7b811-9dad-11d1-80b4-00c04fd430c8 TYPE SHA1
  NAME "libcontact ${PROJECT_VERSION} ${now} ${CMAKE_SYSTEM_NAME}")
set(sbom "SPDXVersion: SPDX-2.3
DataLicense: CC0-1.0
SPDXID: SPDXRef-DOCUMENT
DocumentName: libcontact-${PROJECT_VERSION}
DocumentNamespace: https://spdx.org/spdxdocs/libcontact-${sbom}
Creator: Tool: CMake-${CMAKE_VERSION}
Created: ${now}

PackageName: libcontact
SPDXID: SPDXRef-libcontact
PackageVersion: ${PROJECT_VERSION}
PackageSummary: <text>${PROJECT_DESCRIPTION}</text>
PackageDownloadLocation: NOASSERTION
FilesAnalyzed: false
PackageLicenseConcluded: MIT
PackageLicenseDeclared: MIT
PackageCopyrightText: NOASSERTION
Relationship: SPDXRef-DOCUMENT DESCRIBES SPDXRef-libcontact
")
# part(FOLDER NAME VERSION LICENSE RELATIONSHIP): a component found by
# find_package() in FOLDER if FOLDER is built; VERSION is the variable with its
# version.
function(part folder name version license relationship)
  get_directory_property(version DIRECTORY ${folder} DEFINITION ${version})
  if(NOT version)
    set(version NOASSERTION)
  endif()
  string(REPLACE _ - id ${name}) # SPDX knows no underscores
  set(sbom "${sbom}
PackageName: ${name}
SPDXID: SPDXRef-${id}
PackageVersion: ${version}
PackageDownloadLocation: NOASSERTION
FilesAnalyzed: false
PackageLicenseConcluded: NOASSERTION
PackageLicenseDeclared: ${license}
PackageCopyrightText: NOASSERTION
Relationship: SPDXRef-libcontact ${relationship} SPDXRef-${id}
" PARENT_SCOPE)
endfunction()
part(. Eigen3 Eigen3_VERSION MPL-2.0 STATIC_LINK)
part(. Boost Boost_VERSION BSL-1.0 STATIC_LINK)
part(libcontact fmt fmt_VERSION MIT STATIC_LINK)
part(libcontact tomlplusplus tomlplusplus_VERSION MIT STATIC_LINK)
if(CONTACT_BUILD_APPS AND CONTACT_BUILD_REFERENCE)
  part(libcontact/tools/reference GSL GSL_VERSION GPL-3.0-or-later DYNAMIC_LINK)
endif()
if(CONTACT_BUILD_APPS)
  part(apps/cli CLI11 CLI11_VERSION BSD-3-Clause STATIC_LINK)
  part(apps/cli nlohmann_json nlohmann_json_VERSION MIT STATIC_LINK)
  part(apps/cli HDF5 HDF5_VERSION NOASSERTION DYNAMIC_LINK)
  part(apps/cli SQLite3 SQLite3_VERSION blessing DYNAMIC_LINK)
  part(apps/multibody SUNDIALS SUNDIALS_VERSION BSD-3-Clause DYNAMIC_LINK)
  part(apps/separation Qhull Qhull_VERSION Qhull DYNAMIC_LINK)
  part(apps/study Random123 NONE BSD-3-Clause STATIC_LINK)
  part(apps/programs/fmu minizip MINIZIP_VERSION Zlib DYNAMIC_LINK)
endif()
if(TARGET contact_python)
  part(apps/python pybind11 pybind11_VERSION BSD-3-Clause STATIC_LINK)
  part(apps Python Python_VERSION PSF-2.0 DEPENDS_ON)
  part(apps NumPy Python_NumPy_VERSION BSD-3-Clause DEPENDS_ON)
endif()
file(WRITE ${PROJECT_BINARY_DIR}/libcontact.spdx "${sbom}")
