#!/usr/bin/env bash
# Does README's promise hold on a machine that has nothing? Makes a bare Debian in a folder, clones this checkout
# into it, to a path with a space, and types README's two commands there. Needs root; installs debootstrap if missing.
#   tests/fresh_machine.sh                 the last commit, on Debian 12
#   tests/fresh_machine.sh trixie          the last commit, on Debian 13; or whichever release is named
#   tests/fresh_machine.sh --uncommitted   what lies here now
#   tests/fresh_machine.sh --keep          leaves the root to look around in, and says how
set -euo pipefail

keep=no uncommitted=no release=bookworm
for option; do
    case $option in
    --keep) keep=yes ;;
    --uncommitted) uncommitted=yes ;;
    [a-z]*) release=$option ;;
    *) sed -n '2,7s/^# //p' "$0"; exit 2 ;;
    esac
done
checkout=$(cd "$(dirname "$0")/.." && pwd -P)

stop() { echo "fresh_machine: $1" >&2; exit 2; }
[ "$(id -u)" = 0 ] || stop 'a bare root needs root: sudo tests/fresh_machine.sh'

# Packages come from where this machine has its own: the address of each part of Debian, but for backports.
debian_entries() {
    # shellcheck disable=SC2016 # the names are apt's
    apt-get indextargets --format '$(ORIGIN)|$(COMPONENT)|$(CREATED_BY)|$(CODENAME)|$(SITE)' 2>/dev/null |
        sed -n 's/^Debian|main|Packages|//p' | sort -u
}
[ -n "$(debian_entries)" ] || apt-get update -q >/dev/null
address=$(debian_entries | sed -n 's/^[a-z]*|//p' | head -n 1)
[ -n "$address" ] || stop 'apt on this machine knows no Debian to take packages from'
command -v debootstrap >/dev/null ||
    DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends debootstrap >/dev/null ||
    stop 'cannot install debootstrap'

machine=$(mktemp -d "${TMPDIR:-/var/tmp}/fresh-machine.XXXXXX")
chmod 755 "$machine"
inside=
leave() { # whatever happens: what was mounted in there was so in a namespace, which ends with its first process
    if [ -n "$inside" ]; then
        kill -KILL "$inside" 2>/dev/null || true # it may have ended by itself
        wait "$inside" || true
        sleep 1
    fi
    if [ "$keep" = yes ]; then
        echo "The root is kept: chroot $machine"
    else
        rm -rf --one-file-system "$machine" "$machine.log"
    fi
}
trap leave EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

echo "A bare Debian, $release, in $machine"
debootstrap --variant=minbase "$release" "$machine" "$address" >"$machine.log" 2>&1 ||
    { tail -n 20 "$machine.log" >&2; stop "debootstrap failed, as shown above ($machine.log)"; }
mv "$machine.log" "$machine/var/log/debootstrap.log"

# As an installed machine has them: release, updates and security, one stanza each; and how to get there.
: >"$machine/etc/apt/sources.list"
debian_entries | while IFS='|' read -r codename site; do
    case $codename in bookworm | bookworm-updates | bookworm-security) ;; *) continue ;; esac
    codename=$release${codename#bookworm}
    printf 'Types: deb\nURIs: %s\nSuites: %s\nComponents: main\nSigned-By: %s\n\n' "$site" "$codename" \
        /usr/share/keyrings/debian-archive-keyring.gpg
done >"$machine/etc/apt/sources.list.d/debian.sources"
apt-config dump | grep -E '^Acquire::(http|https|Check-|Retries)' >"$machine/etc/apt/apt.conf.d/90acquire" || true
echo force-unsafe-io >"$machine/etc/dpkg/dpkg.cfg.d/throwaway" # nobody will miss it after a power cut
cp /etc/resolv.conf /etc/hosts "$machine/etc/"

course="$machine/root/frame by frame"
git clone --quiet --no-hardlinks "$checkout" "$course"
if [ "$uncommitted" = yes ]; then
    (cd "$checkout" && git ls-files -z --cached --others --exclude-standard | xargs -0 cp --parents -pt "$course") || true
fi

for command in ./course './course test'; do
    grep -qxF "$command" "$course/README.md" || stop "README.md no longer tells to type $command"
done

# type_there COMMAND: as somebody would who has just logged in there.
type_there() {
    echo "\$ $1"
    # shellcheck disable=SC2016 # for the shell in there
    unshare --mount --pid --fork --kill-child sh -c '
        mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" &&
            exec chroot "$1" /usr/bin/env -i HOME=/root TERM=dumb \
                PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin sh -c "cd ~/\"frame by frame\" && $2"
    ' - "$machine" "$1" </dev/null & # so that a signal does not wait for its end
    inside=$!
    wait "$inside"
    inside=
}
type_there ./course
type_there ./course >"$machine/root/second"
cat "$machine/root/second"
! grep -E ' [0-9]+ s$' "$machine/root/second" || stop 'a second ./course did something again'
type_there './course test'
[ "$uncommitted" = yes ] || [ -z "$(git -C "$course" status --porcelain)" ] ||
    { git -C "$course" status --short; stop 'the build left files in the tree that git sees'; }
echo 'On a fresh machine both commands work.'
