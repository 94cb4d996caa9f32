"""Every Python block of doc/python.md runs, one after another, and what it asserts holds."""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
page = root / "doc" / "python.md"
names = {"tube_xml": str(root / "examples" / "tube.xml")}
blocks = list(re.finditer(r"^```python\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL))
if len(blocks) < 6:
    sys.exit(f"{page}: only {len(blocks)} blocks of Python were found")
for block in blocks:
    line = page.read_text()[: block.start(1)].count("\n")
    exec(compile("\n" * line + block.group(1), str(page), "exec"), names)
