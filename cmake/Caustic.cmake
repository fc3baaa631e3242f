# Declares topics, chapters and tests.
#
# A file of the shared library belongs to one topic and to the chapter that introduces it. Each pair (topic, chapter)
# is one library target, caustic_<topic>_<NN>; the library of chapter N is every target tagged <= N. So chapter N can
# link nothing that a later chapter adds. What the linker cannot see (headers), tools/chapter_order.py checks in the
# compiler's dependency files.

# Any Python 3 runs the tools. find_package(Python3) asks it six times for what only those need who compile against it, which
# is more than half the time of configuring a small tree.
find_program(Python3_EXECUTABLE python3 REQUIRED)
add_executable(Python3::Interpreter IMPORTED GLOBAL)
set_target_properties(Python3::Interpreter PROPERTIES IMPORTED_LOCATION "${Python3_EXECUTABLE}")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
include(GoogleTest)

# So that whatever is built in a student's tree, ./course test as well as ./course check, is built by one rule.
set(students_tree OFF)
if(EXISTS "${CMAKE_SOURCE_DIR}/.course/student.json")
  set(students_tree ON)
endif()
option(CAUSTIC_STUDENT "A student's tree: the starter's stubs leave parameters and helpers unused" ${students_tree})

find_program(CAUSTIC_CCACHE ccache)
if(CAUSTIC_CCACHE AND NOT CAUSTIC_COVERAGE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_SOURCE_DIR}/tools/compiler.sh" "${CMAKE_SOURCE_DIR}" "${CAUSTIC_CCACHE}")
endif()
if(CAUSTIC_STUDENT)
  # Warnings of what a student wrote are no errors; see there.
  list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_SOURCE_DIR}/tools/student_compiler.sh")
endif()

