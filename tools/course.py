"""The course script: ./course COMMAND.

Each command is a module of tools/commands/ with HELP (one line), add_arguments(parser) and run(args) -> exit code. A new
command is a new file there; nothing else lists them.
"""

import argparse
import importlib
import os
import pkgutil
import signal
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import commands
from course_lib.errors import CourseError

INTERRUPTED = 128 + signal.SIGINT
UNREAD = 128 + signal.SIGPIPE


class CommandLine(argparse.ArgumentParser):
    """An ArgumentParser whose errors are one line, like all of ours."""

    def error(self, message):
        raise CourseError(f"{message}; see {self.prog} --help")


def command_names():
    return sorted(module.name.replace("_", "-") for module in pkgutil.iter_modules(commands.__path__))


def load(name):
    return importlib.import_module("commands." + name.replace("-", "_"))


def overview():
    rows = "".join(f"  {name:<11} {load(name).HELP}\n" for name in command_names())
    return f"usage: ./course COMMAND [--help]\n\nCaustic: photorealistic rendering, step by step.\n\n{rows}"


def run_command(name, arguments):
    if name not in command_names():
        raise CourseError(f"there is no command '{name}'; there are {', '.join(command_names())}")
    command = load(name)
    description = (command.__doc__ or command.HELP).strip()
    parser = CommandLine(prog=f"./course {name}", description=description,
                         formatter_class=argparse.RawDescriptionHelpFormatter)
    command.add_arguments(parser)
    return command.run(parser.parse_args(arguments))


def main(arguments):
    if not arguments or arguments[0] in ("-h", "--help", "help"):
        print(overview(), end="")
        return 0 if arguments else 1
    try:
        return run_command(arguments[0], arguments[1:])
    except CourseError as error:
        sys.stdout.flush()
        print(f"course: {error}", file=sys.stderr)
        return error.code
    except KeyboardInterrupt:
        print("\ncourse: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # Nobody reads on: "./course status | head". What is still buffered would fail once more at the end.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return UNREAD


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
