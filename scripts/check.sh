#!/usr/bin/env bash
# Checks in addition to the tests:
#   scripts/check.sh CHECK...
# with any of
#   format    every source file is as clang-format 14 leaves it
#   english   comments are about the thing they document
#   symbols   no code for AVX can get in the place of code for any machine, and
#             libraries destroy nothing when the program ends
#   clang     clang++ builds everything, warnings are errors; all tests pass
#   tidy      clang-tidy finds nothing (an hour)
#   sanitize  no test has errors of memory or undefined behaviour (an hour)
#   threads   studies, tables and Python's threads have no data race
#   fuzz      every fuzz program runs for a minute, or CONTACT_FUZZ_SECONDS
#   packages  Debian packages of build/ install, work and go in a clean root
#   hosts     adapters to simulators (apps/hosts) build, and their tests pass
#   fmu       descriptions of FMUs fit the schemas of FMI, in $FMI_SCHEMAS
#   libcxx    the library builds by clang++ 19 with libc++, and its tests pass
#             with every set of instructions; programs are compiled
#   libcxx_quick  the library by clang++ 19 with libc++, its quickest tests
#   libcxx_apps  programs are compiled by clang++ 19 with libc++, not linked
#   aarch64   the library builds for 64-bit ARM, and its tests pass under qemu
#   mingw     the library builds for 64-bit Windows, and its tests pass under wine
#             with every set of instructions
#   npm       the npm package is made; it has the library's numbers in node and
#             in Chromium, installed too
#   long      the tests that take some of many rows pass with all of them
#   fe        contacts by finite elements of our own and by CalculiX are the
#             programs' (numpy and calculix-ccx; ten minutes)
#   page      the page to calculate on has the programs' numbers and manners
#   all       all of them
# Format, symbols and libcxx_quick are in the gate too.
set -euo pipefail
unset CDPATH
cd "$(dirname "$0")/.."

usage() {
  sed -n '2,30s/^# \{0,1\}//p' "$0" >&2
  exit 2
}

# Tests neither install nor fail for what is missing.
missing() {
  echo "skipped: $1 is missing"
  exit 77
}

check_format() {
  clang-format --version 2>/dev/null | grep -q 'version 14\.' ||
    missing "clang-format 14"
  find libcontact apps tests -regex '.*\.[ch]\(pp\)?' -print0 |
    xargs -0 clang-format --dry-run --Werror
}

# Tests that take more where CONTACT_LONG is set.
long_tests=(Quarter/EllipticForm Seat\\. WalledExactLaw.ApproachOf
  SideFace MotionFriction.RestingHinge Python.load_law)
check_long() {
  CONTACT_LONG=1 ctest --test-dir "${CONTACT_BUILD:-build}" \
    --output-on-failure -R "^($(IFS='|'; echo "${long_tests[*]}"))"
}

# In $PYTHON, which has numpy; those of CalculiX by one mesh each.
check_fe() {
  local python=${PYTHON:-python3} build=${CONTACT_BUILD:-build}
  "$python" -c 'import numpy' 2>/dev/null || missing numpy
  "$python" scripts/fe/check.py "$build"
  command -v ccx >/dev/null || missing CalculiX
  "$python" scripts/fe/check.py "$build" --calculix --elements 20 \
    pin_fixed pin_held pin_liner ball_hip ball_bronze
}

check_english() {
  echo "words in the place of nouns (scripts/english.py --habits says where):" \
    "$(python3 scripts/english.py --habits | tail -1)"
  python3 scripts/english.py
}

# A linker takes any one of the functions of one name that are defined weakly:
# of those in objects for AVX none may be known to objects for less. And none
# may run before main() has asked what the machine has. What a function keeps is
# never destroyed, as threads may be in it while the program ends: objects ask for
# the end of nothing but streams.
check_symbols() {
  local archives
  archives=$(find "${CONTACT_BUILD:-build}" -name '*.a' 2>/dev/null || true)
  [ -n "$archives" ] || missing "a build in ${CONTACT_BUILD:-build}/"
  # Lines of nm: ARCHIVE:OBJECT:[ADDRESS] TYPE NAME
  # shellcheck disable=SC2086  # names of targets, without blanks
  nm -A $archives | awk '
    {
      split($1, place, ":")
      object = place[2]
      set = match(object, /_avx[0-9]+/) ? substr(object, RSTART, RLENGTH) : ""
      all_sets[set]
      known[$3, set] = object
      if ($3 == "__cxa_atexit") at_exit[place[1] ":" object]
      if ($3 ~ /^_ZNSt8ios_base4Init/) streams[place[1] ":" object]
      if (set != "" && $2 == "W") weak[$3, set] = object
      if (set != "" && $3 ~ /^_GLOBAL__sub_I/) {
        print object " runs code before main()"
        bad = 1
      }
    }
    END {
      for (name in at_exit) {
        if (name in streams || name !~ \
            /\/libcontact(_(files|(runs_)?c_parts|multibody|separation))?\.a:/)
          continue
        print name " destroys something when the program ends"
        bad = 1
      }
      for (key in weak) {
        split(key, part, SUBSEP)
        for (other in all_sets) {
          if (other == part[2] || !((part[1], other) in known)) continue
          print weak[key] " defines " part[1] ", known to " \
            known[part[1], other]
          bad = 1
        }
      }
      if (length(all_sets) < 2) {
        print "skipped: objects for AVX are missing"
        exit 77
      }
      exit bad
    }' | c++filt
}

