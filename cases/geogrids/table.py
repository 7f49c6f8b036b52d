#!/usr/bin/python3 -I
"""One Markdown table from the table.csv of several runs: measured / stated (ratio)."""

import argparse
import csv
import json
import os


def short(text):
    return f"{float(text):.3g}" if abs(float(text)) < 1e4 else f"{float(text):.0f}"


def cell(row):
    if row is None:
        return ""
    if not row["stated"]:
        return short(row["measured"])
    ratio = float(row["measured"]) / float(row["stated"])
    said = "input" if row.get("stated_is_input") else f"{ratio:.2f}"
    return f"{short(row['measured'])} / {short(row['stated'])} ({said})"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", nargs="+", help="output folders of the experiment laboratory")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args()
    names, tables, quantities = [], [], []
    for run in arguments.runs:
        with open(os.path.join(run, "summary.json"), encoding="utf-8") as file:
            names.append(json.load(file)["results"]["product"])
        with open(os.path.join(run, "table.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        tables.append({row["quantity"]: row for row in rows})
        for row in rows:
            if (row["quantity"], row["unit"]) not in quantities:
                quantities.append((row["quantity"], row["unit"]))
    lines = ["measured / stated (ratio); stated values: see the product's file", "",
             "| | " + " | ".join(names) + " |", "|---" * (len(names) + 1) + "|"]
    for quantity, unit in quantities:
        lines.append(f"| {quantity} [{unit}] | " + " | ".join(cell(t.get(quantity)) for t in tables) + " |")
    text = "\n".join(lines) + "\n"
    with open(arguments.output + ".part", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(arguments.output + ".part", arguments.output)
    print(text)


if __name__ == "__main__":
    main()
