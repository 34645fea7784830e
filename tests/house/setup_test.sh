#!/usr/bin/env bash
# tools/setup on simulated systems: dpkg-query, apt-get, sudo and id are stand-ins that record how they are
# called.
#   setup_test.sh path/to/tools/setup
set -euo pipefail
setup=$1
bash=$(command -v bash)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# stand_in NAME BODY: creates a program of that name on the simulated system.
stand_in() {
  printf '#!%s\n%s\n' "$bash" "$2" >"$folder/bin/$1"
  chmod +x "$folder/bin/$1"
}

# A bare system with the basics only. $1 = packages that are not installed, $2 = the user's id.
new_system() {
  rm -rf "$folder/bin" "$folder/calls"
  mkdir "$folder/bin"
  : >"$folder/calls"
  for name in cat env; do
    ln -s "$(command -v $name)" "$folder/bin/$name"
  done
  stand_in id "echo $2"
  stand_in dpkg-query "case ' $1 ' in *\" \${!#} \"*) exit 1 ;; *) printf installed ;; esac"
}

add_apt() {
  stand_in apt-get "echo \"\$DEBIAN_FRONTEND apt-get \$*\" >>'$folder/calls'; case \" \$* \" in *\" $1 \"*) exit 100 ;; esac"
}

# run [ARGUMENTS]: sets `status`, `output` and `calls`.
run() {
  status=0
  output=$(PATH=$folder/bin "$bash" "$setup" "$@" 2>&1) || status=$?
  calls=$(cat "$folder/calls")
}

failures=0
expect() {
  if ! eval "$2"; then
    echo "FAILED: $1: $2"
    echo "status $status, output: $output"
    echo "calls: $calls"
    failures=1
  fi
}

new_system "" 0
add_apt none
run
expect "nothing missing: apt is not run" '[ $status = 0 ] && [ -z "$calls" ]'
expect "nothing missing: it says so" '[[ $output == *"packages are installed"* ]]'

new_system "libfmt-dev clang" 0
add_apt none
run
expect "a missing package alone is installed" '[ $status = 0 ] && [[ $calls == *" install -y --no-install-recommends libfmt-dev" ]]'
expect "no questions" '[[ $calls == "noninteractive apt-get "*" update"*"noninteractive apt-get "* ]]'
expect "it says what it installs" '[[ $output == *"installing libfmt-dev"* ]]'
run --all
expect "--all: Clang as well" '[ $status = 0 ] && [[ $calls == *" libfmt-dev clang" ]]'

new_system "libfmt-dev" 0
add_apt update
run
expect "lists that cannot be refreshed do not stop it" '[ $status = 0 ] && [[ $calls == *"install"* ]]'

new_system "libfmt-dev" 0
add_apt install
run
expect "a failed installation is a failure with advice" '[ $status = 1 ] && [[ $output == *"by hand: libfmt-dev"* ]]'

new_system "libfmt-dev cmake" 0
run
expect "no apt-get" '[ $status = 1 ] && [[ $output == *"no apt-get"*"by hand: cmake libfmt-dev"* ]]'

new_system "" 0
rm "$folder/bin/dpkg-query"
run
expect "no Debian" '[ $status = 1 ] && [[ $output == *"no apt-get"*"by hand: g++ cmake"* ]]'

new_system "libfmt-dev" 1000
add_apt none
run
expect "no root and no sudo" '[ $status = 1 ] && [[ $output == *"needs root"*"by hand: libfmt-dev"* ]] && [ -z "$calls" ]'
stand_in sudo "echo sudo >>'$folder/calls'; exec \"\$@\""
run
expect "no root but sudo" '[ $status = 0 ] && [[ $calls == "sudo"*"install"*"libfmt-dev" ]]'

new_system "chromium" 0
add_apt chromium
run
expect "no browser is no failure" '[ $status = 0 ] && [[ $output == *"chromium cannot be installed"*"setup: done"* ]]'

new_system "nodejs npm chromium" 0
add_apt none
for program in node npm chromium; do stand_in $program ""; done
run
expect "node, npm and a browser from elsewhere will do" '[ $status = 0 ] && [ -z "$calls" ]'

new_system "libfmt-dev" 1000
rm "$folder/bin/id"
stand_in id "echo 1000"
stand_in dpkg-query "printf installed"
run
expect "nothing missing needs no root" '[ $status = 0 ]'

[ $failures = 0 ] && echo "all of tools/setup's cases passed"
exit $failures
