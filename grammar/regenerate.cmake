# Runs the ANTLR tool (Java) over the two grammars into the folder ${generated}. Only for those who change the grammar.
# Also a script: cmake -D generated=FOLDER -P grammar/regenerate.cmake
cmake_path(ABSOLUTE_PATH generated)  # the tool runs in the folder of the grammars
find_program(ARMLET_ANTLR_TOOL NAMES antlr4 REQUIRED)
foreach(grammar RbtLexer RbtParser)
  execute_process(
    COMMAND ${ARMLET_ANTLR_TOOL} -Dlanguage=Cpp -no-visitor -no-listener -lib ${generated}
            -o ${generated} ${grammar}.g4
    WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB leftovers ${generated}/*.interp ${generated}/*.tokens)
file(REMOVE ${leftovers})

# The tables are read at their first use. Most programs need only those of RbtTables.h.
foreach(grammar RbtLexer RbtParser)
  file(READ ${generated}/${grammar}.cpp text)
  string(REPLACE "${grammar}::Initializer ${grammar}::_init;"
    "void ${grammar}::prepare() {\n  static Initializer tables;\n}" text "${text}")
  string(REPLACE "RbtLexer::RbtLexer(CharStream *input) : Lexer(input) {"
    "RbtLexer::RbtLexer(CharStream *input) : Lexer(input) {\n  prepare();" text "${text}")
  file(WRITE ${generated}/${grammar}.cpp "${text}")
  file(READ ${generated}/${grammar}.h text)
  string(REPLACE "static Initializer _init;" "\npublic:\n  static void prepare();  // reads the tables" text "${text}")
  file(WRITE ${generated}/${grammar}.h "${text}")
endforeach()
