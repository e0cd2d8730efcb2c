"""The kinds of pieces that curves are approximated with: the table, and one file each."""
