# read(FILE OUT): the text of a file. Brackets and semicolons would split CMake's lists.
function(read file out)
  file(READ ${file} text)
  string(REGEX REPLACE "[][;]" "|" text "${text}")
  set(${out} "${text}" PARENT_SCOPE)
endfunction()
