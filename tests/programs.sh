# Programs of the checks, sourced by them: the axgen to check, and Python with a package of its own. It tests nothing.

check=$(basename "$0")

# missing TEXT: what cannot be done without it is not a failure of what is checked
missing() {
    echo "$check: $1" >&2
    exit 3
}

# use_axgen [AXGEN]: the array axgen is the command to check, without AXGEN that of this repository. Then the folder is the repository's.
use_axgen() {
    axgen=(cargo run -q --release --locked -p axgen --)
    # A path is meant from where the command was called.
    if (($#)); then axgen=("$(command -v "$1" | xargs -r realpath || true)"); fi
    if [ -z "${axgen[0]}" ]; then missing "no command $1"; fi
    cd "$(dirname "${BASH_SOURCE[0]}")/.."
}

# use_python NAME VERSION: python is one that has this package of PyPI, in an environment below the target folder
use_python() {
    local venv=${CARGO_TARGET_DIR:-target}/$1-$2
    command -v python3 >/dev/null || missing "no python3; as root: apt-get install python3 python3-venv"
    python=$venv/bin/python
    if ! "$python" -c "import $1" 2>/dev/null; then
        rm -rf "$venv"
        mkdir -p "$(dirname "$venv")"
        python3 -m venv "$venv" || missing "python3 cannot make an environment; as root: apt-get install python3-venv"
        "$python" -m pip install -q --disable-pip-version-check "$1==$2" ||
            missing "$1 $2 cannot be installed: is a registry of Python packages within reach?"
    fi
}
