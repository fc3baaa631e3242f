"""The one rule by which check, submit and grade judge what stands between an exercise's markers.

A body is taken when it is one: its braces are balanced, no preprocessor line is in it, and it names nothing of the
operating system or of the test kit. Comments and texts may hold what they like. It is read as the compiler reads it, so
that no comment, text or raw text hides code from this rule or code from the compiler.
"""

import re
from dataclasses import dataclass

TOKEN = re.compile(r"""
    (?P<space>[ \t\n\v\f]+)
  | (?P<comment>//[^\n]* | /\*.*?\*/)
  | (?P<raw>(?:u8|u|U|L)?R"(?P<mark>[^()\\\s"]{0,16})\(.*?\)(?P=mark)")
  | (?P<text>(?:u8|u|U|L)?"(?:\\.|[^"\\\n])*")
  | (?P<letter>(?:u8|u|U|L)?'(?:\\.|[^'\\\n])+')
  | (?P<number>\.?[0-9](?:[eEpP][+-]|'[0-9A-Za-z_]|[0-9A-Za-z_.])*)
  | (?P<name>[^\W\d]\w*|\$\w*)
  | (?P<sign>::|->|<%|%>|%:|\?\?|[^\s\w])
""", re.VERBOSE | re.DOTALL)
JOINED_LINES = re.compile(r"\\[ \t]*\n")
CONTROL = re.compile("[\0-\b\x0e-\x1f\x7f]")

RAW_PREFIXES = ("R", "u8R", "uR", "UR", "LR")
# Reserved for the compiler and its library; honest bodies need these of them at most.
RESERVED = re.compile(r"__|_[A-Z]")
RESERVED_BUT_FINE = re.compile(
    r"__builtin_(clz|ctz|ffs|popcount|parity|bswap\d+|expect|fabs|sqrt|fma|huge_val|inf|nan|isnan|isinf|isfinite|signbit)"
    r"(l|ll|f)?|__(func|FUNCTION|PRETTY_FUNCTION)__|__restrict(__)?|__(u?int128)(_t)?|__cplusplus|__(FILE|LINE)__")

TEST_KIT = re.compile(r"(EXPECT|ASSERT|GTEST|TEST|TYPED_TEST|ADD_FAILURE)(_\w+)?|FAIL|SUCCEED|SCOPED_TRACE|RUN_ALL_TESTS"
                      r"|testing|gtest|gmock|UnitTest|TestInfo|TestPartResult\w*|TestEventListeners?|VerdictChannel"
                      r"|takeVerdictChannel|runForVerdict")
SYSTEM = re.compile(
    r"syscall|system|read|write|_fileno|v?fork|forkpty|clone3?|unshare|setns|exec(l|le|lp|v|ve|vp|vpe|veat)|fexecve"
    r"|posix_\w+|p(open|close)|dl(m?open|v?sym|addr|info|close|_iterate_phdr)|ptrace|process_vm_\w+|prctl|seccomp|bpf"
    r"|mmap\d*|munmap|mprotect|mremap|memfd_create|shm\w*|sem_\w+"
    r"|(secure_)?getenv|(un)?setenv|putenv|clearenv|environ|program_invocation\w*"
    r"|kill|killpg|tgkill|tkill|raise|sigaction|sigqueue|sigprocmask|siginterrupt|getppid|getpid|gettid"
    r"|setsid|setpgid|setpgrp|daemon|setrlimit|prlimit|set[eres]*[ug]id|chroot|pivot_root|mount|umount2?"
    r"|pthread_\w+|thrd_\w+|jthread|async|timer_\w+|setitimer|aio_\w+|lio_listio|mq_\w+"
    r"|at_quick_exit|atexit|on_exit|set_terminate|set_new_handler"
    r"|[_]?(sig)?(long|set)jmp|[gs]etcontext|makecontext|swapcontext"
    r"|fopen(64)?|fdopen|freopen(64)?|fileno|tmpfile(64)?|mkstemp\w*|FILE"
    r"|w?[io]?fstream|basic_[io]?fstream|w?filebuf|basic_filebuf|stdio_filebuf"
    r"|filesystem|opendir|readdir|scandir|nftw|readlink|symlink|unlink|mkfifo|mknod|chmod|chown|fcntl|ioctl|openat2?|creat"
    r"|pwrite\w*|pread\w*|writev|readv|vmsplice|splice|sendfile|sendto|sendmsg|recv(from|msg)?|socket(pair)?"
    r"|dup[23]?|pipe2|eventfd|io_uring\w*")
# Words that a body may well use for its own things: they are refused as functions of the system only.
SYSTEM_CALLS = frozenset("open send pipe thread signal alarm waitpid".split())
OPERATORS = frozenset("and or xor bitand bitor not_eq and_eq or_eq xor_eq".split())
LANGUAGE = {
    "asm": "is assembler",
    "extern": "is a linkage specification",
    "gnu": "is an attribute of the compiler",
    "import": "is a preprocessor line",
}
HIDDEN_FILES = re.compile(r"/(proc|dev|sys)\b")

