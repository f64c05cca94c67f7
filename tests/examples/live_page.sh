# Installs playwright-core in WORK, where it is not yet, and runs test_live_page.mjs: live_page.sh ROOT WORK PROGRAM...
set -e
root=$1 work=$2
if [ ! -d "$work/node_modules/playwright-core" ]; then
  mkdir -p "$work"
  cp "$root/examples/live/package.json" "$root/examples/live/package-lock.json" "$work"
  npm ci --prefix "$work" --no-audit --no-fund --ignore-scripts >"$work/npm.log" 2>&1 || {
    echo "skipped: needs npm and its registry"
    exit 0
  }
fi
exec node "$root/tests/examples/test_live_page.mjs" "$@"
