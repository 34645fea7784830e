# A part of the library whose sources are optimised less.
function(higherpair_add_part name level)
  set(part higherpair_${name})
  add_library(${part} OBJECT)
  target_compile_features(${part} PRIVATE cxx_std_20)
  target_link_libraries(${part} PRIVATE Eigen3::Eigen tl::expected fmt::fmt tomlplusplus::tomlplusplus Boost::headers
                                        nlohmann_json::nlohmann_json TBB::tbb)
  target_include_directories(${part} PRIVATE include src src/include)
  set_target_properties(${part} PROPERTIES POSITION_INDEPENDENT_CODE ${BUILD_SHARED_LIBS})
  higherpair_optimise_less(${part} ${level})
  higherpair_set_warnings(${part})
  higherpair_precompile(${part})
  target_link_libraries(higherpair PRIVATE $<BUILD_INTERFACE:${part}>)
endfunction()
