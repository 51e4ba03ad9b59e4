#!/bin/sh
# Installs what Massé needs from a fresh Debian or Ubuntu; does nothing where all is there.
#
#   compiler      cc, pkg-config, cargo >= 1.95
#   gamepads      the udev headers (libudev-dev)
#   sound         the ALSA headers (libasound2-dev); the game runs without a sound device
#   picture       a Vulkan driver (Mesa's, software where there is no GPU) and the X11 libraries a window loads
set -eu

missing=""
need() { missing="$missing $*"; }

command -v cc >/dev/null 2>&1 || need gcc libc6-dev
command -v pkg-config >/dev/null 2>&1 || need pkg-config
pkg-config --exists alsa 2>/dev/null || need libasound2-dev
pkg-config --exists libudev 2>/dev/null || need libudev-dev
ls /usr/share/vulkan/icd.d /etc/vulkan/icd.d 2>/dev/null | grep -q json || need mesa-vulkan-drivers
library() { PATH="$PATH:/sbin:/usr/sbin" ldconfig -p 2>/dev/null | grep -q "$1" || need "$2"; }
library libvulkan.so.1 libvulkan1
library libX11.so.6 libx11-6
library libX11-xcb.so.1 libx11-xcb1
library libXcursor.so.1 libxcursor1
library libXi.so.6 libxi6
library libXrandr.so.2 libxrandr2
library libxkbcommon.so.0 libxkbcommon0
library libxkbcommon-x11.so.0 libxkbcommon-x11-0

if [ -n "$missing" ]; then
    if ! command -v apt-get >/dev/null 2>&1; then
        echo "setup: this system has no apt-get; please install:$missing" >&2
        exit 1
    fi
    as_root=""
    [ "$(id -u)" = 0 ] || as_root="sudo"
    echo "setup: installing$missing"
    $as_root apt-get update -qq
    # shellcheck disable=SC2086
    DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing >/dev/null
fi

if ! command -v cargo >/dev/null 2>&1; then
    echo "setup: Rust is missing. Install it with rustup (https://rustup.rs), 1.95 or newer, then run this again." >&2
    exit 1
fi
