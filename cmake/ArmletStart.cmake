# How programs start soon. A short program takes as long as the loader: the fewer shared libraries, the sooner it runs.
# formatting_library.cpp stands for the shared library of fmt, which would bring in the shared C++ library again.
function(armlet_link_few_libraries program)
  if(ARMLET_SANITIZE)
    return()
  endif()
  target_sources(${program} PRIVATE formatting_library.cpp)
  target_link_options(${program} PRIVATE -static-libstdc++ -static-libgcc -Wl,--as-needed)
  # At a fixed address nothing is relocated at each start: 50 pages of tables of functions stay as they are on disk.
  set_target_properties(${program} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_link_options(${program} PRIVATE -no-pie)
  # Tree patterns of ANTLR, which nothing here uses and which therefore may stand for anything, would bring along a grammar
  # of their own that is read at each start.
  set(patterns _ZN6antlr44tree7pattern23ParseTreePatternMatcher)
  foreach(function C1EPNS_5LexerEPNS_6ParserE D1Ev
          7compileERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEEi)
    target_link_options(${program} PRIVATE -Wl,--defsym=${patterns}${function}=main)
  endforeach()
endfunction()
