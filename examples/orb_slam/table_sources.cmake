# What reads a node table, of the sources of the topobag program: all that rgbd_tum_semantic takes of it.
set(table_sources node_table.cpp appearance_columns.cpp depth_column.cpp label_column.cpp csv_reader.cpp path_kind.cpp)
list(TRANSFORM table_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/../topobag/)