# Options of every target of ours: warnings, architecture, floating point.
add_library(caustic_options INTERFACE)
target_compile_options(caustic_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast
  -Wdouble-promotion -Wimplicit-fallthrough -Werror
  # Contraction turns a*b - c*d into something that is not antisymmetric any more: the watertight triangle leaks with it.
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 sees overlaps in "literal" + std::string that are not there (GCC bug 105329).
  target_compile_options(caustic_options INTERFACE -Wno-restrict)
  # libstdc++ itself switches these off around its strings; a precompiled header forgets such pragmas.
  if(CAUSTIC_PRECOMPILE)
    target_compile_options(caustic_options INTERFACE -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds)
  endif()
endif()
if(CAUSTIC_STUDENT AND NOT (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION MATCHES "^12\\."))
  # A student with another compiler than ours need not wait until we know its warnings.
  target_compile_options(caustic_options INTERFACE -Wno-error)
endif()
# Reading behind the end of a vector, or an empty optional, ends the program where it happens: a test that would pass by
# luck is none. The gates go without it: so ccache knows their trees from the release build.
option(CAUSTIC_ASSERTIONS "The standard library minds what it is asked" ${CAUSTIC_STUDENT})
if(CAUSTIC_ASSERTIONS)
  target_compile_definitions(caustic_options INTERFACE _GLIBCXX_ASSERTIONS)
endif()
if(CAUSTIC_ARCH STREQUAL "native")
  target_compile_options(caustic_options INTERFACE -march=native)
elseif(CAUSTIC_ARCH STREQUAL "auto" AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(caustic_options INTERFACE -march=x86-64-v3)
endif()
if(CAUSTIC_SANITIZE)
  # -w: what the sanitizers insert makes GCC 12 warn of what is not there; the release build is the judge of warnings.
  target_compile_options(caustic_options INTERFACE -fsanitize=${CAUSTIC_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all -w)
  target_link_options(caustic_options INTERFACE -fsanitize=${CAUSTIC_SANITIZE})
endif()
if(CAUSTIC_SANITIZE MATCHES "undefined")
  # Null, stray and dangling pointers end in the address sanitizer anyway; without these four a test compiles in 10.7 to
  # 12.5 s instead of 13.6 to 21.2 s (property_svg.cpp, failure_cases.cpp, GCC 12).
  target_compile_options(caustic_options INTERFACE -fno-sanitize=null,object-size,vptr,alignment)
endif()
if(CAUSTIC_SANITIZE MATCHES "thread")
  target_compile_definitions(caustic_options INTERFACE CAUSTIC_STD_THREADS)
endif()
if(CAUSTIC_COVERAGE)
  # Counters in common/ alone: those of Eigen made a draft three times as slow. Without early inlining, for what it puts into
  # a function that has no counters isn't counted either.
  target_compile_options(caustic_options INTERFACE --coverage -fprofile-filter-files=/common/ -fno-early-inlining)
  target_link_options(caustic_options INTERFACE --coverage)
endif()

# caustic_precompile(<target> HEADERS <header>... LIBRARIES <library>...)
#
# Compiles headers that are not ours once for all targets that ask for them with caustic_use_precompiled. Nothing of ours
# goes in: what the compiler opened for each file would not tell any more who includes whom.
function(caustic_precompile target)
  if(NOT CAUSTIC_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LIBRARIES")
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/precompiled.cpp" CONTENT "// Generated: a library needs a source.\n")
  add_library(${target} OBJECT "${CMAKE_BINARY_DIR}/precompiled.cpp")
  target_link_libraries(${target} PRIVATE caustic_options ${arg_LIBRARIES})
  target_precompile_headers(${target} PRIVATE ${arg_HEADERS})
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # ccache gives a tree what another one compiled, whose generated files have other times.
    target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
endfunction()

# Lets a target of ours use what caustic_precompile made, if that was called.
function(caustic_use_precompiled target precompiled)
  if(TARGET ${precompiled})
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
  endif()
endfunction()

# Chapters after this one, and what they add to the topics, are not declared: the tree as it was when this chapter ended.
set(CAUSTIC_LAST_CHAPTER 99 CACHE STRING "Build the course up to this chapter only")

# "1" and "01" -> "01".
function(_caustic_two_digits out number)
  string(REGEX REPLACE "^0+" "" plain "${number}")
  if(plain LESS 10)
    set(plain "0${plain}")
  endif()
  set(${out} "${plain}" PARENT_SCOPE)
endfunction()

# Whether a chapter ("06_fresnel") comes after the last one that is to be built.
function(_caustic_is_left_out out name)
  string(REGEX MATCH "^0*([0-9]+)_" matched "${name}")
  set(${out} OFF PARENT_SCOPE)
  if(CMAKE_MATCH_1 GREATER CAUSTIC_LAST_CHAPTER)
    set(${out} ON PARENT_SCOPE)
  endif()
endfunction()

# All library targets of a topic that are tagged <= chapter.
function(_caustic_topic_targets out topic chapter)
  get_property(tags GLOBAL PROPERTY CAUSTIC_TAGS_${topic})
  set(targets "")
  foreach(tag IN LISTS tags)
    if(tag LESS_EQUAL chapter)
      _caustic_two_digits(nn ${tag})
      list(APPEND targets caustic_${topic}_${nn})
    endif()
  endforeach()
  set(${out} "${targets}" PARENT_SCOPE)
endfunction()

add_custom_target(headers COMMENT "Each header compiles by itself")

# Each header compiles by itself (tools/check_header.py), again when it or a file that it includes changes. Target headers, or
# headers_<NN> for those that chapter <n> adds; not a part of `all`.
function(_caustic_check_header out header target)
  set(checked "${CMAKE_BINARY_DIR}/headers/${header}.checked")
  cmake_path(GET checked PARENT_PATH checked_folder)
  file(MAKE_DIRECTORY "${checked_folder}")
  set(folders "$<REMOVE_DUPLICATES:$<TARGET_PROPERTY:${target},INTERFACE_INCLUDE_DIRECTORIES>>")
  set(ours "$<FILTER:${folders},INCLUDE,^${CMAKE_SOURCE_DIR}/>")
  set(foreign "$<FILTER:${folders},EXCLUDE,^${CMAKE_SOURCE_DIR}/>")
  set(definitions "$<TARGET_PROPERTY:${target},INTERFACE_COMPILE_DEFINITIONS>")
  set(precompiled "")
  set(needed "")
  foreach(part Geometry Core)  # the larger one first
    if(TARGET caustic_precompiled_${part})
      list(APPEND precompiled "Eigen/${part}=${CMAKE_BINARY_DIR}/CMakeFiles/caustic_precompiled_${part}.dir/cmake_pch.hxx")
      list(APPEND needed caustic_precompiled_${part})
    endif()
  endforeach()
  string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" flags)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${${flags}}")
  add_custom_command(OUTPUT "${checked}"
    COMMAND Python3::Interpreter "${CMAKE_SOURCE_DIR}/tools/check_header.py" "${CMAKE_SOURCE_DIR}/${header}" "${checked}" ${precompiled} --
      "${CMAKE_CXX_COMPILER}" ${flags} "$<TARGET_PROPERTY:caustic_options,INTERFACE_COMPILE_OPTIONS>"
      ${OpenMP_CXX_FLAGS} -std=c++${CMAKE_CXX_STANDARD} -Winvalid-pch
      "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>" "$<$<BOOL:${ours}>:-I$<JOIN:${ours},;-I>>"
      "$<$<BOOL:${foreign}>:-idirafter;$<JOIN:${foreign},;-idirafter;>>"
    DEPENDS "${CMAKE_SOURCE_DIR}/${header}" "${CMAKE_SOURCE_DIR}/tools/check_header.py" ${needed} DEPFILE "${checked}.d"
    COMMENT "Checking ${header} by itself" COMMAND_EXPAND_LISTS VERBATIM)
  set(${out} "${checked}" PARENT_SCOPE)
endfunction()

# caustic_topic(<topic> [USES <topic>...] CHAPTER <n> <file>... [LIBRARIES <library>...] [CHAPTER ...])
#
# Declares the files of the topic in the current folder. LIBRARIES behind a CHAPTER are what that chapter's files need
# from outside. A header is included as "topic/name.h".
function(caustic_topic topic)
  set(uses "")
  set(tags "")
  set(mode "")
  foreach(word IN LISTS ARGN)
    if(word MATCHES "^(USES|CHAPTER|LIBRARIES)$")
      set(mode ${word})
    elseif(mode STREQUAL "USES")
      list(APPEND uses ${word})
    elseif(mode STREQUAL "CHAPTER")
      set(tag ${word})
      if(tag LESS_EQUAL CAUSTIC_LAST_CHAPTER)
        list(APPEND tags ${tag})
      endif()
      set(mode FILES)
    elseif(mode STREQUAL "FILES")
      list(APPEND files_${tag} ${word})
    elseif(mode STREQUAL "LIBRARIES")
      list(APPEND libraries_${tag} ${word})
    else()
      message(FATAL_ERROR "caustic_topic(${topic}): '${word}' belongs to no USES, CHAPTER or LIBRARIES")
    endif()
  endforeach()

  foreach(used IN LISTS uses)
    get_property(known GLOBAL PROPERTY CAUSTIC_TOPICS)
    if(NOT used IN_LIST known)
      message(FATAL_ERROR "caustic_topic(${topic}): it uses '${used}', which is not declared before it")
    endif()
  endforeach()
  list(SORT tags COMPARE NATURAL)
  set_property(GLOBAL PROPERTY CAUSTIC_TAGS_${topic} "${tags}")
  set_property(GLOBAL PROPERTY CAUSTIC_USES_${topic} "${uses}")
  # And whatever these use, by this file's tag and not by theirs: a topic of chapter 1 between two of chapter 2 must not
  # hide the lower one.
  set(reachable ${uses})
  foreach(used IN LISTS uses)
    get_property(further GLOBAL PROPERTY CAUSTIC_REACHABLE_${used})
    list(APPEND reachable ${further})
  endforeach()
  list(REMOVE_DUPLICATES reachable)
  set_property(GLOBAL PROPERTY CAUSTIC_REACHABLE_${topic} "${reachable}")
  set_property(GLOBAL APPEND PROPERTY CAUSTIC_TOPICS ${topic})

  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR PARENT_PATH include_root)
  file(RELATIVE_PATH folder "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
  set(lower "")
  foreach(tag IN LISTS tags)
    _caustic_two_digits(nn ${tag})
    set(target caustic_${topic}_${nn})
    set(headers ${files_${tag}})
    list(FILTER headers INCLUDE REGEX "\\.h$")
    set(sources ${files_${tag}})
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    if(sources)
      add_library(${target} STATIC ${sources})
      set(scope PUBLIC)
      set_property(GLOBAL APPEND PROPERTY CAUSTIC_COMPILED ${target})
      if(topic STREQUAL "support")
        caustic_use_precompiled(${target} caustic_precompiled_tests)
      else()
        caustic_use_precompiled(${target} caustic_precompiled)
      endif()
    else()
      add_library(${target} INTERFACE)
      set(scope INTERFACE)
    endif()
    set(checked_headers "")
    foreach(header IN LISTS headers)
      _caustic_check_header(checked "${folder}/${header}" ${target})
      list(APPEND checked_headers "${checked}")
    endforeach()
    add_custom_target(headers_${topic}_${nn} DEPENDS ${checked_headers})
    if(NOT TARGET headers_${nn})
      add_custom_target(headers_${nn})
      add_dependencies(headers headers_${nn})
    endif()
    add_dependencies(headers_${nn} headers_${topic}_${nn})
    list(TRANSFORM headers PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
    target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS "${include_root}" FILES ${headers})
    target_link_libraries(${target} ${scope} caustic_options ${lower} ${libraries_${tag}})
    foreach(used IN LISTS reachable)
      _caustic_topic_targets(targets ${used} ${tag})
      target_link_libraries(${target} ${scope} ${targets})
    endforeach()
    list(APPEND lower ${target})

    foreach(file IN LISTS files_${tag})
      set_property(GLOBAL APPEND_STRING PROPERTY CAUSTIC_FILE_TAGS "${folder}/${file} ${topic} ${tag}\n")
    endforeach()
  endforeach()
endfunction()

# Interface target with everything that chapter <n> may use: caustic_upto_<NN>.
function(_caustic_chapter_library out chapter)
  _caustic_two_digits(nn ${chapter})
  set(target caustic_upto_${nn})
  if(NOT TARGET ${target})
    add_library(${target} INTERFACE)
    get_property(topics GLOBAL PROPERTY CAUSTIC_TOPICS)
    foreach(topic IN LISTS topics)
      _caustic_topic_targets(targets ${topic} ${chapter})
      target_link_libraries(${target} INTERFACE ${targets})
    endforeach()
  endif()
  set(${out} ${target} PARENT_SCOPE)
endfunction()

# A chapter's files with these extensions: those on top, and those of what draws its figures, what times and charts, and
# what counts failures.
function(_caustic_chapter_files out name)
  set(patterns "")
  foreach(folder ${name} ${name}/figures ${name}/measures ${name}/failures)
    foreach(extension IN LISTS ARGN)
      list(APPEND patterns "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.${extension}")
    endforeach()
  endforeach()
  file(GLOB found CONFIGURE_DEPENDS ${patterns})
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# Generates <binary dir>/<NN_name>/chapter_inputs.h: the hash of every source that can change the chapter's figures.
# It is made anew when one of them changes, so an executable always carries the hash of what it was built from.
function(_caustic_inputs_header chapter name target)
  set(header "${CMAKE_CURRENT_BINARY_DIR}/${name}/chapter_inputs.h")
  get_property(table GLOBAL PROPERTY CAUSTIC_FILE_TAGS)
  string(REGEX MATCHALL "[^\n]+" rows "${table}")
  set(depends "")
  foreach(row IN LISTS rows)
    string(REGEX MATCH "^([^ ]+) ([^ ]+) ([0-9]+)$" matched "${row}")
    if(CMAKE_MATCH_3 LESS_EQUAL chapter)
      list(APPEND depends "${CMAKE_SOURCE_DIR}/${CMAKE_MATCH_1}")
    endif()
  endforeach()
  # Paths only decide when to hash again; which assets a figure reads, it says itself when it opens them.
  file(GLOB_RECURSE assets CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/assets/*")
  list(APPEND depends ${assets})
  _caustic_chapter_files(own ${name} cpp h gp json)
  add_custom_command(OUTPUT "${header}"
    COMMAND Python3::Interpreter "${CMAKE_SOURCE_DIR}/tools/inputs.py" "${CMAKE_BINARY_DIR}/declarations.json" "${name}" "${header}"
    DEPENDS ${depends} ${own} "${CMAKE_SOURCE_DIR}/tools/inputs.py"
    COMMENT "Hashing the inputs of ${name}" VERBATIM)
  target_sources(${target} PRIVATE "${header}")
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/${name}")
endfunction()

# caustic_chapter(<NN_name> FIGURES <file>... [LIBRARIES <library>...])
#
# Declares chapters/NN_name: the executable NN_name from main.cpp, and a library <NN_name>_parts from its other
# sources, so that tests can reach them. FIGURES are the PNG files that the chapter writes.
function(caustic_chapter name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FIGURES;LIBRARIES")
  string(REGEX MATCH "^([0-9][0-9])_" matched "${name}")
  if(NOT matched)
    message(FATAL_ERROR "caustic_chapter(${name}): a chapter's name starts with its number, as in 01_bezier_curves")
  endif()
  set(nn ${CMAKE_MATCH_1})
  _caustic_is_left_out(left_out ${name})
  if(left_out)
    return()
  endif()
  string(REGEX REPLACE "^0+" "" chapter ${nn})
  _caustic_chapter_library(library ${chapter})

  _caustic_chapter_files(sources ${name} cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(sources)
    add_library(${name}_parts STATIC ${sources})
    caustic_use_precompiled(${name}_parts caustic_precompiled)
    set(scope PUBLIC)
  else()
    add_library(${name}_parts INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${name}_parts ${scope} "${CMAKE_CURRENT_SOURCE_DIR}/${name}")
  target_link_libraries(${name}_parts ${scope} ${library} ${arg_LIBRARIES})

  add_executable(${name} "${name}/main.cpp")
  target_link_libraries(${name} PRIVATE ${name}_parts)
  caustic_use_precompiled(${name} caustic_precompiled)
  _caustic_inputs_header(${chapter} ${name} ${name})

  set_property(GLOBAL APPEND PROPERTY CAUSTIC_COMPILED ${name})
  set_property(GLOBAL APPEND PROPERTY CAUSTIC_CHAPTERS ${name})
  set_property(GLOBAL APPEND PROPERTY CAUSTIC_PROGRAMS_${name} ${name})
  set_property(GLOBAL PROPERTY CAUSTIC_FIGURES_${name} "${arg_FIGURES}")
endfunction()

# caustic_program(<NN_name> <program> SOURCES <file>... [LIBRARIES <library>...])
#
# A further executable of a chapter (the editor, say); its sources lie in a folder of their own below the chapter's.
function(caustic_program name program)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "SOURCES;LIBRARIES")
  _caustic_is_left_out(left_out ${name})
  if(left_out)
    return()
  endif()
  list(TRANSFORM arg_SOURCES PREPEND "${name}/")
  add_executable(${program} ${arg_SOURCES})
  target_link_libraries(${program} PRIVATE ${name}_parts ${arg_LIBRARIES})
  caustic_use_precompiled(${program} caustic_precompiled)
  set_property(GLOBAL APPEND PROPERTY CAUSTIC_COMPILED ${program})
  set_property(GLOBAL APPEND PROPERTY CAUSTIC_PROGRAMS_${name} ${program})
endfunction()

# caustic_tests(<NN_name> [LIBRARIES <library>...])
#
# Test programs of a chapter, one a kind: tests/NN_name/{graded,property,stability,large}_*.cpp -> <kind>_<NN>. Graded
# tests see the library only, so that they build from what a student has; the other kinds see the chapter's own parts
# too. Large ones take minutes and run with ./course test --full only.
# Registered with ctest as <NN>.<kind>.<Suite>.<Test>, label <NN>.<kind>.
function(caustic_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES")
  _caustic_is_left_out(left_out ${name})
  if(left_out)
    return()
  endif()
  string(SUBSTRING ${name} 0 2 nn)
  string(REGEX REPLACE "^0+" "" chapter ${nn})
  _caustic_chapter_library(library ${chapter})
  if(TARGET ${name})
    # In a file of its own: with no path of the tree in their commands, ccache compiles the tests once for all trees.
    set(program "${CMAKE_CURRENT_BINARY_DIR}/chapter_program_${nn}.cpp")
    file(GENERATE OUTPUT "${program}" CONTENT
      "#include \"support/paths.h\"\n\nstd::string caustic::test::chapterProgram() { return R\"($<TARGET_FILE:${name}>)\"; }\n")
  endif()
  foreach(kind graded property stability large)
    file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${name}/${kind}_*.cpp")
    if(NOT sources)
      continue()
    endif()
    set(target ${kind}_${nn})
    add_executable(${target} ${sources})
    caustic_use_precompiled(${target} caustic_precompiled_tests)
    set_property(GLOBAL APPEND PROPERTY CAUSTIC_COMPILED ${target})
    _caustic_topic_targets(support support ${chapter})
    target_link_libraries(${target} PRIVATE ${support} ${library})
    # The library of a chapter may come before its executable.
    if(NOT kind STREQUAL "graded" AND TARGET ${name})
      target_link_libraries(${target} PRIVATE ${name}_parts ${arg_LIBRARIES})
      target_sources(${target} PRIVATE "${program}")
      add_dependencies(${target} ${name})
    endif()
    set(patience 300)
    if(CAUSTIC_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Debug" OR kind STREQUAL "large")
      set(patience 6000)  # under a sanitizer, or not optimised, tests take up to twenty times as long
    endif()
    set(environment "")
    if(CAUSTIC_SANITIZE MATCHES "thread")
      set(environment ENVIRONMENT "TSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/cmake/thread_suppressions.txt")
    endif()
    gtest_discover_tests(${target} TEST_PREFIX "${nn}.${kind}." DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS "${nn}.${kind}" TIMEOUT ${patience} ${environment})
  endforeach()
endfunction()

# The last step of a build: no file includes what its topic or its chapter may not use. Runs when something was built.
function(_caustic_check_order)
  get_property(compiled GLOBAL PROPERTY CAUSTIC_COMPILED)
  set(stamp "${CMAKE_BINARY_DIR}/chapter_order.stamp")
  set(script "${CMAKE_SOURCE_DIR}/tools/chapter_order.py")
  add_custom_command(OUTPUT "${stamp}"
    COMMAND Python3::Interpreter "${script}" "${CMAKE_BINARY_DIR}"
    COMMAND "${CMAKE_COMMAND}" -E touch "${stamp}"
    DEPENDS ${compiled} "${script}" "${CMAKE_BINARY_DIR}/declarations.json"
    COMMENT "Checking who includes whom" VERBATIM)
  add_custom_target(chapter_order ALL DEPENDS "${stamp}")
endfunction()

# Ends the declarations: writes what the Python tools need to know of them to <binary dir>/declarations.json.
function(caustic_finish)
  _caustic_check_order()
  get_property(table GLOBAL PROPERTY CAUSTIC_FILE_TAGS)
  get_property(topics GLOBAL PROPERTY CAUSTIC_TOPICS)
  set(json "{\n  \"topics\": {")
  set(comma "")
  foreach(topic IN LISTS topics)
    get_property(uses GLOBAL PROPERTY CAUSTIC_USES_${topic})
    list(JOIN uses "\", \"" quoted)
    if(uses)
      set(quoted "\"${quoted}\"")
    endif()
    string(APPEND json "${comma}\n    \"${topic}\": [${quoted}]")
    set(comma ",")
  endforeach()
  string(APPEND json "\n  },\n  \"files\": {")
  string(REGEX MATCHALL "[^\n]+" rows "${table}")
  set(comma "")
  foreach(row IN LISTS rows)
    string(REGEX REPLACE "^([^ ]+) ([^ ]+) ([0-9]+)$" "    \"\\1\": {\"topic\": \"\\2\", \"chapter\": \\3}" entry "${row}")
    string(APPEND json "${comma}\n${entry}")
    set(comma ",")
  endforeach()
  string(APPEND json "\n  },\n  \"chapters\": {")
  get_property(chapters GLOBAL PROPERTY CAUSTIC_CHAPTERS)
  set(comma "")
  foreach(chapter IN LISTS chapters)
    get_property(figures GLOBAL PROPERTY CAUSTIC_FIGURES_${chapter})
    list(JOIN figures "\", \"" quoted)
    string(APPEND json "${comma}\n    \"${chapter}\": [\"${quoted}\"]")
    set(comma ",")
  endforeach()
  string(APPEND json "\n  },\n  \"programs\": {")
  set(comma "")
  foreach(chapter IN LISTS chapters)
    get_property(programs GLOBAL PROPERTY CAUSTIC_PROGRAMS_${chapter})
    list(JOIN programs "\", \"" quoted)
    string(APPEND json "${comma}\n    \"${chapter}\": [\"${quoted}\"]")
    set(comma ",")
  endforeach()
  string(APPEND json "\n  }\n}\n")
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/declarations.json" CONTENT "${json}" @ONLY)
endfunction()