check_clang() {
  cmake --preset clang
  cmake --build --preset clang
  ctest --preset clang --no-tests=error --parallel "$(nproc)"
}

check_tidy() {
  # It reads sources alone: precompiled headers would have to be built first.
  cmake --preset clang -B build-tidy -D CONTACT_UNITY_BUILD=OFF \
    -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON
  run-clang-tidy -quiet -p build-tidy "$PWD/(libcontact|apps|tests)/"
}

check_sanitize() {
  cmake --preset asan
  cmake --build --preset asan
  ctest --preset asan --no-tests=error --parallel "$(nproc)"
}

# Python is not instrumented, so that the sanitizer is loaded before it.
check_threads() {
  cmake --preset tsan
  cmake --build --preset tsan --target installed contact_python joint_rows \
    {half_angle_accuracy,programs_tool,programs_study_tool}_test \
    separation_identity_test study_contract_test
  ctest --preset tsan --no-tests=error --parallel "$(nproc)" \
    -R 'Threads|AnyThread|^Study|^BallStudy|^HingeStudy|Runs\.|ManyThreads'
  LD_PRELOAD=$(g++ -print-file-name=libtsan.so) ctest --preset tsan \
    --no-tests=error -R '^Python\.(joints?|motion|run|misuse)$'
}

fuzz() { # NAME FOLDER...: from the corpus of that name and files there
  local found=build-fuzz/found/$1
  mkdir -p "$found"
  # What programs say on the way is not to be seen.
  "build-fuzz/tests/$1_fuzz" -max_total_time="${CONTACT_FUZZ_SECONDS:-60}" \
    -close_fd_mask=1 -artifact_prefix="$found-" \
    "$found" "tests/fuzz/corpus/$1" "${@:2}"
}

check_fuzz() {
  cmake --preset fuzz
  local names=(tests/fuzz/*_fuzz.cpp) name
  names=("${names[@]##*/}")
  cmake --build --preset fuzz --target "${names[@]%.cpp}"
  for name in "${names[@]%_fuzz.cpp}"; do
    case $name in
      joint_file) fuzz "$name" data/joints data/materials ;;
      case_file) fuzz "$name" data/cases ;;
      study_file) fuzz "$name" data/studies ;;
      *) fuzz "$name" ;;
    esac
  done
}

check_packages() {
  command -v mmdebstrap >/dev/null || missing mmdebstrap
  [ "$(id -u)" -eq 0 ] || unshare --user true 2>/dev/null ||
    missing "the right to make a root"
  cmake --build build --target installed contact_python
  rm -rf build/packages
  (umask 077 && cd build && cpack -G DEB -B packages)
  chmod -R a+rX build/packages
  # shellcheck disable=SC2016  # the hook's own $1
  mmdebstrap --variant=apt --format=null --include=gcc,libc6-dev,pkg-config \
    --customize-hook="copy-in build/packages /" \
    --customize-hook="copy-in tests/install/packages.sh /" \
    --customize-hook="copy-in tests/install/outside_c/turning.c /" \
    --customize-hook='chroot "$1" /packages.sh' \
    "$(. /etc/os-release && echo "$VERSION_CODENAME")" -
}

