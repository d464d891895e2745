"""docs/result.schema.json has the definitions that follow from the lists of fields in answer/.

    python3 schema_test.py PROGRAM SCHEMA            exit code 1: it has not
    python3 schema_test.py PROGRAM SCHEMA --write    writes them

PROGRAM prints the definitions.
"""
import json
import pathlib
import subprocess
import sys

WIDTH = 120


def text(value, indent=0):
    """JSON with what is short on one line."""
    short = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, (dict, list)) or indent + len(short) <= WIDTH:
        return short
    pad = " " * (indent + 2)
    if isinstance(value, dict):
        parts = [f"{json.dumps(key)}: {text(each, indent + 2)}" for key, each in value.items()]
    else:
        parts = [text(each, indent + 2) for each in value]
    opening, closing = "{}" if isinstance(value, dict) else "[]"
    return opening + "\n" + ",\n".join(pad + part for part in parts) + "\n" + " " * indent + closing


def main():
    program, place = sys.argv[1], pathlib.Path(sys.argv[2])
    generated = json.loads(subprocess.run([program], check=True, capture_output=True, text=True).stdout)
    schema = json.loads(place.read_text(encoding="utf-8"))
    different = [name for name, definition in generated.items() if schema["$defs"].get(name) != definition]
    if "--write" in sys.argv:
        schema["$defs"].update(generated)
        place.write_text(text(schema) + "\n", encoding="utf-8")
    elif different:
        sys.exit(f"{place}: the definitions {', '.join(different)} do not follow from the lists of fields; "
                 f"expected those of: python3 {sys.argv[0]} {program} {place} --write")


if __name__ == "__main__":
    main()
