# shellcheck shell=bash
# Checks the options of deploy/demo before anything is installed: with nothing but bash and awk, as on a
# bare Debian. The launcher knows the same options and checks them again; a test holds the two together.
# shellcheck disable=SC2154  # scarab_root is set by setup.sh

usage_error() {
  printf '%s: %s (see --help)\n' "${0##*/}" "$*" >&2
  exit 2
}

# kind_of OPTION: the values it takes; nothing for an unknown option.
kind_of() {
  case $1 in
    --height) echo "number 0 0.5" ;;
    --distance) echo "number 0.01 10" ;;
    --time-limit) echo "number 0.1 36000" ;;
    --seed) echo "integer 0 18446744073709551615" ;;
    --trials) echo "integer 1 100000" ;;
    --domain) echo "integer 0 230" ;;
    --perturb-position) echo "number 0 0.2" ;;
    --perturb-yaw) echo "number 0 3.1415926535897932" ;;
    --perturb-friction) echo "number 0 0.9" ;;
    --friction-scale) echo "number 0.01 10" ;;
    --object-mass) echo "number 0 100" ;;
    --object-diameter) echo "number 0 1" ;;
    --row) echo "row" ;;
    --goal) echo "word across travel walk none" ;;
    --robot) echo "word $(robots)" ;;
    --strategy | --profile | --driver) echo "name" ;;
    --replicas) echo "replicas" ;;
    --config) echo "service_file" ;;
    --tag | --interface | --peers | --device) echo "text" ;;
    --no-perturbation | --no-figure | --no-log | --keep | --realtime | --lockstep | --emulated) echo "flag" ;;
  esac
}

# robots: those that are described.
robots() {
  local file
  for file in "$scarab_root"/config/robot/*.yaml; do
    file=${file##*/}
    echo "${file%.yaml}"
  done | tr '\n' ' '
}

# default_of KEY: what stack.yaml says, of robot and driver.
default_of() {
  awk -v key="$1:" '$1 == key { print $2; exit }' "$scarab_root/deploy/stack.yaml"
}

