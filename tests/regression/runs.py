"""Runs of the program for scripts that need many: each in a folder of its own, resumable.

A folder that holds the finished run of the same scene and settings is taken as it is; one that holds
a checkpoint of it goes on from there; anything else starts anew.
"""
import concurrent.futures
import json
import os
import shutil
import subprocess


def read_json(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return None


def run_once(quern, scene, folder, settings, threads=1):
    """The summary of a run; `settings` are the texts that follow --set."""
    with open(scene, encoding="utf-8") as file:
        asked = {"scene": file.read(), "settings": list(settings)}
    note = os.path.join(folder, "asked.json")
    summary = os.path.join(folder, "summary.json")
    if read_json(note) != asked:
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        with open(note, "w", encoding="utf-8") as file:
            json.dump(asked, file)
    elif (read_json(summary) or {}).get("finished"):
        return read_json(summary)
    command = [quern, "run", scene, "--out", folder, "--threads", str(threads)]
    for setting in settings:
        command += ["--set", setting]
    if os.path.isfile(os.path.join(folder, "checkpoint.h5")):
        command = [quern, "resume", folder, "--threads", str(threads)]
    with open(os.path.join(folder, "log"), "a", encoding="utf-8") as log:
        subprocess.run(command, check=True, stdout=log, stderr=log)
    return read_json(summary)


def run_all(quern, scene, runs, at_once=2):
    """Summaries by name; `runs` has the folder and the settings of each name."""
    with concurrent.futures.ThreadPoolExecutor(at_once) as pool:
        waiting = {name: pool.submit(run_once, quern, scene, folder, settings)
                   for name, (folder, settings) in runs.items()}
        return {name: future.result() for name, future in waiting.items()}
