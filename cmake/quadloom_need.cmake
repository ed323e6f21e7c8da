# What the build needs from elsewhere.

# find_package, with the package of Debian in the message if it is not there.
macro(quadloom_need package debian)
  find_package(${package} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "Quadloom needs ${package}, on Debian: apt-get install ${debian}")
  endif()
endmacro()
