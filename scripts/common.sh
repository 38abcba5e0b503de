# Shared by the scripts of this folder: installing what is missing, configuring, building.
# Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*" >&2; }

# Debian packages the build needs; gnuplot draws the plots, pdflatex sets the PDF, the Python standard library runs checks.
packages=(g++ cmake ninja-build pkg-config libeigen3-dev libboost-dev libboost-iostreams-dev
  libboost-filesystem-dev libfmt-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libmd-dev libmuparser-dev libnlopt-dev librandom123-dev
  libgnuplot-iostream-dev libspectra-dev gnuplot-nox
  texlive-latex-base texlive-latex-recommended lmodern)
# Of the tests: validation against schemas, reading PDF, building Debian packages, finite elements, NetCDF.
test_packages=(catch2 librapidcheck-dev libbenchmark-dev python3 python3-jsonschema poppler-utils dpkg-dev file
  calculix-ccx libnetcdf19)

# Installs those of the named packages that are missing. Quick when none is.
install_missing() {
  local missing=()
  local package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  say "Installing by apt: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "Not root and no sudo: run 'apt-get install --no-install-recommends ${missing[*]}' as root first."
      exit 4
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq >&2 &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
      "${missing[@]}" >&2 || { say "apt could not install: ${missing[*]}"; exit 4; }
}

# configure FOLDER [cmake options]: only where it has not been done or the options changed.
configure() {
  local folder=$1
  shift
  local wanted="$*"
  if [ ! -f "$folder/build.ninja" ] || [ "$(cat "$folder/.options" 2>/dev/null)" != "$wanted" ]; then
    say "Configuring $folder"
    cmake -S "$root" -B "$folder" -G Ninja "$@" >&2 || { say "Configuring failed."; exit 4; }
    printf '%s' "$wanted" >"$folder/.options"
  fi
}

# build FOLDER TARGET...: says so only where there is something to do.
build() {
  local folder=$1
  shift
  if [ "$(ninja -C "$folder" -n "$@" | tail -n 1)" != "ninja: no work to do." ]; then
    say "Building $*"
    ninja -C "$folder" "$@" >&2 || { say "The build failed."; exit 4; }
  fi
}
