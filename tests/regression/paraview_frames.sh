#!/bin/sh
# paraview_frames.sh RUN_FOLDER PARTICLES: paraview_frames.py on a virtual display; 77 (skipped) where
# ParaView or Xvfb is not installed. The picture is RUN_FOLDER/frames.png.
# The server starts anew when its last client leaves, unless told not to, and misses who comes then:
# ParaView connects twice.
command -v pvbatch >/dev/null && command -v xvfb-run >/dev/null || exit 77
exec xvfb-run -a -s -noreset pvbatch "$(dirname "$0")/paraview_frames.py" "$1/frames" "$1/frames.png" "$2"
