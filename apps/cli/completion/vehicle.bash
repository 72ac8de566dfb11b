# Completion of `vehicle` for bash. Installed under share/bash-completion/completions, or: source vehicle.bash
_vehicle() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
  local commands="check info simulate modes validate profile study schema"
  local common="--help --version --format --quiet --strict"
  local settings="--speed --step --rtol --atol --accuracy"
  local forms="flat matrix mbs-linear mbs flat-7-printed flat-literal flat-literal-mb"
  local methods="rk4 dopri5 exact simbody_rkm rk4_split"
  local sharing="--threads --scheme --map"
  local team="--waiting --pinning --priority"
  local words=""
  COMPREPLY=()

  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "$commands help --help --version" -- "$current")
    return
  fi
  if [[ ${COMP_WORDS[1]} == help ]]; then
    ((COMP_CWORD == 2)) && mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current")
    return
  fi
  case $previous in
    --form) words=$forms ;;
    --method) words=$methods ;;
    --format) words="table csv json" ;;
    --threads) words="auto 1 2 4" ;;
    --scheme) words="serial stages halo pipeline split" ;;
    --map) words="paper body auto" ;;
    --waiting) words="auto spin yield sleep" ;;
    --pinning) words="cores free" ;;
    --priority) words="normal raised fifo" ;;
    --speed | --step | --rtol | --atol | --accuracy | --gravity | --every | --realtime | --jobs | --best | --set) return ;;
    --output | --trace | --timeline | --export | --write-best) mapfile -t COMPREPLY < <(compgen -f -- "$current"); return ;;
  esac
  if [[ -z $words && $current == -* ]]; then
    case ${COMP_WORDS[1]} in
      check) words="$common --set" ;;
      info) words="$common --gravity --set" ;;
      simulate) words="$common --form --method $settings $sharing --set --output --overwrite" ;;
      modes) words="$common --form --gravity --set" ;;
      validate) words="$common --form --method $settings --set --serial --details --time-limit --allow-unjudged" ;;
      profile) words="$common --form --method --speed --set --step $sharing $team --every --trace --timeline --overwrite --realtime" ;;
      study) words="$common --output --resume --set --jobs --best --write-best --export --overwrite" ;;
      schema) words="--help --xsd --markdown" ;;
    esac
  fi
  if [[ ${COMP_WORDS[1]} == study && $previous == show ]]; then
    mapfile -t COMPREPLY < <(compgen -f -X '!*.sqlite' -- "$current"; compgen -d -- "$current")
    return
  fi
  if [[ ${COMP_WORDS[1]} == study && $COMP_CWORD == 2 && $current != -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "show" -- "$current")
  fi
  if [[ -n $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  else
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -X '!*.xml' -- "$current"; compgen -d -- "$current")
  fi
}
complete -o filenames -F _vehicle vehicle
