"""What the pages that are made from studies have in common: a study is run, and its tables are read."""
import csv
import os
import shutil
import subprocess


def run(toile, study, folder, jobs=1):
    """Runs a study; cases that are known are not run again. Returns the exit status."""
    return subprocess.run([toile, "study", study, "--output", folder, "--jobs", str(jobs), "--quiet"]).returncode


def table(folder, name):
    """The rows of a table of a study as dictionaries."""
    with open(os.path.join(folder, name + ".csv"), newline="") as file:
        return list(csv.DictReader(file))


def title(study):
    """Of a study file."""
    import xml.etree.ElementTree as tree
    for parameter in tree.parse(study).getroot().findall("Parameter"):
        if parameter.get("name") == "title":
            return parameter.get("value")
    return os.path.splitext(os.path.basename(study))[0]


def rounded(text, digits=3):
    """A number of a table with few digits; a dash if there is none."""
    return f"{float(text):.{digits}g}" if text else "-"


def keep(picture, figures):
    """Copies a picture to doc/figures. Returns its name there, or nothing if there is no picture."""
    if not os.path.exists(picture):
        return None
    os.makedirs(os.path.dirname(figures), exist_ok=True)
    shutil.copyfile(picture, figures)
    return figures
