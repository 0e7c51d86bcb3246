include(ArmletRoom)

# A room whose headers or sources read what ANTLR has made of the grammar. SYSTEM, because its headers are not ours to keep free of
# warnings.
function(armlet_read_grammar room)
  target_link_libraries(armlet_room_${room} PRIVATE antlr4_static)
  target_include_directories(armlet_room_${room} SYSTEM PRIVATE $<TARGET_PROPERTY:armlet_grammar,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()
