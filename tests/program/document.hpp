/// The marked blocks of a document as one shell script: what a reader types and saves, in order.
///
///   <!-- test: shell -->              the block is typed; `shell fails 2`: it has to end with 2
///   <!-- test: file DIR/NAME -->      the block is saved under that name
///   <!-- test: run NAME.xml -->       saved, then `dynamy run` has to end with 0
///   <!-- test: check NAME.xml -->     saved, then `dynamy check` has to end with 0
///   <!-- test: inside SECTION -->     part of a model: `dynamy check` of a model around it
///   <!-- test: build DIR -->          typed in the folder DIR; compiles a plug-in
///   <!-- test: python -->             part of one program of the page; `module`: with import
///   dynamy
///   <!-- test: output -->             has to occur in what was printed so far; … stands for
///   anything
#pragma once
#include <string>
#include <vector>

namespace dynamy {

struct MarkedBlock {
  std::string mark, text;
  int line = 0;  ///< of the mark
};

/// Blocks of a document in the source tree, in order.
std::vector<MarkedBlock> markedBlocks(const std::string& file);

/// The script for bash; it needs `dynamy` in the path and prints what the commands print.
std::string scriptOf(const std::vector<MarkedBlock>& blocks, const std::string& file);

}  // namespace dynamy
