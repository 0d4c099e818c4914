#!/bin/sh
# Godot 4 for Debian machines that have none, from Debian itself: sh install_godot.sh [PREFIX [BIN]]
#
# Debian's stable suite may be older than its Godot 4 package, so that package and everything it
# needs, the C library too, is taken from a newer suite (GODOT_SUITE, by default testing),
# unpacked into PREFIX (/opt/godot4) and started with PREFIX's own loader. No package of the
# system changes; only xvfb, for pictures without a screen, comes from the system's own suite.
# BIN (/usr/local/bin) gets `godot4` and `godot4-render`. Run as root; amd64 and arm64.
set -eu

prefix=${1:-/opt/godot4}
bin=${2:-/usr/local/bin}
suite=${GODOT_SUITE:-testing}
wanted="godot libgl1 libegl1 libegl-mesa0 libglx-mesa0 libgl1-mesa-dri libgles2 mesa-vulkan-drivers
  libvulkan1 libxcursor1 libxinerama1 libxi6 libxrandr2 libxrender1 libxext6"

fail() {
  echo "install_godot.sh: $*" >&2
  exit 1
}

case $(dpkg --print-architecture 2>/dev/null) in
  amd64) triplet=x86_64-linux-gnu loader=ld-linux-x86-64.so.2 ;;
  arm64) triplet=aarch64-linux-gnu loader=ld-linux-aarch64.so.1 ;;
  *) fail "this is no Debian machine with amd64 or arm64" ;;
esac
mkdir -p "$prefix" "$bin"
prefix=$(cd "$prefix" && pwd)
bin=$(cd "$bin" && pwd)
lib=$prefix/usr/lib/$triplet

# put NAME: the script on standard input becomes BIN/NAME at once.
put() {
  cat > "$bin/.$1.new"
  chmod 755 "$bin/.$1.new"
  mv "$bin/.$1.new" "$bin/$1"
}

put_commands() {
  put godot4 <<END
#!/bin/sh
exec $lib/$loader --library-path $lib:$prefix/usr/lib:$lib/pulseaudio $prefix/usr/bin/godot "\$@"
END
  put godot4-render <<END
#!/bin/sh
# Draws with OpenGL in software on a virtual screen of GODOT_SCREEN pixels.
export LIBGL_DRIVERS_PATH=$lib/dri
export __EGL_VENDOR_LIBRARY_DIRS=$prefix/usr/share/glvnd/egl_vendor.d
exec xvfb-run -a -s "-screen 0 \${GODOT_SCREEN:-1280x720x24}" $bin/godot4 \\
  --rendering-method gl_compatibility --rendering-driver opengl3 --audio-driver Dummy "\$@"
END
}

# The mirror that this machine's apt has for its own release, whatever form its list has.
mirror() {
  release=$(. /etc/os-release && echo "$VERSION_CODENAME")
  apt-get indextargets --format '$(IDENTIFIER) $(RELEASE) $(COMPONENT) $(REPO_URI)' \
    | awk -v r="$release" '$1 == "Packages" && $2 == r && $3 == "main" { print $4; exit }'
}

# An apt of its own, which believes that nothing is installed, so that it resolves everything.
private_apt() {
  from=$(mirror)
  keys=/usr/share/keyrings/debian-archive-keyring.gpg
  [ -n "$from" ] || fail "the apt sources of this machine name no mirror of its release"
  [ -r "$keys" ] || fail "install the package debian-archive-keyring first"
  mkdir -p "$1/lists/partial" "$1/cache/archives/partial" "$1/parts" "$1/debs"
  : > "$1/status"
  echo "deb [signed-by=$keys] $from $suite main" > "$1/sources.list"
  cat > "$1/apt.conf" <<END
Dir::Etc::sourcelist "$1/sources.list";
Dir::Etc::sourceparts "$1/parts";
Dir::Etc::preferencesparts "$1/parts";
Dir::State::Lists "$1/lists";
Dir::State::status "$1/status";
Dir::Cache "$1/cache";
APT::Install-Recommends "false";
APT::Sandbox::User "root";
END
}

unpack() {
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  private_apt "$work"
  export APT_CONFIG="$work/apt.conf"
  apt-get update -qq >&2
  # shellcheck disable=SC2086 # a list of words
  apt-get install -y --print-uris $wanted > "$work/plan" || fail "apt cannot resolve $wanted"
  sed -n "s/^'[^']*' \([^_]*\)_.*/\1/p" "$work/plan" | sort -u > "$work/names"
  count=$(wc -l < "$work/names")
  echo "install_godot.sh: unpacking $count packages into $prefix" >&2
  (cd "$work/debs" && xargs apt-get download -qq < "$work/names" >&2)
  [ "$(find "$work/debs" -name '*.deb' | wc -l)" -eq "$count" ] || fail "not every package arrived"
  # Debian has these as links into /usr; unpacking needs them to be there first.
  for name in bin lib lib64 sbin; do
    mkdir -p "$prefix/usr/$name"
    [ -e "$prefix/$name" ] || ln -s "usr/$name" "$prefix/$name"
  done
  for deb in "$work"/debs/*.deb; do
    dpkg -x "$deb" "$prefix"
  done
  unset APT_CONFIG
}

[ -x "$prefix/usr/bin/godot" ] || unpack
put_commands
if ! command -v xvfb-run > /dev/null; then
  apt-get install -y --no-install-recommends xvfb xauth >&2 || echo "no xvfb: no pictures" >&2
fi
"$bin/godot4" --version
