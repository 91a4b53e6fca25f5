#!/bin/sh
# report_bundle.sh REPORT_FOLDER WORK_FOLDER: whether io/report/dist is what package-lock.json builds.
# 77 (skipped) where there is no npm, or npm cannot fetch.
command -v npm >/dev/null || { echo "skipped: npm is not installed"; exit 77; }
rm -rf "$2" && mkdir -p "$2" && cd "$1" || exit 1
cp -r build.mjs package.json package-lock.json src "$2"
cd "$2" || exit 1
npm ci --no-audit --no-fund --fetch-retries=1 --fetch-timeout=20000 >npm.log 2>&1 || {
  grep -qE 'ENOTFOUND|ECONNREFUSED|ETIMEDOUT|EAI_AGAIN|ECONNRESET|network' npm.log || { cat npm.log; exit 1; }
  echo "skipped: npm cannot reach its registry"
  exit 77
}
node build.mjs "$2/dist" && diff -r "$1/dist" "$2/dist" && exit 0
echo "io/report/dist is not what its lock file and sources build: ./dev page"
exit 1