# drivers ROBOT: those that it has a configuration for.
drivers() {
  local file
  for file in "$scarab_root/config/robot_bridge/$1"-*.yaml; do
    [ -f "$file" ] || continue
    file=${file##*/"$1"-}
    echo "${file%.yaml}"
  done | tr '\n' ' '
}

# profiles_with_a_device: those that name what can be emulated of them.
profiles_with_a_device() {
  awk '/^[^ #]/ { inside = /^profiles:/ }
       inside && /^  [^ #]/ { sub(/:.*/, ""); profile = $1 }
       inside && /^    emulated:/ { print profile }' "$scarab_root/deploy/stack.yaml" | tr '\n' ' '
}

# strategies: names in the default robot's supervisor configuration; nothing where that builds on another file,
# which only the supervisor itself can read.
strategies() {
  local robot file
  robot=$(default_of robot)
  file=$scarab_root/config/supervisor/$robot.yaml
  [ -f "$file" ] && ! grep -q '^extends:' "$file" || return 0
  awk '/^[^ #]/ { inside = /^strategies:/ }
       inside && /^  [^ #]/ { sub(/:.*/, ""); print $1 }' "$file"
}

# check_arguments ARGUMENT...: exits with 2 at the first mistake.
check_arguments() {
  local option value kind
  local -A given=()
  while [ $# -gt 0 ]; do
    option=${1%%=*}
    kind=$(kind_of "$option")
    [ -n "$kind" ] || usage_error "unknown option '$1'"
    if [ "$kind" = flag ]; then
      [ "$1" = "$option" ] || usage_error "$option takes no value"
      given[$option]=yes
      shift
      continue
    fi
    if [ "$1" = "$option" ]; then
      [ $# -ge 2 ] || usage_error "$option needs a value"
      value=$2
      shift 2
    else
      value=${1#*=}
      shift
    fi
    # shellcheck disable=SC2086  # kind and bounds are words
    check_value "$option" "$value" $kind
    given[$option]=$value
  done
  check_together
}

# check_together: what options say of each other; `given` is that of check_arguments.
check_together() {
  local known
  if [ "${given[--goal]-}" = across ] && [ -n "${given[--height]-}" ] && ! is_above "${given[--height]}"; then
    usage_error "--goal across needs an obstacle: --height greater than 0"
  fi
  [ -z "${given[--realtime]-}" ] || [ -z "${given[--lockstep]-}" ] ||
    usage_error "--realtime and --lockstep contradict each other"
  check_device
  # Names in other files than the default ones are left to the launcher, once it is built.
  [ -n "${given[--strategy]-}" ] && [ -z "${given[--robot]-}${given[--config]-}" ] || return 0
  known=$(strategies | tr '\n' ' ')
  # shellcheck disable=SC2086  # known is words
  [ -z "$known" ] || is_one_of "${given[--strategy]}" $known ||
    usage_error "--strategy: unknown value '${given[--strategy]}'; one of: $known"
}

# check_device: the options of a robot and its driver; `given` is that of check_arguments.
check_device() {
  local option known robot=${given[--robot]-}
  for option in --driver --device --emulated; do
    # shellcheck disable=SC2046  # the profiles are words
    [ -z "${given[$option]-}" ] || is_one_of "${given[--profile]-sim}" $(profiles_with_a_device) ||
      usage_error "$option needs a profile with a robot bridge: --profile $(profiles_with_a_device)"
  done
  [ -z "${given[--emulated]-}" ] || [ -z "${given[--device]-}" ] ||
    usage_error "--device and --emulated contradict each other: what is emulated is the device"
  # shellcheck disable=SC2046
  [ -z "${given[--lockstep]-}" ] || ! is_one_of "${given[--profile]-sim}" $(profiles_with_a_device) ||
    usage_error "--lockstep: a robot does not wait; leave the option out"
  [ -n "${given[--driver]-}" ] || return 0
  known=$(drivers "${robot:-$(default_of robot)}")
  # shellcheck disable=SC2086  # known is words
  is_one_of "${given[--driver]}" $known ||
    usage_error "--driver: unknown value '${given[--driver]}'; one of: $known"
}

# check_value OPTION VALUE KIND BOUND...
check_value() {
  local option=$1 value=$2 kind=$3
  shift 3
  case $kind in
    name)
      [[ $value =~ ^[A-Za-z0-9][A-Za-z0-9_+-]*$ ]] || usage_error "$option: '$value' is not a name" ;;
    replicas)
      [[ $value =~ ^[a-z][a-z0-9_]*=[1-8](,[a-z][a-z0-9_]*=[1-8])*$ ]] ||
        usage_error "$option: '$value' is not SERVICE=N with N from 1 to 8, such as premotor=2" ;;
    service_file)
      [[ $value =~ ^[a-z][a-z0-9_]*=. ]] || usage_error "$option: '$value' is not SERVICE=FILE"
      [ -f "${value#*=}" ] || usage_error "$option: there is no file ${value#*=}" ;;
    row)
      [[ $value =~ ^.+:[0-9]+$ ]] || usage_error "$option: '$value' is not FILE:N, such as results.csv:17"
      [ -f "${value%:*}" ] || usage_error "$option: there is no file ${value%:*}" ;;
    word)
      is_one_of "$value" "$@" || usage_error "$option: unknown value '$value'; one of: $*" ;;
    integer)
      [[ $value =~ ^[0-9]+$ ]] || usage_error "$option: '$value' is not a whole number"
      in_integer_range "$value" "$1" "$2" || usage_error "$option: $value is out of range [$1, $2]" ;;
    number)
      [[ $value =~ ^-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$ ]] ||
        usage_error "$option: '$value' is not a number"
      awk -v x="$value" -v low="$1" -v high="$2" 'BEGIN { exit !(x + 0 >= low + 0 && x + 0 <= high + 0) }' ||
        usage_error "$option: $value is out of range [$1, $2]" ;;
  esac
}

is_one_of() {
  local value=$1 known
  shift
  for known in "$@"; do
    [ "$value" = "$known" ] && return
  done
  return 1
}

is_above() {
  awk -v x="$1" 'BEGIN { exit !(x + 0 > 0) }'
}

# in_integer_range N LOW HIGH: compared as digits, since a seed has 64 bits.
in_integer_range() {
  local number
  number=$(printf '%s' "$1" | sed 's/^0*\(.\)/\1/')
  not_above "$2" "$number" && not_above "$number" "$3"
}

not_above() {
  [ ${#1} -lt ${#2} ] || { [ ${#1} -eq ${#2} ] && [[ ! $1 > $2 ]]; }
}