# Nothing is wrong with these, but a body that attacks the test around it could hardly do without.
WORTH_A_LOOK = frozenset(
    "reinterpret_cast const_cast bit_cast uintptr_t intptr_t union exit quick_exit _exit abort launder".split())


@dataclass(frozen=True)
class Token:
    kind: str  # "raw", "text", "letter", "number", "name", "sign"
    text: str
    line: int  # of the body, counted from 1


@dataclass(frozen=True)
class Complaint:
    line: int  # of the body, counted from 1
    reason: str  # what it is: "'fork' is of the operating system"


class Unreadable(Exception):
    """What cannot be read as C++; carries a Complaint."""

    def __init__(self, line, reason):
        super().__init__(reason)
        self.complaint = Complaint(line, reason)


def tokens(source):
    """The tokens of a source without comments and white space.

    @throws Unreadable where a comment or a text has no end
    """
    found = []
    position, line = 0, 1
    while position < len(source):
        matched = TOKEN.match(source, position)
        if not matched or (matched["sign"] in ('"', "'") or source.startswith("/*", position) and not matched["comment"]):
            raise Unreadable(line, "a text has no end" if source[position] in "\"'" else "a comment has no end"
                             if source.startswith("/*", position) else f"{source[position]!r} is no part of C++")
        if matched.lastgroup != "space" and not matched["space"] and not matched["comment"]:
            kind = next(name for name in ("raw", "text", "letter", "number", "name", "sign") if matched[name] is not None)
            if kind == "name" and matched["name"] in RAW_PREFIXES and source.startswith('"', matched.end()):
                raise Unreadable(line, "a raw text has no end")
            found.append(Token(kind, matched[0], line))
        line += matched[0].count("\n")
        position = matched.end()
    return found


def complaint_about(body):
    """Why a body cannot be taken; None when it can."""
    control = CONTROL.search(body)
    if control:
        return Complaint(line_of(body, control.start()), f"the character {ord(control[0]):#04x} is no part of a text file")
    joined = JOINED_LINES.search(body)
    if joined:
        return Complaint(line_of(body, joined.start()), "a backslash at the end of a line joins it with the next one")
    try:
        words = tokens(body)
    except Unreadable as error:
        return error.complaint
    return complaint_of_braces(words) or complaint_of_words(words)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def complaint_of_braces(words):
    opened = []
    for word in words:
        if word.text == "{":
            opened.append(word.line)
        elif word.text == "}":
            if not opened:
                return Complaint(word.line, "this '}' closes what the body did not open")
            opened.pop()
    return Complaint(opened[-1], "this '{' is not closed") if opened else None


def complaint_of_words(words):
    for position, word in enumerate(words):
        before = words[position - 1].text if position > 0 else ""
        if before == "&" and position > 1 and is_type_end(words[position - 2]):
            before = ""  # a reference, not an address
        after = words[position + 1].text if position + 1 < len(words) else ""
        reason = reason_against(word, before, after)
        if reason:
            return Complaint(word.line, reason)
    return None


def is_type_end(word):
    return (word.kind == "name" and word.text != "return") or word.text == ">"


def reason_against(word, before, after):
    """What is wrong with one word; empty when nothing is."""
    text = word.text
    if word.kind in ("text", "raw") and HIDDEN_FILES.search(text):
        return f"{HIDDEN_FILES.search(text)[0]} is of the operating system"
    if word.kind == "sign" and text in ("#", "%:", "??"):
        return "this is a preprocessor line"
    if word.kind == "sign" and text in ("<%", "%>"):
        return f"'{text}' is an old way to write a brace; write the brace"
    if word.kind == "sign" and text == "\\":
        return "a backslash stands outside of a text"
    if word.kind != "name":
        return ""
    if text in LANGUAGE:
        return f"'{text}' {LANGUAGE[text]}"
    if TEST_KIT.fullmatch(text) or (text == "test" and after == "::"):
        return f"'{text}' is of the test kit"
    if RESERVED.match(text) and not RESERVED_BUT_FINE.fullmatch(text):
        return f"'{text}' is reserved for the compiler"
    is_member = before in (".", "->") and text != "_fileno"
    is_used = after in ("(", "<") or before in ("::", "&") or (after.isidentifier() and after not in OPERATORS)
    if not is_member and (SYSTEM.fullmatch(text) or (text in SYSTEM_CALLS and is_used)):
        return f"'{text}' is of the operating system (call it something else, if it is yours)"
    return ""


def worth_a_look(body):
    """What in a body a person should look at, each once, in its order."""
    try:
        words = tokens(body)
    except Unreadable:
        return []
    found = [word.text for word in words if word.kind == "name" and word.text in WORTH_A_LOOK]
    if any(is_pointer_cast(words[i:i + 3]) for i in range(len(words) - 2)):
        found.append("a cast to a pointer")
    return list(dict.fromkeys(found))


def is_pointer_cast(words):
    """Whether three tokens are the end of a cast such as (char*)x, and what is cast."""
    star, bracket, operand = words
    return star.text == "*" and bracket.text == ")" and (
        operand.kind in ("name", "number") and operand.text not in ("const", "noexcept", "mutable") or operand.text in ("(", "&", "*"))
