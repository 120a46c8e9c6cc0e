# Sourced by scripts that need joints with walls.
#
#   walled_joint FILE KIND RADIUS_mm CLEARANCE_um INNER OUTER [BACKING LAYER...]
#
# writes a joint file. INNER and OUTER are materials at the contact, "E_GPa nu"
# (inf: rigid). BACKING is rigid, held or a material; without it the outer body
# is unbounded. A LAYER is "thickness_mm" or "thickness_mm E_GPa nu". A pin is 1
# mm long. coating="thickness_mm E_GPa nu" adds a coating to the inner body.
material() { # "E_GPa nu" SEPARATOR
  printf "youngs_modulus_GPa = %s${2}poissons_ratio = %s\n" $1
}
layer() { # TABLE LAYER
  printf '[[%s]]\nthickness_mm = %s\n' "$1" "${2%% *}"
  if [[ $2 == *' '* ]]; then material "${2#* }" '\n'; fi
}
walled_joint() {
  local file=$1
  {
    printf 'name = "joint"\nkind = "%s"\n[geometry]\n' "$2"
    printf 'radius_mm = %s\nradial_clearance_um = %s\n' "$3" "$4"
    if [ "$2" = pin ]; then echo 'length_m = 1'; fi
    printf '[materials.inner]\n'
    material "$5" '\n'
    printf '[materials.outer]\n'
    material "$6" '\n'
    if [ -n "${coating:-}" ]; then layer coating "$coating"; fi
    if [ $# -gt 6 ]; then
      printf '[wall]\nbacking = '
      case $7 in
        rigid | held) echo "\"$7\"" ;;
        *) echo "{ $(material "$7" ', ') }" ;;
      esac
    fi
    for thickness in "${@:8}"; do layer wall.layer "$thickness"; done
  } >"$file"
}
