# What doxygen has to be told of our comments (INPUT_FILTER of doc/Doxyfile.in).
# The first lines speak of the file, not of what is declared next.
1{
  /\\file/!s|^/// |/// \\file\n/// |
}
# Lines that are set in are formulas, tables and code: they keep their shape.
s|^( *///)   +([^ ].*)$|\1        \2|
