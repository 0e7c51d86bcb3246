# Runs the ANTLR tool (Java) over the two grammars into the folder ${generated}. Only for those who change the grammar.
# Also a script: cmake -D generated=FOLDER -P grammar/regenerate.cmake
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

# The tables were checked when they were made; checking them again would cost every start of a program half a millisecond.
foreach(grammar RbtLexer RbtParser)
  file(READ ${generated}/${grammar}.cpp text)
  string(REPLACE "atn::ATNDeserializer deserializer;"
    "atn::ATNDeserializationOptions options;\n  options.setVerifyATN(false);\n  atn::ATNDeserializer deserializer(options);"
    text "${text}")
  file(WRITE ${generated}/${grammar}.cpp "${text}")
endforeach()
