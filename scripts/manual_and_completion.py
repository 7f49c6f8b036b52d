#!/usr/bin/python3
"""The manual page and the completion for bash of a built program, from what it says itself.

    manual_and_completion.py PROGRAM FOLDER VERSION

Reads `PROGRAM --help` and `PROGRAM help COMMAND` of each command and writes FOLDER/man/man1/interlock.1 and
FOLDER/bash-completion/completions/interlock.
"""

import os
import re
import subprocess
import sys

# Options and arguments by what may follow them.
FOLDERS = {"folder"}
FILES = {"file", "stones", "--output", "--report"}


class Help:
    """The text of one `--help`, taken apart: sentence, usage, and sections of (name, explanation)."""

    def __init__(self, text):
        self.sections, self.footer = {}, []
        lines = text.splitlines()
        self.sentence = lines[0].rstrip(".")
        self.usage = lines[1].partition("Usage: ")[2]
        section = None
        for line in lines[2:]:
            entry = re.match(r"  (\S.*)$", line)
            if re.match(r"(Positionals|Options|Subcommands):$", line):
                section = self.sections.setdefault(line[:-1], [])
            elif section is not None and entry:
                # Two blanks part a name from its explanation; a long name has a line of its own, and a long one that
                # just fits has a single blank behind it.
                name, explanation = entry.group(1)[:28].rstrip(), entry.group(1)[28:]
                if "  " not in entry.group(1) and len(entry.group(1)) > 28 and entry.group(1)[27] != " ":
                    name, explanation = entry.group(1), ""
                section.append([name, explanation.strip()])
            elif section is not None and line.startswith(" " * 30):
                section[-1][1] = (section[-1][1] + " " + line.strip()).strip()
            else:
                section = None
                self.footer.append(line)
        self.footer = "\n".join(self.footer).strip()

    def of(self, section):
        return self.sections.get(section, [])

    def options(self):
        """(spellings, whether a value follows) of each option."""
        for name, _ in self.of("Options"):
            spelled, _, value = name.partition(" ")
            yield spelled.split(","), bool(value)


def ask(program, *words):
    # Nothing of the machine on which this is built belongs into the text.
    return Help(subprocess.run([program, *words], check=True, capture_output=True, text=True).stdout)


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in text.splitlines())


def entries(rows):
    return "".join(f".TP\n.B {roff(name)}\n{roff(explanation)}\n" for name, explanation in rows)


def manual(overview, commands, version):
    text = [f'.TH INTERLOCK 1 "" "Interlock {version}" "User Commands"\n.SH NAME\n'
            f"interlock \\- {roff(overview.sentence[0].lower() + overview.sentence[1:])}\n"
            ".SH SYNOPSIS\n.B interlock\n.I command\n[options]\n.SH COMMANDS\n",
            entries(overview.of("Subcommands")), ".SH OPTIONS\n", entries(overview.of("Options"))]
    for name, page in commands.items():
        text.append(f".SH INTERLOCK {roff(name.upper())}\n{roff(page.sentence)}.\n.PP\n.B {roff(page.usage)}\n")
        text.append(entries(page.of("Positionals")) + entries(page.of("Options")))
        if page.footer and page.footer != overview.footer:
            text.append(f".PP\n.nf\n{roff(page.footer)}\n.fi\n")
    text.append(".SH EXIT STATUS\n.nf\n" + roff(overview.footer) + "\n.fi\n.SH FILES\n"
                ".I share/interlock/cases\nbeside the program's folder holds the cases and products that come with it.\n"
                ".SH ENVIRONMENT\n.TP\n.B INTERLOCK_SHARE\nThe folder share/interlock, for a program that was copied "
                "elsewhere.\n")
    return "".join(text)


def choices(commands, name):
    """The words that an argument may be, where its explanation lists them: "... template: a, b, c (...)"."""
    if name == "template":
        listed = commands[name].of("Positionals")[0][1].partition(": ")[2].partition(" (")[0]
        return [word.strip() for word in listed.split(",")]
    if name == "help":
        return list(commands)
    return []


def completion(overview, commands):
    cases, values = [], []
    for name, page in commands.items():
        words = []
        for spellings, takes_value in page.options():
            words += spellings
            if takes_value:
                wanted = "files" if set(spellings) & FILES else "nothing"
                values.append(f"    {name}:" + f" | {name}:".join(spellings) + f") {wanted}=1 ;;")
        arguments = [argument.split()[0] for argument, _ in page.of("Positionals")]
        folders = bool(set(arguments) & FOLDERS)
        kind = "folders" if folders else "files" if set(arguments) & FILES else "nothing"
        listed = " ".join(f'"{choice}"' for choice in choices(commands, name))
        cases.append(f"    {name}) options=\"{' '.join(words)}\" arguments={kind} choices=({listed}) ;;")
    names = " ".join(commands)
    return f"""# Completion of interlock for bash: commands, their options, files.
_interlock()
{{
  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command=${{COMP_WORDS[1]}}
  local options="" arguments=nothing files=0 nothing=0 choices=() choice
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{names} {' '.join(w for s, _ in overview.options() for w in s)}" -- "$current"))
    return
  fi
  case $command in
{chr(10).join(cases)}
    *) return ;;
  esac
  case $command:$before in
{chr(10).join(values)}
  esac
  if [ "$nothing" -eq 1 ]; then return; fi
  local IFS=$'\\n'
  if [[ $files -eq 0 && $current == -* ]]; then
    COMPREPLY=($(compgen -W "${{options// /$'\\n'}}" -- "$current"))
  elif [ "$files" -eq 1 ] || [ "$arguments" = files ]; then
    COMPREPLY=($(compgen -f -- "$current"))
    compopt -o filenames 2>/dev/null
  elif [ "$arguments" = folders ]; then
    COMPREPLY=($(compgen -d -- "$current"))
    compopt -o filenames 2>/dev/null
  else
    for choice in "${{choices[@]}}"; do
      if [[ $choice == "$current"* ]]; then COMPREPLY+=("$(printf %q "$choice")"); fi
    done
  fi
}}
complete -F _interlock interlock
"""


def write(folder, name, text):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)


def main():
    program, folder, version = sys.argv[1:]
    overview = ask(program, "--help")
    commands = {name: ask(program, "help", name) for name, _ in overview.of("Subcommands")}
    write(os.path.join(folder, "man", "man1"), "interlock.1", manual(overview, commands, version))
    write(os.path.join(folder, "bash-completion", "completions"), "interlock", completion(overview, commands))


if __name__ == "__main__":
    main()