# The schemas have a licence of their own, and are not in the repository:
# https://github.com/modelica/fmi-standard, the folder schema of v2.0.x and 3.0.x.
check_fmu() {
  [ -d "${FMI_SCHEMAS:-}" ] || missing "FMI_SCHEMAS, the folder of the schemas"
  command -v xmllint >/dev/null || missing xmllint
  local work file version
  work=$(mktemp -d)
  for file in tests/hosts/ball.toml tests/hosts/pin.toml data/cases/*.toml; do
    for version in 2 3; do
      build/bin/hinge-fmu "$file" --fmi "$version" --output "$work/it.fmu"
      unzip -p "$work/it.fmu" modelDescription.xml > "$work/it.xml"
      xmllint --noout --schema \
        "$FMI_SCHEMAS/fmi${version}ModelDescription.xsd" "$work/it.xml"
    done
  done
  rm -r "$work"
}

check_hosts() {
  install packages-hosts.txt
  cmake --preset release
  cmake --build --preset release --target hosts
  ctest --preset release --no-tests=error -L '^host$'
}

install() { # LIST...
  [ "${CONTACT_SKIP_SETUP:-}" = 1 ] || scripts/setup.sh "${@/#/scripts/}"
}

test_every_set() { # PRESET: its tests, with every set of instructions
  local sets=(baseline) set
  grep -q ' avx2 .* fma\| fma .* avx2 ' /proc/cpuinfo && sets+=(avx2)
  grep -q ' avx512vl' /proc/cpuinfo && sets+=(avx512)
  for set in "${sets[@]}"; do
    CONTACT_INSTRUCTION_SET=$set ctest --preset "$1" --no-tests=error \
      --parallel "$(nproc)"
  done
}

check_libcxx() {
  install packages-libcxx.txt
  cmake --preset libcxx
  cmake --build --preset libcxx
  test_every_set libcxx
  check_libcxx_apps
}

# The distribution's libraries that programs link are for libstdc++, so that
# they are compiled and not linked. SUNDIALS asks for OpenMP, and does not need
# it. Some sources are always optimised, which precompiled headers then are not.
check_libcxx_apps() {
  install packages-libcxx.txt
  cmake --preset libcxx -B build-libcxx-apps -D CONTACT_BUILD_TESTS=OFF \
    -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
    -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0 \
    -D CONTACT_BUILD_APPS=ON -D CONTACT_BUILD_PYTHON=ON \
    -D OpenMP_CXX_FLAGS=-fopenmp -D OpenMP_CXX_LIB_NAMES=gomp \
    -D OpenMP_gomp_LIBRARY=gomp
  ninja -C build-libcxx-apps -t targets all |
    sed -n 's/^\(apps.*\.o\):.*/\1/p' | xargs ninja -C build-libcxx-apps
}

# Optimisation would take ten minutes more. Without it kernels of AVX share
# functions with the rest: the tests that run are those that link none.
check_libcxx_quick() {
  install packages-libcxx.txt
  cmake --preset libcxx -B build-libcxx-quick -D CMAKE_BUILD_TYPE=Debug \
    -D CMAKE_CXX_FLAGS_DEBUG=-O0
  local tests=(base_{accuracy,contract}_test conforming_pin_test
    half_angle_identity_test pair_accuracy_test seat_contract_test) test
  cmake --build build-libcxx-quick --target libcontact/all "${tests[@]}"
  for test in "${tests[@]}"; do "build-libcxx-quick/tests/$test"; done
}

check_aarch64() {
  install packages-aarch64.txt
  cmake --preset aarch64
  cmake --build --preset aarch64
  ctest --preset aarch64 --no-tests=error --parallel "$(nproc)"
}

check_mingw() {
  install packages-mingw.txt
  cmake --preset mingw
  cmake --build --preset mingw
  test_every_set mingw
}

check_npm() {
  install packages-page.txt
  CONTACT_SKIP_SETUP=1 scripts/npm.sh
  cmake --preset release
  cmake --build --preset release --target hinge-joint contact_python
  [ -d tests/browser/node_modules/typescript ] || npm ci --prefix tests/browser
  CONTACT_BUILD=build CONTACT_NPM=build-wasm/npm \
    node --test-concurrency=1 --test tests/npm/{package,browser,mujoco}_test.js
}

check_page() {
  install packages-page.txt
  CONTACT_SKIP_SETUP=1 scripts/page.sh
  cmake --preset release
  cmake --build --preset release \
    --target hinge-joint hinge-pressure contact_python
  [ -d tests/browser/node_modules/axe-core ] || npm ci --prefix tests/browser
  CONTACT_BUILD=build CONTACT_PAGE=build-wasm/calculator.html \
    CONTACT_ENGINE=build-wasm/bin/engine.js \
    node --test-concurrency=1 --test tests/browser/{engine,page}_test.js
}

[ $# -gt 0 ] || usage
checks=("$@")
[ "$*" = all ] && checks=(format english symbols clang tidy sanitize threads fuzz packages hosts fmu libcxx aarch64 mingw npm long page)
for check in "${checks[@]}"; do
  declare -F "check_$check" >/dev/null || usage
done
for check in "${checks[@]}"; do
  echo "check: $check"
  case $check in
    english | symbols) ;;  # they read what is there
    *) install packages.txt packages-check.txt ;;
  esac
  "check_$check"
done
