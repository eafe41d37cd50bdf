# What the program answers to the commands of $session, a file: the lines that begin with "$ ", each
# with what it prints, on either output, and its code where that is not 0. To write a file anew:
#    furiko() { PATH-OF/furiko "$@"; }; session=test/data/session.txt; . test/data/session.sh >/tmp/x
# Read what has changed, then move it to its place.
grep '^\$ ' "$session" | while IFS= read -r line; do
   printf '%s\n' "$line"
   (eval "${line#\$ }") </dev/null 2>&1
   code=$?
   [ $code = 0 ] || echo "[$code]"
done
